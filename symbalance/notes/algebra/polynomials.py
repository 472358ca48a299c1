"""Laurent polynomials over a `Domain`: sums, products with the radicals reduced, and exact division.

A polynomial is a dict from monomials to rational coefficients, without zeros.
"""

from __future__ import annotations

from collections import defaultdict
from fractions import Fraction
from math import lcm

from symbalance.notes.algebra.domain import (
    ONE,
    Domain,
    Exponent,
    Monomial,
    Polynomial,
    TooLargeError,
    plain,
)

MOST_WORK = 150_000
"""Products of two terms a domain may form: about a second's work."""
LARGEST_EXPONENT = 400
LARGEST_BITS = 20_000
"""Of a coefficient: `MOST_WORK` counts products of terms, and would not see numbers that grow."""
UNIT: Polynomial = {ONE: Fraction(1)}
"""The number 1; one object, so that most denominators are known to be 1 without a comparison."""
Exponents = tuple[Exponent, ...]
"""The exponents of one monomial, for a fixed row of generators."""


def constant(value: Fraction | int) -> Polynomial:
    """Return a rational as a polynomial."""
    return {ONE: Fraction(value)} if value else {}


def is_unit(polynomial: Polynomial) -> bool:
    """Tell whether a polynomial is the number 1."""
    return polynomial is UNIT or (len(polynomial) == 1 and polynomial.get(ONE) == 1)


def is_rational(polynomial: Polynomial) -> bool:
    """Tell whether a polynomial is a rational number."""
    return not polynomial or (len(polynomial) == 1 and ONE in polynomial)


def plus(left: Polynomial, right: Polynomial) -> Polynomial:
    """Return the sum."""
    if not left:
        return right
    total = dict(left)
    _add(total, right)
    return total


def _add(total: Polynomial, more: Polynomial) -> None:
    for monomial, coefficient in more.items():
        value = total.get(monomial, 0) + coefficient
        if value:
            total[monomial] = value
        else:
            del total[monomial]


def scale(polynomial: Polynomial, factor: Fraction | int) -> Polynomial:
    """Return the polynomial times a rational."""
    return {m: c * factor for m, c in polynomial.items()} if factor else {}


def minus(left: Polynomial, right: Polynomial) -> Polynomial:
    """Return the difference."""
    return plus(left, scale(right, -1))


def times(domain: Domain, left: Polynomial, right: Polynomial) -> Polynomial:
    """Return the product, every radical's power below two."""
    count_work(domain, len(left) * len(right))
    if is_unit(left):
        return right
    if is_unit(right):
        return left
    if not left or not right:
        return {}
    if len(left) == 1 or len(right) == 1:
        product = _times_term(domain, left, right)
        _check_size(product)
        return _without_squares(domain, product) if domain.radicals else product
    left_terms, left_denominator = _over_common_denominator(left)
    right_terms, right_denominator = _over_common_denominator(right)
    total: dict[Monomial, int | Fraction] = {}
    for first, a in left_terms.items():
        for second, b in right_terms.items():
            factor, monomial = domain.times(first, second)
            total[monomial] = total.get(monomial, 0) + a * b * factor
    product = {m: Fraction(c, left_denominator * right_denominator) for m, c in total.items() if c}
    _check_size(product)
    return _without_squares(domain, product) if domain.radicals else product


def _times_term(domain: Domain, left: Polynomial, right: Polynomial) -> Polynomial:
    """Return the product of two polynomials, one of them a single term."""
    if len(left) > 1:
        left, right = right, left
    ((first, a),) = left.items()
    product: Polynomial = {}
    for second, b in right.items():
        factor, monomial = domain.times(first, second)
        coefficient = b if a == 1 else a * b
        coefficient = coefficient if factor == 1 else coefficient * factor
        product[monomial] = product[monomial] + coefficient if monomial in product else coefficient
    return {m: c for m, c in product.items() if c} if len(product) < len(right) else product


