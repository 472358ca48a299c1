"""Proved bounds on the harmonics that a truncated series leaves out.

The coefficients of `symbalance.kinematics.slider_crank` alternate in sign, so that at theta = 90
degrees all harmonics add up with one sign: the bounds here are attained there (the velocity's is safe,
not attained). With k' and q as in that module, |c_{k+1}| <= q (k - 1/2)/(k + 1) |c_k|, because
|C(1/2, k+1)/C(1/2, k)| = (k - 1/2)/(k + 1) and 2F1(-1/2, k - 1/2; k + 1; q^2) falls with k (every
term but the first is negative, and grows in size). So |A_{2k+2}|/|A_2k| <= q (k + 1)(k - 1/2)/k^2: a
geometric tail. Where that is slow (q near 1) the sum of all comes from the exact form at 90 degrees:

    sum of |A_n| = rho/sqrt(1 - rho^2),  of |B_n| = (c_0 - sqrt(1 - rho^2))/rho,  of |R_n| = asin(rho).

Through rho^15, with the signs that the coefficients have:

Formulas:
    rho/sqrt(1 - rho^2) = A_2 - A_4 + A_6 - A_8 + A_10 - A_12 + A_14 - A_16 + ...
    asin rho = R_1 - R_3 + R_5 - R_7 + R_9 - R_11 + R_13 - R_15 + ...
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.kinematics.slider_crank import (
    acceleration_value,
    acceleration_values,
    checked_order,
    checked_quantity,
    checked_ratio,
    integrated,
    rho_root_q,
    rod_angle_value,
    root_mean,
)
from symbalance.text.reals import Real, asin, fsum

SLOW = 0.9
"""Above this ratio of neighbouring terms the tail is found from the sum of all instead."""
ROUNDING = 1 + 2.0**-26
"""Covers the rounding of the sums, which carry more digits than this."""
RELATIVE = Fraction(1, 10**6)
"""The bound may exceed the largest error by this much of itself."""


def left_out(order: int, ratio: Fraction, quantity: str = "acceleration") -> Real:
    """Return a proved bound, at any crank angle, on the error of keeping harmonics to `order` only.

    Every coefficient is taken exact in lambda; units r, r omega, r omega^2, m r omega^2 or rad. Kept to
    order 1, the force's error is largest at 90 degrees, where the exact acceleration is known:

    Formulas:
        A_2 - A_4 + A_6 - A_8 + A_10 - A_12 + A_14 - A_16 = rho + rho^3/2 + 3 rho^5/8 + ...

    >>> from symbalance.text.reals import nstr
    >>> nstr(left_out(6, Fraction(4)), 6)
    '1.35724e-6'
    """
    checked_order(order)
    checked_quantity(quantity)
    ratio = checked_ratio(ratio)
    if quantity == "rod-angle":
        return _rod_angle_left_out(order + 1 + order % 2, ratio)
    first = order + 2 - order % 2 if order > 1 else 2
    *_, q = rho_root_q(ratio, 30)
    if q < SLOW:
        return _tail(first, ratio, quantity, q)
    rest = _rest(first, ratio, quantity)
    return rest / first if quantity == "velocity" else rest


def _size(quantity: str, n: int, ratio: Fraction) -> Real:
    return abs(acceleration_value(n, ratio)) * abs(integrated(quantity, n))


def _tail(first: int, ratio: Fraction, quantity: str, q: Real) -> Real:
    """Return the sum of the terms from `first` on, with the geometric rest added."""
    total, n = Real(0, 30), first
    while True:
        size = _size(quantity, n, ratio)
        total += size
        k = n // 2
        fall = q * max(Fraction((k + 1) * (2 * k - 1), 2 * k * k), 1) if k > 1 else q * 1.125
        if fall < 1 and (rest := size * fall / (1 - fall)) < total * RELATIVE:
            return (total + rest) * ROUNDING
        n += 2


def _rest(first: int, ratio: Fraction, quantity: str) -> Real:
    """Return the sum of all terms less those below `first`, with the digits that takes."""
    quantity = "acceleration" if quantity == "velocity" else quantity
    weights = {n: abs(integrated(quantity, n)) for n in range(2, first, 2)}
    digits = 30
    while True:
        values = acceleration_values(first - 1, ratio, digits)
        included = fsum(abs(values[n]) * w for n, w in weights.items())
        rest = _sum_of_all(quantity, ratio, digits) - included
        if rest > Fraction(1, 10 ** (digits - 10)):
            return rest * ROUNDING
        digits *= 2


def _sum_of_all(quantity: str, ratio: Fraction, digits: int) -> Real:
    rho, root, _ = rho_root_q(ratio, digits)
    if quantity == "displacement":
        return (root_mean(ratio, digits) - root) / rho
    return rho / root


def _rod_angle_left_out(first: int, ratio: Fraction) -> Real:
    """Return sum |R_n| from `first` on: terms, then the tail of asin's own power series.

    Each power rho^p of asin(rho sin theta) spreads over the orders with weights that add up to 1, so
    the orders above p hold at most the powers above p: sum |R_n|, n >= p, is at most
    a_p rho^p/(1 - rho^2) with a_p <= 1/p.
    """
    rho, root, _ = rho_root_q(ratio, 30)
    if rho * rho > SLOW:
        return _rod_angle_rest(first, ratio)
    total, n = Real(0, 30), first
    while True:
        total += abs(rod_angle_value(n, ratio))
        n += 2
        rest = rho**n / (n * root**2)
        if rest < total * RELATIVE:
            return (total + rest) * ROUNDING


def _rod_angle_rest(first: int, ratio: Fraction) -> Real:
    digits = 30
    while True:
        included = fsum(abs(rod_angle_value(n, ratio, digits)) for n in range(1, first, 2))
        rest = asin(1 / ratio, digits) - included
        if rest > Fraction(1, 10 ** (digits - 10)):
            return rest * ROUNDING
        digits *= 2
