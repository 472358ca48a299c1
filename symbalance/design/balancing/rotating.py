r"""Rotating parts: sum of m_i r_i, the force and couple they leave, and the counterweights that end both.

A part of mass m at radius r and angle a has the unbalance m r e^(i a); a crank is in static balance where
their sum is 0, in dynamic balance where the sum of station * m r e^(i a) is 0 too. For one throw that is
the second equation of a founding document, sum of m_i r_i = m_4 r_4. For a crank two planes always do
(Den Hartog, Mechanical Vibrations, section 6.2, from memory); `symbalance.design.balancing.planes`
shares the weights out over more.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from symbalance.design.balancing.planes import in_planes
from symbalance.engine.balancers import Counterweight, Weight
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError, shown
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.angles import Angle
from symbalance.exact.arithmetic import total
from symbalance.text.numbers import exact, listed


def throw_unbalance(parts: Iterable[tuple[object, object]]) -> Fraction:
    """Return sum of m_i r_i, the unbalance of what hangs on one throw: kg times mm give kg mm.

    Radii count from the crank's axis towards the pin; negative ones lie opposite, as a web's own
    counterweight does. The counterweight that ends it has the same mass times radius on the other side.

    >>> throw_unbalance([("0.35", 40), ("0.42", 40), ("0.9", 12)])  # pin, rod end, two cheeks
    Fraction(208, 5)
    """
    rows = [tuple(listed(part, "part", "(0.35, 40)")) for part in listed(parts, "parts", "[(0.35, 40)]")]
    if any(len(row) != 2 for row in rows):
        raise SymbalanceError("parts", "hold a mass and a radius each", "write them like [(0.35, 40)]")
    return sum((_mass(m) * exact(r, "radius") for m, r in rows), Fraction(0))


def _mass(value: object) -> Fraction:
    mass = exact(value, "mass")
    if mass < 0:
        raise SymbalanceError(f"mass = {shown(value)}", "must not be negative", "give a negative radius")
    return mass


def rotating_weights(layout: Engine) -> list[Weight]:
    """Return the rotating masses of an engine, in kg mm if its sizes are known, else in shares.

    >>> from symbalance.engine.builders import inline
    >>> from symbalance.engine.trains import CrankTrain
    >>> train = CrankTrain(reciprocating_mass=Fraction(1, 2), rotating_mass=Fraction(3, 4))
    >>> [w.vector.rational() for w in rotating_weights(inline("1-2", crank_train=train))]
    [Fraction(3, 2), Fraction(3, 2)]
    """
    unit = layout.unit_unbalance
    found = []
    for cylinder, share in zip(layout.cylinders, layout.rotating_sizes, strict=True):
        size = {"share": share} if unit is None else {"unbalance": share * unit}
        found += [Weight(cylinder.station, cylinder.throw, **size)] if share else []
    return found


def rotating_unbalance(weights: Iterable[Weight], plane: object = 0) -> tuple[Amplitude, Amplitude]:
    """Return the force and the couple about a station that turning weights leave, in their unit.

    >>> force, couple = rotating_unbalance([Weight(1, 0, unbalance=5), Weight(-1, 180, unbalance=5)])
    >>> force.is_zero(), couple.rational()
    (True, Fraction(10, 1))
    """
    rows, station = _checked(weights), exact(plane, "plane")
    return total(w.vector for w in rows), total(w.vector.scaled(w.station - station) for w in rows)


def balanced_weights(
    weights: Iterable[Weight], stations: Sequence[object], *, spread: str = "ends"
) -> list[Counterweight]:
    """Return counterweights at given stations that balance turning weights in force and couple.

    With two stations or more the balance is exact; `spread` "ends" takes the fewest planes and the least
    total, "even" all of them with the least sum of squares. With one station it is static, if it can be
    no more.

    >>> found = balanced_weights([Weight(1, 0, unbalance=6), Weight(0, 90, unbalance=3)], [3, -3])
    >>> [str(c.station) for c in found], all(c.weight is not None for c in found)
    (['3', '-3'], True)
    """
    rows = _checked(weights)
    in_kg_mm = any(w.in_kg_mm for w in rows)
    places = [exact(s, "stations") for s in listed(stations, "stations", "[2, -2]")]
    force, couple = rotating_unbalance(rows)
    if len(set(places)) == 1:  # static: the couple about the one plane is not to be had
        force, couple = -force, -force.scaled(places[0])
    else:
        force, couple = -force, -couple
    if force.is_zero() and couple.is_zero():
        return []
    placed = in_planes(force, couple, places, spread=spread, length=Fraction(1))
    return [_counterweight(vector, station, in_kg_mm) for station, vector in placed]


def _counterweight(vector: Amplitude, station: Fraction, in_kg_mm: bool) -> Counterweight:
    if not in_kg_mm:
        return Counterweight(Angle(Fraction(0)), station, share=vector)
    return Counterweight(Angle(Fraction(0)), station, unbalance=vector)


def _checked(weights: Iterable[Weight]) -> list[Weight]:
    rows = listed(weights, "weights", "[Weight(1, 0, unbalance=5)]")
    if not all(isinstance(w, Weight) for w in rows):
        raise SymbalanceError("weights", "must be Weight values", "make each with Weight(...)")
    if len({w.in_kg_mm for w in rows}) > 1:
        raise SymbalanceError("weights", "are partly in kg mm and partly shares", "give them in one unit")
    return rows
