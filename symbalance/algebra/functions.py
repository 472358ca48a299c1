"""Roots, exponentials and circular functions of forms.

cos x and sin x are (e^(ix) ± e^(-ix))/2: an argument is split into monomials, each with its own
generator e^(i m), and multiples of pi become turns. e^(i asin v) = √(1-v²) + i v, and the like.
"""

from __future__ import annotations

from fractions import Fraction
from math import isqrt

from symbalance.algebra import polynomials as poly
from symbalance.algebra.domain import (
    HALF,
    ONE,
    QUARTER,
    TURN,
    Domain,
    Monomial,
    NoFormError,
    Polynomial,
    TooLargeError,
)
from symbalance.algebra.forms import Form
from symbalance.algebra.signs import is_never_negative
from symbalance.phasor import prime_factors

INVERSES = ("asin", "acos", "atan")
LARGEST_FACTORED = 10**12


def unit(domain: Domain) -> Form:
    """Return i."""
    return Form.of(domain, {((TURN, QUARTER),): Fraction(1)})


def exponential(argument: Form) -> Form:
    """Return e^argument: real parts become growth, imaginary ones turns and angles."""
    domain = argument.domain
    if not argument.is_polynomial:
        below = opaque("over", Form.of(domain, argument.denominator))
        argument = Form.of(domain, argument.numerator).times(below)
    result = Form.number(domain, 1)
    for monomial, coefficient in argument.numerator.items():
        result = result.times(_exponential_of_term(domain, monomial, coefficient))
    return result


def _exponential_of_term(domain: Domain, monomial: Monomial, coefficient: Fraction) -> Form:
    turns = dict(monomial).get(TURN, 0)
    rest = tuple((g, e) for g, e in monomial if g != TURN)
    if turns == 0:
        if rest == ONE:
            return Form.of(domain, {((domain.symbol("e"), coefficient),): Fraction(1)})
        return Form.of(domain, {((domain.growth(rest), coefficient),): Fraction(1)})
    if turns != QUARTER:
        raise NoFormError("a power of e that is neither real nor imaginary")
    return _phase(domain, rest, coefficient)


def _phase(domain: Domain, monomial: Monomial, coefficient: Fraction) -> Form:
    """Return e^(i coefficient monomial)."""
    if monomial == ((domain.symbol("pi"), 1),):
        factor, turn = domain.times(((TURN, coefficient * HALF),), ((TURN, Fraction(0)),))
        return Form.of(domain, {turn: Fraction(factor)})
    inverse = _inverse_function(domain, monomial)
    if inverse is not None and coefficient.denominator == 1:
        return _phase_of_inverse(*inverse, int(coefficient))
    generator = domain.exponential(monomial)
    factor, made = domain.raised(((generator, 1),), coefficient)
    return Form.of(domain, {made: Fraction(factor)})


def exponent_of(form: Form) -> Form | None:
    """Return x where a form is e^x, one product of exponentials and turns; None where it is not."""
    if not form.is_polynomial or len(form.numerator) != 1:
        return None
    domain = form.domain
    ((monomial, coefficient),) = form.numerator.items()
    total = Form.number(domain, 0)
    if coefficient != 1:
        return None
    for number, exponent in monomial:
        generator = domain.generators[number]
        if generator.kind == "turn":
            inner = Form.letter(domain, "pi").scaled(2).times(unit(domain))
        elif generator.kind in ("exponential", "growth"):
            inner = Form.of(domain, {generator.content: Fraction(1)})
            inner = inner.times(unit(domain)) if generator.kind == "exponential" else inner
        else:
            return None
        total = total.plus(inner.scaled(exponent))
    return total


def assume_whole(exponent: Form, base: Form) -> None:
    """Note that the letters of an exponent are whole: (e^(ix))^n = e^(inx) needs it."""
    domain = base.domain
    turning = {"turn", "exponential"} & {domain.generators[g].kind for m in base.numerator for g, _ in m}
    for monomial in exponent.numerator if turning else ():
        for number, _ in monomial:
            generator = domain.generators[number]
            if generator.kind == "symbol" and generator.content not in domain.integer:
                domain.assumptions[f"{generator.content} ∈ ℤ"] = None


def _inverse_function(domain: Domain, monomial: Monomial) -> tuple[str, Form] | None:
    if len(monomial) != 1 or monomial[0][1] != 1:
        return None
    generator = domain.generators[monomial[0][0]]
    if generator.kind == "opaque" and generator.content[0] in INVERSES:
        return generator.content
    return None


