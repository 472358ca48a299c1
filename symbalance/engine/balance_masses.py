"""Counterweights on the crank and balance shafts: where they are, how heavy, how fast they turn.

A weight of unbalance U (mass times radius) on what turns at n times the crank's speed pushes with
U n^2 omega^2 in its own direction: a counterweight adds to the part of order +1 of force and couple, a
shaft that turns with the crank at n times its speed to +n, one that turns against it to -n. U is given
in kg mm or as a `share`: that weight pushes with share * F_n, F_n = A_n m r omega^2 (m r omega^2 of the
first cylinder where cylinders are unlike), so that U = share A_n m r/n^2, exactly, whatever lambda is.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from symbalance.engine.cylinders import Cylinder
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.angles import Angle, angle
from symbalance.exact.phasor import ONE, Phasor
from symbalance.exact.symbolic_phasor import SymbolicPhasor
from symbalance.kinematics.slider_crank import HIGHEST_ORDER, surviving
from symbalance.text.numbers import LARGEST_QUOTIENT, as_list, checked_whole, exact

MOST_BALANCERS = 2000
"""Counterweights, or shafts, or weights of a shaft: one for each of 1000 throws, and as many again."""
WEB = Fraction(1, 4)
"""How far a web stands from the middle of its pin, in pitches, where no station is given."""
HALF, QUARTER = Fraction(1, 2), Fraction(1, 4)


@dataclass(frozen=True, init=False)
class Weight:
    """A balance weight: its unbalance, its direction at theta = 0, its station along the crank.

    Give `unbalance` in kg mm, or `share`, a multiple of A_n m r/n^2 (a number of the exact fields, as a
    design finds it, counts with its own direction). `phase` is its direction at theta = 0, degrees from
    straight up, positive in the sense of rotation; `station` in pitches, as for cylinders. A direction
    that is no fraction of a turn is given exactly by two parts in place of one size: along `phase`, and a
    quarter turn after it.

    >>> weight = Weight(share="1/2", phase=180)
    >>> weight.vector == Phasor.root(Fraction(1, 2)).scaled(Fraction(1, 2)), weight.in_kg_mm
    (True, False)
    >>> Weight(share=("1/2", "-1/3")).vector == Phasor.of(4, {0: Fraction(1, 2), 1: Fraction(-1, 3)})
    True
    """

    station: Fraction
    vector: Amplitude = field(hash=False)
    in_kg_mm: bool

    def __init__(
        self, station: object = 0, phase: object = 0, *, share: object = None, unbalance: object = None
    ) -> None:
        if (share is None) == (unbalance is None):
            rule, remedy = "takes either unbalance or share", "kg mm, or a multiple of A_n m r/n^2"
            raise SymbalanceError("a weight", rule, remedy)
        set_field = object.__setattr__
        set_field(self, "station", exact(station, "station"))
        set_field(self, "in_kg_mm", share is None)
        set_field(self, "vector", directed(_size(share, unbalance), angle(phase, "phase")))


def _size(share: object, unbalance: object) -> Amplitude:
    name, value = ("unbalance", unbalance) if share is None else ("share", share)
    if not isinstance(value, tuple | list):
        return _part(value, name)
    if len(value) != 2:
        rule = "must be one size, or two parts: along its direction, and a quarter turn after it"
        raise SymbalanceError(f"{name} = {brief(value)}", rule, "write it like [1/2, -1/3]")
    along, across = (_part(part, f"{name}[{i}]") for i, part in enumerate(value, 1))
    return along + across.rotated(QUARTER)


def _part(value: object, name: str) -> Amplitude:
    if isinstance(value, Amplitude):
        return value
    return Phasor.of(1, {0: exact(value, name, LARGEST_QUOTIENT)})


def directed(size: Amplitude, direction: Angle) -> Amplitude:
    """Return a number turned by an angle, which may hold symbols."""
    rotated = size.rotated(direction.turns)
    if not direction.symbols:
        return rotated
    if rotated.is_decimal:
        rule = "cannot hold symbols beside a decimal share"
        raise SymbalanceError(f"angle = {direction.as_text()}", rule, "give it in degrees")
    return rotated.times(SymbolicPhasor.of({direction.symbols: ONE}))


@dataclass(frozen=True, init=False)
class Counterweight:
    """A counterweight on the crank: at a station and angle, or opposite a throw or on a web.

    `angle` is its direction at theta = 0; with `throw` (a cylinder's number) or `web` (counted from the
    front, two to a pin) it is measured from the direction opposite that crank pin, and the station need
    not be given: a throw's is its cylinder's, a web's a quarter pitch from its pin's. `overbalance` k,
    with a throw, balances the rotating mass of that cylinder and k of its reciprocating mass.

    >>> Counterweight(throw=1, overbalance="1/2").overbalance
    Fraction(1, 2)
    """

    angle: Angle
    station: Fraction | None
    weight: Weight | None
    overbalance: Fraction | None
    throw: int | None
    web: int | None

    def __init__(
        self,
        angle: object = 0,
        station: object = None,
        *,
        share: object = None,
        unbalance: object = None,
        overbalance: object = None,
        throw: object = None,
        web: object = None,
    ) -> None:
        if sum(x is not None for x in (share, unbalance, overbalance)) != 1:
            rule, remedy = "takes one of unbalance, share and overbalance", "give one of them"
            raise SymbalanceError("counterweight", rule, remedy)
        if throw is not None and web is not None:
            raise SymbalanceError(f"web = {brief(web)}", "stands on a throw's web", "leave out throw")
        if overbalance is not None and throw is None:
            what, rule = f"overbalance = {brief(overbalance)}", "is of the masses of one cylinder"
            raise SymbalanceError(what, rule, "add throw = its number")
        set_field, known = object.__setattr__, overbalance is None
        set_field(self, "angle", _direction(angle))
        set_field(self, "station", None if station is None else exact(station, "station"))
        weight = Weight(0, self.angle, share=share, unbalance=unbalance) if known else None
        set_field(self, "weight", weight)
        set_field(self, "overbalance", None if known else exact(overbalance, "overbalance"))
        for name, value in (("throw", throw), ("web", web)):
            checked = None if value is None else checked_whole(value, name, 1, 2000, "count from 1")
            set_field(self, name, checked)

    def stands_at(self, cylinders: Sequence[Cylinder]) -> tuple[Angle, Fraction]:
        """Return what its own angle is measured from, and its station; refused where that is unknown."""
        zero = Angle(Fraction(0))
        if self.throw is not None:
            on = next((c for c in cylinders if c.number == self.throw), None)
            if on is None:
                rule = "names no cylinder"
                raise SymbalanceError(f"throw = {self.throw}", rule, "give a cylinder's number")
            pin, station = on.throw, on.station
        elif self.web is not None:
            pin, station = _web(self.web, cylinders)
        else:
            return zero, self.station or Fraction(0)
        return pin + Angle(HALF), station if self.station is None else self.station


def _direction(value: object) -> Angle:
    return angle(value, "angle")


def _web(web: int, cylinders: Sequence[Cylinder]) -> tuple[Angle, Fraction]:
    pins = crank_pins(cylinders)
    if web > 2 * len(pins):
        rule = f"is beyond the last: the crank has {len(pins)} pins"
        raise SymbalanceError(f"web = {web}", rule, f"count from the front, 1 to {2 * len(pins)}")
    throw, station = pins[(web - 1) // 2]
    return throw, station + (WEB if web % 2 else -WEB)


def crank_pins(cylinders: Sequence[Cylinder]) -> list[tuple[Angle, Fraction]]:
    """Return throw and station of every pin from the front; a pin's station is its cylinders' mean.

    Cylinders share a pin where their throws are the same and they stand within a pitch.

    >>> vee = [Cylinder(1, 0, -30, "1/8"), Cylinder(2, 0, 30, "-1/8")]
    >>> pins = crank_pins([*vee, Cylinder(3, 180, 0, -1)])
    >>> [(t.as_text(), str(s)) for t, s in pins]
    [('0', '0'), ('180', '-1')]
    """
    groups: list[list[Cylinder]] = []
    for cylinder in sorted(cylinders, key=lambda c: -c.station):
        mates = (
            g for g in groups if g[0].throw == cylinder.throw and g[0].station - cylinder.station < 1
        )
        group = next(mates, None)
        if group is None:
            groups.append([cylinder])
        else:
            group.append(cylinder)
    pins = [(g[0].throw, sum((c.station for c in g), Fraction(0)) / len(g)) for g in groups]
    return sorted(pins, key=lambda pin: -pin[1])


@dataclass(frozen=True, init=False)
class BalanceShaft:
    """A balance shaft at `speed` times the crank's speed, negative if it turns against the crank.

    Its weights' phases are directions at theta = 0, to which its own `phase` adds. `x` and `y` are where
    its axis runs, mm to the right of the crank and above it, seen from the front: its forces have a
    moment about the crank.

    >>> shaft = BalanceShaft(-2, [Weight(share=2)], y=60)
    >>> shaft.speed, shaft.y, len(shaft.weights)
    (-2, Fraction(60, 1), 1)
    """

    speed: int
    weights: tuple[Weight, ...]
    phase: Angle
    x: Fraction
    y: Fraction

    def __init__(
        self, speed: object, weights: Iterable[Weight], *, phase: object = 0, x: object = 0, y: object = 0
    ) -> None:
        set_field = object.__setattr__
        set_field(self, "speed", checked_speed(speed))
        set_field(self, "weights", tuple(as_list(weights, "weights", "[Weight(share=1)]")))
        for weight in self.weights:
            _check_weight(weight)
        if not 1 <= len(self.weights) <= MOST_BALANCERS:
            raise SymbalanceError("weights = []", "a shaft has at least one", "give share or unbalance")
        set_field(self, "phase", angle(phase, "phase"))
        set_field(self, "x", exact(x, "x"))
        set_field(self, "y", exact(y, "y"))


def _check_weight(weight: object) -> None:
    if not isinstance(weight, Weight):
        raise SymbalanceError(f"weights hold {brief(weight)}", "must be Weight values", "make each so")


def check_shares(shafts: Iterable[BalanceShaft]) -> None:
    """Refuse shares of an A_n that is 0: with cylinders alike, every odd one above the first."""
    for shaft in shafts:
        if not surviving(abs(shaft.speed)) and not all(w.in_kg_mm for w in shaft.weights):
            rule = f"is a multiple of A_{abs(shaft.speed)}, which is 0"
            raise SymbalanceError("share", rule, "give unbalance = ..., kg mm")


def checked_speed(speed: Any) -> int:
    """Return a shaft's speed over the crank's, a whole number other than 0, or refuse.

    >>> checked_speed(-2)
    -2
    """
    remedy = "times the crank's; - turns against it"
    number = checked_whole(speed, "speed", -HIGHEST_ORDER, HIGHEST_ORDER, remedy)
    if number == 0:
        raise SymbalanceError("speed = 0", "must not be 0", remedy)
    return number


@dataclass(frozen=True)
class Balancers:
    """The counterweights and balance shafts of an engine."""

    counterweights: tuple[Counterweight, ...] = ()
    shafts: tuple[BalanceShaft, ...] = ()

    def __post_init__(self) -> None:
        for name, kind in (("counterweights", Counterweight), ("shafts", BalanceShaft)):
            values = getattr(self, name)
            few = isinstance(values, tuple | list) and len(values) <= MOST_BALANCERS
            if not few or not all(isinstance(x, kind) for x in values):
                rule = f"must be at most {MOST_BALANCERS} {kind.__name__} values"
                raise SymbalanceError("balancers", rule, f"make each with {kind.__name__}(...)")

    def __bool__(self) -> bool:
        return bool(self.counterweights or self.shafts)

    def denominators(self) -> list[int]:
        """Return the denominators, in turns, of every angle in it."""
        moduli = [s.phase.turns.denominator for s in self.shafts]
        vectors = [w.vector for s in self.shafts for w in s.weights]
        vectors += [c.weight.vector for c in self.counterweights if c.weight]
        for vector in vectors:
            moduli += vector.moduli
        return moduli


def checked_balancers(value: object, cylinders: Sequence[Cylinder]) -> Balancers:
    """Return an engine's balancers, or refuse what is none or stands on a throw that is not there."""
    if value is None:
        return Balancers()
    if not isinstance(value, Balancers):
        raise SymbalanceError(f"balancers = {brief(value)}", "must be Balancers", "make them so")
    for counterweight in value.counterweights:
        counterweight.stands_at(cylinders)
    return value
