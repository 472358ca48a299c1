"""Units of bare numbers by the lines above: 1.590 x 33 is no 52.5 kg m where 33 was 33 mm.

An arithmetic may leave its units out, and its result name one. Where numbers of it stand above with their
units, the result has to be in these: its number may be right and its unit a thousand times too large.
"""

from __future__ import annotations

import re
from fractions import Fraction
from math import isclose, log10

from symbalance.document.formula import Call, Formula, Negative, Number, Power, Product, Quotient, names
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.units.conversions import quantity_of, scale_of, sign_of_unit
from symbalance.notes.checking.units.dimensions import NONE, Dimension, unit_of, unit_text
from symbalance.notes.checking.units.printed_units import without_unit_of_result
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.notes.reading.formulas.result_units import value_of

NEAR = 700
"""Characters above in which a number's unit is looked for."""
MOST_COUNTED = 20
"""A whole number up to this may count something or come from a formula."""
_UNITS = 3
"""Words that a unit has at most: kg m s⁻¹."""
_MARKUP = re.compile(r"\\(?:mathrm|text|textrm|mbox|,|;|:|!|[ ]|quad|ensuremath)|[~${}]|</?[a-z]+>")
_EXPONENT = re.compile(r"\$?\^\{?([-−]?[0-9])\}?\$?")
"""The exponent of a unit, which may stand between dollars of its own: s$^{-1}$."""
_NUMERAL = re.compile(r"(?<![\w.,^_])[0-9]+(?:[.,][0-9]+)?(?![0-9])")
_SIGNS = re.compile(r"\\(?:cdot|times|sqrt|[dt]?frac|left|right|,|;|:|!|quad)|(?<![A-Za-z])x(?![A-Za-z])")
_LETTER = re.compile(r"[^\W\d_]|°")
_CLOSE = 1e-9
_KILO = Fraction(1000)


def refuted_by_units_above(chain: Chain, k: int, document: ReadNotes) -> Decision | None:
    """Return that a result is in another unit than its numbers make; None where that is open."""
    left, right = chain.sides[k], chain.sides[k + 1]
    result = quantity_of(right, document)
    unit = None if result is None else unit_of(result.unit)
    bare = without_unit_of_result(left.node, left.span)
    factors = None if result is None or unit is None else _factors(bare)
    if not factors or result is None or unit is None or names(left.node) or unit == NONE:
        return None
    has_units = _LETTER.search(_SIGNS.sub(" ", document.source(left.span))) is not None
    if has_units or any(_is_power_of_ten(value) for value, _ in factors):
        return None  # a power of ten may convert
    above = _numbers_above(document, chain.start)
    above |= _lone_data_above(document, chain, [value for value, _ in factors if value not in above])
    numbers_unit = _made_of(factors, above)
    if numbers_unit is None or numbers_unit[0] != unit:
        if numbers_unit is None:
            return None
        return _of_another_kind(chain, document, factors, above, numbers_unit[0], unit)
    total = value_of(bare)
    is_arithmetic = total is not None and isclose(total, float(result.value), rel_tol=0.01)
    ratio = float(numbers_unit[1] / result.scale)
    powers = log10(ratio)
    if not is_arithmetic or abs(powers) < 1 or abs(powers - round(powers)) > _CLOSE:
        return None
    reason = f"the numbers' units above make it {_times(ratio)} than {result.unit}"
    return Decision(REFUTED, reason)


def _made_of(
    factors: list[tuple[Fraction, int]], above: dict[Fraction, dict[Dimension, Fraction]]
) -> tuple[Dimension, Fraction] | None:
    """Return the dimension and the scale that numbers have together by their units above."""
    dimension, size = NONE, Fraction(1)
    if not any(above.get(value) for value, _ in factors):
        return None
    for value, power in factors:
        known = above.get(value, {})
        if len(known) > 1:
            return None
        for own, scale in known.items():
            dimension = tuple(a + power * b for a, b in zip(dimension, own, strict=True))
            size *= scale**power
    return dimension, size