def _phase_of_inverse(function: str, value: Form, multiple: int) -> Form:
    """Return e^(i multiple f(value)) for f = asin, acos or atan, from cosine and sine of f(value)."""
    one = Form.number(value.domain, 1)
    if function == "atan":
        cosine = one.over(root(one.plus(value.times(value))))
        sine = value.times(cosine)
    else:
        other = root(one.minus(value.times(value)))
        cosine, sine = (other, value) if function == "asin" else (value, other)
    sign = 1 if multiple >= 0 else -1
    return cosine.plus(unit(value.domain).times(sine).scaled(sign)).raised(abs(multiple))


def cosine(argument: Form) -> Form:
    """Return cos x = (e^(ix) + e^(-ix))/2."""
    forward, backward = _both_ways(argument)
    return forward.plus(backward).scaled(HALF)


def sine(argument: Form) -> Form:
    """Return sin x = (e^(ix) - e^(-ix))/(2i)."""
    forward, backward = _both_ways(argument)
    return forward.minus(backward).times(unit(argument.domain)).scaled(-HALF)


def _both_ways(argument: Form) -> tuple[Form, Form]:
    turned = unit(argument.domain).times(argument)
    return exponential(turned), exponential(turned.scaled(-1))


def opaque(function: str, argument: Form) -> Form:
    """Return a function that has no rule here, as a generator; equal arguments share one."""
    domain = argument.domain
    for number in domain.opaque:
        name, known = domain.generators[number].content
        if name == function and known.equals(argument):
            return Form.of(domain, {((number, 1),): Fraction(1)})
    number = domain.opaque_function((function, argument))
    return Form.of(domain, {((number, 1),): Fraction(1)})


def root(form: Form) -> Form:
    """Return the positive square root, its rational and monomial factors taken out.

    The root of a letter's square is that letter where the letter is positive; otherwise the domain
    notes the assumption that it is.
    """
    domain = form.domain
    if form.is_polynomial:
        return _root_of_polynomial(domain, form.numerator)
    below, sign = form.denominator, 1
    if is_never_negative(domain, poly.scaled(below, -1)):
        below, sign = poly.scaled(below, -1), -1
    elif not is_never_negative(domain, below):
        domain.assume_positive(below)
    product = poly.scaled(poly.times(domain, form.numerator, below), sign)
    return _root_of_polynomial(domain, product).over(Form.of(domain, below))


def _root_of_polynomial(domain: Domain, square: Polynomial) -> Form:
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
    shared = _shared_squares(domain, square)
    if not terms:
        return shared, Fraction(1)
    positive = [term for term in terms if term[0] == _positive_part(domain, term[0])]
    letters = sorted({g for monomial, _ in terms for g, _ in monomial})
    lead, coefficient = max(positive or terms, key=lambda t: [dict(t[0]).get(g, 0) for g in letters])
    return domain.times(_positive_part(domain, lead), shared)[1], coefficient


def _is_letter(domain: Domain, number: int) -> bool:
    return domain.generators[number].kind in ("symbol", "prime", "growth")


def _positive_part(domain: Domain, monomial: Monomial) -> Monomial:
    return tuple((g, e) for g, e in monomial if domain.generators[g].positive)


def _shared_squares(domain: Domain, square: Polynomial) -> Monomial:
    """Return the largest even powers of letters of unknown sign that divide every term."""
    exponents = [dict(monomial) for monomial in square]
    shared = []
    for number in sorted({g for monomial in square for g, _ in monomial}):
        if domain.generators[number].kind == "symbol" and not domain.generators[number].positive:
            lowest = min(own.get(number, 0) for own in exponents)
            shared.append((number, lowest // 2 * 2))
    return tuple((g, e) for g, e in shared if e)


def _assume_not_negative(domain: Domain, monomial: Monomial) -> None:
    """Note the letters whose sign counts in √(x²) = x or √(xy) = √x √y; √x alone only has to be real."""
    open_signs = [(g, e) for g, e in monomial if not domain.generators[g].positive]
    odd = [g for g, e in open_signs if e % 2]
    for generator, exponent in open_signs:
        if exponent % 4 == 2 or (exponent % 2 and len(odd) > 1):
            domain.assumptions[f"{domain.generators[generator].content} ≥ 0"] = None


def _root_of_term(domain: Domain, monomial: Monomial, coefficient: Fraction) -> Form:
    _, halved = domain.raised(monomial, HALF)
    return root_of_rational(domain, coefficient).times(Form.of(domain, {halved: Fraction(1)}))


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
    if whole > LARGEST_FACTORED:
        raise TooLargeError("the root of a large number")
    outside = 1
    primes: list[tuple[int, Fraction]] = []
    for prime in prime_factors(whole):
        count = 0
        while whole % prime == 0:
            whole, count = whole // prime, count + 1
        outside *= prime ** (count // 2)
        if count % 2:
            primes.append((domain.prime(prime), HALF))
    return Form.of(domain, {tuple(sorted(primes)): Fraction(outside, value.denominator)})
