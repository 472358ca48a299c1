r"""Values listed as multiples of one length or angle: z = ±a/2, ±3a/2; n = ½, 1, 1½, …; θ = 0, π/2, π.

A letter that runs through them has no single value; what is known of it is the smallest and the largest.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from symbalance.notes.reading.signs import VULGAR
from symbalance.text import lazy_patterns as re

_INTEGER = r"[0-9]{1,4}"
_DECIMAL = rf"{_INTEGER}(?:\.[0-9]{{1,4}})?"
_SIGNS_OF_HALVES = "".join(VULGAR)
_LETTER = (
    r"(?:\\(?!pm|mp|dots|ldots|cdot|times|text|mathrm|quad|qquad|frac|tfrac|dfrac)[a-z]{2,8}(?![A-Za-z])"
    r"|[^\W\d_](?![^\W\d_]))(?:_\{\w{1,4}\}|_\w|[₀-₉])?"
)
_DEGREE = r"(?:\s?°|\^\s?\\circ(?![A-Za-z])|\^\s?\{\s?\\circ\s?\})"
_UNIT_OF_LIST = rf"(?:{_DEGREE}|(?:[ ·*]|\\[,;: ]|\\cdot\s?)?{_LETTER})"
_SIGN = r"(?:(?:\\pm(?![A-Za-z])|\\mp(?![A-Za-z])|[-−+±∓])\s?)?"
_BODY = (
    rf"(?:\\[dt]?frac\s?(?:\{{\s?(?:{_DECIMAL}\s?)?(?:{_LETTER})?\s?\}}\s?\{{\s?{_INTEGER}\s?\}}|[0-9]\s?[0-9])"
    rf"(?:{_UNIT_OF_LIST})?"
    rf"|(?:\(\s?{_INTEGER}\s?/\s?{_INTEGER}\s?\)|(?:{_INTEGER})?[{_SIGNS_OF_HALVES}]|{_DECIMAL}(?:\s?/\s?{_INTEGER})?)"
    rf"(?:{_UNIT_OF_LIST}(?:\s?/\s?{_INTEGER})?)?"
    rf"|{_LETTER}(?:\s?/\s?{_INTEGER})?)"
)
VALUE = _SIGN + _BODY
"""One multiple as it is typed: 3a/2, -\\frac{3}{2} a, ±½a, 1½, 0, 90°."""
_PARTS_OF_VALUE = re.compile(rf"(?P<sign>\\pm|\\mp|[-−+±∓])?\s?(?P<body>{_BODY})")
_FRACTION = re.compile(
    rf"\\[dt]?frac\s?(?:\{{\s?(?P<above>{_DECIMAL})?\s?(?P<letter>{_LETTER})?\s?\}}\s?\{{\s?(?P<below>{_INTEGER})\s?\}}"
    r"|(?P<one>[0-9])\s?(?P<two>[0-9]))"
)
_QUOTIENT = re.compile(rf"\(?\s?(?P<above>{_DECIMAL})\s?(?:/\s?(?P<below>{_INTEGER})\s?\)?)?")
_HALVES = re.compile(rf"(?P<whole>{_INTEGER})?(?P<part>[{_SIGNS_OF_HALVES}])")
_LAST_DIVISOR = re.compile(rf"\s?/\s?(?P<below>{_INTEGER})$")
_LEADING_SPACE = re.compile(r"^(?:[ ·*]|\\[,;: ]|\\cdot\s?)+")


class Multiple(NamedTuple):
    """A value as a number of times a letter, "" for a bare number; `is_both` where it has either sign."""

    size: Fraction
    letter: str
    is_both: bool
    is_fraction: bool

    @property
    def sizes(self) -> tuple[Fraction, ...]:
        """Both values of ±, else the one."""
        return (self.size, -self.size) if self.is_both else (self.size,)


def multiple(text: str) -> Multiple | None:
    r"""Return a typed value as a multiple of one letter, None where it is none.

    >>> [str(multiple(v).size) for v in (r"\pm 3a/2", r"\frac{5a}{2}", "−½ a", "1½", r"-\tfrac32\pi")]
    ['3/2', '5/2', '-1/2', '3/2', '-3/2']
    """
    match = _PARTS_OF_VALUE.fullmatch(text.strip())
    if match is None:
        return None
    sign, body = match["sign"] or "", match["body"].strip()
    number = _number(body)
    if number is None:
        return None
    size, rest = number
    divisor = _LAST_DIVISOR.search(rest)
    if divisor is not None:
        if int(divisor["below"]) == 0:
            return None
        size, rest = size / int(divisor["below"]), rest[: divisor.start()]
    letter = _LEADING_SPACE.sub("", rest).strip()
    is_fraction = size.denominator > 1 and "." not in body
    return Multiple(
        -size if sign in ("-", "−") else size, letter, sign in ("±", "∓", "\\pm", "\\mp"), is_fraction
    )


def is_multiple(text: str) -> bool:
    """Tell whether a value is no bare letter, and no bare number: 3a, a/2, ±a.

    >>> is_multiple("3a/2"), is_multiple("-a"), is_multiple("r"), is_multiple("0")
    (True, True, False, False)
    """
    part = multiple(text)
    return part is not None and part.letter != "" and re.fullmatch(_LETTER, text.strip()) is None


def _number(body: str) -> tuple[Fraction, str] | None:
    """Return the number that a value begins with, 1 where none is typed, and what stands behind it."""
    if match := _FRACTION.match(body):
        above = Fraction(match["one"] or match["above"] or 1)
        below = int(match["two"] or match["below"])
        if below == 0 or (match["letter"] is None and match["above"] is None and match["one"] is None):
            return None
        return above / below, (match["letter"] or "") + body[match.end() :]
    if match := _HALVES.match(body):
        return Fraction(match["whole"] or 0) + Fraction(*VULGAR[match["part"]]), body[match.end() :]
    if match := _QUOTIENT.match(body):
        below = int(match["below"] or 1)
        return (Fraction(match["above"]) / below, body[match.end() :]) if below else None
    return Fraction(1), body


def range_of(letter: str, values: list[str], *, is_endless: bool = False) -> str | None:
    r"""Return the range that holds a letter's listed values, None where they are no such list.

    >>> range_of("z", [r"\pm a/2", r"\pm 3a/2"]), range_of("n", ["1/2", "1", "3/2"], is_endless=True)
    ('-3a/2 ≤ z ≤ 3a/2', 'n ≥ 1/2')
    >>> range_of("x", ["a", "b"]) is None, range_of("λ", ["1/4", "3000"]) is None
    (True, True)
    """
    parts = [multiple(value) for value in values]
    known = [part for part in parts if part is not None]
    letters = {part.letter for part in known if part.size != 0 or part.letter}
    if len(known) < len(parts) or len(letters) > 1:
        return None
    unit = next(iter(letters), "")
    sizes = [part.size for part in known]
    spread = sizes + [-part.size for part in known if part.is_both]
    if min(spread) == max(spread):
        return None
    is_signed = any(part.is_both for part in known)
    if not unit and not is_signed and not _is_run(known):
        return None  # λ = 1/4, 3000 rpm: the speed is another quantity
    if is_endless:
        is_rising = sizes == sorted(sizes) and not is_signed
        return f"{letter} ≥ {written(sizes[0], unit)}" if is_rising else None
    return f"{written(min(spread), unit)} ≤ {letter} ≤ {written(max(spread), unit)}"


def _is_run(parts: list[Multiple]) -> bool:
    """Tell whether bare numbers, fractions among them, rise or fall by like steps."""
    sizes = [part.size for part in parts]
    steps = [after - before for before, after in pairwise(sizes)]
    one_way = all(step > 0 for step in steps) or all(step < 0 for step in steps)
    is_even = max(map(abs, steps)) <= _MOST_UNEVEN * min(map(abs, steps)) if one_way else False
    has_fraction = any(part.is_fraction for part in parts)
    return is_even and has_fraction and (len(parts) > 2 or all(part.is_fraction for part in parts))


_MOST_UNEVEN = 4


def written(size: Fraction, unit: str) -> str:
    """Return a multiple as a formula that can be read in one way only: 3a/2, and not 3/2a."""
    if size == 0 and not is_of_degrees(unit):
        return "0"
    above, below = size.numerator, f"/{size.denominator}" if size.denominator > 1 else ""
    is_one = abs(above) == 1 and unit and not is_of_degrees(unit)
    number = str(above).removesuffix("1") if is_one else str(above)
    return f"{number}{unit}{below}"


def is_of_degrees(unit: str) -> bool:
    """Tell whether the unit of a multiple is a degree."""
    return _OF_ANGLES.search(unit) is not None


_OF_ANGLES = re.compile(r"(?:°|circ\s?\}?)$")
