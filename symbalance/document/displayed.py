"""Displayed equations in lines that fit: one left column, chains of relations run on where they can."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from symbalance.document.formula import Equation, Formula
from symbalance.document.formula_printing import FormulaWriter
from symbalance.document.line_breaking import Line, broken


class DisplayedLine(NamedTuple):
    """A line of displayed equations: what stands left of the relation, how deep it is indented, the rest."""

    left: str
    depth: int
    printed: str


def displayed(
    equations: Sequence[Equation], writer: FormulaWriter, room: float, indent: float
) -> Iterator[DisplayedLine]:
    """Yield the lines of equations that share one left column, none wider than `room` where that can be.

    Lengths are in the writer's own unit; each bracket that a line continues takes up `indent`.
    """
    space = writer.width(" ")
    left = max(writer.width(writer.write(each.left)) for each in equations) + space
    for each in equations:
        name = writer.write(each.left)
        for line in chain_lines(each.links, writer, room - left, indent):
            yield DisplayedLine(name, line.depth, line.printed)
            name = ""


def chain_lines(
    links: Iterable[tuple[str, Formula]], writer: FormulaWriter, room: float, indent: float
) -> Iterator[Line]:
    """Yield the lines of a chain of relations, short ones together on one."""
    space = writer.width(" ")
    held: Line | None = None
    for sign, right in links:
        head, *more = broken(writer.relation(sign), right, writer, room, indent)
        if held and not more and held.width + space + head.width <= room:
            held = Line(0, f"{held.printed} {head.printed}", held.width + space + head.width)
            continue
        if held:
            yield held
        if more:
            yield from (head, *more)
            held = None
        else:
            held = head
    if held:
        yield held
