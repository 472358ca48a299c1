"""A real cyclotomic number to any number of digits."""

from __future__ import annotations

from fractions import Fraction

from mpmath import mp

from symbalance.exact.phasor import Phasor
from symbalance.text.numbers import Real

MOST_DIGITS = 1_000_000


def evaluated(number: Phasor, digits: int) -> Real:
    """Return a real cyclotomic number to `digits` significant digits, whatever cancels in it."""
    if number.is_zero():
        return mp.mpf(0)
    size = sum(abs(Fraction(c)) for c in number.terms.values())
    working = digits + 15
    while True:
        with mp.workdps(working):
            value = mp.fsum(
                mp.mpf(Fraction(c).numerator)
                / Fraction(c).denominator
                * mp.cospi(mp.mpf(2 * k) / number.modulus)
                for k, c in number.terms.items()
            )
            lost = mp.mpf(10) ** (digits + 5 - working) * size.numerator / size.denominator
            if abs(value) > lost:
                return value
        working *= 2
        if working > MOST_DIGITS:
            raise AssertionError(f"{number} is called non-zero, and has no digit")
