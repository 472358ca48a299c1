"""Proved bound on the harmonics of a mechanism's force above an order, link rods included.

In the strip |Im p| <= a of `mechanism_types` y - cos p is analytic and at most M (`fourier`), so that its
coefficients obey |c_n| <= M e^(-a n). With A_n - i B_n = 2 n^2 c_n and x = e^(-a), all orders n >= N >= 2
together are at most, at whatever crank angle,

    sum of |A_n - i B_n| <= 2 M sum of n^2 x^n = 2 M x^N (N^2/(1-x) + 2 N x/(1-x)^2 + x (1+x)/(1-x)^3).

The sum S from N on, with X = x^N, and the sum from N + 1 on differ by the first term alone:

Formulas:
    S - Q = N^2 X
    with S = X (N^2/(1 - x) + 2 N x/(1 - x)^2 + x (1 + x)/(1 - x)^3);
    Q = X x ((N + 1)^2/(1 - x) + 2 (N + 1) x/(1 - x)^2 + x (1 + x)/(1 - x)^3); X, x, N numbers

M e^(-a n) has the true rate e^(-a n) of a slider-crank, whose nearest branch point lies on the strip's
edge, but not its n^(-3/2): the bound is some 10 n^(3/2) too large. So whoever needs it sharp adds up
known harmonics first and bounds only those far out, where all of it is nothing.
"""

from __future__ import annotations

from symbalance.kinematics.mechanisms.mechanism_types import LinkRod, Mechanism, simplified
from symbalance.kinematics.slider_crank import checked_order
from symbalance.text.reals import Real, exp, sqrt

ROUNDING = 1 + 2.0**-26
"""Covers the rounding of this module's few operations, which carry more digits."""


def force_tail(mechanism: Mechanism, order: int) -> Real:
    """Return a proved bound on the sum of the force's harmonics above `order`, over m r omega^2.

    >>> from symbalance.text.reals import nstr
    >>> from symbalance.kinematics.mechanisms import SliderCrank, force_harmonics
    >>> from symbalance.text.reals import fsum, hypot
    >>> offset = SliderCrank(4, "1/2")
    >>> nstr(force_tail(offset, 12), 3)
    '3.12e-8'
    >>> forces = force_harmonics(offset, 40)
    >>> nstr(fsum(hypot(*forces[n]) for n in forces if n > 12), 3)
    '1.73e-10'
    """
    checked_order(order)
    mechanism = simplified(mechanism)
    first = order + 1
    size = sqrt(2, 30) * mechanism.length
    if isinstance(mechanism, LinkRod):
        size += sqrt(3, 30) * mechanism.link_radius
    x = exp(-mechanism.strip, 30)
    rest = 1 - x
    total = first**2 / rest + 2 * first * x / rest**2 + x * (1 + x) / rest**3
    return 2 * size * x**first * total * ROUNDING
