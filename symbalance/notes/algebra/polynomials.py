"""Laurent polynomials over a `Domain`: sums and products, with the radicals reduced."""

from __future__ import annotations

from fractions import Fraction
from math import lcm

from symbalance.notes.algebra.domain import ONE, Domain, Monomial, Polynomial, TooLargeError

MOST_WORK = 150_000
"""Products of two terms a domain may form: about a second's work."""
LARGEST_EXPONENT = 400
LARGEST_BITS = 20_000
UNIT: Polynomial = {ONE: Fraction(1)}


def constant(value: Fraction | int) -> Polynomial:
    """Return a rational as a polynomial."""
    return {ONE: Fraction(value)} if value else {}


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


def scaled(polynomial: Polynomial, factor: Fraction | int) -> Polynomial:
    """Return the polynomial times a rational."""
    return {m: c * factor for m, c in polynomial.items()} if factor else {}


def minus(left: Polynomial, right: Polynomial) -> Polynomial:
    """Return the difference."""
    return plus(left, scaled(right, -1))


def times(domain: Domain, left: Polynomial, right: Polynomial) -> Polynomial:
    """Return the product, every radical's power below two."""
    worked(domain, len(left) * len(right))
    if left == UNIT:
        return right
    if right == UNIT:
        return left
    (ours, above), (theirs, below) = _cleared(left), _cleared(right)
    total: dict[Monomial, int | Fraction] = {}
    for first, a in ours.items():
        for second, b in theirs.items():
            factor, monomial = domain.times(first, second)
            total[monomial] = total.get(monomial, 0) + a * b * factor
    product = {m: Fraction(c, above * below) for m, c in total.items() if c}
    _check_size(product)
    return _without_squares(domain, product) if domain.radicals else product


def _cleared(polynomial: Polynomial) -> tuple[dict[Monomial, int], int]:
    """Return the coefficients as integers over one denominator: they multiply faster than fractions."""
    below = lcm(*(c.denominator for c in polynomial.values()))
    return {m: c.numerator * (below // c.denominator) for m, c in polynomial.items()}, below


def worked(domain: Domain, products: int) -> None:
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
    high = [m for m in polynomial if any(e >= 2 and g in radicals for g, e in m)]
    if not high:
        return polynomial
    kept = dict(polynomial)
    for monomial in high:
        _add(kept, {monomial: -polynomial[monomial]})
        _add(kept, _square_replaced(domain, radicals, monomial, polynomial[monomial]))
    return kept


def _square_replaced(
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
