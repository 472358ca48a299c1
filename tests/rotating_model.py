"""A whole engine with all that turns, in the time domain, without symbalance's sums.

Pistons are placed by intersecting circles and lines (`placed`) and differentiated numerically, or
taken from the closed form of `kinematics`; a weight is a point that turns at constant speed, its force
the mass times the second derivative of its place, taken in closed form. Of an engine only the data are
read: throws, banks, stations, sizes; of a weight its size and direction in decimals. A share is turned
into an unbalance with A_n found by the trapezoidal rule. Units: m r omega^2 of cylinder 1, pitches.
"""

from __future__ import annotations

from functools import cache

from mpmath import mp

import symbalance as sb
from tests import kinematics

DIGITS = 50


def number(value):
    return kinematics.number(value)


def direction(angle):
    """Return e^(i angle) of an `Angle` without symbols."""
    return mp.expj(kinematics.radians(angle.in_degrees()))


@cache
def coefficient(n: int, ratio):
    """Return A_n of one piston by the trapezoidal rule."""
    with mp.workdps(DIGITS):
        lam = number(ratio)
        points = kinematics.points_for(ratio, n, 46)
        found = kinematics.harmonics(lambda p: kinematics.acceleration(p, lam), [n], points)
        return found[n][0].real


def size(vector):
    """Return a weight's size and direction, as one complex number."""
    return mp.mpc(vector.evaluated())


def turning(layout: sb.Engine):
    """Return (speed, complex force over m r omega^2, station) of every weight and rotating mass."""
    first = layout.cylinders[0]
    unit = number(first.reciprocating_mass or 1) * number(first.stroke or 2) / 2
    found = []
    for counterweight in layout.balancers.counterweights:
        found.append(_counterweight(layout, counterweight, unit))
    if layout.balancers.counterweights:
        for cylinder in layout.cylinders:
            mass = cylinder.rotating_mass or 0
            radius = number(cylinder.stroke or 2) / 2
            pull = number(mass) * radius / unit * direction(cylinder.throw)
            found.append((1, pull, cylinder.station))
    for shaft in layout.balancers.shafts:
        for weight in shaft.weights:
            n = abs(shaft.speed)
            pull = size(weight.vector) * direction(shaft.phase)
            if weight.in_kg_mm:
                pull = pull * n**2 / unit  # U n^2 omega^2
            elif layout.has_common_harmonics:
                pull = pull * (coefficient(n, layout.ratio) if n > 1 else 1)
            found.append((shaft.speed, pull, weight.station))
    return found


def _counterweight(layout, counterweight, unit):
    reference, station = mp.mpc(1), counterweight.station
    if counterweight.throw is not None:
        on = next(c for c in layout.cylinders if c.number == counterweight.throw)
        reference = -direction(on.throw)
        station = on.station if station is None else station
    station = 0 if station is None else station
    if counterweight.overbalance is not None:
        train = on.sizes
        radius = number(train.stroke or 2) / 2
        masses = number(train.rotating_mass or 0)
        masses += number(counterweight.overbalance) * number(train.reciprocating_mass or 1)
        return 1, masses * radius / unit * reference * direction(counterweight.angle), station
    pull = size(counterweight.weight.vector) * reference
    return 1, pull / unit if counterweight.weight.in_kg_mm else pull, station


def like_pistons(layout: sb.Engine, theta, arms: bool):
    """Return vertical + i lateral of alike, centred pistons: the closed form of their acceleration."""
    ratio, mean = number(layout.ratio), layout.mean_station
    total = mp.mpc(0)
    for cylinder in layout.cylinders:
        lead = kinematics.radians(cylinder.throw.in_degrees() - cylinder.bank.in_degrees())
        arm = number(cylinder.station - mean) if arms else 1
        total += arm * kinematics.acceleration(theta + lead, ratio) * direction(cylinder.bank)
    return total


def engine(layout: sb.Engine, arms: bool, pistons=like_pistons):
    """Return theta -> vertical + i lateral of the free force or couple, all orders at once."""
    weights, mean = turning(layout), layout.mean_station

    def at(theta):
        total = pistons(layout, theta, arms)
        for speed, pull, station in weights:
            arm = number(station - mean) if arms else 1
            total += arm * pull * mp.expj(speed * theta)
        return total

    return at


def orders(layout: sb.Engine, wanted, pistons=like_pistons, points: int | None = None):
    """Return (order, "force" or "couple") -> the largest of its C and S, complex."""
    found = {}
    with mp.workdps(DIGITS):
        count = points or kinematics.points_for(layout.ratio, max(wanted) + 8)
        for arms, kind in ((False, "force"), (True, "couple")):
            parts = kinematics.harmonics(engine(layout, arms, pistons), wanted, count)
            for n in wanted:
                found[n, kind] = parts[n]
    return found


def largest(parts) -> float:
    """Return the largest amplitude among some orders."""
    return float(max(max(abs(c), abs(s)) for c, s in parts))
