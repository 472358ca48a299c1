"""Reading of measured numbers, with any number of digits, as fractions or floats."""

from __future__ import annotations

import re
from fractions import Fraction
from math import isfinite
from typing import Any

from symbalance.errors import SymbalanceError, brief
from symbalance.text.numbers import exact

SMALLEST, LARGEST = Fraction(1, 10**12), Fraction(10**12)
_NUMBER = re.compile(r"\s*[+-]?(?:\d{1,30}(?:\.\d{0,30})?|\.\d{1,30})(?:[eE][+-]?\d{1,3})?\s*", re.ASCII)


def measurement(value: Any, name: str) -> Fraction:
    """Return a number of any length: a measured value, or one that was computed.

    >>> float(measurement("1.013250000000000028e+00", "bar")), measurement(0.1, "bar")
    (1.01325, Fraction(1, 10))
    """
    text = value
    if not isinstance(value, str | bool | Fraction) and hasattr(value, "__float__"):
        number = float(value)
        text = repr(number) if isfinite(number) else value
    if isinstance(text, str) and _NUMBER.fullmatch(text):
        return Fraction(text)
    return value if isinstance(value, Fraction) else exact(value, name)


def as_float(value: Any, name: str) -> float:
    """Return a measured number as a double, read as strictly as `measurement` and many times faster.

    >>> as_float(" 1.25e1", "bar")
    12.5
    """
    if isinstance(value, str) and _NUMBER.fullmatch(value):
        return float(value)
    return float(measurement(value, name))


def positive_float(value: object, name: str) -> float:
    """Return a number above 0 as a float, or refuse: also one whose square leaves the doubles."""
    number = measurement(value, name)
    if number <= 0:
        raise SymbalanceError(f"{name} = {brief(value)}", "must be positive", "check the value")
    if not SMALLEST <= number <= LARGEST:
        rule = f"must lie within {float(SMALLEST):g} and {float(LARGEST):g}"
        raise SymbalanceError(f"{name} = {brief(value)}", rule, "check the value, and its unit")
    return float(number)
