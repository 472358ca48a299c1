"""The document of a quantity's harmonics: a table of coefficients as series in 1/lambda."""

from __future__ import annotations

from typing import Any

from symbalance.document.formula import Call, Formula, Name, equal, number
from symbalance.document.nodes import Cell, Column, Document, Facts, Table
from symbalance.kinematics.series_printing import series_formula
from symbalance.kinematics.slider_crank import Harmonics
from symbalance.kinematics.truncation_table import UNITS

_THETA = Name("theta")


def harmonics_document(harmonics: Harmonics) -> Document:
    """Return a table of the coefficients, and what they multiply."""
    rows: list[tuple[Cell, ...]] = []
    if harmonics.constant.terms:
        rows.append((number(1), series_formula(harmonics.constant, ellipsis=True)))
    for order, series in harmonics.terms.items():
        angle = _THETA if order == 1 else number(order) * _THETA
        rows.append((Call(harmonics.function, angle), series_formula(series, ellipsis=True)))
    lam: Formula = Name("lam")
    legend = (
        (equal(lam, Name("l") / Name("r")), "connecting rod over crank radius"),
        (_THETA, "crank angle, 0 at top dead centre"),
        ("unit", UNITS[harmonics.quantity]),
    )
    table = Table("", (Column("of"), Column(("coefficient, in powers of ", 1 / lam))), tuple(rows))
    return Document(harmonics.summary(), (table, Facts(legend, "How to read it")))


def harmonics_data(harmonics: Harmonics) -> dict[str, Any]:
    """Return every coefficient as a series that SymPy reads, and how far it is kept."""
    return {
        "quantity": harmonics.quantity,
        "function": harmonics.function,
        "constant": str(harmonics.constant.in_lam()),
        "harmonics": [
            {"order": str(n), "series": str(series.in_lam()), "through": series.through}
            for n, series in harmonics.terms.items()
        ],
    }


def harmonics_records(harmonics: Harmonics) -> list[dict[str, Any]]:
    """Return a row for each power of 1/lambda of each order, as a fraction and a float."""
    return [
        {
            "order": n,
            "function": harmonics.function,
            "power": power,
            "coefficient": str(value),
            "value": float(value),
        }
        for n, series in harmonics.terms.items()
        for power, value in sorted(series.terms.items())
    ]
