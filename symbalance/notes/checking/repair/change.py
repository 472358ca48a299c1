"""A single change to a formula, and the roles its parts play."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from symbalance.document import formula
from symbalance.document.formula import Call, Formula, Power, Product, Quotient, Sum


@dataclass(frozen=True, slots=True)
class Edit:
    """The part `old` of a formula replaced by `new`; `cost` ranks changes of equal effect."""

    kind: str
    cost: float
    old: Formula
    new: Formula

    def applied(self, way: dict[int, Formula]) -> Formula:
        """Return the whole formula changed; `way` leads from each part to what it is a part of."""
        old, new = self.old, self.new
        while id(old) in way:
            outer = way[id(old)]
            new = formula.with_children(
                outer, tuple(new if p is old else p for p in formula.children(outer))
            )
            old = outer
        return new


def ways(node: Formula) -> dict[int, Formula]:
    """Return, for each part of a formula, the part it stands in."""
    found: dict[int, Formula] = {}
    for outer in formula.walk(node):
        for part in formula.children(outer):
            found[id(part)] = outer
    return found


def parts(node: Formula, role: str = "side") -> Iterator[tuple[Formula, str]]:
    """Yield every part with its role: side, term, factor, exponent, argument or operand."""
    yield node, role
    for part in formula.children(node):
        if isinstance(part, formula.Dots):
            continue
        yield from parts(part, _role(node, part, role))


def _role(node: Formula, part: Formula, role: str) -> str:
    inherited = role if role in ("argument", "angle term", "phase", "exponent") else ""
    if isinstance(node, Sum):
        angle = "angle term" if formula.names(part) else "phase"
        return angle if inherited else "term"
    if isinstance(node, Power):
        return "exponent" if part is node.exponent else inherited or "operand"
    if isinstance(node, Call):
        return "argument"
    if inherited:
        return inherited
    return "factor" if isinstance(node, Product | Quotient) else "operand"
