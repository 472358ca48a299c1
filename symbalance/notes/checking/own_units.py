"""Speeds in revolutions per minute: a letter that counts them takes the number as it stands.

The reader turns 3000 rpm into radians per second, which an angular speed wants. `n = 3000 min⁻¹`
says of a letter declared as "engine speed rpm" that it is 3000.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Constant, Formula, Name, Number, Product, Quotient
from symbalance.notes.reading.equations import Chain

ROLE = "engine speed rpm"
_PER_MINUTE = Quotient(Constant("pi"), Number(Fraction(30)))


def speeds_in_own_unit(chain: Chain, symbols: Mapping[str, str]) -> Chain:
    """Return a chain that begins with a letter for revolutions per minute, its values in that unit."""
    head = chain.sides[0].node
    if not isinstance(head, Name) or symbols.get(head.name, "").partition(",")[0].strip() != ROLE:
        return chain
    sides = [replace(side, readings=tuple(map(_without_unit, side.readings))) for side in chain.sides[1:]]
    return replace(chain, sides=(chain.sides[0], *sides))


def _without_unit(node: Formula) -> Formula:
    """Return a product without the factor that its unit, rpm, stands for."""
    if not isinstance(node, Product) or len(node.factors) < 2 or node.factors[-1] != _PER_MINUTE:
        return node
    unit = node.factors[-1]
    is_typed = isinstance(unit, Quotient) and unit.numerator.span != unit.denominator.span
    if is_typed:
        return node  # π/30 as the author wrote it
    rest = node.factors[:-1]
    return rest[0] if len(rest) == 1 else Product(rest, span=node.span)
