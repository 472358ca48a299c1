"""Film coefficients from a CSV file: degrees, then eight columns a bearing."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from symbalance.crankshaft.bearings.periodic import film_from_tables
from symbalance.crankshaft.rotor import Array
from symbalance.crankshaft.system import Film
from symbalance.errors import SymbalanceError
from symbalance.text.csv_rows import Row, rows_of, without_headers
from symbalance.text.files import read_text

COEFFICIENTS = ("kvv", "kvl", "klv", "kll", "cvv", "cvl", "clv", "cll")
MOST_ROWS = 100_000
LARGEST_FILE = 200_000_000
"""Bytes: as many rows of a dozen bearings."""


def read_film(path: str | Path, bearings: int, cycle: float) -> Film:
    """Return the film of a CSV file; `cycle` in radians.

    Columns: crank angle in degrees, then for each bearing, front to rear, kvv kvl klv kll in N/m and
    cvv cvl clv cll in N s/m, v vertical, l lateral, the force's direction first. Columns are parted by
    commas, semicolons or tabs; empty lines, lines that begin with # and one line of column names are
    passed over. An error names file, line, rule and remedy.
    """
    theta, stiffness, damping = _numbers(Path(path), bearings)
    try:
        return film_from_tables(theta, stiffness, damping, cycle)
    except SymbalanceError as problem:
        raise problem.within(str(path)) from None


def _numbers(path: Path, bearings: int) -> tuple[Array, Array, Array]:
    place, text = str(path), read_text(path, LARGEST_FILE, "a CSV file of film coefficients")
    _, rows = without_headers(rows_of(text, place))
    if not 0 < len(rows) <= MOST_ROWS:
        rule, remedy = f"must be 1 to {MOST_ROWS}", "write one row a crank angle"
        raise SymbalanceError(f"{len(rows)} rows", rule, remedy, place)
    names = ["angle", *(f"{name} of bearing {i + 1}" for i in range(bearings) for name in COEFFICIENTS)]
    values = np.array([_row(row, names) for row in rows])
    table = values[:, 1:].reshape(len(values), bearings, 2, 2, 2)
    return np.radians(values[:, 0]), table[:, :, 0], table[:, :, 1]


def _row(row: Row, names: list[str]) -> list[float]:
    row.check_width(len(names), f"degrees, then for each bearing {', '.join(COEFFICIENTS)}")
    return [row.number(column, name) for column, name in enumerate(names)]