def _over_common_denominator(polynomial: Polynomial) -> tuple[dict[Monomial, int], int]:
    """Return the coefficients as integers over one denominator: they multiply faster than fractions."""
    below = lcm(*(c.denominator for c in polynomial.values()))
    return {m: c.numerator * (below // c.denominator) for m, c in polynomial.items()}, below


def count_work(domain: Domain, products: int) -> None:
    """Count products of two terms; too many raise TooLargeError."""
    domain.work += products
    if domain.work > MOST_WORK:
        raise TooLargeError("too many terms")


def _check_size(polynomial: Polynomial) -> None:
    for coefficient in polynomial.values():
        if coefficient.numerator.bit_length() + coefficient.denominator.bit_length() > LARGEST_BITS:
            raise TooLargeError("a coefficient of thousands of digits")


def _without_squares(domain: Domain, polynomial: Polynomial) -> Polynomial:
    """Return the polynomial with radical² replaced by what is under the root."""
    radicals = set(domain.radicals)
    squares = [m for m in polynomial if any(e >= 2 and g in radicals for g, e in m)]
    if not squares:
        return polynomial
    result = dict(polynomial)
    for monomial in squares:
        _add(result, {monomial: -polynomial[monomial]})
        _add(result, _replace_square(domain, radicals, monomial, polynomial[monomial]))
    return result


def _replace_square(
    domain: Domain, radicals: set[int], monomial: Monomial, coefficient: Fraction
) -> Polynomial:
    number, exponent = next((g, e) for g, e in monomial if g in radicals and e >= 2)
    square = power(domain, domain.generators[number].content, int(exponent // 2))
    rest = tuple((g, exponent % 2 if g == number else e) for g, e in monomial)
    return times(domain, {tuple((g, e) for g, e in rest if e): coefficient}, square)


def power(domain: Domain, polynomial: Polynomial, exponent: int) -> Polynomial:
    """Return the polynomial to a whole power, not negative, by repeated squaring."""
    if exponent > LARGEST_EXPONENT:
        raise TooLargeError(f"the power {exponent}")
    result, square = constant(1), polynomial
    while exponent:
        if exponent & 1:
            result = times(domain, result, square)
        exponent >>= 1
        if exponent:
            square = times(domain, square, square)
    return result


# Exact division, to find the common denominator of two forms


def quotient(domain: Domain, dividend: Polynomial, divisor: Polynomial) -> Polynomial | None:
    """Return dividend/divisor where it is a polynomial, else None; no divisor of turns or roots is tried.

    Before each product of turns and roots the dividend must be divisible for itself.

    >>> x, one = ((1, 1),), Fraction(1)
    >>> quotient(Domain(), {((1, 2),): one, (): -one}, {x: one, (): -one})
    {((1, 1),): Fraction(1, 1), (): Fraction(1, 1)}
    """
    if not divisor or any(not domain.is_free(g) for m in divisor for g, _ in m):
        return None
    groups: dict[Monomial, Polynomial] = defaultdict(dict)
    for monomial, coefficient in dividend.items():
        special = tuple((g, e) for g, e in monomial if not domain.is_free(g))
        free = tuple((g, e) for g, e in monomial if domain.is_free(g)) if special else monomial
        groups[special][free] = coefficient
    result: Polynomial = {}
    for special, group in groups.items():
        part = _free_quotient(domain, group, divisor)
        if part is None:
            return None
        result |= {tuple(sorted((*special, *m))): c for m, c in part.items()}
    return result


def _free_quotient(domain: Domain, dividend: Polynomial, divisor: Polynomial) -> Polynomial | None:
    """Divide leading term by leading term, in the lexicographic order of exponents.

    Every exponent of the quotient lies between the differences of the lowest and of the highest ones: a
    term outside ends the search.
    """
    numbers = sorted({g for p in (dividend, divisor) for m in p for g, _ in m})
    rest, by = _rows(dividend, numbers), _rows(divisor, numbers)
    pairs = zip(_box(rest), _box(by), strict=True)
    box = [(low - low_, high - high_) for (low, high), (low_, high_) in pairs]
    if any(low > high for low, high in box):
        return None
    lead, result = max(by), dict[Exponents, Fraction]()
    while rest:
        first = max(rest)
        step = tuple(a - b for a, b in zip(first, lead, strict=True))
        if any(not low <= e <= high for e, (low, high) in zip(step, box, strict=True)):
            return None
        result[step] = rest[first] / by[lead]
        count_work(domain, len(by))
        rest = _subtract_multiple(rest, by, step, result[step])
    return {_monomial(numbers, row): c for row, c in result.items()}


def _rows(polynomial: Polynomial, numbers: list[int]) -> dict[Exponents, Fraction]:
    powers = [(dict(monomial), coefficient) for monomial, coefficient in polynomial.items()]
    return {tuple(exponents.get(g, 0) for g in numbers): coefficient for exponents, coefficient in powers}


def _box(rows: dict[Exponents, Fraction]) -> list[tuple[Exponent, Exponent]]:
    return [(min(column), max(column)) for column in zip(*rows, strict=True)]


def _subtract_multiple(
    rest: dict[Exponents, Fraction], by: dict[Exponents, Fraction], step: Exponents, factor: Fraction
) -> dict[Exponents, Fraction]:
    """Return rest - factor step by."""
    difference = dict(rest)
    for row, coefficient in by.items():
        place = tuple(a + b for a, b in zip(row, step, strict=True))
        difference[place] = difference.get(place, Fraction(0)) - factor * coefficient
        if not difference[place]:
            del difference[place]
    return difference


def _monomial(numbers: list[int], row: Exponents) -> Monomial:
    return tuple((g, plain(e)) for g, e in zip(numbers, row, strict=True) if e)


def common_multiple(
    domain: Domain, left: Polynomial, right: Polynomial
) -> tuple[Polynomial, Polynomial, Polynomial]:
    """Return (a, b, c) with c = a left = b right: one of the two where the other divides it."""
    is_swapped = len(left) < len(right)
    large, small = (right, left) if is_swapped else (left, right)
    factor = quotient(domain, large, small)
    if factor is None:
        return right, left, times(domain, left, right)
    return (factor, UNIT, large) if is_swapped else (UNIT, factor, large)
