r"""What turns in an engine: counterweights, balance shafts and the rotating masses of the crank.

A vector u on what turns at n times the crank's speed (n of either sign) adds u to c_n of the force and
(station - reference plane) u to c_n of the couple (`symbalance.forces.resultants`); u is in the unit of
its order: m r omega^2 of the first cylinder at order 1, F_n = A_n m r omega^2 above. The rotating masses,
sum of m_j r_j e^(i throw_j) at their stations, are taken as balanced throw by throw as long as an engine
lists no counterweight; from the first one on they count.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from mpmath import mp

from symbalance.engine.balancers import Counterweight, Weight, directed
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError
from symbalance.exact.arithmetic import decimal
from symbalance.exact.decimal_phasor import DIGITS, DecimalPhasor
from symbalance.exact.phasor import Phasor
from symbalance.exact.spectrum import Number
from symbalance.kinematics.slider_crank import acceleration_values
from symbalance.text.numbers import Real


@dataclass(frozen=True)
class Rotor:
    """A vector that turns at `speed` times the crank's speed, at a station, its axis at (x, y) mm."""

    speed: int
    vector: Number
    station: Fraction
    x: Fraction = Fraction(0)
    y: Fraction = Fraction(0)


def rotors(layout: Engine) -> list[Rotor]:
    """Return all that turns and is not balanced by itself, each in the unit of its order."""
    found = [_counterweight(layout, c) for c in layout.balancers.counterweights]
    if layout.balancers.counterweights:
        found += _rotating(layout)
    for shaft in layout.balancers.shafts:
        for weight in shaft.weights:
            vector = directed(_in_units(layout, weight, shaft.speed), shaft.phase)
            found.append(Rotor(shaft.speed, vector, weight.station, shaft.x, shaft.y))
    return found


def _counterweight(layout: Engine, counterweight: Counterweight) -> Rotor:
    against, station = counterweight.stands_at(layout.cylinders)
    if counterweight.weight is not None:
        vector = directed(_in_units(layout, counterweight.weight, 1), against)
    else:
        assert counterweight.overbalance is not None
        place = next(i for i, c in enumerate(layout.cylinders) if c.number == counterweight.throw)
        share = rotating_shares(layout)[place] + counterweight.overbalance * layout.sizes[place]
        vector = directed(Phasor.of(1, {0: share}), against + counterweight.angle)
    return Rotor(1, vector, station)


def _rotating(layout: Engine) -> list[Rotor]:
    pairs = zip(layout.cylinders, rotating_shares(layout), strict=True)
    return [Rotor(1, directed(Phasor.of(1, {0: s}), c.throw), c.station) for c, s in pairs if s]


def rotating_shares(layout: Engine) -> list[Fraction]:
    """Return every cylinder's rotating mass times crank radius over m r of the first; 0 where not given.

    >>> from symbalance.engine.builders import inline
    >>> from symbalance.engine.trains import CrankTrain
    >>> train = CrankTrain(reciprocating_mass=Fraction(1, 2), rotating_mass=Fraction(3, 4))
    >>> rotating_shares(inline("1-2", crank_train=train))
    [Fraction(3, 2), Fraction(3, 2)]
    """
    masses = [c.rotating_mass for c in layout.cylinders]
    if not any(masses):
        return masses
    strokes, one = [c.stroke for c in layout.cylinders], layout.first.stroke
    first = layout.first.reciprocating_mass
    if not first:
        rule = "counts beside counterweights, in units of the reciprocating mass"
        raise SymbalanceError("rotating_mass", rule, "give reciprocating_mass, kg, above 0")
    if len(set(strokes)) == 1:
        return [m / first for m in masses]
    if any(s is None for s in strokes):
        rule = "is given for some cylinders and not for others"
        raise SymbalanceError("stroke", rule, "give it for all, or in [crank_train]")
    return [m * s / (first * one) for m, s in zip(masses, strokes, strict=True) if s and one]


def unit_unbalance(layout: Engine) -> Fraction | None:
    """Return m r of the first cylinder in kg mm, None where its mass or stroke is not given.

    >>> from symbalance.engine.catalogue import load
    >>> unit_unbalance(load("vq30de"))
    Fraction(493309, 20000)
    """
    mass, radius = layout.first.reciprocating_mass, layout.first.radius
    return mass * radius if mass and radius else None


def _in_units(layout: Engine, weight: Weight, speed: int) -> Number:
    """Return a weight's force over the unit of its order; decimals where that is no longer exact."""
    if weight.in_kg_mm:
        unit = unit_unbalance(layout)
        if unit is None:
            rule = "counts in units of m r"
            remedy = "give stroke and reciprocating_mass (above 0) in [crank_train], or a share"
            raise SymbalanceError("unbalance", rule, remedy)
        return weight.vector.scaled(speed * speed / unit)
    if counts_in_orders(layout) or not layout.has_common_harmonics or abs(speed) == 1:
        return weight.vector
    with mp.workdps(DIGITS):
        return DecimalPhasor(decimal(weight.vector) * share_unit(layout, speed))


def counts_in_orders(layout: Engine) -> bool:
    """Tell whether every order is geometry in units of its own F_n = A_n m r omega^2, whatever lambda is.

    So it is where all cylinders have one A_n and every weight above the crank's speed is a share of it:
    one in kg mm needs A_n as a number.
    """
    fast = (s for s in layout.balancers.shafts if abs(s.speed) > 1)
    return layout.has_common_harmonics and not any(w.in_kg_mm for s in fast for w in s.weights)


def share_unit(layout: Engine, speed: int) -> Real:
    """Return what a share of 1 pushes with at n times the crank's speed, in m r omega^2: A_n, or 1.

    It is 1 where cylinders have no A_n in common, and refused where that depends on an unknown ratio.
    """
    n = abs(speed)
    if n == 1 or not layout.has_common_harmonics:
        return mp.mpf(1)
    if layout.ratio is None:
        rule, remedy = f"has no rod ratio, and A_{n} depends on it", "give stroke and rod, or ratio"
        raise SymbalanceError(f"engine {layout.name!r}", rule, remedy)
    return acceleration_values(n, layout.ratio, DIGITS)[n]
