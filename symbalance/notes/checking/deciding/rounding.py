"""Agreement of printed decimals with exact values, to the digits they show.

A lone decimal stands for all that is rounded to it, half a unit of its last place to either side. So does
a decimal of three digits or more that a result is computed from, here or in a line before; shorter ones
are data, taken as exact. A whole number is exact, unless it is the result of an arithmetic with decimals,
or of a division that does not come out even, and has three digits, or two before a unit. Among letters
every coefficient is compared for itself, and may be off by what half a unit in the last place of each
number that is no datum brings.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from symbalance.document import formula
from symbalance.document.formula import Formula, Negative, Number, names
from symbalance.notes.algebra import polynomials as poly
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.harmonics import Components, components
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.values import Point, Valuation, context, letters, sample
from symbalance.notes.checking.deciding.numbers_put_in import (
    is_put_in,
    margin_of_numbers,
    margin_of_terms,
    may_be_rounded,
)
from symbalance.notes.checking.deciding.substitution import replace_part, substitute

DEEPEST = 12
"""Values that rest on values, one in the other."""
ROUGHLY = 0.01
"""What ≈ forgives an arithmetic with numbers put in."""
MOST_BY_DATA = 0.02
"""What the digits of data, each taken for itself, may move a result at most, as a part of it."""
SHORTEST = 2
"""Digits of decimals beside roots, at least, that may be rounded."""
LONGEST = 9
"""Digits of a whole number that a result is rounded to; a longer one is meant as it stands."""
APART = 1.9
"""Times that a decimal of one digit may not be off, though it is rounded to it."""
LONG = 3
"""A decimal of this many digits on the way to a result may itself be rounded."""
SHORT_WHOLE = 100
"""A whole number below it has too few digits to be half a unit short."""
KILO = 1000
"""A power of ten from here on, behind a whole number, is a unit's: 254 kN."""
MEASURED = 2
"""Digits of a whole number with a unit, or of a letter with a formula, at least, that is a result and
rounded: 33° for 360°/11."""


def decimals(node: Formula) -> list[Number]:
    """Return the numbers of a formula that are printed with a decimal point."""
    return [part for part in formula.parts_of_kind(node, Number) if part.last_place is not None]


def exact_exponents(node: Formula) -> set[int]:
    """Return the decimals of exponents, by their identity: the 0.4 of 9^0.4 is meant as it stands."""
    powers = formula.parts_of_kind(node, formula.Power)
    return {id(number) for power in powers for number in decimals(power.exponent)}


def _distinct(node: Formula) -> list[Number]:
    """Return the decimals of a formula; that of a letter, wherever it is put in, is one."""
    return list({id(number): number for number in decimals(node)}.values())


def agrees_as_printed(
    left: Formula,
    right: Formula,
    form_of: Callable[[Formula], Form],
    values: Mapping[str, Formula] | None = None,
    *,
    generous: bool = False,
    printed: Collection[float] = (),
    stated: Collection[float] = (),
    counted: Collection[int] = (),
) -> bool:
    """Tell whether two sides agree to the last digits printed; `form_of` gives a side's form.

    A lone decimal may be off by half a unit of its last place, and by what the decimals bring that the
    other side is computed from, those of the letters' `values` too; by a whole unit towards zero if
    `generous` (cut off, not rounded). `printed` are the results that the page prints: one that is put in
    stands for its interval, other numbers are data; so are those of them that the page merely states.
    Those that end at `counted` count things.
    """
    typed_left, typed_right = left, right
    if not generous and any(_counts(side, counted) for side in (left, right)):
        return False
    left, right = (with_decimals(node, values or {}) for node in (left, right))
    results = (
        _coefficients(typed_left, typed_right, values or {}),
        _coefficients(typed_right, typed_left, values or {}),
    )
    has_coefficients = any(results)
    may_round = has_coefficients or _is_result(left) or _is_result(right)
    if not decimals(left) and not decimals(right) and not may_round:
        return False
    forms = form_of(left), form_of(right)
    if not any(map(letters, forms)):
        typed = typed_left, typed_right
        meanings = tuple(_formula_of(node, values or {}) for node in typed)
        by_result = _as_result(left, right, typed, forms, form_of, generous, printed, stated, meanings)
        if by_result is not None:
            return by_result
        return _within_margins(left, right, typed, forms, form_of, generous, printed, meanings)
    is_exact = not decimals(left) and not decimals(right) and not has_coefficients
    if is_exact or not all(form.is_polynomial for form in forms):
        return False
    moved = [
        [form_of(node) for node in _moved(*each)]
        for each in zip((left, right), (typed_left, typed_right), results, strict=True)
    ]
    return _coefficients_agree((left, right), forms, moved)


