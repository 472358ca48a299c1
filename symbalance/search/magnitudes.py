"""Exact sizes, compared exactly: sqrt(a) + sqrt(b) with a and b real numbers of a cyclotomic field.

The largest value of an order over a turn is |z| + |w|, of its halves that turn with and against the
crank: a = z z*, b = w w*. Zero is a = b = 0, which the field decides. Two sizes are equal,

    sqrt(a) + sqrt(b) = sqrt(c) + sqrt(d)   with D = a + b - c - d, p = ab, q = cd,

exactly if D = 2 sqrt(q) - 2 sqrt(p): where D = 0, if p = q; else if D has the sign of q - p, and
E = 4(p + q) - D^2 is 8 sqrt(pq): E not negative, E^2 = 64 pq. All of these are zeros and signs in the
field. Sizes that are not equal are evaluated to ever more digits until their intervals part.

Formulas:
    (2 q - 2 p)^2 = 4 (p^2 + q^2) - 8 p q
    with p = sqrt(a b); q = sqrt(c d); a, b, c, d positive
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property, cmp_to_key

from symbalance.document.formula import Formula
from symbalance.exact.phasor import ZERO, Phasor
from symbalance.exact.radicals.closed_forms import ClosedForm
from symbalance.exact.radicals.forms import square_root_form
from symbalance.text.reals import Real, sqrt

DIGITS = 20
MOST_DIGITS = 100_000
"""Where the search for a digit in which two sizes differ ends: they are known to differ."""


@dataclass(frozen=True, eq=False)
class Magnitude:
    """sqrt(first) + sqrt(second), both real and not negative.

    >>> root = Magnitude.rational(Fraction(3, 2))
    >>> root.spelling, root.is_zero(), compare(root, Magnitude.rational(2))
    ('3/2', False, -1)
    """

    first: Phasor
    second: Phasor = field(default_factory=lambda: ZERO)

    @staticmethod
    def rational(value: int | Fraction) -> Magnitude:
        """Return a rational number, zero or positive."""
        return Magnitude(Phasor.of(1, {0: Fraction(value) ** 2}))

    def is_zero(self) -> bool:
        """Tell whether it is zero: a proof either way."""
        return self.first.is_zero() and self.second.is_zero()

    def value(self, digits: int = DIGITS) -> Real:
        """Return it in decimals, to so many digits."""
        parts = [one for one in (self.first, self.second) if not one.is_zero()]
        total = Real(0, digits + 5)
        for part in parts:
            total += sqrt(part.real_value(digits + 5), digits + 5)
        return total

    @cached_property
    def near(self) -> Real:
        """Its value to `DIGITS` digits."""
        return self.value()

    @cached_property
    def _form(self) -> ClosedForm:
        parts = [square_root_form(one) for one in (self.first, self.second) if not one.is_zero()]
        return sum(parts[1:], parts[0]) if parts else ClosedForm({})

    @property
    def spelling(self) -> str:
        """The exact number as SymPy reads it."""
        return self._form.spelling

    def as_formula(self) -> Formula:
        """Return the exact number as a formula."""
        return self._form.as_formula()


def compare(left: Magnitude, right: Magnitude) -> int:
    """Return -1, 0 or 1 as the left size is smaller, equal or larger: decided, never rounded.

    >>> two, three, five = (Magnitude(Phasor.of(1, {0: n})) for n in (2, 3, 5))
    >>> both = Magnitude(two.first, three.first)  # (sqrt 2 + sqrt 3)^2 = 5 + sqrt 24
    >>> compare(both, both), compare(five, both)
    (0, -1)
    """
    sign = _apart(left, right, DIGITS)
    if sign or _equal(left, right):
        return sign
    digits = 2 * DIGITS
    while not sign:
        sign = _apart(left, right, digits)
        digits *= 2
        if digits > MOST_DIGITS:
            raise AssertionError("two sizes are called different, and have no digit in which they differ")
    return sign


def largest(sizes: Iterable[Magnitude]) -> Magnitude:
    """Return the largest of some sizes, zero if there is none."""
    return max(sizes, key=cmp_to_key(compare), default=Magnitude(ZERO))


def _apart(left: Magnitude, right: Magnitude, digits: int) -> int:
    """Return the sign of a difference that shows in so many digits, 0 where none does."""
    first = left.near if digits == DIGITS else left.value(digits)
    second = right.near if digits == DIGITS else right.value(digits)
    if abs(first - second) <= (first + second) * Fraction(1, 10 ** (digits - 3)):
        return 0
    return 1 if first > second else -1


def _equal(left: Magnitude, right: Magnitude) -> bool:
    a, b, c, d = left.first, left.second, right.first, right.second
    if (a - c).is_zero() and (b - d).is_zero():
        return True
    difference = a + b - c - d
    p, q = a.multiplied(b), c.multiplied(d)
    if difference.is_zero():
        return (p - q).is_zero()
    if _sign(difference) != _sign(q - p):
        return False
    excess = (p + q).scaled(4) - difference.multiplied(difference)
    if _sign(excess) < 0:
        return False
    return (excess.multiplied(excess) - p.multiplied(q).scaled(64)).is_zero()


def _sign(number: Phasor) -> int:
    """Return the sign of a real number of the field."""
    if number.is_zero():
        return 0
    return 1 if number.real_value(DIGITS) > 0 else -1
