"""Displayed equations in lines that fit: one left column, chains of relations run on where they can."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from symbalance.document.formula import Equation
from symbalance.document.line_breaking import Medium, break_equation


class DisplayedLine(NamedTuple):
    """A line of displayed equations: what stands left of the relation, its indent, the rest."""

    left: str
    depth: int
    printed: str


def display_lines(
    equations: Sequence[Equation], writer: Medium, room: float, indent: float, column: float = 0
) -> Iterator[DisplayedLine]:
    """Yield the lines of equations that share one left column, none wider than `room` where that can be.

    Lengths are in the writer's own unit; each bracket that a line continues takes up `indent`, and the
    left column at least `column`.
    """
    space = writer.width(" ")
    names = [writer.write(each.left) for each in equations]
    left = max(column, *map(writer.width, names)) + space
    for name, each in zip(names, equations, strict=True):
        for place, line in enumerate(break_equation(each, writer, room - left, indent)):
            yield DisplayedLine("" if place else name, line.depth, line.printed)
