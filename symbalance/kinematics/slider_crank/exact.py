"""The harmonics exact in lambda: formulas with 2F1, and their values to any number of digits."""

from __future__ import annotations

from fractions import Fraction
from math import comb
from typing import TYPE_CHECKING

from mpmath import mp

from symbalance.document.symbols import symbol
from symbalance.kinematics.slider_crank.limits import checked_order
from symbalance.text.numbers import Real

if TYPE_CHECKING:
    import sympy


def exact_coefficient(order: int) -> sympy.Expr:
    """Return A_order exact in rho, as a SymPy expression with a hypergeometric function.

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


def _rho_root_q(ratio: Fraction) -> tuple[Real, Real, Real]:
    """Return rho, sqrt(1 - rho^2) and q to the working precision, however near rho is to 0 or 1."""
    over, under = ratio.numerator, ratio.denominator
    rho = mp.mpf(under) / over
    root = mp.sqrt(mp.mpf(over * over - under * under)) / over
    return rho, root, (rho / (1 + root)) ** 2


def acceleration_value(order: int, ratio: Fraction, digits: int = 20) -> Real:
    """Return A_order for a rod ratio, exact in lambda, to `digits` significant digits."""
    if order % 2:
        return mp.mpf(order == 1)
    k = order // 2
    with mp.workdps(digits + 10):
        rho, root, q = _rho_root_q(ratio)
        tail = mp.hyp2f1(mp.mpf(-0.5), k - mp.mpf(0.5), k + 1, q * q)
        return 4 * k * k / rho * (1 + root) * mp.binomial(mp.mpf(0.5), k) * q**k * tail


def acceleration_values(order: int, ratio: Fraction, digits: int = 20) -> dict[int, Real]:
    """Return A_1 and every even A_n to `order`, exact in lambda, to `digits` significant digits.

    The c_k obey q (k - 3/2) c_{k-1} + (1 + q^2) k c_k + q (k + 3/2) c_{k+1} = 0 and are its minimal
    solution, so the recurrence is run downward from two values of the closed form (upward it is lost).
    """
    top = order // 2
    values = {1: mp.mpf(1)} | {
        2 * k: acceleration_value(2 * k, ratio, digits) for k in (top - 1, top) if k > 0
    }
    with mp.workdps(digits + 10):
        *_, q = _rho_root_q(ratio)
        both = (1 + q * q) / q
        for k in range(top - 1, 1, -1):
            above, here = values[2 * k + 2] / (k + 1) ** 2, values[2 * k] / k**2
            below = -(both * k * here + (k + mp.mpf(1.5)) * above) / (k - mp.mpf(1.5))
            values[2 * k - 2] = below * (k - 1) ** 2
    return dict(sorted(values.items()))


def root_mean(ratio: Fraction) -> Real:
    """Return c_0, the mean of sqrt(1 - rho^2 sin^2 theta), to the working precision."""
    rho = mp.mpf(ratio.denominator) / ratio.numerator
    return 2 * mp.ellipe(rho * rho) / mp.pi


def rod_angle_value(order: int, ratio: Fraction, digits: int = 20) -> Real:
    """Return R_order for a rod ratio, exact in lambda, to `digits` significant digits."""
    if order % 2 == 0:
        return mp.mpf(0)
    i = order // 2
    lead = Fraction((-1) ** i * comb(2 * i, i), order << 4 * i)
    with mp.workdps(digits + 10):
        rho = mp.mpf(ratio.denominator) / ratio.numerator
        tail = mp.hyp2f1(i + mp.mpf(0.5), i + mp.mpf(0.5), order + 1, rho * rho)
        return mp.mpf(lead.numerator) / lead.denominator * rho**order * tail
