"""Angular speeds divided by a turn: ω/2π is a rate, so 15.9 rev/s behind it are turns and no radians.

The reader turns revolutions into radians, which an angular speed wants. What is divided by 2π counts
revolutions: ω/(2π) = 955 rpm = 15.9 Hz, and ω/2π written in a line has the 2π below.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Constant, Formula, Name, Number, Product, Quotient, names
from symbalance.notes.checking.units.own_units import ANGULAR_LETTERS, BY_THE_SECOND, is_unit_of_speed
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.text import lazy_patterns as re

_TWO, _PI = Number(Fraction(2)), Constant("pi")
_A_SIXTIETH = Number(Fraction(1, 60))
_BY_THE_SECOND = re.compile(rf"[0-9][\s~$\\,{{}}A-Za-z]{{0,20}}?{BY_THE_SECOND}(?![A-Za-z])")
"""A number of hertz or of revolutions per second."""


def with_turns_divided(document: ReadNotes) -> ReadNotes:
    """Return a page whose revolutions are rates where an angular speed is divided by a turn."""
    return replace(document, chains=tuple(_chain(chain, document) for chain in document.chains))


def _chain(chain: Chain, document: ReadNotes) -> Chain:
    rates = chain.sides[1:]
    is_of_turns = any(_in_turns(s.node) or _BY_THE_SECOND.search(document.source(s.span)) for s in rates)
    if not any(map(_divided, chain.sides)) or not is_of_turns:
        return chain
    return replace(chain, sides=tuple(map(_side, chain.sides)))


def _side(side: Side) -> Side:
    divided = _divided(side)
    if divided:
        return replace(side, readings=divided)
    in_turns = _in_turns(side.node)
    return replace(side, readings=(in_turns,)) if in_turns is not None else side


def _divided(side: Side) -> tuple[Formula, ...]:
    """Return the readings of a side in which an angular speed is divided by 2π, and nothing else."""
    return tuple(node for node in side.readings if _is_divided(node))


def _is_divided(node: Formula) -> bool:
    if not isinstance(node, Quotient) or not isinstance(node.denominator, Product):
        return False
    above = node.numerator
    is_angular = isinstance(above, Name) and above.name.partition("_")[0] in ANGULAR_LETTERS
    return is_angular and node.denominator.factors == (_TWO, _PI) and not names(node.denominator)


def _in_turns(node: Formula) -> Formula | None:
    """Return a number of revolutions per minute or per second as a rate; None for other sides."""
    if not isinstance(node, Product) or len(node.factors) != 2 or not isinstance(node.factors[0], Number):
        return None
    number, unit = node.factors
    if is_unit_of_speed(unit):
        return Product((number, replace(_A_SIXTIETH, span=unit.span)), span=node.span)
    if not isinstance(unit, Product) or unit != Product((_TWO, _PI)):
        return None
    is_turn = unit.factors[0].span == unit.factors[1].span
    return replace(number, span=node.span) if is_turn else None