def _as_result(
    left: Formula,
    right: Formula,
    typed: tuple[Formula, Formula],
    forms: tuple[Form, Form],
    form_of: Callable[[Formula], Form],
    generous: bool,
    printed: Collection[float],
    stated: Collection[float],
    meanings: tuple[Formula | None, ...],
) -> bool | None:
    """Tell whether one side is the other, rounded to the decimal it consists of; None where none does."""
    first, second = forms
    for node, value, exact, other_side in ((right, second, first, left), (left, first, second, right)):
        meaning = meanings[0 if other_side is left else 1]
        lone = _lone_decimal(node, other_side, exact, generous)
        if lone is None and meaning is not None:  # y of y = a/b divides, though no letter shows it
            lone = _lone_decimal(node, meaning, exact, generous) or _short_result(node, meaning, exact)
        other = _lone_decimal(other_side, node, value, generous)
        if lone is None or (other is not None and _is_finer(lone, other)):
            continue  # of two lone decimals the coarser one is the other, rounded
        if node is left and other is not None and _is_one_of_a_unit(node, lone):
            continue  # 1 knot is one knot, whatever it comes to in others
        numbers = _number(value), _number(exact)
        unit = _unit(node, lone, numbers[0], form_of)
        is_short = lone.last_place == 1 and abs(lone.value) < SHORT_WHOLE
        if is_short and abs(numbers[1]) > abs(numbers[0]):
            unit *= 1 - 1e-9  # half of two digits is rounded up: 43.5 is 44
        is_number = other is not None and _is_bare(other_side) and not _is_in_degrees(node)
        typed_side = typed[0] if other_side is left else typed[1]
        spread = 0 if is_number else _spread(other_side, typed_side, numbers[1], form_of, printed, stated)
        return _is_rounded(lone, unit, *numbers, spread, generous)
    return None


def _within_margins(
    left: Formula,
    right: Formula,
    typed: tuple[Formula, Formula],
    forms: tuple[Form, Form],
    form_of: Callable[[Formula], Form],
    generous: bool,
    printed: Collection[float],
    meanings: tuple[Formula | None, ...],
) -> bool:
    """Tell whether two computed sides differ by no more than the rounded numbers in them bring."""
    if not names(left) and not names(right) and (_is_bare(left) or _is_bare(right)):
        return False  # a whole number beside a decimal
    first, second = forms
    margin: Any = 0
    for typed_side, node, opposite, form, meaning in (
        (typed[0], left, typed[1], first, meanings[1]),
        (typed[1], right, typed[0], second, meanings[0]),
    ):
        if is_put_in(typed_side, opposite):
            own = margin_of_numbers(node, opposite, form_of, printed, meaning)
        else:
            own = _spread(node, typed_side, _number(form), form_of, printed)
        whole = right if node is left else left
        margin += max(own, margin_of_terms(node, whole if meaning is None else meaning, form_of))
    gap, size = abs(_number(first) - _number(second)), abs(_number(first))
    return gap <= margin * (1 + 1e-12) + (size * ROUGHLY if generous else 0) + size * _tiny()


def _formula_of(node: Formula, values: Mapping[str, Formula]) -> Formula | None:
    """Return the formula of the letter that a side consists of, None for other sides."""
    value = values.get(node.name) if isinstance(node, formula.Name) else None
    return value if value is not None and names(value) else None


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


def _counts(node: Formula, counted: Collection[int]) -> bool:
    """Tell whether a side is a whole number of things."""
    return isinstance(node, Number) and node.last_place is None and node.span[1] in counted


def _is_result(node: Formula) -> bool:
    return _is_bare(node) or whole_before_unit(node) is not None


def _is_one_of_a_unit(node: Formula, lone: Number) -> bool:
    """Tell whether a side is a whole number of one digit before its unit."""
    return isinstance(node, formula.Product) and lone.last_place == 1 and abs(lone.value) < 10


