"""Inertia torque of one centred cylinder: its harmonics t_n, in powers of rho and exact in lambda.

At constant omega the torque is what the piston's kinetic energy gives back, T = -dE/dtheta: with the
velocity v/(r omega) = s + s phi', s = sin theta and phi the rod's angle, T/(m r^2 omega^2) is the sum of
t_n sin n theta.

Formulas:
    E = s^2 + 2 s^2 D + s^2 D^2
    -(1/2) dE/dtheta = t_1 sin theta + t_2 sin 2 theta + t_3 sin 3 theta + t_4 sin 4 theta + ...
    D = rho cos theta/w
    s^2 D^2 = s^2 - 1 + 1/rho^2 - (1/rho^2 - 1)/w^2
    with E = (v/(r omega))^2; D = dphi/dtheta; w = sqrt(1 - rho^2 s^2); s = sin theta

The first and last part of E hold the even orders, the middle one the odd. The last is a fraction of two
polynomials in s^2. With 1/w^2 = (1 + 2 sum of (-q)^k cos 2k theta)/k' the even orders are elementary,
t_2k = -2 k (k'/rho^2) (-q)^k for k > 1; the odd ones follow from phi' = sum of D_n cos n theta, n odd,
D_n = n R_n, D_-n = D_n, by t_n = (n/2) (D_n - (D_{n-2} + D_{n+2})/2):

Formulas:
    t_2 = -1 + 2 k'/(1 + k')^2
    rho^2 t_4 = -4 k' q^2
    rho^2 t_6 = 6 k' q^3
    t_1 = (1/2) (D_1 - (D_1 + D_3)/2)
    t_3 = (3/2) (D_3 - (D_1 + D_5)/2)
    D_3 = 3 R_3
    with q = (rho/(1 + k'))^2; k' = sqrt(1 - rho^2)

D_{2i+1} = rho (E_i + E_{i+1})/2 with the Laplace coefficients 1/w = sum of (E_k/2) e^(2 i k theta),

    E_k = (4/(1 + k')) (-q)^k (C(2k, k)/4^k) 2F1(1/2, k + 1/2; k + 1; q^2).

The D_n alternate in sign, so nothing cancels in t_n: no order vanishes, whatever rho; the odd t_n have
the signs of sin n 90 degrees, so that sum of |t_n|, n odd, is T at 90 degrees: rho/k'.
Also |D_n| is a moment of order n/2 of a positive measure on (0, q) (the contour of its Fourier integral
drawn around the cut of 1/w), hence |D_{n+2}| <= q |D_n|, and |t_{n+2}| <= q (n + 2)/n |t_n| for n > 2.
Source: expanded afresh; the first four in Taylor, The Internal-Combustion Engine in Theory and Practice,
vol. 2, and in many others: rho/4, -1/2, -3 rho/4, -rho^2/4.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from math import ceil, comb

from symbalance.kinematics.slider_crank import (
    Series,
    checked_order,
    checked_power,
    checked_ratio,
    rho_root_q,
    rod_angle_series,
)
from symbalance.kinematics.truncation import ROUNDING, SLOW
from symbalance.text.reals import Real, fsum, hyp2f1, log


@lru_cache(maxsize=4096)
def torque_series(order: int, through: int) -> Series:
    """Return t_order, in units of m r^2 omega^2, kept through (1/lambda)^through.

    Formulas:
        t_1 = rho/4 + rho^3/16 + ...
        t_2 = -1/2 - rho^4/32 - ...
        t_3 = -3 rho/4 - 9 rho^3/32 - ...
        t_4 = -rho^2/4 - rho^4/8 - ...

    >>> [torque_series(n, 4).in_powers_of_rho() for n in (1, 2, 3, 4)]
    [rho**3/16 + rho/4, -rho**4/32 - 1/2, -9*rho**3/32 - 3*rho/4, -rho**4/8 - rho**2/4]
    """
    checked_order(order)
    checked_power(through, "through")
    return _odd_series(order, through) if order % 2 else _even_series(order // 2, through)


def _odd_series(n: int, through: int) -> Series:
    total: dict[int, Fraction] = {}
    for place, weight in ((n, 1), (abs(n - 2), Fraction(-1, 2)), (n + 2, Fraction(-1, 2))):
        for power, c in rod_angle_series(place, through).terms.items():
            total[power] = total.get(power, Fraction(0)) + c * weight * place * Fraction(n, 2)
    return Series(dict(sorted(total.items())), through)


def _even_series(k: int, through: int) -> Series:
    """Return t_2k from s^2 phi'^2 = sum of rho^2m (s^2m - s^(2m+2)), m = 1, 2, ...."""
    terms = {0: Fraction(-1, 2)} if k == 1 else {}
    for m in range(max(1, k - 1), through // 2 + 1):
        inner = comb(2 * m, m - k) if m >= k else 0
        number = (-1) ** k * 2 * k * (4 * inner - comb(2 * m + 2, m + 1 - k))
        if number:
            terms[2 * m] = Fraction(number, 1 << 2 * m + 2)
    return Series(terms, through)


def default_power(order: int) -> int:
    """Return the power of 1/lambda that keeps two terms of t_order.

    >>> [len(torque_series(n, default_power(n)).terms) for n in (1, 2, 3, 4, 5, 12)]
    [2, 2, 2, 2, 2, 2]
    """
    return {1: 3, 2: 4}.get(order, order)


def torque_values(order: int, ratio: Fraction, digits: int = 20) -> dict[int, Real]:
    """Return every t_n to `order`, exact in lambda, to `digits` significant digits.

    >>> from symbalance.text.reals import nstr
    >>> {n: nstr(t, 8) for n, t in torque_values(4, Fraction(4)).items()}
    {1: '0.063506261', 2: '-0.50013014', 3: '-0.19205557', 4: '-0.016129031'}
    """
    checked_order(order)
    return _values(order, checked_ratio(ratio), digits)


def _values(order: int, ratio: Fraction, digits: int) -> dict[int, Real]:
    rho, root, q = rho_root_q(ratio, digits + 20)  # E_i + E_{i+1} loses a factor 1 - q: 6 digits at most
    rates = _rod_rates(order + 2, rho, root, q)
    values = {}
    for n in range(1, order + 1):
        if n % 2:
            values[n] = n * (rates[n] - (rates[abs(n - 2)] + rates[n + 2]) / 2) / 2
        else:
            values[n] = -n * root / (rho * rho) * (-q) ** (n // 2) - (n == 2)
    return values


def _rod_rates(order: int, rho: Real, root: Real, q: Real) -> dict[int, Real]:
    """Return D_n for the odd n to `order` or one above.

    The E_k are the minimal solution of (k + 1/2) E_{k+1} + k (q + 1/q) E_k + (k - 1/2) E_{k-1} = 0, so
    the recurrence is run downward from two values of the closed form.
    """
    top = order // 2 + 1
    values = [_laplace(k, root, q) for k in (top, top - 1)]
    middle = q + 1 / q
    for k in range(top - 1, 0, -1):
        values.append(-(k * middle * values[-1] + (k + 0.5) * values[-2]) / (k - 0.5))
    values.reverse()
    return {2 * i + 1: rho * (values[i] + values[i + 1]) / 2 for i in range(top)}


def _laplace(k: int, root: Real, q: Real) -> Real:
    """Return the Laplace coefficient E_k."""
    lead = Fraction(comb(2 * k, k), 4**k) * (-q) ** k
    return 4 / (1 + root) * lead * hyp2f1(0.5, k + 0.5, k + 1, q * q)


def torque_left_out(order: int, ratio: Fraction) -> Real:
    """Return a proved bound on the error of keeping t_1 to t_order only, in m r^2 omega^2.

    It is the sum of the |t_n| left out: the odd ones are attained at 90 degrees, the even ones not.

    >>> from symbalance.text.reals import nstr
    >>> nstr(torque_left_out(6, Fraction(4)), 6)
    '5.33138e-5'
    """
    checked_order(order)
    ratio = checked_ratio(ratio)
    rho, root, q = rho_root_q(ratio, 30)
    first = max(order // 2 + 1, 2)
    gap = 2 * root / (1 + root)  # 1 - q, without its rounding
    even = 2 * root / (rho * rho) * q**first * (first * gap + q) / (gap * gap)
    if order == 1:
        even += 1 - 2 * root / (1 + root) ** 2
    odd = _odd_tail(order + 1 + order % 2, ratio, q, gap) if q < SLOW else _odd_rest(order, ratio)
    return (even + odd) * ROUNDING


def _odd_tail(first: int, ratio: Fraction, q: Real, gap: Real) -> Real:
    """Return the sum of the |t_n| from the odd n = `first` on, the geometric rest added."""
    last = first + 2 * (2 + ceil(-7 * log(10) / log(q)))
    values = _values(last, ratio, 20)
    rest = abs(values[last]) * (q / gap + 2 * q / (last * gap * gap))
    return fsum(abs(values[n]) for n in range(first, last + 1, 2)) + rest


def _odd_rest(order: int, ratio: Fraction) -> Real:
    """Return rho/k' less the odd |t_n| to `order`, with the digits that takes."""
    digits = 30
    while True:
        rho, root, _ = rho_root_q(ratio, digits)
        values = _values(order, ratio, digits)
        rest = rho / root - fsum(abs(values[n]) for n in range(1, order + 1, 2))
        if rest > Fraction(1, 10 ** (digits - 10)) * rho / root:
            return rest
        digits *= 2
