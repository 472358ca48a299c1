"""Ratios of amplitudes, and the other products and sums of them, whichever kind they are of."""

from __future__ import annotations

from fractions import Fraction

from symbalance.exact.phasor import ZERO
from symbalance.exact.spectrum import Component, Number
from symbalance.exact.symbolic_phasor import SymbolicPhasor
from symbalance.text.reals import Complex, Real

FINEST = 10_000
"""The largest denominator of a ratio that is looked for."""


def product(left: Number, right: Number) -> Number:
    """Return the product of two numbers."""
    return left.times(right)


def summed(numbers: list[Number]) -> Number:
    """Return the sum of numbers; of none it is 0."""
    return sum(numbers, ZERO)


def norm(number: Number) -> Number:
    """Return a number times its conjugate."""
    return number.norm()


def real_part(number: Number) -> Number:
    """Return the real part, as a number with no other."""
    return number.real()


def imaginary_part(number: Number) -> Number:
    """Return the imaginary part, as a real number."""
    return number.imaginary()


def size_of(number: Number) -> Real:
    """Return the absolute value of a number without symbols, in decimals."""
    return number.size()


def added(left: Number, right: Number) -> Number:
    """Return the sum of two numbers."""
    return left + right


def decimal(number: Number) -> Complex:
    """Return a number without symbols in decimals."""
    return number.evaluated()


def station_of(force: Number, couple: Number) -> Fraction | None:
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
    if isinstance(force, SymbolicPhasor) or isinstance(couple, SymbolicPhasor):
        return None
    ratio = couple.evaluated() / force.evaluated()
    near = Fraction(round(ratio.real * 10**15), 10**15).limit_denominator(FINEST)
    return near if (couple - force.scaled(near)).is_zero() else None


def quotient(above: Number, below: Number):
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
