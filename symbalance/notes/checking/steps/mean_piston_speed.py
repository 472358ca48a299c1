"""The mean piston speed: two strokes a revolution, 2 s n or 4 r n, and not 2 r n.

Where words name it right before a letter, and its formula is a number times the crank radius or
the stroke and one other letter, the revolutions, that number is known: 4 or 2, or a 60th of it if these
are counted by the minute, a 12th where inches make feet, a 1000th where mm make metres. Half or twice the
number is a stroke forgotten; anything else is no claim.
"""

from __future__ import annotations

from fractions import Fraction
from math import prod

from symbalance.document.formula import Formula, Name, Number, Product, Quotient, names
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.own_units import is_angular_speed
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_NAMED = re.compile(
    r"(?:mean\s+(?:piston\s+)?speed(?:\s+of\s+the\s+piston)?|average\s+piston\s+speed"
    r"|mittlere\s+Kolbengeschwindigkeit|平均ピストン速度)[^.;=\n]{0,20}$",
    re.IGNORECASE,
)
_SPEEDS = {"crank radius": Fraction(4), "stroke": Fraction(2)}
"""What a length is multiplied by with the revolutions in the same time."""
_UNITS = tuple(by_time * by_length for by_time in (1, 60) for by_length in (1, 12, 1000))
"""What a formula of numbers is divided by: minutes are made seconds, inches feet, millimetres metres."""
_SLIPS = (Fraction(1, 4), Fraction(1, 2), Fraction(2), Fraction(4))


def mean_piston_speed(state: JudgingState, chain: Chain) -> Decision | None:
    """Return that a formula is not the mean piston speed that the words before it name, else None."""
    head, value = chain.sides[0].node, chain.sides[1].node
    start = chain.sides[0].span[0]
    before = state.document.text[max(start - 80, 0) : start]
    factor = _factor(value)
    if not isinstance(head, Name) or factor is None or not _NAMED.search(before.rstrip(" $")):
        return None
    declared, proposed = state.meant.words.sizes(chain.lines[0])
    roles = {**proposed, **declared}
    lengths = [roles[name] for name in names(value) if roles.get(name) in _SPEEDS]
    is_angular = any(is_angular_speed(name, roles) for name in names(value))
    if is_angular or len(lengths) != 1 or len(names(value)) != 2:
        return None
    right = _SPEEDS[lengths[0]]
    ratios = [factor * unit / right for unit in _UNITS]
    if 1 in ratios or not any(ratio in _SLIPS for ratio in ratios):
        return None
    text = "two strokes" if lengths[0] == "stroke" else "four crank radii"
    return Decision(REFUTED, f"the piston goes {text} a revolution: {right} {lengths[0]} × speed")


def _factor(node: Formula) -> Fraction | None:
    """Return the number of a product of it and two letters, 2 of 2 r N and 1/30 of s n/30."""
    if isinstance(node, Name | Number):
        return node.value if isinstance(node, Number) else Fraction(1)
    if isinstance(node, Quotient) and isinstance(node.denominator, Number) and node.denominator.value:
        above = _factor(node.numerator)
        return None if above is None else above / node.denominator.value
    factors = [_factor(part) for part in node.factors] if isinstance(node, Product) else [None]
    numbers = [factor for factor in factors if factor is not None]
    return prod(numbers, start=Fraction(1)) if len(numbers) == len(factors) else None
