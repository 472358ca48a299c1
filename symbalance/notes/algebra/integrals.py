"""Integrals of normal forms: powers of a letter times exponentials in it, term by term.

    ∫ x^k e^(sx) dx = e^(sx) Σ_j (-1)^j k!/(k-j)! x^(k-j)/s^(j+1),   s free of x and not 0,

which holds all trigonometric polynomials and polynomials; 1/x gives ln x. A rate s that is made of
letters may be 0 at values of theirs: that it is not is an assumption, as in ∫ cos nθ dθ over a turn.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.notes.algebra import functions
from symbalance.notes.algebra.domain import Domain, Exponent, Monomial, NoFormError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.roots import unit
from symbalance.notes.algebra.special_values import note_that_not_zero
from symbalance.notes.algebra.substitution_in_forms import Dependence, substitute_letter, term_by_term

HIGHEST_POWER = 60
"""Of the letter beside an exponential: each is a term of the result."""


def antiderivative(form: Form, letter: int) -> Form:
    """Return a form whose derivative by a letter is the one given.

    >>> domain = Domain()
    >>> x = Form.letter(domain, "x")
    >>> antiderivative(x, domain.symbol("x")).equals(x.times(x).scaled(Fraction(1, 2)))
    True
    """
    domain = form.domain
    return term_by_term(
        form, letter, lambda moving: _of_term(domain, moving, letter), "the integral of a quotient"
    )


def _of_term(domain: Domain, moving: Monomial, letter: int) -> Form:
    power: Exponent = 0
    rate, wave = Form.number(domain, 0), Form.number(domain, 1)
    for number, exponent in moving:
        if number == letter:
            power = exponent
        else:
            rate = rate.plus(_rate(domain, number, exponent, letter))
            wave = wave.times(Form.of(domain, {((number, exponent),): Fraction(1)}))
    variable = Form.of(domain, {((letter, 1),): Fraction(1)})
    if rate.is_zero() is True:
        return _of_power(domain, letter, power)
    if power.denominator != 1 or not 0 <= power <= HIGHEST_POWER:
        raise NoFormError("the integral of such a power beside a wave")
    assume_not_zero(rate)
    total, factor, below = Form.number(domain, 0), Fraction(1), rate
    for step in range(int(power) + 1):
        total = total.plus(variable.raised(int(power) - step).scaled(factor).over(below))
        factor *= -(int(power) - step)
        below = below.times(rate)
    return total.times(wave)


def _of_power(domain: Domain, letter: int, power: Exponent) -> Form:
    if power == -1:
        return functions.logarithm(Form.of(domain, {((letter, 1),): Fraction(1)}))
    return Form.of(domain, {((letter, power + 1),): 1 / Fraction(power + 1)})


def _rate(domain: Domain, number: int, exponent: Exponent, letter: int) -> Form:
    """Return s of the exponential e^(sx) that a power of a generator is."""
    generator = domain.generators[number]
    if generator.kind not in ("exponential", "growth"):
        raise NoFormError("the integral of a root or a function")
    content = dict(generator.content)
    if content.pop(letter, 0) != 1:
        raise NoFormError("the integral of a wave whose angle is no multiple of the variable")
    if any(Dependence(domain, letter).of(g) for g in content):
        raise NoFormError("the integral of a wave within a wave")
    rest = tuple(sorted(content.items()))
    rate = Form.of(domain, {rest: Fraction(exponent)})
    return rate.times(unit(domain)) if generator.kind == "exponential" else rate


def assume_not_zero(form: Form) -> None:
    """Note that a form made of letters is not 0, unless it is a product of positive ones."""
    domain = form.domain
    if form.rational() is not None or not form.is_polynomial:
        return
    letters = {g for monomial in form.numerator for g, _ in monomial}
    open_letters = [g for g in letters if domain.generators[g].kind not in ("turn", "prime", "growth")]
    is_product = len(form.numerator) == 1
    if is_product and all(domain.generators[g].positive for g in open_letters):
        return
    text = f"{_printed(form)} ≠ 0"
    domain.assumptions[text] = None
    note_that_not_zero(form, text)


def _printed(form: Form) -> str:
    """Return a rate in print: without the i and the common factor that play no part in its zero."""
    domain = form.domain
    terms = []
    content = next(iter(form.numerator.values()))
    for monomial, coefficient in form.numerator.items():
        letters = [
            f"{domain.generators[g].content}" + ("" if e == 1 else f"^{e}")
            for g, e in monomial
            if domain.generators[g].kind in ("symbol", "constant")
        ]
        factor = coefficient / content
        size = "" if abs(factor) == 1 and letters else f"{abs(factor)} "
        sign = "-" if factor < 0 else "+"
        terms.append(f"{sign} {size}{' '.join(letters)}".rstrip())
    return " ".join(terms).removeprefix("+ ")


def definite(form: Form, letter: int, lower: Form, upper: Form) -> Form:
    """Return the integral of a form from one value of a letter to another."""
    whole = antiderivative(form, letter)
    return substitute_letter(whole, letter, upper).minus(substitute_letter(whole, letter, lower))
