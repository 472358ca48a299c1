r"""Rotating masses of an engine as vectors: counterweights, balance shafts, and masses at the crank pins.

A vector u on what turns at n times the crank's speed (n of either sign) adds u to c_n of the force and
(station - reference plane) u to c_n of the couple (`symbalance.forces.free_forces`); u is in the unit of
its order: m r omega^2 of the first cylinder at order 1, F_n = A_n m r omega^2 above. The rotating masses,
sum of m_j r_j e^(i throw_j) at their stations, are taken as balanced throw by throw as long as an engine
lists no counterweight; from the first one on they count.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from symbalance.engine.balance_masses import Counterweight, Weight, directed
from symbalance.errors import SymbalanceError
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.decimal_phasor import DecimalPhasor
from symbalance.exact.phasor import Phasor
from symbalance.kinematics.slider_crank import acceleration_values
from symbalance.text.reals import DIGITS, Real

if TYPE_CHECKING:
    from symbalance.engine.engine import Engine


@dataclass(frozen=True)
class RotatingMass:
    """A vector that turns at `speed` times the crank's speed, at a station, its axis at (x, y) mm."""

    speed: int
    vector: Amplitude
    station: Fraction
    x: Fraction = Fraction(0)
    y: Fraction = Fraction(0)


def rotating_masses(engine: Engine) -> list[RotatingMass]:
    """Return all that turns and is not balanced by itself, each in the unit of its order."""
    masses = [_counterweight(engine, c) for c in engine.balancers.counterweights]
    if engine.balancers.counterweights:
        masses += _rotating(engine)
    for shaft in engine.balancers.shafts:
        for weight in shaft.weights:
            vector = directed(_in_units(engine, weight, shaft.speed), shaft.phase)
            masses.append(RotatingMass(shaft.speed, vector, weight.station, shaft.x, shaft.y))
    return masses


def _counterweight(engine: Engine, counterweight: Counterweight) -> RotatingMass:
    against, station = counterweight.stands_at(engine.cylinders)
    if counterweight.weight is not None:
        vector = directed(_in_units(engine, counterweight.weight, 1), against)
    else:
        assert counterweight.overbalance is not None
        place = next(i for i, c in enumerate(engine.cylinders) if c.number == counterweight.throw)
        share = engine.rotating_sizes[place] + counterweight.overbalance * engine.sizes[place]
        vector = directed(Phasor.of(1, {0: share}), against + counterweight.angle)
    return RotatingMass(1, vector, station)


def _rotating(engine: Engine) -> list[RotatingMass]:
    pairs = zip(engine.cylinders, engine.rotating_sizes, strict=True)
    return [RotatingMass(1, directed(Phasor.of(1, {0: s}), c.throw), c.station) for c, s in pairs if s]


def _in_units(engine: Engine, weight: Weight, speed: int) -> Amplitude:
    """Return a weight's force over the unit of its order; decimals where that is no longer exact."""
    if weight.in_kg_mm:
        unit = engine.unit_unbalance
        if unit is None:
            rule = "counts in units of m r"
            remedy = "give stroke and reciprocating_mass (above 0) in [crank_train], or a share"
            raise SymbalanceError("unbalance", rule, remedy)
        return weight.vector.scaled(speed * speed / unit)
    if has_unit_share(engine, speed):
        return weight.vector
    return DecimalPhasor(weight.vector.evaluated() * unit_of_share(engine, speed))


def has_unit_share(engine: Engine, speed: int) -> bool:
    """Tell whether a share of 1 is the unit its order counts in: then shares are the order's vectors.

    Shares are of A_n m r omega^2, as orders are where the engine counts in them; or of m r omega^2 at
    the crank's own speed, and where cylinders have no A_n in common, as orders then are too. They differ
    where cylinders are alike, and a weight in kg mm faster than the crank makes orders count in
    m r omega^2 all the same: there a share of 1 is A_n (`unit_of_share`), which is no fraction.
    """
    return engine.counts_in_orders or not engine.has_common_harmonics or abs(speed) == 1


def share_sign(engine: Engine, speed: int) -> int:
    """Return the sign of what a share is a multiple of, known without a rod ratio: -1 for A_4, A_8, ...

    The distance of a piston is sqrt(lambda^2 - 1/2 + cos(2 theta)/2) beside the crank's part. The powers
    of the cosine have the signs of the binomial coefficients of 1/2, which take turns, and the k-th adds
    to harmonics k, k - 2, ... of 2 theta alone: so A_2, A_6, ... are above 0, and A_4, A_8, ... below.
    """
    return -1 if engine.has_common_harmonics and abs(speed) % 4 == 0 else 1


def unit_of_share(engine: Engine, speed: int) -> Real:
    """Return what a share of 1 pushes with at n times the crank's speed, in m r omega^2: A_n, or 1.

    It is 1 where cylinders have no A_n in common, and refused where that depends on an unknown ratio.
    """
    n = abs(speed)
    if n == 1 or not engine.has_common_harmonics:
        return Real(1)
    if engine.ratio is None:
        rule, remedy = f"has no rod ratio, and A_{n} depends on it", "give stroke and rod, or ratio"
        raise SymbalanceError(f"engine {engine.name!r}", rule, remedy)
    return acceleration_values(n, engine.ratio, DIGITS)[n]
