"""Numbers put in whose units stand in the words before: 4.45 cc over 1.131 cm² is 3.93 cm, not 3.93 mm.

A result of bare numbers is read in the unit printed behind it, as 80/2 = 40 mm is. Where the page gives
each of those numbers its unit right before, the units decide: the same digits in another power of ten are
wrong.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Formula, Number, Product, Quotient
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.units.conversions import is_power_of_ten, quantity_of
from symbalance.notes.checking.units.dimensions import Dimension, unit_of
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.notes.reading.formulas.result_units import without_unit_of_result
from symbalance.notes.reading.spellings.numerals import sign_of_unit
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

NEAREST = 400
"""Characters before a result in which a number with its unit is looked for, in the same paragraph."""
FEWEST_DIGITS = 3
"""That such a number shows, so that it is no other one by chance."""
IN_THEIR_UNITS = "numbers in the units that the words before give them"
_LETTERS = re.compile(r"\\[A-Za-z]+|[^\W\d_]")
_PLAIN = frozenset(("\\frac", "\\dfrac", "\\tfrac", "\\cdot", "\\times", "\\left", "\\right", "\\div"))
_UNIT = (
    r"(?:[ ~$]|\\[,;: ]|\\(?:mathrm|text|si|unit)\s*\{)*"
    r"(?P<unit>[A-Za-zµ]+[²³]?(?:\^\{?[23]\}?)?(?:/[A-Za-z]+[²³]?)?)"
)


def decide_by_printed_units(
    chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the decision on a result of bare numbers by the units that these have in the words before.

    None where a unit is not known, the units do not make that of the result, or its digits are others.
    """
    left, right = chain.sides[k], chain.sides[k + 1]
    result = quantity_of(right, document)
    kind = unit_of(result.unit) if result else None
    source = document.source(left.span)
    if result is None or kind is None or any(m[0] not in _PLAIN for m in _LETTERS.finditer(source)):
        return None
    numbers = _in_units(without_unit_of_result(left), left.span[0], document.text)
    if numbers is None:
        return None
    value, dimension = numbers
    ratio = value / (result.value * result.scale) if result.value else Fraction(0)
    power = _nearest_power(ratio)
    if dimension != kind or power is None:
        return None
    exact = Side((Number(value / result.scale),), left.span)
    there = decide(exact, Side((Number(result.value, 2 * result.half),), right.span), "≈", knowledge)
    if there.is_proved:
        return replace(there, assumptions=(*there.assumptions, IN_THEIR_UNITS))
    if not power:
        return None
    shown = f"{float(value / result.scale):.4g} {result.unit}"
    reason = f"with the units of the numbers in the words before it is {shown}"
    witness = {"left": shown, "right": f"{float(result.value):g} {result.unit}"}
    return Decision(REFUTED, reason, witness=witness)


def _nearest_power(ratio: Fraction) -> int | None:
    """Return the power of ten that a ratio is, but for rounding; None for another ratio."""
    if ratio <= 0:
        return None
    power = 0
    while ratio > 5:
        ratio, power = ratio / 10, power + 1
    while ratio < Fraction(1, 2):
        ratio, power = ratio * 10, power - 1
    return power if abs(ratio - 1) < Fraction(1, 50) else None


def _in_units(node: Formula, before: int, text: str) -> tuple[Fraction, Dimension] | None:
    """Return the value of a product or quotient of numbers with the units that the words give them."""
    value, exponents, count = Fraction(1), [Fraction(0)] * 5, 0
    for number, power in _factors(node):
        if number is None or not number.value:
            return None
        unit = _printed_unit(number, before, text)
        kind = unit_of(unit) if unit else None
        scale = scale_of(sign_of_unit(unit)) if unit else None
        if kind is None or scale is None or scale[1] or not is_power_of_ten(scale[0]):
            return None
        value *= (number.value * scale[0]) ** power
        exponents = [e + power * own for e, own in zip(exponents, kind, strict=True)]
        count += 1
    return (value, tuple(exponents)) if count > 1 else None


def _factors(node: Formula, power: int = 1) -> Iterator[tuple[Number | None, int]]:
    """Yield the numbers of an arithmetic without sums, 1 above a stroke, -1 below it; None for others."""
    if isinstance(node, Product):
        for factor in node.factors:
            yield from _factors(factor, power)
    elif isinstance(node, Quotient):
        yield from _factors(node.numerator, power)
        yield from _factors(node.denominator, -power)
    elif isinstance(node, Number):
        yield node, power
    else:
        yield None, power


def _printed_unit(number: Number, before: int, text: str) -> str:
    """Return the unit that a number has where it is printed right before, "" for none or two."""
    digits = text[number.span[0] : number.span[1]].strip()
    paragraph = text[max(before - NEAREST, 0) : before].rpartition("\n\n")[2]
    is_number = re.fullmatch(r"[0-9]+(?:[.,][0-9]+)?", digits) is not None
    if not is_number or len(re.sub(r"^0*[.,]?0*|[.,]", "", digits)) < FEWEST_DIGITS:
        return ""
    units = {
        match["unit"]
        for match in re.finditer(rf"(?<![\w.,]){re.escape(digits)}(?![0-9]){_UNIT}", paragraph)
    }
    return units.pop() if len(units) == 1 else ""
