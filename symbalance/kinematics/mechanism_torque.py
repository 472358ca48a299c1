"""Inertia torque of any mechanism: harmonics of the power that its moving masses take from the crank.

At constant omega a mass m whose place along a line is f(p), or a moment of inertia whose angle it is,
takes the power of its kinetic energy from the crank. With f = sum of c_n e^(inp), c_-n = conj(c_n),

    T/(m omega^2) = -1/2 d/dp (f')^2 = sum of C_n cos np + S_n sin np,
    C_n + i S_n = i n conj(sum over k of u_k u_{n-k}),    u_n = i n c_n.

In the strip |Im p| <= a of the mechanism |c_k| <= M e^(-a |k|), so that stopping at k = `order` + K
leaves out less than e^(-a (n + 2K)) of the largest: K is chosen to bring that below 10^-digits.
Centred slider-cranks have closed forms, which are taken instead.

Of one harmonic alone, f = A cos p, that is

Formulas:
    -(1/2) dW/dtheta = -(A^2/2) sin 2 theta
    with W = (A sin theta)^2; A a number
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from math import ceil, log

from symbalance.exact.decimal_phasor import rounded_sum
from symbalance.kinematics.mechanisms import (
    LinkRod,
    Mechanism,
    SliderCrank,
    force_harmonics,
    rod_angle_harmonics,
)
from symbalance.kinematics.mechanisms.fourier import series_of
from symbalance.kinematics.mechanisms.mechanism_types import simplified
from symbalance.kinematics.mechanisms.moving_masses import link_pin_path
from symbalance.kinematics.piston_torque import torque_values
from symbalance.kinematics.rod_torque import rod_torque_values
from symbalance.text.reals import Complex, Real, csum, digits_of, fixed, ldexp

GUARD = 12.0
"""Nepers for what the bounds' constants and the sums over k may add."""
LEAST_STRIP = 1e-9
"""A narrower strip would ask for more terms than there are; so near to lying across `fourier` refuses."""


def inertia_harmonics(mechanism: Mechanism, order: int, digits: int = 40) -> dict[int, Complex]:
    """Return n -> C + iS of the torque of a mass on a mechanism's piston, over m r^2 omega^2.

    >>> from symbalance.text.reals import nstr
    >>> torques = inertia_harmonics(SliderCrank(4, "1/2"), 2)
    >>> [nstr(torques[n], 6) for n in torques]
    ['(0.00862598 + 0.0651292j)', '(0.132415 - 0.492229j)']
    """
    mechanism = simplified(mechanism)
    if isinstance(mechanism, SliderCrank) and not mechanism.offset:
        return {n: Complex(0, t) for n, t in torque_values(order, mechanism.ratio, digits).items()}
    return _of_square(mechanism, order, digits, "height")


def rod_harmonics(mechanism: Mechanism, order: int, digits: int = 40) -> dict[int, Complex]:
    """Return n -> C + iS of the torque of a moment of inertia that turns with the rod, over J omega^2."""
    mechanism = simplified(mechanism)
    if isinstance(mechanism, SliderCrank) and not mechanism.offset:
        return {n: Complex(0, u) for n, u in rod_torque_values(order, mechanism.ratio, digits).items()}
    return _of_square(mechanism, order, digits, "rod-angle")


def rocking_harmonics(mechanism: Mechanism, order: int, digits: int = 40) -> dict[int, Complex]:
    """Return n -> C + iS of phi'': the couple of a moment of inertia on the rod, over J omega^2."""
    angles = rod_angle_harmonics(mechanism, order, digits)
    return {n: -2 * n * n * d.conjugate() for n, d in angles.items() if n}


def beside_harmonics(mechanism: Mechanism, order: int, digits: int = 40) -> dict[int, Complex]:
    """Return n -> C + iS of the inertia force's moment about the crank, over m r^2 omega^2: -eps F.

    The force acts along the cylinder's axis, which passes the crank at eps r.
    """
    offset = mechanism.offset
    if not offset:
        return {}
    forces = force_harmonics(mechanism, order, digits)
    return {n: Complex(a, b) * -offset for n, (a, b) in forces.items()}


@lru_cache(maxsize=256)
def _of_square(mechanism: Mechanism, order: int, digits: int, quantity: str) -> dict[int, Complex]:
    nepers, strip = digits * log(10) + GUARD, max(mechanism.strip, LEAST_STRIP)
    highest = order + ceil(nepers / (2 * strip))
    series = series_of(mechanism, highest, digits, quantity)
    bits = ceil((nepers + strip * order) / log(2)) + 64
    # i n (a + ib) = -n b + i n a
    rates = {n: (fixed(-n * c.imag, bits), fixed(n * c.real, bits)) for n, c in series.items() if n}
    torques, working = {}, digits_of(bits)
    for n in range(1, order + 1):
        real, imaginary = (ldexp(Real(x, working), -2 * bits) for x in _product(rates, n))
        if real or imaginary:
            torques[n] = Complex(n * imaginary, n * real)  # i n conj(real + i imaginary)
    return torques


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


def link_pin_harmonics(mechanism: LinkRod, order: int, digits: int = 40) -> dict[int, Complex]:
    """Return n -> C + iS of the torque of a mass on a link pin, over m r^2 omega^2: -1/2 d/dp |w'|^2.

    w is the pin's place (`symbalance.kinematics.mechanisms.moving_masses`); with u_n = i n w_n, n of both
    signs, C_n + i S_n = i n conj(sum over k of u_k conj(u_{k-n})).
    """
    place = _whole_path(mechanism, order, digits)
    rates = {n: w * Complex(0, n) for n, w in place.items()}
    squares = {n: _correlation(rates, rates, n) for n in range(1, order + 1)}
    return {n: s.conjugate() * Complex(0, n) for n, s in squares.items() if s}


def link_pin_moments(mechanism: LinkRod, order: int, digits: int = 40) -> dict[int, Complex]:
    """Return n -> C + iS of the moment about the crank of a link pin mass's force, over m r^2 omega^2.

    The force -w'' acts at w: with g_n = sum over k of k^2 w_k conj(w_{k-n}) the moment Im(conj(w) (-w''))
    has C_n + i S_n = conj((g_n - conj(g_-n))/i).

    On a master rod without offset every even order is 0, whatever the link pin's place: with A = psi - p
    the part of the moment of momentum that half a turn leaves as it is is -sin A sin phi + phi' cos A
    cos phi = rho cos psi, as sin phi = rho sin p. So they are left out.
    """
    place = _whole_path(mechanism, order, digits)
    forces = {n: w * (n * n) for n, w in place.items()}
    moments = {}
    for n in range(1, order + 1, 2 if mechanism.master.is_centred else 1):
        parts = _correlation(forces, place, n), _correlation(forces, place, -n).conjugate()
        moment = rounded_sum(parts[0], -parts[1])
        if moment:
            moments[n] = Complex(moment.imag, moment.real)
    return moments


def _whole_path(mechanism: LinkRod, order: int, digits: int) -> dict[int, Complex]:
    """Return the link pin's place from the crank's axis, to the order that products need."""
    strip = max(mechanism.master.strip, LEAST_STRIP)
    highest = order + ceil((digits * log(10) + GUARD) / (2 * strip))
    place = link_pin_path(mechanism, highest, digits)
    return place | {1: place.get(1, Complex(0, 0, digits + 10)) + 1}


def _correlation(first: Mapping[int, Complex], second: Mapping[int, Complex], n: int) -> Complex:
    """Return the sum over k of left_k conj(right_{k-n})."""
    return csum(x * second[k - n].conjugate() for k, x in first.items() if k - n in second)
