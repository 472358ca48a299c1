"""Agreement of printed decimals with exact values, to the digits they show.

A lone decimal stands for all that is rounded to it, half a unit of its last place to either side. So does
a decimal of three digits or more that a result is computed from, here or in a line before; shorter ones
are data, taken as exact. A whole number is exact, unless it is the result of an arithmetic with decimals
and has three digits. Among letters every coefficient is compared for itself, and may be off by what half
a unit in the last place of each decimal in it brings.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from typing import Any

from symbalance.document import formula
from symbalance.document.formula import Formula, Negative, Number, names
from symbalance.notes.algebra import polynomials as poly
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.harmonics import Components, components
from symbalance.notes.algebra.tree_values import names_behind
from symbalance.notes.algebra.values import Valuation, context, letters, sample
from symbalance.notes.checking.deciding.substitution import replace_part, substitute

DEEPEST = 12
"""Values that rest on values, one in the other."""
SHORTEST = 2
"""Digits of decimals beside roots, at least, that may be rounded."""
LONGEST = 9
"""Digits of a whole number that a result is rounded to; a longer one is meant as it stands."""
LONG = 3
"""A decimal of this many digits on the way to a result may itself be rounded."""


def decimals(node: Formula) -> list[Number]:
    """Return the numbers of a formula that are printed with a decimal point."""
    return [
        part for part in formula.walk(node) if isinstance(part, Number) and part.last_place is not None
    ]


def agrees_as_printed(
    left: Formula,
    right: Formula,
    form_of: Callable[[Formula], Form],
    values: Mapping[str, Formula] | None = None,
    *,
    generous: bool = False,
) -> bool:
    """Tell whether two sides agree to the last digits printed; `form_of` gives a side's form.

    A lone decimal may be off by half a unit of its last place, and by what the decimals bring that the
    other side is computed from, those of the letters' `values` too; by a whole unit towards zero if
    `generous` (cut off, not rounded).
    """
    left, right = (with_decimals(node, values or {}) for node in (left, right))
    if not decimals(left) and not decimals(right) and not (_is_bare(left) or _is_bare(right)):
        return False
    first, second = form_of(left), form_of(right)
    if not letters(first) and not letters(second):
        for node, value, exact, other_side in (
            (right, second, first, left),
            (left, first, second, right),
        ):
            lone = _lone_decimal(node, other_side, exact, generous)
            other = _lone_decimal(other_side, node, value, generous)
            if lone is None or (other is not None and _is_finer(lone, other)):
                continue  # of two lone decimals the coarser one is the other, rounded
            numbers = _number(value), _number(exact)
            unit = _unit(node, lone, numbers[0], form_of)
            spread = 0 if other is not None else _spread(other_side, numbers[1], form_of)
            return _is_rounded(lone, unit, *numbers, spread, generous)
        if not names(left) and not names(right) and (_is_bare(left) or _is_bare(right)):
            return False  # a whole number beside a decimal
    if not decimals(left) and not decimals(right):
        return False
    return _coefficients_agree(left, right, first, second, form_of)


def with_decimals(node: Formula, values: Mapping[str, Formula]) -> Formula:
    """Return a formula with the letters put in whose values come down to numbers printed in decimals."""
    for _ in range(DEEPEST):
        before = node
        for name in sorted(names(node)):
            value = values.get(name)
            if value is not None and _holds_decimals(value, values):
                try:
                    node = substitute(node, name, value)
                except NoFormError:
                    continue  # a derivative by the letter: it stays one
        if node is before:
            break
    return node


def _holds_decimals(value: Formula, values: Mapping[str, Formula]) -> bool:
    """Tell whether a value holds decimals, also by the letters in it."""
    if decimals(value):
        return True
    return any(decimals(values[name]) for name in names_behind(value, values) if name in values)


def _is_bare(node: Formula) -> bool:
    """Tell whether a side is a number as printed, nothing computed."""
    return isinstance(node.operand if isinstance(node, Negative) else node, Number)


def _is_finer(lone: Number, other: Number) -> bool:
    assert lone.last_place is not None
    assert other.last_place is not None
    return lone.last_place < other.last_place


def _as_printed(number: Number, other_side: Formula, exact: Form, generous: bool) -> Number | None:
    """Return a whole number as the result it is, of decimals or of a number as 120π: to its units.

    Its closing zeros are open behind three digits, 3550 for 3549.5, and all if `generous`.
    """
    is_rounded = decimals(other_side) or exact.rational() is None
    if number.value.denominator != 1 or not number.value or not is_rounded:
        return None
    digits = str(abs(number.value.numerator))
    if not generous and (not LONG <= len(digits) <= LONGEST or _is_bare(other_side)):
        return None
    zeros = len(digits) - len(digits.rstrip("0"))
    if not generous:
        zeros = min(zeros, len(digits) - LONG)
    return Number(number.value, Fraction(10**zeros))


def _lone_decimal(node: Formula, other_side: Formula, exact: Form, generous: bool) -> Number | None:
    """Return the decimal a side consists of, up to its sign and a factor without decimals."""
    if isinstance(node, Negative):
        return _lone_decimal(node.operand, other_side, exact, generous)
    if isinstance(node, Number):
        return node if node.last_place is not None else _as_printed(node, other_side, exact, generous)
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


def _spread(node: Formula, value: Any, form_of: Callable[[Formula], Form]) -> Any:
    """Return how far a side may be off by the long decimals it is computed from, each by half a unit."""
    total = context().mpf(0)
    for number in decimals(node):
        assert number.last_place is not None
        if significant(number) >= LONG:
            off_by_half = Number(number.value + number.last_place / 2, number.last_place)
            total += abs(_number(form_of(replace_part(node, number, off_by_half))) - value)
    return total


def _is_rounded(lone: Number, unit: Any, value: Any, exact: Any, spread: Any, generous: bool) -> bool:
    """Tell whether a value is the exact one, rounded; a printed 0.000 stands for half a unit at most."""
    is_cut_off = generous and bool(lone.value) and abs(value) <= abs(exact)
    return abs(value - exact) <= (unit * (1 if is_cut_off else 0.5) + spread) * (1 + 1e-12)


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
    moved = [[form_of(node) for node in _moved(side)] for side in (left, right)]
    if domain.radicals or domain.opaque:
        # a decimal within a root changes the root: no coefficient can be compared for itself
        if any(significant(number) < SHORTEST for number in (*decimals(left), *decimals(right))):
            return False  # 0.3 would be all between a quarter and 0.35
        return _values_agree(first, second, *moved)
    left_parts, right_parts = _parts(first), _parts(second)
    margins: dict[Any, Any] = {}
    for forms, parts in zip(moved, (left_parts, right_parts), strict=True):
        for parts_off in map(_parts, forms):
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


def _moved(side: Formula) -> Iterator[Formula]:
    """Yield a side with each of its decimals off by half a unit of its last place."""
    for number in decimals(side):
        assert number.last_place is not None
        off_by_half = Number(number.value + number.last_place / 2, number.last_place)
        yield replace_part(side, number, off_by_half)


def _values_agree(left: Form, right: Form, left_moved: list[Form], right_moved: list[Form]) -> bool:
    """Tell whether two sides agree at points, as far as their decimals may be off."""
    points = sample([left, right, *left_moved, *right_moved])
    for _, (one, other, *changed) in points:
        margin = sum(abs(value - one) for value in changed[: len(left_moved)])
        margin += sum(abs(value - other) for value in changed[len(left_moved) :])
        if abs(one - other) > margin * (1 + 1e-12) + _tiny():
            return False
    return bool(points)


def _parts(form: Form) -> Components:
    return components(form.domain, form.numerator)


def _tiny() -> Any:
    return context().mpf(10) ** -25
