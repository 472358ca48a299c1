r"""Derivatives of one cylinder's harmonics A_n - i B_n by crank radius, rod and offset, to any digits.

Of y = cos p + lam cos phi, sin phi = (sin p - eps)/lam (lengths over r), the derivatives are

    dy/dlam = 1/cos phi,        dy/deps = tan phi,

so with their Fourier coefficients S_n and T_n

    df_n/dlam = 2 n^2 S_n,      df_n/deps = 2 n^2 T_n,      f_n = A_n - i B_n = 2 n^2 c_n,

and of the force m omega^2 r f_n(l/r, e/r), at fixed m and omega and over m omega^2,

    d/dr = f_n - lam df_n/dlam - eps df_n/deps,     d/dl = df_n/dlam,     d/de = df_n/deps.

The coefficients are means over N points. In the strip |Im p| <= a with (cosh a + |eps|)/lam = s < 1 both
functions are at most M = 1/sqrt(1 - s^2), so N points alias onto order n at most 2 M e^(-a (N - n))/(1 -
e^(-a N)): coefficient k is at most M e^(-a |k|), and those of all k = n + j N, j != 0, are added to n's.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from math import acosh, ceil, log, sqrt
from typing import NamedTuple

from symbalance.errors import SymbalanceError
from symbalance.kinematics.mechanisms import SliderCrank, force_harmonics
from symbalance.text.reals import DIGITS, Complex, Real, expjpi, fdot
from symbalance.text.reals import sqrt as root

GUARD = 10
"""Digits computed beyond those promised."""
MOST_POINTS = 20_000
"""More are needed only where the rod lies almost across at mid-stroke: refused rather than slow."""


class LengthDerivatives(NamedTuple):
    """f_n of one cylinder and its derivatives by crank radius, rod and offset, each over r."""

    value: Complex
    stroke: Complex
    rod: Complex
    offset: Complex


def length_derivatives(
    mechanism: SliderCrank, order: int, digits: int = DIGITS
) -> dict[int, LengthDerivatives]:
    """Return n -> (f_n, r df/dr, r df/dl, r df/de), n = 1..order, of m omega^2 r f_n, over m omega^2 r.

    `stroke` is the derivative by the crank radius: half of it is that by the stroke.

    >>> from symbalance.text.reals import nstr
    >>> [nstr(x.real, 8) for x in length_derivatives(SliderCrank(4), 2)[2][:3]]
    ['0.25402504', '0.51634683', '-0.065580447']
    """
    return dict(_rows(mechanism, order, digits))


@lru_cache(maxsize=256)
def _rows(mechanism: SliderCrank, order: int, digits: int) -> tuple[tuple[int, LengthDerivatives], ...]:
    forces = force_harmonics(mechanism, order, digits)
    changes = _means(mechanism, range(1, order + 1), digits)
    rows = []
    for n, (by_rod, by_offset) in changes.items():
        value = Complex(forces[n][0], -forces[n][1]) if n in forces else Complex(0)
        radius = value - mechanism.ratio * by_rod - mechanism.offset * by_offset
        rows.append((n, LengthDerivatives(value, radius, by_rod, by_offset)))
    return tuple(rows)


def _means(
    mechanism: SliderCrank, orders: Sequence[int], digits: int
) -> dict[int, tuple[Complex, Complex]]:
    """Return n -> (df_n/dlam, df_n/deps); what symmetry makes zero is 0."""
    points, working = _points(mechanism, max(orders), digits)
    centred, derivatives = mechanism.offset == 0, {}
    roots = [expjpi(Fraction(2 * i, points), working) for i in range(points)]
    sines = [(z.imag - mechanism.offset) / mechanism.ratio for z in roots]
    secants = [1 / root((1 - x) * (1 + x)) for x in sines]
    tangents = [x * y for x, y in zip(sines, secants, strict=True)]
    for n in orders:
        rotations = [roots[-n * i % points] for i in range(points)]
        by_rod = Complex(0) if centred and n % 2 else _mean(secants, rotations, n)
        by_offset = Complex(0) if centred and n % 2 == 0 else _mean(tangents, rotations, n)
        derivatives[n] = (by_rod, by_offset)
    return derivatives


def _mean(samples: Sequence[Real], rotations: Sequence[Complex], n: int) -> Complex:
    """Return 2 n^2 times a coefficient: real at even n, imaginary at odd n: sin p alone matters."""
    total = 2 * n * n * fdot(samples, rotations) / len(samples)
    return Complex(0, total.imag) if n % 2 else Complex(total.real)


def _points(mechanism: SliderCrank, order: int, digits: int) -> tuple[int, int]:
    """Return how many points, and how many digits to work with, give order n to `digits` of its own."""
    reach, lam = float(abs(mechanism.offset)), float(mechanism.ratio)
    slant = (1 + (1 + reach) / lam) / 2
    width = acosh(max(slant * lam - reach, 1.0)) if slant < 1 else 0.0
    bound = 1 / sqrt(1 - slant * slant) if slant < 1 else float("inf")
    nepers = (digits + GUARD) * log(10) + mechanism.strip * order
    needed = order + (nepers + log(4 * bound)) / width if width else float("inf")
    if needed > MOST_POINTS:
        what, rule = (
            f"ratio = {lam:.12g}",
            "lets the rod lie across so nearly that its derivatives are not computed",
        )
        raise SymbalanceError(what, rule, "lengthen the rod, or ask for fewer orders")
    return ceil(needed), digits + GUARD + ceil(mechanism.strip * order / log(10)) + 12
