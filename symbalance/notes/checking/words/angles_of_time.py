"""Angles given as ω t = π: the time at which the crank stands there, t = π/ω.

So the angle belongs to its sentence, as θ = π does, and the next ω t = 2π is another time and no
contradiction.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Constant, Formula, Name, Product, Quotient, names, walk
from symbalance.notes.reading.equations import Chain, ReadNotes

_SPEEDS = ("omega", "Omega", "w")
_TIME = "t"


def with_angles_of_time(document: ReadNotes) -> ReadNotes:
    """Return a page whose relations ω t = angle in numbers are those of the time."""
    chains = tuple(map(_chain, document.chains))
    return document if chains == document.chains else replace(document, chains=chains)


def _chain(chain: Chain) -> Chain:
    speed = _speed(chain.sides[0].node)
    behind = chain.sides[1:]
    if speed is None or not behind or {r.sign for r in chain.relations} != {"="}:
        return chain
    if not all(_is_angle(node) for side in behind for node in side.readings):
        return chain
    time = Name(_TIME, span=chain.sides[0].node.span)
    first = replace(chain.sides[0], readings=(time,))
    rest = (
        replace(side, readings=tuple(Quotient(node, speed, span=node.span) for node in side.readings))
        for side in behind
    )
    return replace(chain, sides=(first, *rest))


def _speed(node: Formula) -> Name | None:
    """Return the ω of ω t, None for any other formula."""
    if not isinstance(node, Product) or len(node.factors) != 2:
        return None
    first, second = node.factors
    is_angle = isinstance(first, Name) and isinstance(second, Name) and second.name == _TIME
    return first if is_angle and isinstance(first, Name) and first.name in _SPEEDS else None


def is_time_of_angle(name: str, node: Formula) -> bool:
    """Tell whether a value is that of the time at an angle, t = π/ω."""
    if name != _TIME or not isinstance(node, Quotient) or not isinstance(node.denominator, Name):
        return False
    return node.denominator.name in _SPEEDS and _is_angle(node.numerator)


def _is_angle(node: Formula) -> bool:
    """Tell whether a side is an angle in numbers: 0, π/2, 90°, 2π/3."""
    letters = {part.name for part in walk(node) if isinstance(part, Constant)}
    return not names(node) and letters <= {"pi"}
