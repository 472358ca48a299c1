"""Whole numbers put in that are rounded: τ = 620·10³/32668 = 19.0 MPa, where the modulus is 32667.5 mm³.

A whole number of four digits or more is often a result with its last digit rounded, printed nowhere else.
Put in for a formula it makes the formula's own value only to that digit. It is read so where the
arithmetic makes the number printed, and in the unit printed it is off by no more than its whole numbers.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from math import log10

from symbalance.document.formula import Formula, Number, Product, Quotient, names, walk
from symbalance.notes.checking.deciding.equality import PROVED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.notes.reading.formulas.result_units import value_of, without_unit_of_result

FEWEST_DIGITS = 1000
"""The least whole number that may be rounded."""
DIGITS_PRINTED = "the digits printed"
SAME = 1e-9


def decide_rounded_wholes(
    chain: Chain, k: int, document: ReadNotes, knowledge: Knowledge
) -> Decision | None:
    """Return the proof of numbers put in whose whole numbers are rounded, or of their result."""
    k -= bool(k) and not names(chain.sides[k].node)
    if k + 2 >= len(chain.sides) or not names(chain.sides[k].node) or names(chain.sides[k + 1].node):
        return None
    left, put_in, result = chain.sides[k : k + 3]
    arithmetic = without_unit_of_result(put_in)
    allowed = sum(_half(number) for number in _factors(arithmetic))
    exact, number, printed = number_of(left.node, knowledge), value_of(arithmetic), value_of(result.node)
    if not allowed or exact is None or not number or not printed or printed / number <= 0:
        return None
    unit = 10.0 ** round(log10(printed / number))
    is_result = abs(printed / (number * unit) - 1) <= _open_by(result.node, number)
    is_value = abs(float(exact) / (number * unit) - 1) <= allowed
    return Decision(PROVED, order=DIGITS_PRINTED) if is_result and is_value else None


def _open_by(result: Formula, number: float) -> float:
    """Return by what part of itself a printed result may be rounded."""
    places = [
        float(part.last_place / 2 / abs(part.value))
        for part in walk(result)
        if isinstance(part, Number) and part.last_place is not None and part.value
    ]
    return max(places, default=0.5 / abs(number)) * (1 + SAME)


def _factors(node: Formula) -> Iterator[Number]:
    """Yield the numbers that an arithmetic multiplies and divides by."""
    if isinstance(node, Product):
        for factor in node.factors:
            yield from _factors(factor)
    elif isinstance(node, Quotient):
        yield from _factors(node.numerator)
        yield from _factors(node.denominator)
    elif isinstance(node, Number):
        yield node


def _half(number: Number) -> float:
    """Return by what part of itself a whole number may be rounded; a round one, 3000, is exact."""
    value = number.value
    is_whole = number.last_place is None and value.denominator == 1 and abs(value) >= FEWEST_DIGITS
    return float(Fraction(1, 2) / abs(value)) if is_whole and value % 10 else 0.0
