"""Bessel functions of whole order, by their recurrence to J_0 and J_1.

J_(n+1)(z) = (2n/z) J_n(z) - J_(n-1)(z),   J_(-n) = (-1)^n J_n       (Watson 1922, 2.12 and 2.1)
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.functions import opaque

HIGHEST_ORDER = 40


def bessel_of(order: Form, argument: Form) -> Form:
    """Return J_n(z) as a combination of J_0(z) and J_1(z)."""
    value, domain = order.rational(), order.domain
    if value is None or value.denominator != 1:
        raise NoFormError("a Bessel function whose order is no whole number")
    n = abs(int(value))
    if n > HIGHEST_ORDER:
        raise TooLargeError(f"a Bessel function of order {n}")
    sign = -1 if value < 0 and n % 2 else 1
    if argument.is_zero():
        return Form.number(domain, 0 if n else 1)
    before, last = opaque("besselj0", argument), opaque("besselj1", argument)
    if n == 0:
        return before
    for k in range(1, n):
        before, last = last, last.scaled(2 * k).over(argument).minus(before)
    return last.scaled(sign)


def series_of(order: int, size: int) -> list[Fraction]:
    """Return the coefficients of J_0 or J_1 about 0: (-1)^k/(k! (k+n)!) at (z/2)^(2k+n)."""
    result, value = [Fraction(0)] * size, Fraction(1, 2**order)
    for k in range(size):
        if 2 * k + order < size:
            result[2 * k + order] = value
        value = -value / (4 * (k + 1) * (k + 1 + order))
    return result
