"""Results as they are printed: units at a result only, and powers of ten as a part of its number.

In √(7² − 2²) = 6.71 in the numbers on the way to the result are in its unit. Whether they are, or in
metres and newtons, their value tells: it is the number printed before the unit, or the quantity itself.
1.8·10⁴ and 9.9 kN are rounded to the last digit printed, as 9900 ± 50 is. A whole number with a unit that
a computation of bare numbers comes to is measured, and rounded too: 8600/9 = 956 lb.
"""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Sequence
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    names,
    walk,
)
from symbalance.notes.reading.equations import Side
from symbalance.notes.reading.formulas.lexer import PERCENT, Token

_CLOSE = 0.005  # of the number printed: a rounded result is nearer than that, another unit is not
_NEAR = 0.25  # of the number printed: a slip in its digits, seldom another unit
_PREFIX = 1000
_HUNDRED = 100
_WAVES = {"sin": math.sin, "cos": math.cos, "tan": math.tan}
_ANGLES = ("asin", "acos", "atan")
_FUNCTIONS = {
    **_WAVES, "sqrt": math.sqrt, "exp": math.exp, "ln": math.log, "asin": math.asin, "acos": math.acos,
    "atan": math.atan, "sinh": math.sinh, "cosh": math.cosh, "tanh": math.tanh,
}  # fmt: skip


def in_unit_of_result(
    sides: Sequence[Side | None], tokens: Sequence[Sequence[Token]], text: str = ""
) -> tuple[list[Side | None], list[str]]:
    """Return the sides of a chain, bare numbers before a result in the result's unit, and what to say.

    `text` is the page: 572 in a product is in kN where "572 kN" stands above.
    """
    done, notes = list(sides), []
    for place, side in enumerate(sides):
        unit = _unit_of(tokens[place]) if side is not None else None
        if side is None or unit is None:
            continue
        printed, factor = unit
        for before in range(place - 1, -1, -1):
            other = done[before]
            if other is None or not _is_bare(other.node, tokens[before]):
                break
            if not isinstance(factor, Number) and _is_angle(other.node):
                break  # arcsin 0.15 is in radians, whatever is printed behind it
            value = value_of(other.node)
            if value is None or not _is_meant(value, printed, _size(factor)):
                break
            if _is_percentage(tokens[place]) and not _is_of_hundreds(other.node):
                break
            is_prefix = _size(factor) in (1e3, 1e6, 1e9)
            if is_prefix and abs(printed) >= _PREFIX and not _is_printed_with(other, _size(factor), text):
                break  # 1800 kN for 1800 N is a slip that is made: who computes in kN has 1.8
            readings = tuple(Product((reading, factor), span=reading.span) for reading in other.readings)
            done[before] = replace(other, readings=readings)
            notes = ["numbers before a result are in its unit"]
    return done, notes


def without_unit_of_result(side: Side) -> Formula:
    """Return an arithmetic as typed, without the unit of the result behind it that it was read in."""
    node = side.node
    if not isinstance(node, Product) or len(node.factors) != 2:
        return node
    arithmetic, unit = node.factors
    is_read_in = unit.span == (0, 0) or not side.span[0] <= unit.span[0] < side.span[1]
    return arithmetic if is_read_in else node


def _is_printed_with(side: Side, size: float, text: str) -> bool:
    """Tell whether a number of an arithmetic stands above with such a unit: 572 kN, then 3·572."""
    start, prefix = side.span[0], {1e3: "k", 1e6: "M", 1e9: "G"}[size]
    for part in walk(side.node):
        if not isinstance(part, Number) or part.span is None or abs(part.value) < _HUNDRED:
            continue
        digits = re.escape(text[part.span[0] : part.span[1]].strip())
        unit = rf"(?:[ ~$]|\\[,;: ]|\\[a-z]{{4,7}}\{{){{0,4}}{prefix}(?:N|W|J|Pa)"
        if digits and re.search(rf"(?<![0-9.,]){digits}{unit}", text[:start]):
            return True
    return False


def _is_percentage(tokens: Sequence[Token]) -> bool:
    return any(token.kind == "number" and token.value == PERCENT for token in tokens)


def _is_of_hundreds(node: Formula) -> bool:
    """Tell whether an arithmetic comes to hundredths: 12/15 · 100 = 80 %, 100 - 20 = 80 %, not 12/15."""
    if isinstance(node, Sum):
        return all(abs(value_of(term) or 0) >= 1 for term in node.terms)
    numbers = [part for part in walk(node) if isinstance(part, Number)]
    return any(abs(number.value) == _HUNDRED for number in numbers)


