"""A single change to a formula, and the roles its parts play."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from symbalance.document import syntax
from symbalance.document.syntax import Call, Node, Power, Product, Quotient, Sum


@dataclass(frozen=True, slots=True)
class Edit:
    """The part `old` of a formula replaced by `new`; `cost` ranks changes of equal effect."""

    kind: str
    cost: float
    old: Node
    new: Node

    def applied(self, way: dict[int, Node]) -> Node:
        """Return the whole formula changed; `way` leads from each part to what it is a part of."""
        old, new = self.old, self.new
        while id(old) in way:
            outer = way[id(old)]
            new = syntax.with_children(
                outer, tuple(new if p is old else p for p in syntax.children(outer))
            )
            old = outer
        return new


def ways(node: Node) -> dict[int, Node]:
    """Return, for each part of a formula, the part it stands in."""
    found: dict[int, Node] = {}
    for outer in syntax.walk(node):
        for part in syntax.children(outer):
            found[id(part)] = outer
    return found


def parts(node: Node, role: str = "side") -> Iterator[tuple[Node, str]]:
    """Yield every part with its role: side, term, factor, exponent, argument or operand."""
    yield node, role
    for part in syntax.children(node):
        if isinstance(part, syntax.Dots):
            continue
        yield from parts(part, _role(node, part, role))


def _role(node: Node, part: Node, role: str) -> str:
    inherited = role if role in ("argument", "angle term", "phase", "exponent") else ""
    if isinstance(node, Sum):
        angle = "angle term" if syntax.names(part) else "phase"
        return angle if inherited else "term"
    if isinstance(node, Power):
        return "exponent" if part is node.exponent else inherited or "operand"
    if isinstance(node, Call):
        return "argument"
    if inherited:
        return inherited
    return "factor" if isinstance(node, Product | Quotient) else "operand"