def _of_another_kind(
    chain: Chain,
    document: ReadNotes,
    factors: list[tuple[Fraction, int]],
    above: dict[Fraction, dict[Dimension, Fraction]],
    numbers_unit: Dimension,
    unit: Dimension,
) -> Decision | None:
    """Return that N times m is no N; None where a number's unit is not sure.

    All of them have to have their units above; the 4 of 4 m r² ω² is in no metres.
    """
    words = document.text[max(0, chain.start - NEAR) : chain.end]
    is_open = _WEIGHTS.search(words) is not None or numbers_unit == NONE
    if is_open or any(value != 1 and not above.get(value) for value, _ in factors):
        return None
    sizes = [(value, power) for value, power in factors if value.denominator > 1 or value > MOST_COUNTED]
    without_counts = _made_of(sizes, above)
    if without_counts is not None and without_counts[0] == unit:
        return None
    witness = {"left": unit_text(numbers_unit), "right": unit_text(unit)}
    return Decision(REFUTED, "the numbers' units above make another unit", witness=witness)


_WEIGHTS = re.compile(r"(?<![A-Za-z])(?:lbs?|lbf|kgf|kp|tf|oz|pounds?|ounces?)(?![A-Za-z])")
"""Units that are weights in one place and masses in another."""


def _times(ratio: float) -> str:
    words = {3: "a thousand times", 6: "a million times"}
    power = round(abs(log10(ratio)))
    return f"{words.get(power, f'{10**power} times')} {'larger' if ratio > 1 else 'smaller'}"


def _factors(node: Formula, power: int = 1) -> list[tuple[Fraction, int]]:
    """Return the numbers of a product or quotient with their powers; none for a sum."""
    match node:
        case Number(value=value) if value > 0:
            return [(value, power)]
        case Negative(operand=operand):
            return _factors(operand, power)
        case Product(factors=parts):
            rows = [_factors(part, power) for part in parts]
            return [pair for row in rows for pair in row] if all(rows) else []
        case Quotient(numerator=above, denominator=below):
            first, second = _factors(above, power), _factors(below, -power)
            return first + second if first and second else []
        case Power(base=Number(value=value), exponent=Number(value=exponent)) if (
            value > 0 and exponent.denominator == 1
        ):
            return [(value, power * int(exponent))]
    is_root = isinstance(node, Call) and node.function == "sqrt" and isinstance(node.argument, Number)
    return [(Fraction(1), 0)] if is_root else []  # √10 is a pure number


def _is_power_of_ten(value: Fraction) -> bool:
    powers = log10(value)
    return value != 1 and isclose(powers, round(powers), abs_tol=_CLOSE)


def _lone_data_above(
    document: ReadNotes, chain: Chain, values: list[Fraction]
) -> dict[Fraction, dict[Dimension, Fraction]]:
    """Return numbers with the units that they have anywhere above, where the page has them nowhere else.

    The spacing 35.0 mm of a table of data is 0.035 in an arithmetic pages below; a 0.035 that stands
    alone somewhere may be any number.
    """
    text = document.text.replace("{,}", ".")
    written = [Fraction(m[0].replace(",", ".")) for m in _NUMERAL.finditer(text)]
    alone = [value for value in values if value.denominator > 1 and written.count(value) == 1]
    if not alone:
        return {}
    above = _numbers_above(document, chain.start, chain.start)
    return {value: above[value] for value in alone if value in above}


def _numbers_above(
    document: ReadNotes, start: int, near: int = NEAR
) -> dict[Fraction, dict[Dimension, Fraction]]:
    """Return the numbers right above a place with the units behind them, 1590 g as 1.590 kg too."""
    text = document.text[max(0, start - near) : start].replace("{,}", ".")
    found: dict[Fraction, dict[Dimension, Fraction]] = {}
    for match in _NUMERAL.finditer(text):
        value = Fraction(match[0].replace(",", "."))
        named = _unit_behind(text[match.end() : match.end() + 40])
        if named is None or not value:
            continue
        dimension, scale = named
        found.setdefault(value, {})[dimension] = scale
        for shift in (_KILO, 1 / _KILO):
            found.setdefault(value * shift, {}).setdefault(dimension, scale / shift)
    return found


def _unit_behind(text: str) -> tuple[Dimension, Fraction] | None:
    """Return the dimension and the scale of the longest unit that a text begins with."""
    text = _EXPONENT.sub(r"^\1", text.split("\n\n", maxsplit=1)[0])
    words = _MARKUP.sub(" ", text).split()
    for count in range(min(_UNITS, len(words)), 0, -1):
        source = " ".join(words[:count]).rstrip(".,;:)")
        dimension = unit_of(source) if source and source[0].isalpha() else None
        scale = scale_of(sign_of_unit(source)) if dimension not in (None, NONE) else None
        if dimension is not None and scale is not None and not scale[1]:
            return dimension, scale[0]
    return None
