"""Harmonics of the force of every mass that a mechanism moves, at its piston and at its link pin.

A mass whose place is w(p) = sum of w_n e^(inp) over r (height + i lateral, in the cylinder's frame)
pushes with -w'' = sum of n^2 w_n e^(inp), in m r omega^2.

- The piston moves along the axis: w is real, n^2 w_n = (A_n - i B_n)/2, and w_-n = conj(w_n).
- A mass on the crank pin has w = e^(ip): it turns steadily.
- A link pin stands at w = e^(ip) + L e^(i (chi - phi(p + D))), phi the master rod's angle, lam and eps
  its ratio and offset. With q = p + D, e^(-i phi(q)) = cos phi - i sin phi, where cos phi =
  (y(q) - cos q)/lam of the master's height y, and sin phi = (sin q - eps)/lam: known harmonics.

Formulas:
    L e^(i (c - b)) = L e^(i c) (cos b - i sin b)
    -d^2w/dp^2 = n^2 w
    with w = e^(i n p); p, b, c angles; n a whole number; L positive
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.kinematics.mechanisms.force_bounds import force_tail
from symbalance.kinematics.mechanisms.fourier import force_harmonics, series_of
from symbalance.kinematics.mechanisms.mechanism_types import (
    LinkRod,
    Mechanism,
    SliderCrank,
    has_link_pin,
    simplified,
)
from symbalance.kinematics.slider_crank import acceleration_values
from symbalance.text.reals import DIGITS, Complex, Real, expjpi


def piston_force(mechanism: Mechanism, order: int) -> dict[int, Complex]:
    """Return n -> f_n = A_n - i B_n, n = 1..order, to 40 digits; orders that symmetry removes are absent.

    >>> from symbalance.text.reals import nstr
    >>> [(n, nstr(f.real, 6)) for n, f in piston_force(SliderCrank(4), 4).items()]
    [(1, '1.0'), (2, '0.254025'), (4, '-0.00409811')]
    """
    mechanism = simplified(mechanism)
    if isinstance(mechanism, SliderCrank) and mechanism.is_centred:
        values = acceleration_values(order, mechanism.ratio, DIGITS)
        return {n: Complex(a) for n, a in values.items() if n <= order}
    return {n: Complex(a, -b) for n, (a, b) in force_harmonics(mechanism, order, DIGITS).items()}


def link_pin_path(mechanism: LinkRod, order: int, digits: int = DIGITS) -> dict[int, Complex]:
    """Return n -> w_n, |n| <= order, of a link pin's place as seen from the crank pin, over r.

    >>> from symbalance.text.reals import nstr
    >>> pin = link_pin_path(LinkRod(SliderCrank(4), "1/9", "3/4", "13/4", "1/9"), 2)
    >>> [nstr(pin[n].real, 6) for n in (-2, -1, 0, 1, 2)]
    ['0.00103385', '0.0718167', '0.73814', '-0.0718167', '0.00103385']
    """
    master, turn = mechanism.master, mechanism.bank_difference
    heights = series_of(master, order, digits, "height")
    arm = expjpi(2 * mechanism.pin_direction, digits + 10) * mechanism.link_radius
    half, zero = Fraction(1, 2), Complex(0, 0, digits + 10)
    path = {}
    for n in range(-order, order + 1):
        height = heights.get(abs(n), zero)
        cosine = height.conjugate() if n < 0 else height
        if abs(n) == 1:
            cosine -= half
        # -i times the harmonics of the sine: sin q = (e^(iq) - e^(-iq))/2i
        sine = {1: -half, -1: half}.get(n, Fraction(0))
        harmonic = cosine + sine if n else cosine + Complex(0, master.offset, digits + 10)
        if harmonic:
            path[n] = arm * (harmonic / master.ratio) * expjpi(2 * n * turn, digits + 10)
    return path


def link_pin_force(mechanism: Mechanism | None, order: int) -> dict[int, Complex]:
    """Return n -> n^2 w_n, 0 < |n| <= order, of a mass on the link pin less that of one on the crank pin.

    In m r omega^2, to 40 digits; empty where the rod runs on the crank pin.
    """
    if not has_link_pin(mechanism):
        return {}
    return {n: w * (n * n) for n, w in link_pin_path(mechanism, order).items() if n}


def link_pin_tail(mechanism: Mechanism | None, order: int) -> Real:
    """Return a proved bound on the sum of |n^2 w_n|, |n| > order >= 1, of the link pin's force.

    Above order 1 n^2 w_n is L/lam times the master piston's, whose bound is `force_tail`.
    """
    if not has_link_pin(mechanism):
        return Real(0)
    return force_tail(mechanism.master, order) * mechanism.link_radius / mechanism.master.ratio