def _is_finer(lone: Number, other: Number) -> bool:
    assert lone.last_place is not None
    assert other.last_place is not None
    return lone.last_place < other.last_place


def _as_printed(
    number: Number, other_side: Formula, exact: Form, generous: bool, fewest: int = LONG
) -> Number | None:
    """Return a whole number as the result it is, of decimals, of 120π or of 7000/60: to its units.

    Its closing zeros are open behind three digits, 3550 for 3549.5, and all if `generous`.
    """
    ratio = exact.rational()
    is_divided = ratio is None or (ratio.denominator > 1 and _divides(other_side))
    is_rounded = decimals(other_side) or is_divided
    if number.value.denominator != 1 or not number.value or not is_rounded:
        return None
    digits = str(abs(number.value.numerator))
    if not generous and (not fewest <= len(digits) <= LONGEST or _is_bare(other_side)):
        return None
    zeros = len(digits) - len(digits.rstrip("0"))
    if not generous:
        zeros = min(zeros, max(len(digits) - LONG, 0))
    return Number(number.value, Fraction(10**zeros))


def _short_result(node: Formula, meaning: Formula | None, exact: Form) -> Number | None:
    """Return a whole number that a letter's formula comes to, 34 for 100 sin 20°; None for others."""
    if meaning is None or not isinstance(node, Number) or node.last_place is not None:
        return None
    return _as_printed(node, meaning, exact, generous=False, fewest=MEASURED)


def _divides(node: Formula) -> bool:
    """Tell whether an arithmetic of numbers holds a division, as typed: none that a unit brings."""
    return any(
        isinstance(part, formula.Quotient) and not _is_unit_factor(part) for part in formula.walk(node)
    )


def _lone_decimal(node: Formula, other_side: Formula, exact: Form, generous: bool) -> Number | None:
    """Return the decimal a side consists of, up to its sign and a factor without decimals."""
    if isinstance(node, Negative):
        return _lone_decimal(node.operand, other_side, exact, generous)
    if isinstance(node, Number):
        return node if node.last_place is not None else _as_printed(node, other_side, exact, generous)
    if (whole := whole_before_unit(node)) is not None:
        turns = isinstance(node, formula.Product) and isinstance(node.factors[1], formula.Quotient)
        own = (
            exact.over(Form.constant(exact.domain, "pi")) if turns else exact
        )  # of rpm and °: π/30 or π/180 each
        return _as_printed(whole, other_side, own, generous, MEASURED)
    numbers = decimals(node)
    if not isinstance(node, formula.Product) or len(numbers) != 1 or formula.names(node):
        return None
    # 2·0.7071 is √2, rounded; 0.72·6369 puts in data, and is no arithmetic's result
    is_short = significant(numbers[0]) < SHORTEST
    is_exact = not (is_short or decimals(other_side) or _is_bare(other_side))
    is_scaled = all(_is_scale(factor) or (is_exact and _is_small(factor)) for factor in node.factors)
    return numbers[0] if numbers[0] in node.factors and is_scaled else None


def whole_before_unit(node: Formula) -> Number | None:
    """Return the 452 of 452 cm³, a whole number whose unit is no typed number; None for other sides."""
    if not isinstance(node, formula.Product) or len(node.factors) != 2:
        return None
    number, unit = node.factors
    if not isinstance(number, Number) or number.last_place is not None or number.value.denominator > 1:
        return None
    return number if _is_unit_factor(unit) else None


def _is_unit_factor(node: Formula) -> bool:
    """Tell the factor of a unit, 1/1000 of mm, 1000 of kN or π/180 of °, from a number that computes."""
    if isinstance(node, formula.Quotient):
        is_turn = any(
            node == formula.Quotient(formula.Constant("pi"), Number(Fraction(part))) for part in (30, 180)
        )
        return is_turn and node.numerator.span == node.denominator.span
    if not isinstance(node, Number) or node.last_place is not None:
        return False
    return node.value.denominator > 1 or (_is_scale(node) and node.value >= KILO)


def _is_in_degrees(node: Formula) -> bool:
    """Tell whether a side is a number of degrees or turns: in radians it was rounded for itself."""
    whole = node.operand if isinstance(node, Negative) else node
    return isinstance(whole, formula.Product) and isinstance(whole.factors[-1], formula.Quotient)


