"""The mean of a form over one turn of an angle: what is left once all that swings is taken away.

Of a polynomial in waves e^(ikx) it is the terms with k = 0. Of other forms that repeat after a turn, such
as a root, it stays a function of its own, "mean", of a form in the letter `TURNING`: it can be
expanded in every other letter, term by term, and evaluated.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.notes.algebra import functions
from symbalance.notes.algebra import polynomials as poly
from symbalance.notes.algebra.domain import Domain, Exponent, Monomial, NoFormError, Polynomial
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.functions import MEAN, TURNING
from symbalance.notes.algebra.substitution_in_forms import Dependence, depends, substitute_letter

MOST_TERMS = 80
"""Of a form that is averaged over its images: larger ones cost seconds."""


def mean(form: Form, letter: int) -> Form:
    """Return the mean of a form from 0 to 2π of a letter, given by its generator's number.

    >>> from symbalance.notes.algebra.domain import Domain
    >>> domain = Domain()
    >>> cosine = functions.cosine(Form.letter(domain, "x"))
    >>> mean(cosine.times(cosine), domain.symbol("x")).rational()
    Fraction(1, 2)
    """
    domain, dependence = form.domain, Dependence(form.domain, letter)
    for number in {g for p in (form.numerator, form.denominator) for m in p for g, _ in m}:
        _refuse_what_does_not_repeat(domain, number, letter, dependence)
    if dependence.of_polynomial(form.denominator):
        return _of_quotient(form, dependence, letter)
    parts: dict[Monomial, Polynomial] = {}
    for monomial, coefficient in form.numerator.items():
        free = tuple((g, e) for g, e in monomial if not dependence.of(g))
        moving = tuple((g, e) for g, e in monomial if dependence.of(g))
        is_wave = all(domain.generators[g].kind == "exponential" for g, _ in moving)
        if is_wave and moving:
            continue  # e^(ikx), k a whole number other than 0
        part = parts.setdefault(free, {})
        part[moving] = part.get(moving, Fraction(0)) + coefficient
    total = Form.number(domain, 0)
    for free, moving_part in parts.items():
        outside = Form.of(domain, {free: Fraction(1)})
        total = total.plus(outside.times(_of_moving(Form.of(domain, moving_part), letter)))
    return total.over(Form.of(domain, form.denominator))


def _of_quotient(form: Form, dependence: Dependence, letter: int) -> Form:
    """Return the mean of what has the letter in its denominator, common factors taken out of it."""
    domain = form.domain
    outside = Form.number(domain, 1)
    inside = [form.numerator, form.denominator]
    for place, polynomial in enumerate(inside):
        shared = _common(polynomial, dependence)
        if not shared:
            continue
        _, inverse = domain.raised(shared, -1)
        inside[place] = poly.times(domain, polynomial, {inverse: Fraction(1)})
        factor = Form.of(domain, {shared: Fraction(1)})
        outside = outside.over(factor) if place else outside.times(factor)
    rest = Form.of(domain, *inside)
    if not dependence.of_polynomial(rest.denominator):
        return outside.times(mean(rest, letter))
    return outside.times(_of_moving(rest, letter))


def _common(polynomial: Polynomial, dependence: Dependence) -> Monomial:
    """Return the letters that all terms have in common, each with its lowest power."""
    generators = dependence.domain.generators
    shared: dict[int, Exponent] | None = None
    for monomial in polynomial:
        own = {g: e for g, e in monomial if generators[g].kind == "symbol" and not dependence.of(g)}
        shared = own if shared is None else {g: min(e, own[g]) for g, e in shared.items() if g in own}
    return tuple(sorted((shared or {}).items()))


def _of_moving(inside: Form, letter: int) -> Form:
    if not depends(inside, letter):
        return inside
    """Return the mean of what has no antiderivative here, averaged over reflection and half a turn.

    Of √(1 - ε² sin²θ) cos 3θ nothing remains, as each half of the turn takes away what the other brings.
    """
    domain = inside.domain
    if len(inside.numerator) + len(inside.denominator) > MOST_TERMS:
        turning = Form.letter(domain, TURNING)
        return functions.opaque(MEAN, substitute_letter(inside, letter, turning))
    turning, half_turn = Form.letter(domain, TURNING), Form.constant(domain, "pi")
    images = (turning, turning.scaled(-1), turning.plus(half_turn), half_turn.minus(turning))
    total = Form.number(domain, 0)
    for image in images:
        total = total.plus(substitute_letter(inside, letter, image))
    total = total.scaled(Fraction(1, len(images)))
    number = domain.symbol(TURNING)
    generators = {g for p in (total.numerator, total.denominator) for m in p for g, _ in m}
    moving = [g for g in generators if Dependence(domain, number).of(g)]
    if all(domain.generators[g].kind == "exponential" for g in moving) and total.is_polynomial:
        return Form.of(domain, {m: c for m, c in total.numerator.items() if not {*moving} & {*dict(m)}})
    return functions.opaque(MEAN, total)


def _refuse_what_does_not_repeat(
    domain: Domain, number: int, letter: int, dependence: Dependence
) -> None:
    """Refuse a generator that is not the same after a turn of the letter, such as the letter itself."""
    if not dependence.of(number):
        return
    generator = domain.generators[number]
    inside: list[Monomial] = []
    if generator.kind == "exponential" and generator.content == ((letter, 1),):
        return
    if generator.kind == "radical":
        inside = list(generator.content)
    elif generator.kind == "opaque" and generator.content[0] != MEAN:
        inside = [*generator.content[1].numerator, *generator.content[1].denominator]
    if not inside:
        raise NoFormError("the mean over a turn of what does not repeat after it")
    for monomial in inside:
        for inner, exponent in monomial:
            if domain.generators[inner].kind == "exponential" and exponent.denominator != 1:
                raise NoFormError("the mean over a turn of what does not repeat after it")
            _refuse_what_does_not_repeat(domain, inner, letter, dependence)
