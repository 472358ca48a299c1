"""Amplitudes in decimals of 40 digits, for engines whose sizes have no exact harmonics.

The one rule for its zero: a sum that is 10^-25 of its parts, or less, is 0, and so is a real or imaginary
part of that size beside the other. The reason for 25: engine files hold numbers of 30 digits, so that
a weight that was designed, written and read again differs by 10^-30 of itself from the one that cancels
exactly; what a sum over the cylinders and their lever arms makes of that stays 10^5 below the limit,
and the roundings of 40 digits far below that again. No engine's sizes are known to 25 digits.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import ClassVar

from symbalance.exact.amplitude import Amplitude
from symbalance.text.reals import DIGITS, Complex, Real, expjpi

LEAST = Fraction(1, 10**25)
"""A sum this small beside its parts is 0."""


@dataclass(frozen=True)
class DecimalPhasor(Amplitude):
    """A complex number of `DIGITS` digits or more.

    >>> third = DecimalPhasor(Complex(1) / 3)
    >>> (third + DecimalPhasor(Complex(Real("-0.333333333333333333333333333333")))).is_zero()
    True
    """

    value: Complex
    rank: ClassVar[int] = 2
    is_decimal: ClassVar[bool] = True

    def __post_init__(self) -> None:
        object.__setattr__(self, "value", Complex(self.value))

    @classmethod
    def holding(cls, number: Amplitude) -> DecimalPhasor:
        """Return a number in decimals; one with symbols is refused."""
        return number if isinstance(number, DecimalPhasor) else cls(number.evaluated(DIGITS))

    def is_zero(self) -> bool:
        """Tell whether it is 0 itself, as sums that cancel are."""
        return not self.value

    def plus(self, other: DecimalPhasor) -> DecimalPhasor:
        """Return the sum, 0 where it is nothing beside its parts."""
        return DecimalPhasor(rounded_sum(self.value, other.value))

    def multiplied(self, other: DecimalPhasor) -> DecimalPhasor:
        """Return the product."""
        return DecimalPhasor(self.value * other.value)

    def __neg__(self) -> DecimalPhasor:
        return DecimalPhasor(-self.value)

    def scaled(self, factor: int | Fraction) -> DecimalPhasor:
        """Return the number times a rational."""
        return DecimalPhasor(self.value * factor)

    def rotated(self, turns: Fraction) -> DecimalPhasor:
        """Return the number times e^(2 pi i turns)."""
        return DecimalPhasor(self.value * expjpi(2 * turns))

    def conjugate(self) -> DecimalPhasor:
        """Return the complex conjugate."""
        return DecimalPhasor(self.value.conjugate())

    def evaluated(self, digits: int = DIGITS) -> Complex:
        """Return the number; a part that is but rounding of the other is 0."""
        least = abs(self.value) * LEAST
        real, imaginary = (x if abs(x) > least else Real(0) for x in (self.value.real, self.value.imag))
        return Complex(real, imaginary)

    @property
    def most(self) -> float:
        """The size."""
        return float(abs(self.value))

    @property
    def moduli(self) -> list[int]:
        """None: it is of no such field."""
        return []

    @property
    def spelling(self) -> object:
        """The value."""
        return self.value


def rounded_sum(first: Complex, second: Complex) -> Complex:
    """Return the sum of two numbers, 0 where it is nothing beside its parts."""
    sum_of_both = first + second
    if _binary_size(sum_of_both) > max(_binary_size(first), _binary_size(second)) - LEAST_BITS:
        return sum_of_both
    if abs(sum_of_both) <= LEAST * (abs(first) + abs(second)):
        return Complex(0)
    return sum_of_both


LEAST_BITS = 78
"""A sum within so many bits of its parts is no 0: LEAST is 83 bits, and sizes are off by less than 2."""


def _binary_size(number: Complex) -> float:
    """Return the binary logarithm of the larger part, up to 1 too high; below all numbers for 0."""
    return max(
        (exponent + bits for _, mantissa, exponent, bits in number._mpc_ if mantissa),
        default=-float("inf"),
    )
