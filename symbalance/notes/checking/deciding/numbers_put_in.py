"""Numbers put in for letters: which of them are data, exact, and which are results, rounded as printed.

m r ω² = 0.72·6396 puts in m = 0.72 kg as it is given, and 6396 for r ω², rounded. A number is the value
of a part of the other side if it agrees with it to the last digit printed, in its unit or a thousandth of
it; one that is no part's value is what it says, but for a decimal of three digits that the page prints as
a result elsewhere, or that stands for √3/2, π and the like: those have more digits than are shown.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator
from fractions import Fraction
from itertools import combinations, pairwise
from typing import Any

from symbalance.document import formula
from symbalance.document.formula import Formula, Name, Negative, Number, Product, names
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.values import Valuation, letters
from symbalance.notes.checking.deciding.substitution import replace_part
from symbalance.notes.reading.equations import ReadNotes
from symbalance.text import lazy_patterns as re

LONG = 3
"""A decimal of this many digits on the way to a result may itself be rounded."""
SHORTEST = 2
"""Digits from which on a whole number behind ≈ is meant to the last of them."""
SHORT, SMALL = 2, 0.01
"""Digits of a small constant that a formula was left with, 0.00034: its zeros are none."""
LONGER = 5
"""A term of a sum with this many digits is a result."""
MOST_FACTORS = 8
"""Factors of a product whose parts are looked through: 255 of them."""
MOST_ZEROS = 40
"""Of a power of ten that a number is printed with."""
_SCALES = (1.0, 1e-3, 1e3, 1e-6, 1e6)
"""A value in mm, kN or MPa is put in as it is typed."""
_POWERS = tuple(10.0**power for power in range(-9, 10))
"""A result of 122700 is put in as 1.227 times a power of ten."""
_ROUNDING = 1 + 1e-9
_EXACTLY = 1e-9
_DEGREES = (15, 18, 22.5, 30, 36, 40, 45, 360 / 7, 54, 60, 72, 75)
_EXACT = (
    *(math.sqrt(n) for n in (2, 3, 5, 6, 7, 10)),
    *(math.pi * n for n in (1, 2, 4)),
    *(f(math.radians(angle)) for f in (math.sin, math.cos, math.tan) for angle in _DEGREES),
)
_CONSTANTS = tuple(factor * value for value in _EXACT for factor in (0.25, 0.5, 1, 2, 3, 4))
"""What decimals such as 0.866, 1.732 and 3.1416 stand for."""


def significant_digits(number: Number) -> int:
    """Return how many digits of a number count, closing zeros of a whole one not.

    >>> significant_digits(Number(Fraction(1, 25), Fraction(1, 1000)))  # 0.040
    2
    """
    if number.last_place is not None:
        return len(str(abs(number.value / number.last_place).numerator))
    return len(str(abs(number.value.numerator)).rstrip("0"))


def printed_results(document: ReadNotes) -> frozenset[float]:
    """Return the numbers that a page prints as results: behind a relation, but for the sizes it gives.

    A length, a mass or a time that a letter is set equal to is data. The constant of a formula that a
    page computes, W R N² (2π/60)²/g = 0.00034 W R N², is a result too.
    """
    results: set[float] = set()
    for chain in document.chains:
        for k, side in enumerate(chain.sides[1:], 1):
            node = side.node.operand if isinstance(side.node, Negative) else side.node
            if (constant := _computed_constant(chain.sides[k - 1].node, node)) is not None:
                results.add(abs(float(constant.value)))
            node = node.factors[0] if isinstance(node, Product) and not names(node) else node
            is_given = (
                k == 1
                and isinstance(chain.sides[0].node, Name)
                and chain.relations[0].sign == "="
                and len(chain.sides) == 2
                and _SIZE.search(document.source(side.span)) is not None
            )
            if isinstance(node, Number) and not is_given and significant_digits(node) >= LONG:
                results.add(abs(float(node.value)))
    return frozenset(results)


def stated_values(document: ReadNotes) -> frozenset[float]:
    """Return the numbers that a page gives letters without any arithmetic: its data."""
    stated: set[float] = set()
    computed: set[float] = set()
    for chain in document.chains:
        is_stated = len(chain.sides) == 2 and isinstance(chain.sides[0].node, Name)
        for side in chain.sides[1:]:
            node = side.node.factors[0] if isinstance(side.node, Product) else side.node
            if isinstance(node, Number) and not names(side.node):
                (stated if is_stated else computed).add(abs(float(node.value)))
    return frozenset(stated - computed)


def counted_things(text: str) -> frozenset[int]:
    """Return where the numbers end that words behind them count things with.

    >>> sorted(counted_things("a gear of 143 teeth for 4 cylinders at 600 rpm"))
    [13, 25]
    """
    return frozenset(match.end("number") for match in _COUNTED.finditer(text))


_COUNTED = re.compile(
    r"(?<![0-9.,])(?P<number>[0-9]{1,9})\$?[ ~]?\$?(?:firing |power |full |Zünd-?|volle )?"
    r"(?:cylinders?|teeth|tooth|pulses?|firings?|throws?|pistons?|engines?|bolts?|balls?|pieces?"
    r"|times(?!\s+(?!(?:per|an?|each|every|in|during|within|one)\b)[\w$])"  # how often, and no multiple
    r"|Zylinder|Zähnen?|Zündungen|Kolben|Kröpfungen|Stück|気筒|歯|個|本|回(?!転))"
)


def _computed_constant(before: Formula, node: Formula) -> Number | None:
    """Return the decimal that a formula begins with, where the one before it has none."""
    first = next(iter(_leading(node)), None)
    if first is None or first.last_place is None or not (names(node) and names(before)):
        return None
    is_computed = not isinstance(before, Name) and not any(
        isinstance(part, Number) and part.last_place is not None for part in formula.walk(before)
    )
    return first if is_computed and significant_digits(first) >= SHORT else None


def _leading(node: Formula) -> Iterator[Number]:
    """Yield the number that a product or quotient begins with."""
    while isinstance(node, formula.Quotient | Product):
        node = node.numerator if isinstance(node, formula.Quotient) else node.factors[0]
    if isinstance(node, Number):
        yield node


_SIZE = re.compile(
    r"[0-9](?:\s|~|\$|\\[,;: ]|\\(?:mathrm|text|textrm)\{|\}\{|\\(?:milli|kilo|centi))*"
    r"(?:[kmcd]?m|k?g|m?s|inch|in|ft|lbs?|\\metre|\\meter|\\gram|\\second)[\s}$.,;]*$"
)


def may_be_rounded(number: Number, printed: Collection[float]) -> bool:
    """Tell whether a number in an arithmetic has more digits than it shows: a result, or √3/2."""
    value, half = abs(float(number.value)), _half(number)
    if significant_digits(number) < LONG:
        is_constant = value < SMALL and significant_digits(number) == SHORT
        return is_constant and number.last_place is not None and value in printed
    if any(_is_same(value, other) for other in printed):
        return True
    return number.last_place is not None and any(abs(c - value) <= half * _ROUNDING for c in _CONSTANTS)


def _is_same(value: float, other: float) -> bool:
    return any(math.isclose(value * scale, other, rel_tol=1e-9) for scale in _POWERS)


def _half(number: Number) -> float:
    """Return half a unit of the last digit that counts."""
    if number.last_place is not None:
        return float(number.last_place) / 2
    digits = str(abs(number.value.numerator))
    zeros = min(len(digits) - len(digits.rstrip("0")), max(len(digits) - 2, 0))
    return 10.0**zeros / 2


def agrees_to_its_digits(left: Formula, right: Formula, values: tuple[Any, Any]) -> bool:
    """Tell whether two numbers agree as closely as a whole one behind ≈ is meant: 2130 to 10 in it.

    It is rounded, to half of that, or cut off; up to a whole one it may be off where letters, or numbers
    of three digits, are put in, which may be rounded too. Of two whole numbers the coarser one is the
    other, rounded: 997 ≈ 1000. A formula, and a number of one digit, say nothing.
    """
    pairs = ((left, values[0], right, values[1]), (right, values[1], left, values[0]))
    printed = [
        (_precision(number), *pair) for pair in pairs if (number := _whole_number(pair[0])) is not None
    ]
    if not printed:
        return True
    share, _, own, other_side, other = max(printed, key=lambda entry: entry[0])
    gap, unit = abs(own - other), share * abs(own)
    is_cut_off = abs(own) <= abs(other)
    return gap <= unit * (1 if is_cut_off or _may_rest_on_rounded(other_side) else 0.5) * _ROUNDING


def _may_rest_on_rounded(node: Formula) -> bool:
    """Tell whether letters stand in an arithmetic, or numbers that may be results."""
    numbers = (part for part in formula.walk(node) if isinstance(part, Number))
    return bool(names(node)) or any(significant_digits(number) >= LONG for number in numbers)


def _precision(number: Number) -> float:
    if significant_digits(number) < SHORTEST or not number.value:
        return 1.0
    return 2 * _half(number) / abs(float(number.value))


def _whole_number(node: Formula) -> Number | None:
    """Return the whole number that a side is, before a unit or a power of ten; None for other sides."""
    if isinstance(node, Negative):
        return _whole_number(node.operand)
    if isinstance(node, Product) and len(node.factors) == 2 and _is_scale(node.factors[1]):
        node = node.factors[0]
    is_whole = isinstance(node, Number) and node.last_place is None and node.value.denominator == 1
    return node if is_whole and isinstance(node, Number) else None


def _is_scale(node: Formula) -> bool:
    """Tell whether a factor is that of a unit, 1/1000 or π/30, or a power of ten."""
    if isinstance(node, Number):
        return node.value.denominator > 1 or str(node.value.numerator).rstrip("0") == "1"
    return _exponent_of_ten(node) is not None or (isinstance(node, formula.Quotient) and not names(node))


def margin_of_numbers(
    put_in: Formula,
    other: Formula,
    form_of: Callable[[Formula], Form],
    printed: Collection[float],
    meaning: Formula | None = None,
) -> Any:
    """Return how far a side of numbers may be off, put in for the letters of the other side.

    `meaning` is the formula of a letter that the other side consists of: numbers of three digits or more
    may be put in for its parts.
    """
    whole = _value(put_in, form_of)
    parts_behind = [] if meaning is None else list(_values_of_parts(meaning, form_of))
    parts = list(_values_of_parts(other, form_of))
    total: Any = 0
    for number, scale in _typed(put_in):
        size = Number(number.value * scale, number.last_place * scale if number.last_place else None)
        half, value = _half(number) * float(scale), abs(float(size.value))
        own = parts + (parts_behind if significant_digits(number) >= LONG else [])
        is_part = any(abs(part * unit - value) <= half * _ROUNDING for part in own for unit in _SCALES)
        is_exact = any(_is_same(value, part) for part in own)
        # 204.84 mm - 114.72 mm: as many digits as these are results, not data
        is_long = number.last_place is not None and significant_digits(number) >= LONGER
        is_term = is_long and isinstance(put_in, formula.Sum)
        if is_exact or not (is_part or is_term or may_be_rounded(size, printed)):
            continue
        moved = replace_part(put_in, number, Number(number.value + Fraction(_half(number))))
        total += abs(_value(moved, form_of) - whole)
    return total


def margin_of_terms(total: Formula, other: Formula, form_of: Callable[[Formula], Form]) -> Any:
    """Return how far a sum may be off whose terms are those of another sum, each rounded for itself.

    J = 0.030·1² + 0.042·2.434 + 1.85·0.093² comes to 0.030 + 0.102 + 0.016: half a unit of each.
    """
    margin: Any = 0
    terms, unit = _terms_in_unit(total)
    others, unit_of_others = _terms_in_unit(other)
    sizes = [size * unit_of_others for term in others for size in _size(term, form_of)]
    for term in terms if sizes else ():
        number = next((p for p in formula.walk(term) if isinstance(p, Number)), None)
        if number is None or number.last_place is None or not is_lone_number(term):
            continue
        value = next(_size(term, form_of), 0.0) * unit
        half = _half(number) * (value / abs(float(number.value)) if number.value else unit)
        gap = min(abs(size - value) for size in sizes)
        if gap > half * _ROUNDING:
            return 0  # a term of its own
        margin += half if gap > _EXACTLY * value else 0
    return margin


def _terms_in_unit(node: Formula) -> tuple[tuple[Formula, ...], float]:
    """Return the terms of a sum, and what the unit behind it comes to; none for other formulas."""
    if isinstance(node, Product) and len(node.factors) == 2 and isinstance(node.factors[1], Number):
        terms, _ = _terms_in_unit(node.factors[0])
        return terms, float(node.factors[1].value)
    return (node.terms if isinstance(node, formula.Sum) else ()), 1.0


def _typed(node: Formula) -> Iterator[tuple[Number, Fraction]]:
    """Yield the numbers of a side that may be values, each with the power of ten that it stands before.

    Those are decimals, and whole numbers from 100: 6.136 of 6.136·10⁻⁷/0.4 with 10⁻⁷, and 0.4 with 1.
    """
    scales = _powers_of_ten_behind(node)
    exponents = {id(part.exponent) for part in formula.walk(node) if isinstance(part, formula.Power)}
    for part in formula.walk(node):
        if isinstance(part, Number) and id(part) not in exponents:
            is_whole = part.value.denominator == 1 and abs(part.value) >= 100
            if part.last_place is not None or is_whole:
                yield part, scales.get(id(part), Fraction(1))


def _powers_of_ten_behind(node: Formula) -> dict[int, Fraction]:
    """Return what 10ⁿ comes to by the number right before it, a decimal, in a product."""
    powers: dict[int, Fraction] = {}
    for part in formula.walk(node):
        factors = part.factors if isinstance(part, Product) else ()
        for factor, behind in pairwise(factors):
            exponent = _exponent_of_ten(behind)
            if exponent is not None and isinstance(factor, Number) and factor.last_place is not None:
                powers[id(factor)] = Fraction(10) ** exponent
    return powers


def _exponent_of_ten(node: Formula) -> int | None:
    """Return the exponent of a power of ten as it is typed, None for anything else."""
    if not isinstance(node, formula.Power) or node.base != Number(Fraction(10)):
        return None
    exponent = node.exponent
    number = exponent.operand if isinstance(exponent, Negative) else exponent
    if not isinstance(number, Number) or number.value.denominator != 1 or abs(number.value) > MOST_ZEROS:
        return None
    return int(-number.value if number is not exponent else number.value)


def _values_of_parts(node: Formula, form_of: Callable[[Formula], Form]) -> Iterator[float]:
    """Yield the sizes of the parts of a formula: of letters, sums and functions, and products of some."""
    for part in formula.walk(node):
        if names(part):
            yield from _size(part, form_of)
        if isinstance(part, formula.Product | formula.Quotient) and names(part):
            every = list(_factors(part))
            factors = [f for f in every if not isinstance(f, Number)][:MOST_FACTORS]
            sizes = [next(_size(f, form_of), None) for f in factors]
            known = [size for size in sizes if size is not None]
            has_count = len(factors) < len(every)  # of 4 λ m r ω² all letters together are a part
            for count in range(2, len(known) + has_count):
                for chosen in combinations(known, count):
                    yield math.prod(chosen)


def _factors(node: Formula) -> Iterator[Formula]:
    """Yield the factors of a product and of a quotient, a square twice, what stands below as 1/x."""
    if isinstance(node, formula.Product):
        for factor in node.factors:
            yield from _factors(factor)
    elif isinstance(node, formula.Quotient):
        yield from _factors(node.numerator)
        for factor in _factors(node.denominator):
            yield formula.Quotient(Number(Fraction(1)), factor)
    elif isinstance(node, formula.Power) and node.exponent == Number(Fraction(2)):
        yield node.base
        yield node.base
    else:
        yield node


def _size(node: Formula, form_of: Callable[[Formula], Form]) -> Iterator[float]:
    try:
        form = form_of(node)
        if not letters(form):
            yield abs(complex(Valuation(form.domain, {}).of(form)))
    except (NoFormError, TooLargeError, OverflowError, ZeroDivisionError):
        return


def _value(node: Formula, form_of: Callable[[Formula], Form]) -> Any:
    form = form_of(node)
    return Valuation(form.domain, {}).of(form)


def is_put_in(node: Formula, other: Formula) -> bool:
    """Tell whether a side is an arithmetic of numbers that stands beside letters: m r ω² = 0.72·6396."""
    return not names(node) and bool(names(other)) and not isinstance(node, Number | Name)


def paired(left: Formula, right: Formula) -> list[tuple[Formula, Formula]] | None:
    """Return the parts of a product with the numbers put in for them, in order; None for other shapes.

    m r ω² = 0.5·0.04·628² puts 0.5 in for m, 0.04 for r, 628 for ω, and v/(D/2) = 25/0.9 puts 0.9 in
    for D/2; λ m r ω² = 0.3·4605 puts in something else, and m r ω² = 7888 nothing.
    """
    pairs = _pairs(left, right)
    return None if pairs is None else [pair for pair in pairs if names(pair[0])]


def constants_put_in(left: Formula, right: Formula) -> list[tuple[Formula, Formula]]:
    """Return the constants of a product with what stands at their places: the 3 of d F/3."""
    return [pair for pair in _pairs(left, right) or () if not names(pair[0])]


def _pairs(left: Formula, right: Formula) -> list[tuple[Formula, Formula]] | None:
    """Return the letters and constants of a product with the numbers at their places."""
    by_parts = _paired_parts(left, without_unit(right))
    if by_parts is not None and isinstance(left, formula.Product | formula.Quotient):
        return by_parts
    first, second = list(_bases(left)), list(_bases(without_unit(right)))
    if len(first) != len(second) or len(first) < 2 or [e for _, e in first] != [e for _, e in second]:
        return None
    return [(part, number) for (part, _), (number, _) in zip(first, second, strict=True)]


def without_unit(node: Formula) -> Formula:
    """Return an arithmetic without the unit of its result behind it."""
    if isinstance(node, Product) and len(node.factors) == 2:
        arithmetic, unit = node.factors
        is_result = isinstance(arithmetic, Product | formula.Quotient) and isinstance(unit, Number)
        return arithmetic if is_result else node
    return node


def _paired_parts(left: Formula, right: Formula) -> list[tuple[Formula, Formula]] | None:
    """Return the letters of a formula with what stands at their places in another of the same shape."""
    if isinstance(left, Name):
        return [(left, right)]
    if isinstance(left, formula.Power) and isinstance(right, formula.Power):
        return _paired_power(left, right)
    if not names(left):
        return None if names(right) else [(left, right)]
    first, second = formula.children(left), formula.children(right)
    if type(left) is not type(right) or len(first) != len(second):
        return None
    parts = [
        [(a, b)] if _is_multiple_put_in(a, b) else _paired_parts(a, b)
        for a, b in zip(first, second, strict=True)
    ]
    return None if None in parts else [pair for part in parts if part for pair in part]


def _paired_power(left: formula.Power, right: formula.Power) -> list[tuple[Formula, Formula]] | None:
    """Return the letters of a power with the numbers put in, those of its exponent too: ε^κ = 11^1.35."""
    bases = _paired_parts(left.base, right.base)
    if left.exponent == right.exponent or bases is None:
        return bases
    if not names(left.exponent) or names(right.exponent):
        return None
    is_number = isinstance(right.exponent, Number)
    exponents = [(left.exponent, right.exponent)] if is_number else None
    exponents = exponents or _paired_parts(left.exponent, right.exponent)
    return None if exponents is None else bases + exponents


def _is_multiple_put_in(part: Formula, number: Formula) -> bool:
    """Tell whether one number is put in for a multiple of a letter: 0.9 for D/2, 50 for 2v."""
    is_multiple = isinstance(part, formula.Product | formula.Quotient) and len(names(part)) == 1
    return is_multiple and isinstance(number, Number)


def _bases(node: Formula, sign: int = 1) -> Iterator[tuple[Formula, Fraction]]:
    """Yield the factors of a formula with their exponents; a unit goes with the number before it."""
    if isinstance(node, formula.Product):
        factors: list[Formula] = []
        for factor in node.factors:
            if factors and isinstance(factor, Number) and _is_unit(factor) and not names(factors[-1]):
                factors[-1] = Product((factors[-1], factor))
            else:
                factors.append(factor)
        for factor in factors if len(factors) > 1 else ():
            yield from _bases(factor, sign)
        if len(factors) == 1:
            yield factors[0], Fraction(sign)
    elif isinstance(node, formula.Quotient):
        yield from _bases(node.numerator, sign)
        yield from _bases(node.denominator, -sign)
    elif isinstance(node, formula.Power) and isinstance(node.exponent, Number):
        yield node.base, sign * node.exponent.value
    else:
        yield node, Fraction(sign)


def _is_unit(number: Number) -> bool:
    """Tell the factor of a unit, 1/1000 of mm, which no one types as a number."""
    return number.last_place is None and number.value.denominator > 1


def is_lone_number(node: Formula) -> bool:
    """Tell whether a side is one number with its unit, and no arithmetic."""
    if isinstance(node, Negative):
        return is_lone_number(node.operand)
    if isinstance(node, Product) and not names(node):
        number, *units = node.factors
        return isinstance(number, Number) and all(_is_factor(unit) for unit in units)
    return isinstance(node, Number)


def _is_factor(node: Formula) -> bool:
    """Tell whether a factor behind a number is a unit's or a power of ten."""
    if not isinstance(node, Number) or node.value.denominator > 1:
        return not isinstance(node, Number) or node.last_place is None
    return set(str(node.value)) <= {"1", "0"}
