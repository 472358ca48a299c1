"""Harmonics exact in lambda: hypergeometric closed forms, and their values to any number of digits.

Formulas:
    q = (rho/(1 + k'))^2 = (1 - k')/(1 + k')
    q + 1/q = 4/rho^2 - 2
    q + 1/q = 4 lambda^2 - 2
    1 - q = 2 k'/(1 + k')
    with k' = sqrt(1 - rho^2); q = (1 - k')/(1 + k')
"""

from __future__ import annotations

from fractions import Fraction
from math import comb
from typing import TYPE_CHECKING

from symbalance.document.symbols import symbol
from symbalance.kinematics.slider_crank.arguments import checked_order
from symbalance.text.reals import DIGITS, Real, ellipe, hyp2f1, pi, sqrt

if TYPE_CHECKING:
    import sympy


def exact_coefficient(order: int) -> sympy.Expr:
    """Return A_order exact in rho, as a SymPy expression with a hypergeometric function.

    Its series in powers of rho = r/l begins

    Formulas:
        A_2 = rho + rho^3/4 + 15 rho^5/128 + ...
        A_4 = -rho^3/4 - 3 rho^5/16 - ...
        A_6 = 9 rho^5/128 + ...

    >>> exact_coefficient(2).subs(symbol("rho"), 0.25).evalf(12)
    0.254025042307
    """
    import sympy

    checked_order(order)
    if order % 2:
        return sympy.Integer(order == 1)
    rho, k = symbol("rho"), sympy.Integer(order // 2)
    root = sympy.sqrt(1 - rho**2)
    q = (rho / (1 + root)) ** 2
    tail = sympy.hyper([-sympy.S.Half, k - sympy.S.Half], [k + 1], q**2)
    return 4 * k**2 / rho * (1 + root) * sympy.binomial(sympy.S.Half, k) * q**k * tail


def rho_root_q(ratio: Fraction, digits: int) -> tuple[Real, Real, Real]:
    """Return rho, sqrt(1 - rho^2) and q to so many digits, however near rho is to 0 or 1."""
    over, under = ratio.numerator, ratio.denominator
    rho = Real(1 / ratio, digits)
    root = sqrt(over * over - under * under, digits) / over
    return rho, root, (rho / (1 + root)) ** 2


def _half_over(k: int) -> Fraction:
    """Return the binomial coefficient of 1/2 over k > 0."""
    return Fraction((-1) ** (k - 1) * comb(2 * k, k), 4**k * (2 * k - 1))


def acceleration_value(order: int, ratio: Fraction, digits: int = 20) -> Real:
    """Return A_order for a rod ratio, exact in lambda, to `digits` significant digits."""
    if order % 2:
        return Real(int(order == 1), digits + 10)
    k = order // 2
    rho, root, q = rho_root_q(ratio, digits + 10)
    tail = hyp2f1(-0.5, k - 0.5, k + 1, q * q)
    return 4 * k * k / rho * (1 + root) * _half_over(k) * q**k * tail


def acceleration_values(order: int, ratio: Fraction, digits: int = 20) -> dict[int, Real]:
    """Return A_1 and every even A_n to `order`, exact in lambda, to `digits` significant digits.

    The c_k obey q (k - 3/2) c_{k-1} + (1 + q^2) k c_k + q (k + 3/2) c_{k+1} = 0 and are its minimal
    solution, so the recurrence is run downward from two values of the closed form (upward it is lost).
    """
    top = order // 2
    values = {n: acceleration_value(n, ratio, digits) for n in (1, 2 * top - 2, 2 * top) if n > 0}
    *_, q = rho_root_q(ratio, digits + 10)
    middle = (1 + q * q) / q
    for k in range(top - 1, 1, -1):
        above, here = values[2 * k + 2] / (k + 1) ** 2, values[2 * k] / k**2
        below = -(middle * k * here + (k + 1.5) * above) / (k - 1.5)
        values[2 * k - 2] = below * (k - 1) ** 2
    return dict(sorted(values.items()))


def root_mean(ratio: Fraction, digits: int = DIGITS) -> Real:
    """Return c_0, the mean of sqrt(1 - rho^2 sin^2 theta), to `digits` significant digits."""
    return 2 * ellipe(Real(1 / ratio**2, digits)) / pi(digits)


def rod_angle_value(order: int, ratio: Fraction, digits: int = 20) -> Real:
    """Return R_order for a rod ratio, exact in lambda, to `digits` significant digits."""
    if order % 2 == 0:
        return Real(0, digits + 10)
    i = order // 2
    lead = Fraction((-1) ** i * comb(2 * i, i), order << 4 * i)
    rho = Real(1 / ratio, digits + 10)
    return lead * rho**order * hyp2f1(i + 0.5, i + 0.5, order + 1, rho * rho)
