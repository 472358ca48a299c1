"""A complex number to 40 digits, where the engine's sizes leave nothing exact to hold.

It answers to what spectra ask of a `Phasor`. Whether it is zero is decided where it is made, from the
geometry of like cylinders: a value that is kept counts as not zero.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from mpmath import mp

from symbalance.text.numbers import Real

DIGITS = 40


@dataclass(frozen=True)
class DecimalPhasor:
    """A complex number of `DIGITS` digits."""

    value: Real

    def is_zero(self) -> bool:
        """Tell whether it is 0 itself."""
        return self.value == 0

    def __add__(self, other: DecimalPhasor) -> DecimalPhasor:
        with mp.workdps(DIGITS):
            total = self.value + other.value
            gone = abs(total) < mp.mpf(10) ** (8 - DIGITS) * (abs(self.value) + abs(other.value))
            return DecimalPhasor(mp.mpc(0) if gone else total)

    def __neg__(self) -> DecimalPhasor:
        with mp.workdps(DIGITS):
            return DecimalPhasor(-self.value)

    def scaled(self, factor: int | Fraction) -> DecimalPhasor:
        """Return the number times a rational."""
        with mp.workdps(DIGITS):
            return DecimalPhasor(self.value * factor.numerator / factor.denominator)

    def turned(self, turns: Fraction) -> DecimalPhasor:
        """Return the number times e^(2 pi i turns)."""
        with mp.workdps(DIGITS):
            return DecimalPhasor(self.value * mp.expjpi(mp.mpf(2 * turns.numerator) / turns.denominator))

    def conjugate(self) -> DecimalPhasor:
        """Return the complex conjugate."""
        with mp.workdps(DIGITS):
            return DecimalPhasor(mp.conj(self.value))

    def parts(self) -> tuple[Real, Real]:
        """Return the real and the imaginary part; what is but rounding of the other is 0."""
        with mp.workdps(DIGITS):
            least = mp.mpf(10) ** (8 - DIGITS) * abs(self.value)
            pair = (self.value.real, self.value.imag)
            real, imaginary = (x if abs(x) > least else mp.mpf(0) for x in pair)
        return real, imaginary
