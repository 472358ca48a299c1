r"""What a kinetic energy gives back, for any mechanism: harmonics of products of its series.

At constant omega a mass m whose place along a line is f(p), or a moment of inertia whose angle it is,
takes the power of its kinetic energy from the crank. With f = sum of c_n e^(inp), c_-n = conj(c_n),

    T/(m omega^2) = -1/2 d/dp (f')^2 = sum of C_n cos np + S_n sin np,
    C_n + i S_n = i n conj(sum over k of u_k u_{n-k}),    u_n = i n c_n.

In the strip |Im p| <= a of the mechanism |c_k| <= M e^(-a |k|), so that stopping at k = `order` + K
leaves out less than e^(-a (n + 2K)) of the largest: K is chosen to bring that below 10^-digits.
Centred slider-cranks have closed forms, which are taken instead.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from math import ceil, log

from mpmath import mp

from symbalance.kinematics.inertia import torque_values
from symbalance.kinematics.mechanisms import (
    LinkRod,
    Mechanism,
    SliderCrank,
    force_harmonics,
    rod_angle_harmonics,
)
from symbalance.kinematics.mechanisms.fourier import series_of
from symbalance.kinematics.mechanisms.linkages import plain
from symbalance.kinematics.mechanisms.moving_masses import link_pin_path
from symbalance.kinematics.rod import rod_torque_values
from symbalance.text.numbers import Real

GUARD = 12.0
"""Nepers for what the bounds' constants and the sums over k may add."""
LEAST_STRIP = 1e-9


def inertia_harmonics(mechanism: Mechanism, order: int, digits: int = 40) -> dict[int, Real]:
    """Return n -> C + iS of the torque of a mass on a mechanism's piston, over m r^2 omega^2.

    >>> found = inertia_harmonics(SliderCrank(4, "1/2"), 2)
    >>> [mp.nstr(found[n], 6) for n in found]
    ['(0.00862598 + 0.0651292j)', '(0.132415 - 0.492229j)']
    """
    mechanism = plain(mechanism)
    if isinstance(mechanism, SliderCrank) and not mechanism.offset:
        return {n: mp.mpc(0, t) for n, t in torque_values(order, mechanism.ratio, digits).items()}
    return _of_square(mechanism, order, digits, "height")


def rod_harmonics(mechanism: Mechanism, order: int, digits: int = 40) -> dict[int, Real]:
    """Return n -> C + iS of the torque of a moment of inertia that turns with the rod, over J omega^2."""
    mechanism = plain(mechanism)
    if isinstance(mechanism, SliderCrank) and not mechanism.offset:
        return {n: mp.mpc(0, u) for n, u in rod_torque_values(order, mechanism.ratio, digits).items()}
    return _of_square(mechanism, order, digits, "rod-angle")


def rocking_harmonics(mechanism: Mechanism, order: int, digits: int = 40) -> dict[int, Real]:
    """Return n -> C + iS of phi'': the couple of a moment of inertia on the rod, over J omega^2."""
    angles = rod_angle_harmonics(mechanism, order, digits)
    with mp.workdps(digits + 10):
        return {n: -2 * n * n * mp.conj(d) for n, d in angles.items() if n}


def beside_harmonics(mechanism: Mechanism, order: int, digits: int = 40) -> dict[int, Real]:
    """Return n -> C + iS of the inertia force's moment about the crank, over m r^2 omega^2: -eps F.

    The force acts along the cylinder's axis, which passes the crank at eps r.
    """
    offset = mechanism.offset
    if not offset:
        return {}
    forces = force_harmonics(mechanism, order, digits)
    with mp.workdps(digits + 10):
        arm = -mp.mpf(offset.numerator) / offset.denominator
        return {n: arm * mp.mpc(a, b) for n, (a, b) in forces.items()}


