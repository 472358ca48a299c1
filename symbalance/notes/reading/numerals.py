"""Numbers as printed: 1024, 4.02, 1.8e-4, 4{,}02, 1\\,024."""

from __future__ import annotations

import re
from fractions import Fraction

from symbalance.notes.reading.failures import ReadingError
from symbalance.notes.reading.tokens import Token

MOST_DIGITS = 400
_THOUSANDS = re.compile(r"[0-9]{1,3}(?:(?:\\,|\{,\}|\u2009|\u202f)[0-9]{3})+(?![0-9])(?:\.[0-9]+)?")
_DECIMAL_COMMA = re.compile(r"[0-9]+\{,\}[0-9]+")
_PLAIN = re.compile(r"(?:[0-9]+(?:\.[0-9]+)?|\.[0-9]+)")
_POWER_OF_TEN = re.compile(r"[eE]([+-]?[0-9]+)(?![A-Za-z0-9])")
_GROUPING = re.compile(r"\\,|\{,\}|\u2009|\u202f")

VULGAR = {
    "½": (1, 2), "⅓": (1, 3), "⅔": (2, 3), "¼": (1, 4), "¾": (3, 4), "⅕": (1, 5), "⅖": (2, 5),
    "⅗": (3, 5), "⅘": (4, 5), "⅙": (1, 6),
    "⅚": (5, 6), "⅛": (1, 8), "⅜": (3, 8), "⅝": (5, 8), "⅞": (7, 8),
}  # fmt: skip


def read_number(text: str, start: int, end: int, scientific: bool = True) -> Token | None:
    """Return the number that begins at `start`, or None.

    >>> read_number("4.02", 0, 4).number, read_number("4.02", 0, 4).place
    (Fraction(201, 50), Fraction(1, 100))
    >>> read_number("1\\\\,024", 0, 6).number
    Fraction(1024, 1)
    """
    if found := _THOUSANDS.match(text, start, end):
        digits, exponent = _GROUPING.sub("", found.group()), None
    elif found := _DECIMAL_COMMA.match(text, start, end):
        digits, exponent = found.group().replace("{,}", "."), None
    elif found := _PLAIN.match(text, start, end):
        digits = found.group()
        exponent = _POWER_OF_TEN.match(text, found.end(), end) if scientific else None
    else:
        return None
    return _token(digits, exponent, start, found.end())


def _token(digits: str, exponent: re.Match[str] | None, start: int, stop: int) -> Token:
    if len(digits) > MOST_DIGITS:
        raise ReadingError(start, f"a number of more than {MOST_DIGITS} digits", "write fewer digits")
    value = Fraction(digits)
    decimals = len(digits.partition(".")[2])
    place = Fraction(1, 10**decimals) if decimals else None
    if exponent:
        scale = _scale(exponent, start)
        value, stop = value * scale, exponent.end()
        place = place * scale if place else None
    return Token("number", digits, start, stop, value, place)


def _scale(exponent: re.Match[str], start: int) -> Fraction:
    digits = exponent.group(1)
    if len(digits) > 4 or abs(int(digits)) > MOST_DIGITS:
        raise ReadingError(start, "a power of ten out of all proportion", "check the exponent")
    return Fraction(10) ** int(digits)
