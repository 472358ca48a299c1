"""Square roots of normal forms, and the unit i: which factors stay under a root, and which leave it."""

from __future__ import annotations

from collections import defaultdict
from fractions import Fraction
from math import isqrt

from symbalance.exact.phasor import prime_factors
from symbalance.notes.algebra import polynomials as poly
from symbalance.notes.algebra.domain import (
    HALF,
    ONE,
    QUARTER,
    TURN,
    Domain,
    Exponent,
    Monomial,
    Polynomial,
    TooLargeError,
)
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.zero import with_numbers_worked_out

SMALL_PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47)
LARGEST_FACTORED = 10**12
"""A root of a larger number raises TooLargeError: its primes are not searched for."""


def unit(domain: Domain) -> Form:
    """Return i."""
    return Form.of(domain, {((TURN, QUARTER),): Fraction(1)})


def root(form: Form) -> Form:
    """Return the positive square root, its rational and monomial factors taken out.

    The root of a letter's square is that letter where the letter is positive; otherwise the domain
    notes the assumption that it is.
    """
    domain = form.domain
    if form.is_polynomial:
        return _root_of_polynomial(domain, form.numerator)
    below, sign = form.denominator, 1
    if is_never_negative(domain, poly.scale(below, -1)):
        below, sign = poly.scale(below, -1), -1
    elif not is_never_negative(domain, below):
        domain.assume_positive(below)
    product = poly.scale(poly.times(domain, form.numerator, below), sign)
    return _root_of_polynomial(domain, product).over(Form.of(domain, below))


def _root_of_polynomial(domain: Domain, square: Polynomial) -> Form:
    square = with_numbers_worked_out(domain, square)
    if poly.is_rational(square):
        return root_of_rational(domain, square.get(ONE, Fraction(0)))
    monomial, coefficient = _leading(domain, square)
    factor, inverse = domain.raised(monomial, -1)
    inside = poly.times(domain, square, {inverse: Fraction(factor) / coefficient})
    _assume_not_negative(domain, monomial)
    outside = _root_of_term(domain, monomial, coefficient)
    if inside == {ONE: 1}:
        return outside
    return outside.times(Form.of(domain, {((domain.radical(inside), 1),): Fraction(1)}))


def _leading(domain: Domain, square: Polynomial) -> tuple[Monomial, Fraction]:
    """Return what is taken out of a root: the positive letters and the coefficient of one positive term.

    Terms of positive letters only come first, those with angles or radicals are not asked. The choice
    does not change when the polynomial is multiplied by a positive monomial, so roots of proportional
    polynomials share one generator. Other letters leave by the even powers that all terms share; a
    single term leaves whole.
    """
    terms = [(m, c) for m, c in square.items() if c > 0 and all(_is_letter(domain, g) for g, _ in m)]
    if len(square) == len(terms) == 1:
        return terms[0]
    squares = _shared_squares(domain, square)
    if not terms:
        return squares, Fraction(1)
    positive = [term for term in terms if term[0] == _positive_part(domain, term[0])]
    letters = sorted({g for monomial, _ in terms for g, _ in monomial})
    lead, coefficient = max(positive or terms, key=lambda t: [dict(t[0]).get(g, 0) for g in letters])
    return domain.times(_positive_part(domain, lead), squares)[1], coefficient


def _is_letter(domain: Domain, number: int) -> bool:
    return domain.generators[number].kind in ("symbol", "constant", "prime", "growth")


def _positive_part(domain: Domain, monomial: Monomial) -> Monomial:
    return tuple((g, e) for g, e in monomial if domain.generators[g].positive)


def _shared_squares(domain: Domain, square: Polynomial) -> Monomial:
    """Return the largest even powers of letters of unknown sign that divide every term."""
    exponents = [dict(monomial) for monomial in square]
    squares = []
    for number in sorted({g for monomial in square for g, _ in monomial}):
        if domain.generators[number].kind == "symbol" and not domain.generators[number].positive:
            lowest = min(powers.get(number, 0) for powers in exponents)
            squares.append((number, lowest // 2 * 2))
    return tuple((g, e) for g, e in squares if e)


def _assume_not_negative(domain: Domain, monomial: Monomial) -> None:
    """Note the letters whose sign counts in √(x²) = x or √(xy) = √x √y; √x alone only has to be real."""
    open_signs = [(g, e) for g, e in monomial if not domain.generators[g].positive]
    odd = [g for g, e in open_signs if e % 2]
    for generator, exponent in open_signs:
        if exponent % 4 == 2 or (exponent % 2 and len(odd) > 1):
            domain.assumptions[f"{domain.generators[generator].content} ≥ 0"] = None


def _root_of_term(domain: Domain, monomial: Monomial, coefficient: Fraction) -> Form:
    _, half_power = domain.raised(monomial, HALF)
    return root_of_rational(domain, coefficient).times(Form.of(domain, {half_power: Fraction(1)}))


def root_of_rational(domain: Domain, value: Fraction) -> Form:
    """Return √value: a rational times roots of distinct primes.

    >>> domain = Domain()
    >>> root_of_rational(domain, Fraction(9, 4)).rational()
    Fraction(3, 2)
    """
    if value < 0:
        return unit(domain).times(root_of_rational(domain, -value))
    whole = value.numerator * value.denominator
    exact = isqrt(whole)
    if exact * exact == whole:
        return Form.number(domain, Fraction(exact, value.denominator))
    outside = 1
    for prime in SMALL_PRIMES if whole > LARGEST_FACTORED else ():
        # the squares of a power of ten, of megapascals or of a product of decimals, leave first
        while whole % (prime * prime) == 0:
            whole, outside = whole // (prime * prime), outside * prime
    if whole > LARGEST_FACTORED:
        raise TooLargeError("the root of a large number")
    primes: list[tuple[int, Fraction]] = []
    for prime in prime_factors(whole):
        count = 0
        while whole % prime == 0:
            whole, count = whole // prime, count + 1
        outside *= prime ** (count // 2)
        if count % 2:
            primes.append((domain.prime(prime), HALF))
    return Form.of(domain, {tuple(sorted(primes)): Fraction(outside, value.denominator)})


def is_never_negative(domain: Domain, polynomial: Polynomial) -> bool:
    """Tell whether, before every product of letters, the constant outweighs all waves: 2 + 2 cos 2θ.

    >>> domain = Domain()
    >>> x = domain.symbol("x")
    >>> is_never_negative(domain, {((x, 2),): Fraction(1), (): Fraction(1)})
    True
    >>> is_never_negative(domain, {((x, 1),): Fraction(1), (): Fraction(1)})
    False
    """
    margins: dict[Monomial, Fraction] = defaultdict(Fraction)
    for monomial, coefficient in polynomial.items():
        waves = tuple((g, e) for g, e in monomial if domain.generators[g].kind == "exponential")
        letters = tuple(pair for pair in monomial if pair not in waves)
        if not all(_is_positive(domain, g, e) for g, e in letters):
            return False
        margins[letters] += -abs(coefficient) if waves else coefficient
    return all(margin >= 0 for margin in margins.values())


def _is_positive(domain: Domain, number: int, exponent: Exponent) -> bool:
    generator = domain.generators[number]
    if generator.kind == "symbol" and not generator.positive:
        return exponent % 2 == 0
    return generator.kind in ("symbol", "constant", "prime", "growth", "radical")
