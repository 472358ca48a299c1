"""Numbers as people write them, read exactly: whole, decimal ("13.5") or fraction ("360/7").

Text is matched against one pattern and never evaluated. Floats are read as they print, so that
0.1 is one tenth. Size limits stand here, so that no input can make exact arithmetic hang.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from decimal import Decimal
from fractions import Fraction
from numbers import Rational
from operator import index
from typing import Any

from mpmath import mp

from symbalance.errors import SymbalanceError, shown, written

Real = Any
"""A decimal of many digits, an mpmath `mpf`: mpmath ships no types."""

LONGEST_TEXT = 200
LARGEST = 10**9
LARGEST_DENOMINATOR = 10**12
_PART = r"[+-]?(?:\d{1,30}(?:\.\d{0,30})?|\.\d{1,30})(?:[eE][+-]?\d{1,2})?"
_NUMBER = re.compile(rf"\s*({_PART})\s*(?:/\s*({_PART})\s*)?", re.ASCII)


def exact(value: object, name: str, finest: int = LARGEST_DENOMINATOR) -> Fraction:
    """Return `value` as the fraction it says; `name` is what an error calls it.

    `finest` is the largest denominator allowed.

    >>> exact("360/7", "throw"), exact(0.1, "station"), exact("147.15/36.65", "ratio")
    (Fraction(360, 7), Fraction(1, 10), Fraction(2943, 733))
    >>> exact("nan", "throw")  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    symbalance.errors.SymbalanceError: throw = nan: must be a number or a fraction; ...
    """
    number = _read(value)
    if number is None:
        raise SymbalanceError(
            f"{name} = {shown(value)}",
            "must be a number or a fraction",
            'write it like 120, 13.5 or "360/7"',
        )
    if abs(number) > LARGEST or number.denominator > finest:
        digits = len(str(finest)) - 1
        raise SymbalanceError(
            f"{name} = {shown(value)}",
            f"must lie within {-LARGEST} and {LARGEST} with a denominator up to 10^{digits}",
            "check the unit",
        )
    return number


def _read(value: object) -> Fraction | None:
    if isinstance(value, bool):
        return None
    if isinstance(value, Rational):
        return Fraction(int(value.numerator), int(value.denominator))
    if isinstance(value, str):
        return _from_text(value)
    if isinstance(value, float | Decimal):
        return _from_text(str(value))
    numerator, denominator = getattr(value, "p", None), getattr(value, "q", None)
    if isinstance(numerator, int) and isinstance(denominator, int):  # a SymPy rational
        return Fraction(numerator, denominator)
    return None


def _from_text(text: str) -> Fraction | None:
    match = _NUMBER.fullmatch(text) if len(text) <= LONGEST_TEXT else None
    if match is None:
        return None
    numerator, denominator = match.groups()
    below = Fraction(denominator) if denominator else Fraction(1)
    return Fraction(numerator) / below if below else None


def whole(value: Any) -> int | None:
    """Return a whole number (NumPy's too) as an int, and None for anything else, True and False included.

    >>> whole(12), whole(12.0), whole(True)
    (12, None, None)
    """
    if isinstance(value, bool):
        return None
    try:
        return index(value)
    except TypeError:
        return None


def checked_whole(value: Any, name: str, lowest: int, highest: int, remedy: str) -> int:
    """Return a whole number of a range, or refuse.

    >>> checked_whole(12, "order", 1, 1000, "12 is usual")
    12
    """
    number = whole(value)
    if number is None or not lowest <= number <= highest:
        raise SymbalanceError(
            f"{name} = {written(value)}", f"must be a whole number from {lowest} to {highest}", remedy
        )
    return number


def listed(values: Any, name: str, example: str = "[0, 120, 240]") -> list[Any]:
    """Return several values as a list; text and tables are refused, being no list of values.

    >>> listed((0, 120, 240), "throws")
    [0, 120, 240]
    """
    if isinstance(values, str | bytes | dict) or not isinstance(values, Iterable):
        raise SymbalanceError(f"{name} = {shown(values)}", "must be a list", f"as in {example}")
    return list(values)


def real(value: int | Fraction) -> Real:
    """Return a rational as an mpmath number, rounded once to the working precision.

    >>> real(Fraction(1, 4))
    mpf('0.25')
    """
    return mp.mpf(value.numerator) / value.denominator


def decimal_text(value: Real, digits: int) -> str:
    """Return an mpmath number to so many significant digits, exact zero as "0".

    >>> from mpmath import mpf
    >>> decimal_text(mpf(1) / 3, 5), decimal_text(mpf(0), 5)
    ('0.33333', '0')
    """
    return str(mp.nstr(value, digits, min_fixed=-4, max_fixed=digits)) if value else "0"
