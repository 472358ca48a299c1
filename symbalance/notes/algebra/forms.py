"""Quotients of Laurent polynomials: the normal form in which equations are decided."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from symbalance.notes.algebra import polynomials as poly
from symbalance.notes.algebra.domain import ONE, Domain, Monomial, NoFormError, Polynomial
from symbalance.notes.algebra.polynomials import UNIT, common_multiple, is_unit, quotient
from symbalance.notes.algebra.zero import is_zero


@dataclass(frozen=True, slots=True, eq=False)
class Form:
    """numerator/denominator over one domain; the denominator is 1 or has at least two terms.

    Two forms a/b and c/d are equal exactly when a d - b c is the zero polynomial.

    >>> domain = Domain()
    >>> s = Form.letter(domain, "s")
    >>> s.over(s.plus(s)).equals(Form.number(domain, Fraction(1, 2)))
    True
    """

    domain: Domain
    numerator: Polynomial
    denominator: Polynomial

    @staticmethod
    def of(domain: Domain, numerator: Polynomial, denominator: Polynomial | None = None) -> Form:
        """Return the quotient; a denominator of one term is carried into the numerator."""
        if denominator is None or is_unit(denominator):
            return Form(domain, numerator, UNIT)
        if is_zero(domain, denominator) is not False:
            raise NoFormError("a division by zero")
        if len(denominator) == 1:
            ((monomial, coefficient),) = denominator.items()
            if not any(g in domain.radicals for g, _ in monomial):
                factor, inverse = domain.raised(monomial, -1)
                numerator = poly.times(domain, numerator, {inverse: factor / coefficient})
                return Form(domain, numerator, UNIT)
        return _with_rational_denominator(domain, numerator, denominator)

    @staticmethod
    def number(domain: Domain, value: Fraction | int) -> Form:
        """Return a rational number."""
        return Form.of(domain, poly.constant(value))

    @staticmethod
    def letter(domain: Domain, name: str) -> Form:
        """Return a letter."""
        return Form.of(domain, {((domain.symbol(name), 1),): Fraction(1)})

    @staticmethod
    def constant(domain: Domain, name: str) -> Form:
        """Return the number `pi` or `e`."""
        return Form.of(domain, {((domain.constant(name), 1),): Fraction(1)})

    @property
    def is_polynomial(self) -> bool:
        """Tell whether the denominator is 1."""
        return is_unit(self.denominator)

    def rational(self) -> Fraction | None:
        """Return the value of a form that is a rational number, else None."""
        if self.is_polynomial and poly.is_rational(self.numerator):
            return self.numerator.get(ONE, Fraction(0))
        return None

    def plus(self, other: Form) -> Form:
        """Return the sum."""
        if self.denominator is other.denominator or self.denominator == other.denominator:
            return Form.of(self.domain, poly.plus(self.numerator, other.numerator), self.denominator)
        own_factor, other_factor, below = common_multiple(
            self.domain, self.denominator, other.denominator
        )
        cross = poly.plus(
            poly.times(self.domain, self.numerator, own_factor),
            poly.times(self.domain, other.numerator, other_factor),
        )
        return Form.of(self.domain, cross, below)

    def scaled(self, factor: Fraction | int) -> Form:
        """Return the form times a rational."""
        return Form(self.domain, poly.scale(self.numerator, factor), self.denominator)

    def minus(self, other: Form) -> Form:
        """Return the difference."""
        return self.plus(other.scaled(-1))

    def times(self, other: Form) -> Form:
        """Return the product."""
        if self.denominator is UNIT and other.denominator is UNIT:
            return Form(self.domain, poly.times(self.domain, self.numerator, other.numerator), UNIT)
        return Form.of(
            self.domain,
            poly.times(self.domain, self.numerator, other.numerator),
            poly.times(self.domain, self.denominator, other.denominator),
        )

    def over(self, other: Form) -> Form:
        """Return the quotient; a divisor that is zero raises NoFormError."""
        if is_zero(self.domain, other.numerator) is not False:
            raise NoFormError("a division by zero")
        return Form.of(
            self.domain,
            poly.times(self.domain, self.numerator, other.denominator),
            poly.times(self.domain, self.denominator, other.numerator),
        )

    def raised(self, exponent: int) -> Form:
        """Return the form to a whole power."""
        if exponent < 0:
            return Form.number(self.domain, 1).over(self.raised(-exponent))
        return Form.of(
            self.domain,
            poly.power(self.domain, self.numerator, exponent),
            poly.power(self.domain, self.denominator, exponent),
        )

    def is_zero(self) -> bool | None:
        """Return True or False where it is proved, else None."""
        return is_zero(self.domain, self.numerator)

    def equals(self, other: Form) -> bool | None:
        """Return True or False where it is proved, else None."""
        return self.minus(other).is_zero()


def _with_rational_denominator(domain: Domain, numerator: Polynomial, denominator: Polynomial) -> Form:
    """Return numerator/denominator without radicals below: multiplied by the conjugate of each."""
    for generator in list(domain.radicals):
        if any(g == generator for m in denominator for g, _ in m):
            conjugate = {
                m: -c if any(g == generator for g, _ in m) else c for m, c in denominator.items()
            }
            numerator = poly.times(domain, numerator, conjugate)
            denominator = poly.times(domain, denominator, conjugate)
            return Form.of(domain, numerator, denominator)
    shared = _shared_special_factor(domain, denominator)
    if shared:
        factor, inverse = domain.raised(shared, -1)
        by = {inverse: Fraction(factor)}
        below = poly.times(domain, denominator, by)
        return Form.of(domain, poly.times(domain, numerator, by), below)
    whole = quotient(domain, numerator, denominator)
    return Form(domain, numerator, denominator) if whole is None else Form.of(domain, whole)


def _shared_special_factor(domain: Domain, denominator: Polynomial) -> Monomial:
    """Return the turn or root that all terms below share: i in sin θ = (e^(iθ) - e^(-iθ))/(2i).

    No division by a polynomial that holds one is tried, and the quotient would stay one for ever.
    """
    parts = {tuple((g, e) for g, e in m if not domain.is_free(g)) for m in denominator}
    return parts.pop() if len(parts) == 1 else ONE