def with_rounded_results(
    sides: Sequence[Side | None], tokens: Sequence[Sequence[Token]], signs: Sequence[str]
) -> list[Side | None]:
    """Return the sides of a chain, a whole result with a unit as a number rounded to its units.

    Behind = it has three digits, and its closing zeros beyond these are open; behind ≈, and behind an
    arithmetic of decimals, which are measured, two will do, and before a power of ten, 133·10³, too.
    """
    done = list(sides)
    for place, side in enumerate(sides):
        before = sides[place - 1] if place else None
        if side is None or before is None or not _is_bare(before.node, tokens[place - 1]):
            continue
        number, factor, is_of_tens = _whole_result(tokens[place])
        value = value_of(before.node)
        is_rough = signs[place - 1] == "≈" or _is_measured(before.node) or is_of_tens
        fewest = _FEWEST_DIGITS[is_rough]
        digits = str(abs(number.value.numerator)) if number else ""
        if number is None or value is None or not fewest <= len(digits) <= _MOST_DIGITS:
            continue
        zeros = min(len(digits) - len(digits.rstrip("0")), len(digits) - fewest)
        step = Fraction(10**zeros)
        printed = float(number.value)
        scales = [1.0, float(factor)]
        if any(0 < abs(value - printed * scale) <= 0.5 * float(step) * scale for scale in scales):
            rounded = Number(number.value * factor, step * factor, span=side.node.span)
            done[place] = replace(side, readings=(rounded,))
    return done


def _is_measured(node: Formula) -> bool:
    """Tell whether an arithmetic is a product or a quotient that holds decimals."""
    holds_decimal = any(isinstance(part, Number) and part.last_place is not None for part in walk(node))
    return holds_decimal and isinstance(node, Product | Quotient)


_FEWEST_DIGITS = {False: 3, True: 2}
_MOST_DIGITS = 9


def _whole_result(tokens: Sequence[Token]) -> tuple[Number | None, Fraction, bool]:
    """Return the whole number of 956 lb or -956·10³ kg, and what multiplies it: a power of ten too?"""
    is_negative = bool(tokens) and tokens[0].is_op("-")
    rest = tokens[1:] if is_negative else tokens
    first = rest[0] if rest else None
    if (
        first is None
        or first.kind != "number"
        or first.place is not None
        or first.number.denominator != 1
    ):
        return None, Fraction(1), False
    power, unit = _power_of_ten(rest[1:])
    scale = first.scale or (unit[1].number if power and unit else Fraction(1))
    is_result = bool(power or first.scale) and scale != 0
    if not is_result or [token.kind for token in unit] not in ([], _IN_BRACES):
        return None, Fraction(1), False
    number = Number(-first.number if is_negative else first.number)
    return number, scale * (power or 1), power is not None and power > 1


def as_printed(side: Side, tokens: Sequence[Token]) -> Side:
    """Return a side that is one decimal times a power of ten or a unit as the number that these make."""
    units = {token.scale for token in tokens if token.scale}
    return side.changed(lambda node: _one_number(node, units))


def _one_number(node: Formula, units: Collection[Fraction]) -> Formula:
    if isinstance(node, Negative):
        return replace(node, operand=_one_number(node.operand, units))
    if not isinstance(node, Product):
        return node
    decimal = [part for part in node.factors if isinstance(part, Number) and part.last_place is not None]
    scales = [_scale(part, units) for part in node.factors if part not in decimal]
    if len(decimal) != 1 or None in scales:
        return node
    scale = math.prod((part for part in scales if part is not None), start=Fraction(1))
    place = decimal[0].last_place
    return Number(decimal[0].value * scale, place * scale if place else None, span=node.span)


def _scale(node: Formula, units: Collection[Fraction]) -> Fraction | None:
    """Return what a unit or a power of ten multiplies a number by, None for anything else."""
    if isinstance(node, Number):
        return node.value if node.value in units else None
    if not isinstance(node, Power) or node.base != Number(Fraction(10)):
        return None
    exponent, sign = node.exponent, 1
    if isinstance(exponent, Negative):
        exponent, sign = exponent.operand, -1
    if isinstance(exponent, Number) and exponent.value.denominator == 1 and abs(exponent.value) < 40:
        return Fraction(10) ** (sign * int(exponent.value))
    return None


def _unit_of(tokens: Sequence[Token]) -> tuple[float, Formula] | None:
    """Return the number of 6.71 in or 120° as printed, and what its unit multiplies it by."""
    rest = [token for token in tokens if not token.is_op("-")]
    if not rest or rest[0].kind != "number" or len(tokens) - len(rest) > 1:
        return None
    sign = -1 if len(rest) < len(tokens) else 1
    scale = rest[0].scale
    if scale not in (None, 0, 1) and [token.kind for token in rest[1:]] == _IN_BRACES:
        return sign * float(rest[0].number), Number(Fraction(scale or 1))
    power, behind = _power_of_ten(rest[1:])
    if power is not None and [token.kind for token in behind] == _IN_BRACES:
        return sign * float(rest[0].number * power), Number(behind[1].number)
    if len(rest) == 2 and rest[1].kind == "degree":
        return sign * float(rest[0].number), Quotient(Constant("pi"), Number(Fraction(180)))
    return _unit_of_power(tokens)


