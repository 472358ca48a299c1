"""Exact reading of numbers as fractions: whole, decimal ("13.5") or fraction ("360/7").

Text is matched against one pattern and never evaluated. Floats are read as they print, so that
0.1 is one tenth. Size limits stand here, so that no input can make exact arithmetic hang; that of
angles, whose denominators are the order of the field everything is exact in, stands in `angles`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from decimal import Decimal
from fractions import Fraction
from numbers import Rational
from numbers import Real as RealNumber
from operator import index
from typing import Any

from symbalance.errors import SymbalanceError, brief, literal
from symbalance.text.reals import Real, nstr

LONGEST_TEXT = 250
LARGEST = 10**9
LARGEST_DENOMINATOR = 10**12
"""Of a fraction, its factors 2 and 5 left out: a sum's denominator grows by the factors that differ."""
FINEST_DECIMAL = 10**40
"""Of any number as it is written: a double above 1e-24 prints no more decimals, whatever computed it."""
LARGEST_QUOTIENT = 10**100
"""Of a quotient of sizes, such as the rod ratio, and of a design's shares."""
_PART = r"[+-]?(?:\d{1,110}(?:\.\d{0,110})?|\.\d{1,110})(?:[eE][+-]?\d{1,3})?"
_NUMBER = re.compile(rf"\s*({_PART})\s*(?:/\s*({_PART})\s*)?", re.ASCII)


def exact(value: object, name: str, finest: int | None = None) -> Fraction:
    """Return `value` as the fraction it says; `name` is what an error calls it.

    Decimals may have 40 places, so that every float of a usual size is read, and fractions a denominator
    up to 10^12; `finest` is the largest denominator allowed instead.

    >>> exact("360/7", "throw"), exact(0.1, "station"), exact("147.15/36.65", "ratio")
    (Fraction(360, 7), Fraction(1, 10), Fraction(2943, 733))
    >>> exact("nan", "throw")  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    symbalance.errors.SymbalanceError: throw = nan: must be a number or a fraction; ...
    """
    number = _read(value)
    if number is None and hasattr(value, "_mpf_"):
        rule = "prints as many digits as mpmath's working precision happens to have"
        if isinstance(value, Real):
            rule = f"is rounded to {value.digits} digits, and no size as it was written"
        remedy = 'give a float, a fraction, or text such as "0.1"'
        raise SymbalanceError(f"{name} = {brief(value)}", rule, remedy)
    if number is None:
        raise SymbalanceError(
            f"{name} = {brief(value)}",
            "must be a number or a fraction",
            'write it like 120, 13.5 or "360/7"',
        )
    if abs(number) > LARGEST or _is_too_fine(number.denominator, finest):
        fine = "40 decimals, or a denominator up to 10^12"
        if finest is not None:
            fine = f"a denominator up to 10^{len(str(finest)) - 1}"
        remedy = "check the unit" if abs(number) > LARGEST else "write fewer digits"
        rule = f"must lie within {-LARGEST} and {LARGEST} with {fine}"
        raise SymbalanceError(f"{name} = {brief(value)}", rule, remedy)
    return number


def _is_too_fine(denominator: int, finest: int | None) -> bool:
    if denominator > (FINEST_DECIMAL if finest is None else finest):
        return True
    if finest is not None or denominator <= LARGEST_DENOMINATOR:
        return False
    for prime in (2, 5):
        while denominator % prime == 0:
            denominator //= prime
    return denominator > LARGEST_DENOMINATOR


def _read(value: object) -> Fraction | None:
    if isinstance(value, bool):
        return None
    if isinstance(value, Rational):
        return Fraction(int(value.numerator), int(value.denominator))
    if isinstance(value, str):
        return _from_text(value)
    if isinstance(value, float | Decimal) or _prints_itself(value):
        return _from_text(str(value))
    numerator, denominator = getattr(value, "p", None), getattr(value, "q", None)
    if isinstance(numerator, int) and isinstance(denominator, int):  # a SymPy rational
        return Fraction(numerator, denominator)
    return None


def _prints_itself(value: object) -> bool:
    """Tell whether a number of another package prints all it holds: NumPy's floats, SymPy's."""
    return isinstance(value, RealNumber) and type(value).__module__.split(".")[0] in ("numpy", "sympy")


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
            f"{name} = {literal(value)}", f"must be a whole number from {lowest} to {highest}", remedy
        )
    return number


def as_list(values: Any, name: str, example: str = "[0, 120, 240]") -> list[Any]:
    """Return several values as a list; text and tables are refused, being no list of values.

    >>> as_list((0, 120, 240), "throws")
    [0, 120, 240]
    """
    if isinstance(values, str | bytes | dict) or not isinstance(values, Iterable):
        raise SymbalanceError(f"{name} = {brief(values)}", "must be a list", f"as in {example}")
    return list(values)


def evenly_spaced(
    first: Fraction, last: Fraction, step: Fraction, *, most: int, what: str, things: str, remedy: str
) -> list[Fraction]:
    """Return first, first + step, and so on to last; more than `most` are refused, none made.

    `what` asks for them, and `things` is what they are, as the refusal says.

    >>> limit = {"most": 100, "what": "--rpm", "things": "speeds", "remedy": "take a larger step"}
    >>> [str(x) for x in evenly_spaced(Fraction(1), Fraction(2), Fraction(2, 5), **limit)]
    ['1', '7/5', '9/5']
    """
    steps = int((last - first) / step)
    if steps >= most:
        raise SymbalanceError(what, f"asks for more than {most} {things}", remedy)
    return [first + step * k for k in range(steps + 1)]


LONGEST_SHOWN = 10**6
"""A larger denominator says less to a reader than decimals do."""


def short_text(number: Fraction, ellipsis: str = "…") -> str:
    """Return a fraction as tables print it: itself, or decimals cut off where it is long.

    >>> short_text(Fraction(2943, 733)), short_text(Fraction(13948372433243415, 3997776196302304))
    ('2943/733', '3.489032839…')
    """
    if number.denominator <= LONGEST_SHOWN:
        return str(number)
    whole = str(int(abs(number)))
    places = max(10 - len(whole), 0)
    digits = str(int(abs(number) * 10**places)).zfill(places + 1)
    sign = "-" if number < 0 else ""
    return sign + (f"{digits[:-places]}.{digits[-places:]}" if places else digits) + ellipsis


def decimal_text(value: Real, digits: int) -> str:
    """Return a decimal to so many significant digits, exact zero as "0".

    >>> from symbalance.text.reals import Real
    >>> decimal_text(Real(1) / 3, 5), decimal_text(Real(0), 5)
    ('0.33333', '0')
    """
    return nstr(value, digits, min_fixed=-4, max_fixed=digits) if value else "0"
