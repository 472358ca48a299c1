"""Small slips between two sides: factors, units, signs and digits that people get wrong."""

from __future__ import annotations

import math

from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.verdicts import Fix
from symbalance.text import lazy_patterns as re

_NO_SLIP = ("value", "miscalculated", "term", "phase", "factor sqrt(-1)", "convention")
"""Kinds of corrections that put something else in the place of what is written."""
_MISPRINT = re.compile(r"digits|times too|sign")
"""In the words of a correction of a number that was copied wrongly."""
LEAST_APART = math.log10(1.003)
"""Powers of ten that numbers carried on in rounded form may differ by."""
SAME_DIGITS = 0.005
"""Of a power of ten: digits that agree to a per cent."""
_USUAL = tuple(
    factor * number
    for factor in (1, 2**0.5, 3**0.5, math.pi)
    for number in (1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 30, 32, 60, 64, 100, 1000)
)
"""Factors that people forget, or have too many of."""
_OF_UNITS = (
    *(factor**power for factor in (30 / math.pi, 12, 25.4, 0.3048, 60) for power in (1, 2)),
    *(180 / math.pi, 9.80665, 32.174, 4.44822, 0.453592, 745.7, 735.499, 1.35582, 16.387, 61.024),
)
"""Of units that somebody did not convert: turns a minute as rad/s, inches as millimetres, lb as kg."""
CLOSE, ABOUT = 1e-9, 0.005
"""How near a ratio is to one of them: of exact formulas, and of printed numbers."""
POINTS = 3
"""At which two sides are compared."""


def is_slip(fix: Fix | None, decision: Decision, *, is_datum: bool, is_result: bool) -> bool:
    """Tell whether one small slip lies between two sides: a sign, a factor, an exponent, digits."""
    ratio = ratio_of_sides(decision)
    if ratio is not None and not is_datum and is_usual_factor(ratio):
        return True
    if fix is None:
        return False
    if is_datum or is_result:  # another number stands for any other
        return _MISPRINT.search(fix.words) is not None
    kinds = [kind.strip() for kind in fix.kind.split(";")]
    if any(kind.startswith("factor") for kind in kinds):  # by one with letters a side becomes anything
        return kinds != ["factor"] and ratio is None
    return not any(kind.startswith(_NO_SLIP) for kind in kinds)


def is_usual_factor(ratio: float) -> bool:
    """Tell whether a ratio is a factor that people forget: -1, 2, 1/2, √3, π, a power of ten, a unit."""
    if not ratio:
        return False
    powers = math.log10(abs(ratio))
    if abs(powers) < LEAST_APART:
        return ratio < 0
    return abs(powers - round(powers)) < SAME_DIGITS or any(
        abs(each / factor - 1) < ABOUT
        for factor in (*_USUAL, *_OF_UNITS)
        for each in (abs(ratio), 1 / abs(ratio))
    )


def ratio_of_sides(decision: Decision) -> float | None:
    """Return how many times larger the exact side is, where that is the same for all letters' values."""
    exact, claimed = decision.left, decision.right
    if exact is None or claimed is None:
        return None
    try:
        rows = [row for _, row in values.sample([exact, claimed], POINTS)]
        ratios = [complex(first) / complex(second) for first, second in rows]
    except (NoFormError, ZeroDivisionError):
        return None
    first = ratios[0] if ratios else 0j
    is_one = all(abs(each - first) <= CLOSE * abs(first) for each in ratios)
    return first.real if is_one and abs(first.imag) <= CLOSE * abs(first) else None