_POWER_OF_TEN = ("number", "op", "number", "sup")


def _unit_of_power(tokens: Sequence[Token]) -> tuple[float, Formula] | None:
    """Return the number of 40.9 × 10³ lb as printed, and what its unit multiplies it by."""
    kinds = tuple(token.kind for token in tokens)
    has_unit = kinds[-3:] == ("open", "number", "close") and tokens[-4].scale is not None
    if kinds[:4] != _POWER_OF_TEN or not has_unit or tokens[2].number != _TEN or not tokens[1].is_op("*"):
        return None
    exponent = [token for token in tokens[4:-3] if token.kind not in ("open", "close")]
    is_negative = bool(exponent) and exponent[0].is_op("-")
    digits = exponent[is_negative:]
    if [token.kind for token in digits] != ["number"] or not digits[0].number < _LARGEST_POWER:
        return None
    power = (-1 if is_negative else 1) * float(digits[0].number)
    return float(tokens[0].number) * 10.0**power, Number(tokens[-2].number)


_TEN, _LARGEST_POWER = 10, 40


_IN_BRACES = ["open", "number", "close"]
_MOST_TENS = 30


def _power_of_ten(tokens: Sequence[Token]) -> tuple[Fraction | None, Sequence[Token]]:
    """Return the power of ten that tokens begin with, × 10^6 of 4.69 × 10^6, and what stands behind."""
    is_times_ten = len(tokens) > 3 and tokens[0].is_op("*") and tokens[2].kind == "sup"
    if not is_times_ten or tokens[1].kind != "number" or tokens[1].number != 10:
        return None, tokens
    kinds = [token.kind for token in tokens[3:]]
    if kinds[:1] == ["number"]:
        exponent, behind = tokens[3].number, tokens[4:]
    elif kinds[:3] == _IN_BRACES:
        exponent, behind = tokens[4].number, tokens[6:]
    elif kinds[:4] == ["open", "op", "number", "close"] and tokens[4].is_op("-"):
        exponent, behind = -tokens[5].number, tokens[7:]
    else:
        return None, tokens
    if exponent.denominator != 1 or abs(exponent) > _MOST_TENS:
        return None, tokens
    return Fraction(10) ** int(exponent), behind


def _is_bare(node: Formula, tokens: Sequence[Token]) -> bool:
    """Tell whether a side holds numbers without any letter or unit, but for the angles of its waves."""
    waves = [part.span for part in walk(node) if isinstance(part, Call) and part.function in _WAVES]
    return not names(node) and not any(
        token.scale is not None
        or (token.kind == "degree" and not any(start <= token.start < end for start, end in waves))
        for token in tokens
    )


def _is_angle(node: Formula) -> bool:
    """Tell whether an arithmetic holds an angle by its sine, cosine or tangent."""
    return any(isinstance(part, Call) and part.function in _ANGLES for part in walk(node))


def _is_meant(value: float, printed: float, size: float) -> bool:
    """Tell whether a value is in the unit printed: it agrees there, or nearly and nowhere else."""
    if _agree(value, printed * size):
        return False
    if _agree(value, printed) or not value or not printed:
        return _agree(value, printed)
    far = not 0.5 < abs(printed * size / value) < 2
    shift = round(math.log10(abs(value / printed)))
    if shift and _agree(value, printed * 10.0**shift):  # the digits are right: a slip by a power of ten
        return abs(math.log10(abs(value / printed))) < abs(math.log10(abs(value / (printed * size))))
    return far and abs(value - printed) <= _NEAR * abs(printed)


def _agree(value: float, printed: float) -> bool:
    return abs(value - printed) <= _CLOSE * abs(printed)


def _size(factor: Formula) -> float:
    return float(factor.value) if isinstance(factor, Number) else math.pi / 180


def value_of(node: Formula) -> float | None:
    """Return about what a formula without letters is, None for anything unusual."""
    try:
        return _plain_value(node)
    except (ArithmeticError, ValueError):
        return None


def _plain_value(node: Formula) -> float:
    if isinstance(node, Number):
        return float(node.value)
    if isinstance(node, Sum):
        return math.fsum(_plain_value(term) for term in node.terms)
    if isinstance(node, Product):
        return math.prod(_plain_value(factor) for factor in node.factors)
    if isinstance(node, Quotient):
        return _plain_value(node.numerator) / _plain_value(node.denominator)
    return -_plain_value(node.operand) if isinstance(node, Negative) else _value_of_power(node)


def _value_of_power(node: Formula) -> float:
    if isinstance(node, Power):
        exponent = _plain_value(node.exponent)
        if abs(exponent) > 100:
            raise ValueError(exponent)
        result = _plain_value(node.base) ** exponent
        if isinstance(result, complex):
            raise ValueError(result)
        return result
    if isinstance(node, Call) and node.function in _FUNCTIONS:
        return _FUNCTIONS[node.function](_plain_value(node.argument))
    if node == Constant("pi"):
        return math.pi
    raise ValueError(node)
