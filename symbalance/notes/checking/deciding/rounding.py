"""Agreement of printed decimals with exact values, to the digits they show.

A lone decimal is the result of what stands on the other side, whose own numbers count as exact. Among
letters every coefficient is compared for itself, and may be off by what half a unit in the last place of
each decimal in it brings.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from symbalance.document import formula
from symbalance.document.formula import Formula, Negative, Number
from symbalance.notes.algebra import polynomials as poly
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.harmonics import Components, components
from symbalance.notes.algebra.values import Valuation, context, letters
from symbalance.notes.checking.deciding.substitution import replace_part

LONG = 3
"""A decimal of this many digits on the way to a result may itself be rounded."""


def decimals(node: Formula) -> list[Number]:
    """Return the numbers of a formula that are printed with a decimal point."""
    return [
        part for part in formula.walk(node) if isinstance(part, Number) and part.last_place is not None
    ]


def agrees_as_printed(
    left: Formula, right: Formula, form_of: Callable[[Formula], Form], *, generous: bool = False
) -> bool:
    """Tell whether two sides agree to the last digits printed; `form_of` gives a side's form.

    A lone decimal may be off by half a unit of its last place; by a whole one towards zero if `generous`
    (cut off, not rounded), or if the other side goes through long decimals.
    """
    if not decimals(left) and not decimals(right):
        return False
    first, second = form_of(left), form_of(right)
    if not letters(first) and not letters(second):
        for node, value, exact, other_side in (
            (right, second, first, left),
            (left, first, second, right),
        ):
            lone = _lone_decimal(node, generous) if decimals(node) or decimals(other_side) else None
            if lone is not None:
                numbers = _number(value), _number(exact)
                unit = _unit(node, lone, numbers[0], form_of)
                return _is_rounded(lone, unit, *numbers, decimals(other_side), generous)
    return _coefficients_agree(left, right, first, second, form_of)


def _as_printed(number: Number, generous: bool) -> Number | None:
    """Return a whole number as the result it is: to its units, its closing zeros open if `generous`."""
    if number.value.denominator != 1 or not number.value:
        return None
    digits = str(abs(number.value.numerator))
    zeros = len(digits) - len(digits.rstrip("0")) if generous else 0
    return Number(number.value, Fraction(10**zeros))


def _lone_decimal(node: Formula, generous: bool) -> Number | None:
    """Return the decimal a side consists of, up to its sign and a factor without decimals."""
    if isinstance(node, Negative):
        return _lone_decimal(node.operand, generous)
    if isinstance(node, Number):
        return node if node.last_place is not None else _as_printed(node, generous)
    numbers = decimals(node)
    if not isinstance(node, formula.Product) or len(numbers) != 1 or formula.names(node):
        return None
    return numbers[0] if numbers[0] in node.factors else None


def _number(form: Form) -> Any:
    return Valuation(form.domain, {}).of(form)


def _unit(node: Formula, lone: Number, value: Any, form_of: Callable[[Formula], Form]) -> Any:
    """Return what one unit of a lone decimal's last place comes to in the side that it is."""
    assert lone.last_place is not None
    if lone.value:
        return abs(value) * float(lone.last_place / abs(lone.value))
    return abs(_number(form_of(replace_part(node, lone, Number(lone.last_place)))))


def _is_rounded(
    lone: Number, unit: Any, value: Any, exact: Any, others: list[Number], generous: bool
) -> bool:
    """Tell whether a value is the exact one, rounded; a printed 0.000 stands for half a unit at most."""
    is_loose = any(significant(number) >= LONG for number in others)
    is_loose = is_loose or (generous and abs(value) <= abs(exact))
    return abs(value - exact) <= unit * (1 if is_loose and lone.value else 0.5) * (1 + 1e-12)


def significant(number: Number) -> int:
    """Return how many digits of a decimal count.

    >>> significant(Number(Fraction(1, 25), Fraction(1, 1000)))  # 0.040
    2
    """
    assert number.last_place is not None
    return len(str(abs(number.value / number.last_place).numerator))


def _coefficients_agree(
    left: Formula, right: Formula, first: Form, second: Form, form_of: Callable[[Formula], Form]
) -> bool:
    """Tell whether no coefficient is off by more than half a unit in each decimal's last place brings."""
    if not (first.is_polynomial and second.is_polynomial):
        return False
    domain = first.domain
    left_parts, right_parts = _parts(first), _parts(second)
    margins: dict[Any, Any] = {}
    for side, parts in ((left, left_parts), (right, right_parts)):
        for number in decimals(side):
            assert number.last_place is not None
            off_by_half = Number(number.value + number.last_place / 2, number.last_place)
            parts_off = _parts(form_of(replace_part(side, number, off_by_half)))
            for key in {*parts, *parts_off}:
                change = poly.minus(parts_off.get(key, {}), parts.get(key, {}))
                margins[key] = margins.get(key, 0) + abs(Valuation(domain, {}).polynomial(change))
    for key in {*left_parts, *right_parts}:
        difference = poly.minus(left_parts.get(key, {}), right_parts.get(key, {}))
        if (
            abs(Valuation(domain, {}).polynomial(difference))
            > margins.get(key, 0) * (1 + 1e-12) + _tiny()
        ):
            return False
    return True


def _parts(form: Form) -> Components:
    return components(form.domain, form.numerator)


def _tiny() -> Any:
    return context().mpf(10) ** -25
