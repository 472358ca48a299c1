"""The document of sensitivities: the worst steps first, cylinders that are alike in one row."""

from __future__ import annotations

from collections.abc import Sequence

from symbalance.design.variations.legend import TURNING, Entry, as_decimal, letters_entry, unit_formulas
from symbalance.design.variations.sensitivity import STEPS, Sensitivities
from symbalance.document.decimals import decimal
from symbalance.document.formula import Formula, Name, number
from symbalance.document.nodes import Cell, Column, Document, Facts, Paragraph, Table, Words, blocks
from symbalance.forces.rows import plane

MOST_ROWS = 500
"""Rows that a document lists: the largest steps."""
_COLUMNS = tuple(map(Column, ("order", "size", "step", "cylinders", "force", "couple")))


def sensitivities_document(result: Sensitivities) -> Document:
    """Return sensitivities as a document: what one step adds, order by order, worst first."""
    force, couple = unit_formulas(result.engine, at_speed=result.rpm is not None)
    speed = "" if result.rpm is None else f", at {as_decimal(result.rpm)} rpm"
    title = f"{result.engine.name}: sensitivities to order {result.order}{speed}"
    rows = _rows(result)
    table = Table(
        ("What one step adds, force in ", force, ", couple in ", couple), _COLUMNS, rows[:MOST_ROWS]
    )
    more = len(rows) - MOST_ROWS
    rest = Paragraph(f"{more} more rows, none with a larger step: the JSON of this result has them all")
    entries: list[Entry] = [
        ("a step", "changes one size of one cylinder"),
        ("force, couple", "the largest modulus over a turn of what is added"),
        ("rows", "worst first: by the force, or where it is larger the couple over one pitch"),
        ("orders", "those that cancel in the engine as drawn are among them"),
        ("couples", f"about {plane(result.reference)}"),
        letters_entry(result.engine),
    ]
    if result.engine.balancers or any(c.rotating_mass for c in result.engine.cylinders):
        entries.append(TURNING)
    return Document(
        title, blocks(table, rest if more > 0 else None, Facts(tuple(entries), "How to read it"))
    )


def _rows(result: Sensitivities) -> tuple[tuple[Cell, ...], ...]:
    groups: dict[tuple[str, int, Formula | str, Formula | str], list[int]] = {}
    for change in result:
        force, couple = map(decimal, result.at_speed(change))
        groups.setdefault((change.parameter, change.order, force, couple), []).append(change.cylinder)
    return tuple(
        (number(order), parameter, _step(parameter), number_runs(cylinders), force, couple)
        for (parameter, order, force, couple), cylinders in groups.items()
    )


def _step(parameter: str) -> Words:
    """Return a step in words, the letter it is a part of as a letter."""
    before, _, last = STEPS[parameter][1].rpartition(" ")
    return (f"{before} ", Name(last)) if len(last) == 1 else STEPS[parameter][1]


def number_runs(numbers: Sequence[int]) -> str:
    """Return numbers as runs.

    >>> number_runs([4, 1, 2, 3, 7])
    '1–4, 7'
    """
    runs: list[list[int]] = []
    for each in sorted(numbers):
        if runs and each == runs[-1][-1] + 1:
            runs[-1].append(each)
        else:
            runs.append([each])
    return ", ".join(f"{r[0]}–{r[-1]}" if len(r) > 2 else ", ".join(map(str, r)) for r in runs)
