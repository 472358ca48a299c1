"""The document of a sweep: a row for each point of the grid."""

from __future__ import annotations

from symbalance.design.variations.size_sweep import Sweep, SweepPoint
from symbalance.document.decimals import decimal
from symbalance.document.formula import number
from symbalance.document.nodes import UNKNOWN, Cell, Column, Document, Facts, Paragraph, Table, blocks
from symbalance.engine.variants import VARIABLES

MOST_SAID = 5
"""Points whose refusals are said one by one."""


def sweep_document(result: Sweep) -> Document:
    """Return the grid as a table, and what its columns mean."""
    at_speed = result.rpm is not None
    heads = (f"{name}, {result.unit(name)}" if at_speed else name for name in result.quantities)
    columns = tuple(map(Column, (*result.variables, *heads)))
    rows = tuple(_row(point) for point in result)
    kinds = dict.fromkeys(name.split(".")[0] for name in result.quantities)
    legend = (
        *((name, _SIZES.get(name, VARIABLES[name])) for name in result.variables),
        *((f"{kind}.n", f"{_MEANINGS[kind]}, in {result.unit(kind)}") for kind in kinds),
        *(() if at_speed else (_LETTERS,)),
    )
    problems = [Paragraph(point.problem) for point in result.refused[:MOST_SAID]]
    if len(result.refused) > MOST_SAID:
        problems.append(Paragraph(f"and {len(result.refused) - MOST_SAID} more"))
    table = Table("", columns, rows, keys=len(result.variables))
    return Document(result.summary(), blocks(table, tuple(problems), Facts(legend, "How to read it")))


_SIZES = {"bank": "degrees between the two banks; the crank stays as it is"}
_LETTERS = ("m, r, a", "reciprocating mass and crank radius of cylinder 1 at the point, and the pitch")
_MEANINGS = {
    "force": "the free force of order n, largest over a turn; .vertical, .lateral: the amplitude there",
    "couple": "the free couple's, about the mean of all stations",
    "torque": "the inertia torque's amplitude of order n",
}


def _row(point: SweepPoint) -> tuple[Cell, ...]:
    settings = (number(v) if v.denominator == 1 else decimal(v, 9) for v in point.settings)
    return (*settings, *(UNKNOWN if value is None else decimal(value) for value in point.values))
