"""Derivatives of normal forms by the chain rule, generator by generator.

A form is a quotient of polynomials in generators, so its rate is the sum over the generators g of
(g dp/dg) (g'/g), with g'/g computed once: x'/x for a letter, i m' for e^(i m), q'/(2q) for the root of q.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from symbalance.notes.algebra.domain import HALF, Domain, NoFormError, Polynomial
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.functions import MEAN, TURNING, opaque
from symbalance.notes.algebra.means import mean
from symbalance.notes.algebra.roots import root, unit

Rates = Mapping[int, Polynomial]


def differentiate(form: Form, rates: Rates) -> Form:
    """Return the rate of change, given the rates of the letters that change; the others are constant.

    >>> domain = Domain()
    >>> s = Form.letter(domain, "s")
    >>> differentiate(s.times(s), {domain.symbol("s"): {(): Fraction(1)}}).equals(s.scaled(2))
    True
    """
    return _Differentiation(form.domain, rates).of(form)


class _Differentiation:
    def __init__(self, domain: Domain, rates: Rates) -> None:
        self.domain, self.rates = domain, rates
        self._relative_rates: dict[int, Form] = {}

    def of(self, form: Form) -> Form:
        top = self.polynomial(form.numerator)
        if form.is_polynomial:
            return top
        below = Form.of(self.domain, form.denominator)
        return top.minus(form.times(self.polynomial(form.denominator))).over(below)

    def polynomial(self, polynomial: Polynomial) -> Form:
        total = Form.number(self.domain, 0)
        for number in sorted({g for monomial in polynomial for g, _ in monomial}):
            relative = self.relative(number)
            if relative.numerator:
                terms = {m: c * e for m, c in polynomial.items() for g, e in m if g == number}
                total = total.plus(Form.of(self.domain, terms).times(relative))
        return total

    def relative(self, number: int) -> Form:
        """Return g'/g for a generator g."""
        if number not in self._relative_rates:
            self._relative_rates[number] = self._find_relative(number)
        return self._relative_rates[number]

    def _find_relative(self, number: int) -> Form:
        domain, generator = self.domain, self.domain.generators[number]
        if generator.kind == "symbol":
            return Form.of(domain, self.rates.get(number, {})).over(_itself(domain, number))
        if generator.kind in ("exponential", "growth"):
            inner = self.polynomial({generator.content: Fraction(1)})
            return inner.times(unit(domain)) if generator.kind == "exponential" else inner
        if generator.kind == "radical":
            rate = self.polynomial(generator.content)
            return rate.over(Form.of(domain, generator.content)).scaled(HALF) if rate.numerator else rate
        if generator.kind == "opaque":
            rate = self._opaque(*generator.content)
            return rate.over(_itself(domain, number)) if rate.numerator else rate
        return Form.number(domain, 0)

    def _opaque(self, function: str, argument: Form) -> Form:
        inner = self.of(argument)
        if inner.is_zero():
            return Form.number(self.domain, 0)
        if function == MEAN:
            return mean(inner, self.domain.symbol(TURNING))
        if function not in _SLOPES:
            raise NoFormError("the derivative of a function that has no rule here")
        return inner.times(_SLOPES[function](argument))


def _itself(domain: Domain, number: int) -> Form:
    return Form.of(domain, {((number, 1),): Fraction(1)})


def _one_over(form: Form) -> Form:
    return Form.number(form.domain, 1).over(form)


def _square_and_one(argument: Form, sign: int) -> Form:
    return Form.number(argument.domain, 1).plus(argument.times(argument).scaled(sign))


_SLOPES: dict[str, Callable[[Form], Form]] = {
    "ln": _one_over,
    "atan": lambda x: _one_over(_square_and_one(x, 1)),
    "asin": lambda x: _one_over(root(_square_and_one(x, -1))),
    "acos": lambda x: _one_over(root(_square_and_one(x, -1))).scaled(-1),
    "besselj0": lambda x: opaque("besselj1", x).scaled(-1),
    "besselj1": lambda x: opaque("besselj0", x).minus(opaque("besselj1", x).over(x)),
    "over": lambda x: _one_over(x.times(x)).scaled(-1),
}
