"""What is written of frequencies over speed: each mode's course, then all of them speed by speed."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from symbalance.crankshaft.rotor_facts import DIGITS, HERTZ, RPM, rotor_entry, speed_words, whirl_word
from symbalance.document.decimals import rounded
from symbalance.document.formula import number
from symbalance.document.nodes import Cell, Column, Document, Facts, Strong, Table, Words, blocks

if TYPE_CHECKING:
    from symbalance.crankshaft.campbell import Campbell
    from symbalance.crankshaft.rotor import Array

ABREAST = 6
"""Modes beside one another in a table."""


def campbell_document(lines: Campbell) -> Document:
    """Return a Campbell diagram's lines as a document."""
    first, last = (speed_words(float(lines.speeds[i])) for i in (0, -1))
    span = f"from {first} to {last}" if len(lines.speeds) > 1 else f"at {first}"
    held = "free" if lines.is_free else "on a given stiffness, alike in all directions across the axis"
    entries: tuple[tuple[Words, Words], ...] = (
        rotor_entry(lines.rotor),
        ("held", held),
        ("turning axes", "turn with the rotor"),
        ("stationary axes", "the stronger line of a mode there; negative: it whirls backward"),
        ("growth", "real part of the root in 1/s; above 0: unstable"),
        ("mode", "tracked over the speed by its shape"),
    )
    return Document(
        f"Natural frequencies over speed, {span}",
        blocks(
            _courses(lines),
            tuple(_over_speed("Stationary axes, Hz", lines, lines.stationary * HERTZ)),
            tuple(_over_speed("Turning axes, Hz", lines, lines.rotating * HERTZ)),
            tuple(_over_speed("Growth, 1/s", lines, lines.growth)) if lines.unstable.any() else None,
            Facts(entries, "How to read it"),
        ),
        _verdict(lines),
    )


def _verdict(lines: Campbell) -> Words:
    """Return at which speeds something grows."""
    growing = lines.speeds[lines.unstable.any(axis=1)]
    if not len(growing):
        return "Nothing grows at these speeds."
    return Strong(f"Unstable at {', '.join(speed_words(float(speed)) for speed in growing)}.")


def _courses(lines: Campbell) -> Table:
    """Return a row for each mode: what moves, and its frequencies at the first and the last speed."""
    ends = [0, -1] if len(lines.speeds) > 1 else [0]
    heads = [Column("mode"), Column("motion")]
    heads += [Column(f"stationary Hz at {speed_words(float(lines.speeds[i]))}") for i in ends]
    heads += [Column("largest growth 1/s")]
    rows = tuple(_course(lines, k, ends) for k in range(lines.rotating.shape[1]))
    return Table("Modes", tuple(heads), rows)


def _course(lines: Campbell, mode: int, ends: list[int]) -> tuple[Cell, ...]:
    motion = whirl_word(float(lines.forward[-1, mode])) if lines.lateral[-1, mode] else "axial or torsion"
    hertz = [rounded(float(lines.stationary[i, mode]) * HERTZ, DIGITS) for i in ends]
    growth = float(lines.growth[:, mode].max())
    return number(mode + 1), motion, *hertz, rounded(growth if abs(growth) > lines.rounding else 0.0, 3)


def _over_speed(title: str, lines: Campbell, values: Array) -> Iterator[Table]:
    """Yield tables of values (speed, mode), some modes each."""
    count = values.shape[1]
    for start in range(0, count, ABREAST):
        stop = min(start + ABREAST, count)
        heads = (Column("rpm"), *(Column(f"mode {k + 1}") for k in range(start, stop)))
        rows = tuple(
            (rounded(float(speed) * RPM), *(rounded(float(value), DIGITS) for value in row[start:stop]))
            for speed, row in zip(lines.speeds, values, strict=True)
        )
        yield Table(title, heads, rows)
