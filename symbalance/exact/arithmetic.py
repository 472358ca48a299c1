"""Sums of amplitudes of any kind, and the ratio of two where it is rational."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING

from symbalance.exact.amplitude import Amplitude
from symbalance.exact.phasor import ZERO
from symbalance.exact.spectrum import Component

if TYPE_CHECKING:
    import sympy

FINEST = 10_000
"""The largest denominator of a ratio that is tried."""


def total(numbers: Iterable[Amplitude]) -> Amplitude:
    """Return the sum of numbers; of none it is 0."""
    return sum(numbers, ZERO)


def station_of(force: Amplitude, couple: Amplitude) -> Fraction | None:
    """Return the arm z with couple = z force, if it is a fraction: a weight there does for both.

    The nearest fraction is tried and proved; what cannot be proved is None.

    >>> from symbalance.exact.phasor import ONE
    >>> station_of(ONE.scaled(2), ONE.scaled(3)), station_of(ONE, ONE.turned(Fraction(1, 4)))
    (Fraction(3, 2), None)
    """
    if force.is_zero():
        return None
    if couple.is_zero():
        return Fraction(0)
    if force.has_symbols or couple.has_symbols:
        return None
    ratio = couple.evaluated() / force.evaluated()
    near = Fraction(round(ratio.real * 10**15), 10**15).limit_denominator(FINEST)
    return near if (couple - force.scaled(near)).is_zero() else None


def quotient(above: Amplitude, below: Amplitude) -> sympy.Expr:
    """Return the quotient of two real numbers as a SymPy expression, a rational if it is one.

    >>> from symbalance.exact.phasor import Phasor
    >>> quotient(Phasor.of(1, {0: 3}), Phasor.of(1, {0: 6}))
    1/2
    """
    import sympy

    ratio = station_of(below, above)
    if ratio is not None:
        return sympy.Rational(ratio.numerator, ratio.denominator)
    return Component(above).cos / Component(below).cos