@lru_cache(maxsize=256)
def _of_square(mechanism: Mechanism, order: int, digits: int, quantity: str) -> dict[int, Real]:
    nepers, strip = digits * log(10) + GUARD, max(mechanism.strip, LEAST_STRIP)
    highest = order + ceil(nepers / (2 * strip))
    series = series_of(mechanism, highest, digits, quantity)
    bits = ceil((nepers + strip * order) / log(2)) + 64
    with mp.workprec(bits + 64):
        rates = {n: mp.mpc(0, n) * c for n, c in series.items() if n}
        whole = {n: (int(mp.ldexp(u.real, bits)), int(mp.ldexp(u.imag, bits))) for n, u in rates.items()}
        found = {}
        for n in range(1, order + 1):
            real, imaginary = _product(whole, n)
            if real or imaginary:
                square = mp.mpc(mp.ldexp(real, -2 * bits), mp.ldexp(imaginary, -2 * bits))
                found[n] = mp.mpc(0, n) * mp.conj(square)
        return found


def _product(rates: Mapping[int, tuple[int, int]], n: int) -> tuple[int, int]:
    """Return the sum of u_k u_{n-k} over all k, u_-k = conj(u_k), of whole numbers."""
    real = imaginary = 0
    for k, (a, b) in rates.items():
        if k < n and n - k in rates:
            c, d = rates[n - k]
            real, imaginary = real + a * c - b * d, imaginary + a * d + b * c
        if n + k in rates:
            c, d = rates[n + k]
            real, imaginary = real + 2 * (a * c + b * d), imaginary + 2 * (a * d - b * c)
    return real, imaginary


def link_pin_harmonics(mechanism: LinkRod, order: int, digits: int = 40) -> dict[int, Real]:
    """Return n -> C + iS of the torque of a mass on a link pin, over m r^2 omega^2: -1/2 d/dp |w'|^2.

    w is the pin's place (`symbalance.kinematics.mechanisms.moving_masses`); with u_n = i n w_n, n of both
    signs, C_n + i S_n = i n conj(sum over k of u_k conj(u_{k-n})).
    """
    place = _whole_path(mechanism, order, digits)
    with mp.workdps(digits + 10):
        rates = {n: mp.mpc(0, n) * w for n, w in place.items()}
        squares = {n: _correlation(rates, rates, n) for n in range(1, order + 1)}
        return {n: mp.mpc(0, n) * mp.conj(s) for n, s in squares.items() if s}


def link_pin_moments(mechanism: LinkRod, order: int, digits: int = 40) -> dict[int, Real]:
    """Return n -> C + iS of the moment about the crank of a link pin mass's force, over m r^2 omega^2.

    The force -w'' acts at w: with g_n = sum over k of k^2 w_k conj(w_{k-n}) the moment Im(conj(w) (-w''))
    has C_n + i S_n = conj((g_n - conj(g_-n))/i).
    """
    place = _whole_path(mechanism, order, digits)
    with mp.workdps(digits + 10):
        forces = {n: n * n * w for n, w in place.items()}
        found = {}
        for n in range(1, order + 1):
            both = _correlation(forces, place, n) - mp.conj(_correlation(forces, place, -n))
            if both:
                found[n] = mp.conj(both / mp.mpc(0, 1))
        return found


def _whole_path(mechanism: LinkRod, order: int, digits: int) -> dict[int, Real]:
    """Return the link pin's place from the crank's axis, to the order that products need."""
    strip = max(mechanism.master.strip, LEAST_STRIP)
    highest = order + ceil((digits * log(10) + GUARD) / (2 * strip))
    place = link_pin_path(mechanism, highest, digits)
    with mp.workdps(digits + 10):
        return place | {1: place.get(1, mp.mpc(0)) + 1}


def _correlation(left: Mapping[int, Real], right: Mapping[int, Real], n: int) -> Real:
    """Return the sum over k of left_k conj(right_{k-n})."""
    return mp.fsum(x * mp.conj(right[k - n]) for k, x in left.items() if k - n in right)