def _is_small(factor: Formula) -> bool:
    return isinstance(factor, Number) and abs(factor.value) < 100


def _is_scale(factor: Formula) -> bool:
    """Tell whether a factor beside a decimal is a unit or a power of ten: 0.72·6396 is an arithmetic."""
    if not isinstance(factor, Number) or factor.last_place is not None or factor.value.denominator > 1:
        return True
    return str(abs(factor.value.numerator)).rstrip("0") == "1"


def _number(form: Form) -> Any:
    return Valuation(form.domain, {}).of(form)


def _unit(node: Formula, lone: Number, value: Any, form_of: Callable[[Formula], Form]) -> Any:
    """Return what one unit of a lone decimal's last place comes to in the side that it is."""
    assert lone.last_place is not None
    if lone.value:
        return abs(value) * float(lone.last_place / abs(lone.value))
    return abs(_number(form_of(replace_part(node, lone, Number(lone.last_place)))))


def _spread(
    node: Formula,
    typed: Formula,
    value: Any,
    form_of: Callable[[Formula], Form],
    printed: Collection[float],
    stated: Collection[float] = (),
) -> Any:
    """Return how far a side may be off by the long decimals it is computed from, each by half a unit.

    A number that stands in the line itself is data, unless the page prints it as a result elsewhere.
    Where data nearly cancel, half a unit of each would allow anything: 0.3 for 10.0 - 9.8. So far they
    are exact.
    """
    total = by_data = context().mpf(0)
    own = {id(part) for part in formula.walk(typed)}
    exact = exact_exponents(node)
    for number in (each for each in _distinct(node) if id(each) not in exact):
        assert number.last_place is not None
        is_rounded = may_be_rounded(number, printed)
        is_open = significant(number) >= LONG and id(number) not in own
        if is_open or is_rounded:
            off_by_half = Number(number.value + number.last_place / 2, number.last_place)
            moved = abs(_number(form_of(replace_part(node, number, off_by_half))) - value)
            is_datum = not is_rounded or abs(float(number.value)) in stated
            total, by_data = (total, by_data + moved) if is_datum else (total + moved, by_data)
    return total + min(by_data, MOST_BY_DATA * abs(value))


def _is_rounded(lone: Number, unit: Any, value: Any, exact: Any, spread: Any, generous: bool) -> bool:
    """Tell whether a value is the exact one, rounded; a printed 0.000 stands for half a unit at most."""
    if lone.value and exact and significant(lone) == 1:
        sizes = sorted((abs(value), abs(exact)))
        if sizes[1] >= APART * sizes[0]:
            return False  # 0.01 for 0.005: one digit says less than that they are twice apart
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
    sides: tuple[Formula, Formula], forms: tuple[Form, Form], moved: list[list[Form]]
) -> bool:
    """Tell whether no coefficient is off by more than half a unit in each rounded number's last place.

    `moved` are the forms of either side with one of its rounded numbers off by half a unit.
    """
    first, second = forms
    domain = first.domain
    if domain.radicals or domain.opaque:
        # a decimal within a root changes the root: no coefficient can be compared for itself
        if any(significant(number) < SHORTEST for side in sides for number in decimals(side)):
            return False  # 0.3 would be all between a quarter and 0.35
        return _values_agree(first, second, *moved)
    left_parts, right_parts = _parts(first), _parts(second)
    margins: dict[Any, Any] = {}
    for changed, parts in zip(moved, (left_parts, right_parts), strict=True):
        for parts_off in map(_parts, changed):
            if parts_off.keys() - parts.keys() and parts.keys() - parts_off.keys():
                return False  # it stands in an angle, cos 628.3 t: moved, the wave is another one
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


def _moved(side: Formula, typed: Formula, coefficients: Collection[Number]) -> Iterator[Formula]:
    """Yield a side with each of its rounded numbers off by half a unit, a letter's once.

    Data are exact as they are among numbers alone: the short decimals that letters stand for or that
    stand beside them, and those in a product of numbers. `coefficients` are rounded whole numbers.
    """
    factors = _factors_of_products(typed)
    for number in _distinct(side):
        assert number.last_place is not None
        is_datum = side is not typed or id(number) in factors
        if is_datum and significant(number) < LONG:
            continue
        off_by_half = Number(number.value + number.last_place / 2, number.last_place)
        yield replace_part(side, number, off_by_half)
    for number in coefficients:
        yield replace_part(side, number, Number(number.value + Fraction(1, 2)))


