"""Exact power series of a normal form in one small letter (ρ, or 1/λ), with the order they go through.

A series is a map from exponents to forms together with the exponent through which it is known. A form is
expanded generator by generator: powers of the letter as they stand, roots by the binomial recurrence,
angles and logarithms by Taylor's series where the letter stands inside them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from symbalance.notes.algebra import functions
from symbalance.notes.algebra.bessel import series_of
from symbalance.notes.algebra.domain import HALF, Domain, Monomial, NoFormError, Polynomial
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.functions import MEAN, TURNING
from symbalance.notes.algebra.means import mean
from symbalance.notes.algebra.roots import root, unit

SLACK = 6
"""Orders computed beyond the one wanted: a quotient whose denominator begins late loses some."""


@dataclass(frozen=True, slots=True)
class FormSeries:
    """The sum of terms[k] e^k, all k up to `through`; what lies beyond is not known."""

    domain: Domain
    terms: dict[int, Form]
    through: int

    @property
    def start(self) -> int:
        """The lowest exponent present (`through` + 1 where nothing is)."""
        return min(self.terms, default=self.through + 1)

    def cut(self, through: int) -> FormSeries:
        """Return the series known only through a lower order, zeros dropped."""
        terms = {k: f for k, f in self.terms.items() if k <= through and f.is_zero() is not True}
        return FormSeries(self.domain, terms, min(through, self.through))

    def without_zeros(self) -> FormSeries:
        """Return the series without the terms that are zero."""
        return self.cut(self.through)

    def plus(self, other: FormSeries) -> FormSeries:
        """Return the sum."""
        total = dict(self.terms)
        for k, form in other.terms.items():
            total[k] = total[k].plus(form) if k in total else form
        return FormSeries(self.domain, total, min(self.through, other.through)).cut(
            min(self.through, other.through)
        )

    def scaled(self, factor: Form) -> FormSeries:
        """Return the series times a form free of the small letter."""
        return FormSeries(self.domain, {k: f.times(factor) for k, f in self.terms.items()}, self.through)

    def times(self, other: FormSeries, limit: int) -> FormSeries:
        """Return the product, through at most `limit`."""
        through = min(self.through + other.start, other.through + self.start, limit)
        total: dict[int, Form] = {}
        for j, a in self.terms.items():
            for k, b in other.terms.items():
                if j + k <= through:
                    product = a.times(b)
                    total[j + k] = total[j + k].plus(product) if j + k in total else product
        return FormSeries(self.domain, total, through).cut(through)

    def shifted(self, by: int) -> FormSeries:
        """Return the series times e^by."""
        return FormSeries(self.domain, {k + by: f for k, f in self.terms.items()}, self.through + by)


class Expansion:
    """Expands forms of one domain in one letter; `sign` is -1 where the letter is large (1/λ small)."""

    def __init__(self, domain: Domain, letter: str, sign: int, through: int) -> None:
        self.domain, self.sign, self.limit = domain, sign, through + SLACK
        self.number = domain.symbol(letter)
        self._powers: dict[tuple[int, Fraction | int], FormSeries] = {}
        self._half_powers: set[int] = set()
        self._depends: dict[int, bool] = {}

    def of(self, form: Form) -> FormSeries:
        """Return the series of a form; raises NoFormError where there is none in whole powers."""
        above, below = self.polynomial(form.numerator), self.polynomial(form.denominator)
        return above if form.is_polynomial else above.times(self.reciprocal(below), self.limit)

    def constant(self, form: Form) -> FormSeries:
        """Return a form free of the letter."""
        return FormSeries(self.domain, {0: form}, self.limit + 4 * SLACK).cut(self.limit + 4 * SLACK)

    def polynomial(self, polynomial: Polynomial) -> FormSeries:
        """Return the series of a polynomial."""
        total = FormSeries(self.domain, {}, self.limit + 4 * SLACK)
        for monomial, coefficient in polynomial.items():
            total = total.plus(self._term(monomial, coefficient))
        return total

    def _term(self, monomial: Monomial, coefficient: Fraction) -> FormSeries:
        free = [(g, e) for g, e in monomial if not self.depends(g)]
        result = self.constant(Form.of(self.domain, {tuple(free): coefficient}))
        shift: Fraction | int = 0
        for number, exponent in monomial:
            if number == self.number:
                shift += exponent * self.sign
            elif self.depends(number):
                result = result.times(self.power(number, exponent), self.limit)
                shift -= HALF if number in self._half_powers else 0
        return result.shifted(_whole(shift))

    def depends(self, number: int) -> bool:
        """Tell whether a generator holds the letter; each is looked into once."""
        if number not in self._depends:
            self._depends[number] = number == self.number or any(
                self.depends(g) for monomial in self._inside(number) for g, _ in monomial
            )
        return self._depends[number]

    def _inside(self, number: int) -> Iterator[Monomial]:
        """Yield the monomials that a generator's angle, root or function holds."""
        generator = self.domain.generators[number]
        if generator.kind in ("exponential", "growth"):
            yield generator.content
        elif generator.kind == "radical":
            yield from generator.content
        elif generator.kind == "opaque":
            argument = generator.content[1]
            yield from (*argument.numerator, *argument.denominator)

    def power(self, number: int, exponent: Fraction | int) -> FormSeries:
        """Return the series of generator^exponent; of one in `_half_powers`, times letter^(1/2)."""
        key = (number, exponent)
        if key not in self._powers:
            self._powers[key] = self._expand(number, exponent)
        return self._powers[key]

    def _expand(self, number: int, exponent: Fraction | int) -> FormSeries:
        """Return the series of a power of one generator."""
        generator = self.domain.generators[number]
        if generator.kind == "radical" and exponent == 1:
            square = self.polynomial(generator.content).without_zeros()
            if square.start % 2:
                self._half_powers.add(number)
                square = square.shifted(1)
            return self.root(square)
        if generator.kind in ("exponential", "growth"):
            inner = self._term(generator.content, Fraction(exponent))
            if generator.kind == "exponential":
                inner = inner.scaled(unit(self.domain))
            return self._exponential(inner)
        if generator.kind == "opaque" and exponent == int(exponent) and 0 < exponent <= self.limit:
            function, argument = generator.content
            once = total = self._function(function, self.of(argument))
            for _ in range(int(exponent) - 1):
                total = total.times(once, self.limit)
            return total
        raise NoFormError("a part that has no power series here")

    def _compose(self, coefficients: list[Fraction], inner: FormSeries) -> FormSeries:
        """Return the sum of coefficients[k] inner^k; `inner` starts at order 1 or higher."""
        if inner.start < 1:
            raise NoFormError("a function expanded where it is not small")
        total = self.constant(Form.number(self.domain, coefficients[0]))
        power = self.constant(Form.number(self.domain, 1))
        for coefficient in coefficients[1 : self.limit + 2]:
            power = power.times(inner, self.limit)
            if coefficient:
                total = total.plus(power.scaled(Form.number(self.domain, coefficient)))
        return total.cut(min(inner.through, self.limit))

    def _exponential(self, inner: FormSeries) -> FormSeries:
        coefficients, value = [Fraction(1)], Fraction(1)
        for k in range(1, self.limit + 2):
            value /= k
            coefficients.append(value)
        if 0 in inner.terms:
            steady = functions.exponential(inner.terms[0])
            moving = FormSeries(self.domain, {k: f for k, f in inner.terms.items() if k}, inner.through)
            return self._compose(coefficients, moving).scaled(steady)
        return self._compose(coefficients, inner)

    def _function(self, function: str, inner: FormSeries) -> FormSeries:
        """Return the series of a function of a series: about 0, of ln about 1."""
        size = self.limit + 2
        if function == "over":
            return self.reciprocal(inner)
        if function == MEAN:
            turning = self.domain.symbol(TURNING)
            terms = {k: mean(form, turning) for k, form in inner.terms.items()}
            return FormSeries(self.domain, terms, inner.through).without_zeros()
        if function in ("besselj0", "besselj1"):
            return self._compose(series_of(int(function[-1]), size), inner)
        if function == "asin":
            return self._compose(_asin(size), inner)
        if function == "atan":
            return self._compose(
                [Fraction((-1) ** (k // 2), k) if k % 2 else Fraction(0) for k in range(size)], inner
            )
        if function == "ln" and 0 in inner.terms and inner.terms[0].rational() == 1:
            rest = FormSeries(self.domain, {k: f for k, f in inner.terms.items() if k}, inner.through)
            return self._compose(
                [Fraction(0)] + [Fraction(-((-1) ** k), k) for k in range(1, size)], rest
            )
        raise NoFormError(f"the series of {function}")

    def _split_leading(self, series: FormSeries) -> tuple[Form, int, FormSeries]:
        """Return (c, k, u) with series = c e^k (1 + u) and u of order 1 or higher."""
        first = series.without_zeros()
        if not first.terms:
            raise NoFormError("a series with no leading term")
        start = first.start
        leading = first.terms[start]
        inverse = Form.number(self.domain, 1).over(leading)
        rest = FormSeries(
            self.domain, {k: f for k, f in first.terms.items() if k != start}, first.through
        )
        return leading, start, rest.scaled(inverse).shifted(-start)

    def reciprocal(self, series: FormSeries) -> FormSeries:
        """Return 1/series."""
        leading, start, rest = self._split_leading(series)
        one = Form.number(self.domain, 1)
        signs = [Fraction((-1) ** k) for k in range(self.limit + 2 + 4 * SLACK)]
        return self._compose(signs, rest).scaled(one.over(leading)).shifted(-start)

    def root(self, series: FormSeries) -> FormSeries:
        """Return the positive square root: the binomial series with exponent 1/2."""
        leading, start, rest = self._split_leading(series)
        if start % 2:
            raise NoFormError("a root with half powers")
        coefficients, value = [Fraction(1)], Fraction(1)
        for k in range(1, self.limit + 2):
            value *= (Fraction(1, 2) - (k - 1)) / k
            coefficients.append(value)
        return self._compose(coefficients, rest).scaled(root(leading)).shifted(start // 2)


def _whole(exponent: Fraction | int) -> int:
    if exponent != int(exponent):
        raise NoFormError("half powers of the small letter")
    return int(exponent)


def _asin(size: int) -> list[Fraction]:
    """Return the coefficients of asin x: C(2k, k)/(4^k (2k+1)) at x^(2k+1)."""
    result, value = [Fraction(0)] * size, Fraction(1)
    for k in range((size - 1) // 2 + 1):
        if 2 * k + 1 < size:
            result[2 * k + 1] = value / (2 * k + 1)
        value *= Fraction(2 * k + 1, 2 * k + 2)
    return result
