"""Slips that make one printed number of another: a factor 2 or π, a power of ten, digits exchanged."""

from __future__ import annotations

from math import isclose, pi, sqrt

from symbalance.document.formula import Formula, Number, walk

_SLIPS = tuple(ratio for f in (2.0, 3.0, 4.0, 10.0, sqrt(2), sqrt(3), pi) for ratio in (f, 1 / f))
_NEAR, _FEWEST_DIGITS, _EXCHANGED = 0.004, 2, 2
"""How near a ratio comes to that of a slip; the digits of a number told by it, and those exchanged."""


def is_slip(typed: float, exact: float, node: Formula) -> bool:
    """Tell whether one slip makes a number of another: a factor, a power of ten, two digits exchanged."""
    is_short = len(_digits(node)) < _FEWEST_DIGITS
    return not is_short and (
        is_mistyped(typed, exact, node)
        or any(isclose(typed / exact, slip, rel_tol=_NEAR) for slip in _SLIPS)
    )


def is_mistyped(typed: float, exact: float, node: Formula) -> bool:
    """Tell whether a printed number has two digits of another exchanged, or its point elsewhere."""
    count = len(_digits(node))
    mine, right = (f"{size:.{count - 1}e}".replace(".", "") for size in (typed, exact))
    is_exchanged = sum(a != b for a, b in zip(mine, right, strict=False)) == _EXCHANGED
    is_shifted = any(isclose(typed / exact, ten, rel_tol=_NEAR) for ten in (10, 0.1))
    return count >= _FEWEST_DIGITS and ((sorted(mine) == sorted(right) and is_exchanged) or is_shifted)


def has_one_digit_wrong(typed: float, exact: float, node: Formula) -> bool:
    """Tell whether a printed number is another but for one digit; the last one may differ by rounding.

    >>> has_one_digit_wrong(655, 555.2, Number(655)), has_one_digit_wrong(556, 555.2, Number(556))
    (True, False)
    """
    count = len(_digits(node))
    mine, right = (f"{size:.{max(count - 1, 0)}e}" for size in (typed, exact))
    places = [n for n, (a, b) in enumerate(zip(mine, right, strict=False)) if a != b]
    last = mine.index("e") - 1
    return count > _FEWEST_DIGITS and len(places) == 1 and places[0] < last


def _digits(node: Formula) -> str:
    """Return the digits of a printed number that count: those of 9.0 are two, those of 90 one."""
    number = next((part for part in walk(node) if isinstance(part, Number)), None)
    if number is None:
        return ""
    digits = str(abs(round(number.value / (number.last_place or 1)))).lstrip("0")
    has_decimals = number.last_place is not None and number.last_place < 1
    return digits if has_decimals else digits.rstrip("0")