def _coefficients(typed: Formula, other: Formula, values: Mapping[str, Formula]) -> list[Number]:
    """Return the whole numbers of three digits before letters, 1972 of 1972 cos α, that are results.

    They are where the other side is computed: of letters with values, in a product or a quotient.
    """
    if _coefficients_typed(other) or not (
        names(other) & values.keys()
        or _factors_of_products(other)
        or _divides(other)
        or formula.Constant("pi") in formula.walk(other)
    ):
        return []
    factors = _factors_of_products(typed)
    below = _divisors_typed(typed) if formula.Constant("pi") in formula.walk(other) else []
    return [number for number in [*_coefficients_typed(typed), *below] if id(number) not in factors]


def _coefficients_typed(typed: Formula) -> list[Number]:
    firsts = (
        part.factors[0]
        for part in _outside_functions(typed)
        if isinstance(part, formula.Product) and all(names(factor) for factor in part.factors[1:])
    )
    return [first for first in firsts if isinstance(first, Number) and _is_long_whole(first)]


def _divisors_typed(typed: Formula) -> list[Number]:
    """Return the whole numbers of three digits below letters: 63025 of T N/63025, which is 198000/π."""
    quotients = (part for part in _outside_functions(typed) if isinstance(part, formula.Quotient))
    below = (part.denominator for part in quotients if names(part.numerator))
    return [number for number in below if isinstance(number, Number) and _is_long_whole(number)]


def _is_long_whole(number: Number) -> bool:
    is_whole = number.last_place is None and number.value.denominator == 1
    return is_whole and LONG <= len(str(abs(number.value.numerator)).rstrip("0")) <= LONGEST


def _outside_functions(node: Formula) -> Iterator[Formula]:
    """Yield the parts of a formula, but no arguments, exponents and denominators: 628 t of cos 628 t."""
    yield node
    if isinstance(node, formula.Power):
        yield from _outside_functions(node.base)
    elif isinstance(node, formula.Quotient):
        yield from _outside_functions(node.numerator)
    elif not isinstance(node, formula.Call):
        for part in formula.children(node):
            yield from _outside_functions(part)


def _factors_of_products(node: Formula) -> set[int]:
    """Return the numbers, by identity, of an arithmetic: 0.5 and 0.04 of 0.5·0.04·314² cos α."""
    ids: set[int] = set()
    for part in formula.walk(node):
        if isinstance(part, formula.Product):
            numbers = [
                number
                for factor in part.factors
                if not names(factor)
                for number in formula.walk(factor)
                if isinstance(number, Number) and (number.last_place is not None or not _is_scale(number))
            ]
            if len(numbers) > 1:
                ids |= {id(number) for number in numbers}
    return ids


def _values_agree(left: Form, right: Form, left_moved: list[Form], right_moved: list[Form]) -> bool:
    """Tell whether two sides agree at points, as far as their decimals may be off."""
    points: list[tuple[Point, list[Any]]] = []
    for count in (1, 3):  # the first point says no of most
        points = sample([left, right, *left_moved, *right_moved], count)
        for _, (one, other, *changed) in points:
            margin = sum(abs(value - one) for value in changed[: len(left_moved)])
            margin += sum(abs(value - other) for value in changed[len(left_moved) :])
            if abs(one - other) > margin * (1 + 1e-12) + _tiny():
                return False
    return bool(points)


def _parts(form: Form) -> Components:
    """Return the numbers of a form by their harmonics and letters; π is a part of its number."""
    domain, parts = form.domain, Components()
    for key, number in components(domain, form.numerator).items():
        constants = tuple(e for e in key.letters if domain.generators[e[0]].kind == "constant")
        bare = replace(key, letters=tuple(e for e in key.letters if e not in constants))
        whole = poly.times(domain, number, {constants: Fraction(1)}) if constants else number
        parts[bare] = poly.plus(parts.get(bare, {}), whole)
    return parts


def _tiny() -> Any:
    return context().mpf(10) ** -25
