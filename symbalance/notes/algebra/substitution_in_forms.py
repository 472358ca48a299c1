"""A letter of a normal form replaced by another form, inside angles, roots and functions too."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from symbalance.notes.algebra import functions
from symbalance.notes.algebra.domain import Domain, Exponent, Monomial, NoFormError, Polynomial
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.roots import root, unit


def depends(form: Form, number: int) -> bool:
    """Tell whether a form holds a letter, given by its generator's number."""
    walk = Dependence(form.domain, number)
    return walk.of_polynomial(form.numerator) or walk.of_polynomial(form.denominator)


class Dependence:
    """Which generators of a domain hold a letter; each is looked into once."""

    def __init__(self, domain: Domain, letter: int) -> None:
        self.domain, self.letter = domain, letter
        self._answers: dict[int, bool] = {}

    def of_polynomial(self, polynomial: Polynomial) -> bool:
        """Tell whether a polynomial holds the letter."""
        return any(self.of(g) for monomial in polynomial for g, _ in monomial)

    def of(self, number: int) -> bool:
        """Tell whether a generator holds the letter."""
        if number not in self._answers:
            self._answers[number] = number == self.letter or self._inside(number)
        return self._answers[number]

    def _inside(self, number: int) -> bool:
        generator = self.domain.generators[number]
        if generator.kind in ("exponential", "growth"):
            return any(self.of(g) for g, _ in generator.content)
        if generator.kind == "radical":
            return self.of_polynomial(generator.content)
        if generator.kind == "opaque":
            argument = generator.content[1]
            return self.of_polynomial(argument.numerator) or self.of_polynomial(argument.denominator)
        return False


def term_by_term(form: Form, letter: int, of_moving: Callable[[Monomial], Form], refusal: str) -> Form:
    """Return a linear function of a form: what is free of the letter stands outside, term by term.

    Refused, with the reason, where the letter stands in the denominator.
    """
    domain, dependence = form.domain, Dependence(form.domain, letter)
    if dependence.of_polynomial(form.denominator):
        raise NoFormError(refusal)
    total = Form.number(domain, 0)
    for monomial, coefficient in form.numerator.items():
        free = tuple((g, e) for g, e in monomial if not dependence.of(g))
        moving = tuple((g, e) for g, e in monomial if dependence.of(g))
        outside = Form.of(domain, {free: coefficient})
        total = total.plus(outside.times(of_moving(moving)))
    return total.over(Form.of(domain, form.denominator))


def substitute_letter(form: Form, letter: int, value: Form) -> Form:
    """Return a form with a letter replaced by a form.

    >>> domain = Domain()
    >>> x = Form.letter(domain, "x")
    >>> substitute_letter(x.times(x), domain.symbol("x"), Form.number(domain, 3)).rational()
    Fraction(9, 1)
    """
    return _Substitution(form.domain, letter, value).of(form)


class _Substitution:
    def __init__(self, domain: Domain, letter: int, value: Form) -> None:
        self.domain, self.letter, self.value = domain, letter, value
        self.dependence = Dependence(domain, letter)
        self._powers: dict[tuple[int, Exponent], Form] = {}

    def of(self, form: Form) -> Form:
        above, below = self.polynomial(form.numerator), self.polynomial(form.denominator)
        return above if form.is_polynomial else above.over(below)

    def polynomial(self, polynomial: Polynomial) -> Form:
        if not self.dependence.of_polynomial(polynomial):
            return Form.of(self.domain, polynomial)
        total = Form.number(self.domain, 0)
        for monomial, coefficient in polynomial.items():
            free: Monomial = tuple((g, e) for g, e in monomial if not self.dependence.of(g))
            term = Form.of(self.domain, {free: coefficient})
            for number, exponent in monomial:
                if self.dependence.of(number):
                    term = term.times(self.power(number, exponent))
            total = total.plus(term)
        return total

    def power(self, number: int, exponent: Exponent) -> Form:
        """Return what a power becomes, worked out once: it stands in many terms."""
        key = (number, exponent)
        if key not in self._powers:
            self._powers[key] = self._find_power(number, exponent)
        return self._powers[key]

    def _find_power(self, number: int, exponent: Exponent) -> Form:
        generator = self.domain.generators[number]
        if generator.kind in ("exponential", "growth"):
            inner = self.polynomial({generator.content: Fraction(1)}).scaled(Fraction(exponent))
            turned = inner.times(unit(self.domain)) if generator.kind == "exponential" else inner
            return functions.exponential(turned)
        base = self.base(number)
        if exponent.denominator == 1:
            return base.raised(int(exponent))
        if exponent.denominator == 2:
            return root(base).raised(exponent.numerator)
        raise NoFormError("a root that is no square root")

    def base(self, number: int) -> Form:
        """Return what a letter, a root or a function becomes."""
        generator = self.domain.generators[number]
        if number == self.letter:
            return self.value
        if generator.kind == "radical":
            return root(self.polynomial(generator.content))
        function, argument = generator.content
        inside = self.of(argument)
        if function == "over":
            return Form.number(self.domain, 1).over(inside)
        if function == "sum":
            raise NoFormError("a sum without bounds")
        if function == functions.MEAN:
            return functions.opaque(function, inside)
        return functions.apply(function, inside)
