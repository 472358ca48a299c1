"""The slider-crank and the whole engine from first principles, in mpmath, without symbalance.

Everything here follows from the conventions alone: a piston sits at r cos p + sqrt(l^2 - r^2 sin^2
p) from the crank's axis, p = theta + throw - bank being the cylinder's own crank angle; its
inertia force is minus mass times the second derivative of that, taken in closed form; the vertical
part is cos(bank) of it, the lateral part sin(bank), and the couple is the sum of (station - mean
of stations) times it. Harmonics are found by the trapezoidal rule, which for a smooth periodic
function converges like a power. Units: r = m = omega = 1, rod ratio lam = l/r, angles in degrees
(exact fractions) unless said otherwise.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import NamedTuple

from mpmath import mp

DIGITS = 50
Degrees = int | Fraction


class Place(NamedTuple):
    """One cylinder: throw and bank in degrees, station in pitches."""

    throw: Fraction
    bank: Fraction
    station: Fraction


def number(value: Degrees) -> mp.mpf:
    """Return a fraction at the working precision."""
    exact = Fraction(value)
    return mp.mpf(exact.numerator) / exact.denominator


def radians(degrees: Degrees) -> mp.mpf:
    """Return an angle of so many degrees in radians, at the working precision."""
    return number(degrees) * mp.pi / 180


def height(p: mp.mpf, lam: mp.mpf) -> mp.mpf:
    """Return the piston's distance from the crank's axis."""
    return mp.cos(p) + mp.sqrt(lam**2 - mp.sin(p) ** 2)


def displacement(p: mp.mpf, lam: mp.mpf) -> mp.mpf:
    """Return the piston's way from its top dead centre."""
    return 1 + lam - height(p, lam)


def velocity(p: mp.mpf, lam: mp.mpf) -> mp.mpf:
    """Return the first derivative of the displacement."""
    return mp.sin(p) * (1 + mp.cos(p) / mp.sqrt(lam**2 - mp.sin(p) ** 2))


def acceleration(p: mp.mpf, lam: mp.mpf) -> mp.mpf:
    """Return the second derivative of the displacement: the inertia force, + outward."""
    sine, cosine = mp.sin(p), mp.cos(p)
    root = mp.sqrt(lam**2 - sine**2)
    return cosine + (cosine**2 - sine**2) / root + (sine * cosine) ** 2 / root**3


def rod_angle(p: mp.mpf, lam: mp.mpf) -> mp.mpf:
    """Return the rod's angle to the cylinder's axis."""
    return mp.asin(mp.sin(p) / lam)


def planar(places: Sequence[Place], lam: Degrees, arms: bool) -> Callable[[mp.mpf], mp.mpc]:
    """Return theta -> vertical + i lateral, of the couple if `arms`, else of the force."""
    mean = sum((place.station for place in places), Fraction(0)) / len(places)
    ratio = number(lam)
    rows = [
        (
            radians(place.throw - place.bank),
            mp.expj(radians(place.bank)) * (number(place.station - mean) if arms else 1),
        )
        for place in places
    ]
    return lambda theta: mp.fsum(weight * acceleration(theta + lead, ratio) for lead, weight in rows)


def points_for(lam: Degrees, order: int, digits: int = 36) -> int:
    """Return how many points make the trapezoidal rule good to `digits` up to `order`.

    What is aliased onto an order n <= `order` is of order points - n and more, and the harmonics of
    one piston fall like q^(n/2) with q = ((1 - k')/(1 + k')), k' = sqrt(1 - 1/lam^2).
    """
    with mp.workdps(DIGITS):
        root = mp.sqrt(1 - 1 / number(lam) ** 2)
        fall = mp.log10((1 + root) / (1 - root)) / 2
        return int(order + digits / fall) + 8


def harmonics(
    function: Callable[[mp.mpf], mp.mpc | mp.mpf], orders: Sequence[int], points: int
) -> dict[int, tuple[mp.mpc, mp.mpc]]:
    """Return n -> (C, S) with function = constant + sum of C cos n theta + S sin n theta.

    C and S are complex where the function is: vertical in the real part, lateral in the imaginary.
    The constant stands under 0.
    """
    roots = [mp.expjpi(mp.mpf(2 * i) / points) for i in range(points)]
    samples = [mp.mpc(function(2 * mp.pi * i / points)) for i in range(points)]
    found = {0: (mp.fsum(samples) / points, mp.mpc(0))}
    for n in orders:
        rotated = [roots[n * i % points] for i in range(points)]
        cosine = mp.fsum(s * z.real for s, z in zip(samples, rotated, strict=True))
        sine = mp.fsum(s * z.imag for s, z in zip(samples, rotated, strict=True))
        found[n] = (2 * cosine / points, 2 * sine / points)
    return found


def placed(
    firing_order: Sequence[int],
    banks: Sequence[Degrees] = (0,),
    cylinders: Sequence[Sequence[int]] | None = None,
    intervals: Sequence[Degrees] | None = None,
    stagger: Sequence[Degrees] | None = None,
    strokes: int = 4,
) -> dict[int, Place]:
    """Return number -> place of an engine built from its firing order, walking the cycle once."""
    cycle = 180 * strokes
    rows = cylinders if cylinders is not None else [sorted(firing_order)]
    shifts = stagger if stagger is not None else [0] * len(banks)
    steps = (
        intervals if intervals is not None else [Fraction(cycle, len(firing_order))] * len(firing_order)
    )
    clock, fired = Fraction(0), {}
    for cylinder, step in zip(firing_order, steps, strict=True):
        fired[cylinder] = clock
        clock += Fraction(step)
    places = {}
    for bank, row, shift in zip(banks, rows, shifts, strict=True):
        for position, cylinder in enumerate(row):
            after_first = fired[cylinder] - fired[1]
            # When it fires its pin points along the bank; at theta = 0 it is that far behind.
            throw = Fraction(bank) - after_first
            places[cylinder] = Place(throw, Fraction(bank), Fraction(shift) - position)
    return places
