"""The class `Engine`: cylinders in groups of like ones, counterweights and balance shafts."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from math import lcm
from typing import TypeVar

from symbalance.engine.balance_masses import (
    Balancers,
    BalanceShaft,
    Counterweight,
    check_shares,
    checked_balancers,
)
from symbalance.engine.crank_train import checked_size
from symbalance.engine.cylinders import MOST_CYLINDERS, Cylinder, unchecked_copy
from symbalance.engine.rotating_masses import RotatingMass, rotating_masses
from symbalance.errors import SymbalanceError, brief, literal
from symbalance.exact.angles import SymbolPart
from symbalance.exact.phasor import checked_modulus
from symbalance.kinematics.bodies import Body, bodies
from symbalance.kinematics.mechanisms import Mechanism, has_link_pin
from symbalance.kinematics.slider_crank import checked_ratio
from symbalance.text.numbers import as_list, exact

LONGEST_NAME = 60
NEAR_TOP = Fraction(1, 8)
"""Turns by which an offset or a link rod may move a top dead centre."""
T = TypeVar("T", bound=Hashable)


@dataclass(frozen=True)
class Group:
    """Cylinders that push alike: one mechanism (None: centred, of unknown rod ratio) and one m r.

    `size` is m r over that of the engine's unit, cylinder 1.
    """

    mechanism: Mechanism | None
    size: Fraction
    cylinders: tuple[Cylinder, ...]

    @property
    def bodies(self) -> tuple[Body, ...]:
        """What moves with the mechanism of each; refused where no rod ratio is known."""
        return bodies(self.cylinders[0].known_mechanism)


@dataclass(frozen=True, init=False)
class Engine:
    """An engine: its cylinders, strokes per cycle, counterweights and balance shafts.

    `pitch` is the distance of neighbouring cylinders in mm, `bore` that of all cylinders, which plays a
    part in gas torque alone; None if not known. The cylinder of the
    lowest number is the unit: forces count in its m r omega^2. Sizes shared by all cylinders are put
    into each by whoever makes the engine: `from_cylinders` and the other builders, or an engine file.

    >>> twin = Engine([Cylinder(1, throw=0, station="1/2"), Cylinder(2, throw=180, station="-1/2")])
    >>> len(twin.cylinders), twin.strokes, twin.ratio
    (2, 4, None)
    """

    cylinders: tuple[Cylinder, ...]
    strokes: int
    name: str
    pitch: Fraction | None
    bore: Fraction | None
    balancers: Balancers

    def __init__(
        self,
        cylinders: Iterable[Cylinder],
        *,
        strokes: int = 4,
        name: str = "engine",
        pitch: object = None,
        bore: object = None,
        balancers: Balancers | None = None,
    ) -> None:
        set_field = object.__setattr__
        listed_cylinders = checked_cylinders(cylinders)
        _check_links(listed_cylinders)
        set_field(self, "cylinders", joined_cylinders(listed_cylinders))
        set_field(self, "strokes", checked_strokes(strokes))
        set_field(self, "name", checked_name(name))
        _check_fires(self.cylinders)
        set_field(self, "pitch", None if pitch is None else checked_size("pitch", pitch))
        set_field(self, "bore", None if bore is None else checked_size("bore", bore))
        set_field(self, "balancers", checked_balancers(balancers, self.cylinders))
        if self.balancers.shafts and self.has_common_harmonics:
            check_shares(self.balancers.shafts)

    @cached_property
    def modulus(self) -> int:
        """The m for which every numeric angle is a whole number of m-ths of a turn."""
        angles = (a.turns.denominator for c in self.cylinders for a in (c.bank, c.delay))
        return checked_modulus(lcm(*angles, *self.balancers.denominators()))

    @property
    def has_symbols(self) -> bool:
        """Whether some angle holds a symbol."""
        return any(c.bank.symbols or c.throw.symbols for c in self.cylinders)

    @cached_property
    def first(self) -> Cylinder:
        """The cylinder of the lowest number: the one whose sizes are the units, wherever it is listed."""
        return min(self.cylinders, key=lambda c: c.number)

    @property
    def ratio(self) -> Fraction | None:
        """The rod ratio lambda = l/r of all rods that run on crank pins, None if unknown or not one."""
        ratios = {c.ratio for c in self.cylinders if c.link is None}
        return ratios.pop() if len(ratios) == 1 else None

    @property
    def link_pins(self) -> list[int]:
        """The numbers of the cylinders whose rods hang on a link pin away from the crank pin."""
        return [c.number for c in self.cylinders if has_link_pin(c.mechanism)]

    @property
    def has_link_pin_masses(self) -> bool:
        """Whether some link pin bears a mass, which moves beside the crank pin's circle."""
        return any(c.rotating_mass for c in self.cylinders if has_link_pin(c.mechanism))

    @cached_property
    def sizes(self) -> tuple[Fraction, ...]:
        """Every cylinder's m r over that of the first; 1 where no masses or strokes are given.

        Refused where a mass or a stroke is given for some cylinders only.
        """
        masses = self._over_first("reciprocating_mass")
        return tuple(m * r for m, r in zip(masses, self.radii, strict=True))

    @cached_property
    def radii(self) -> tuple[Fraction, ...]:
        """Every cylinder's crank radius over that of the first; 1 where no strokes are given."""
        return tuple(self._over_first("stroke"))

    def _over_first(self, key: str) -> list[Fraction]:
        values, unit = [getattr(c, key) for c in self.cylinders], getattr(self.first, key)
        if all(value == unit for value in values):
            return [Fraction(1)] * len(values)
        if unit == 0:
            rule = f"is 0 for cylinder {self.first.number}, whose m r is the unit of the others'"
            raise SymbalanceError(key, rule, "give it a mass, or number another cylinder first")
        if any(value is None for value in values):
            rule = "is given for some cylinders and not for others"
            raise SymbalanceError(key, rule, "give it for all, or in [crank_train]")
        return [value / unit for value in values]

    @cached_property
    def groups(self) -> tuple[Group, ...]:
        """The cylinders in groups that push alike, in the order of the first of each."""
        size = dict(zip((c.number for c in self.cylinders), self.sizes, strict=True))
        groups = self.grouped(lambda c: (c.mechanism, size[c.number]))
        return tuple(Group(*key, cylinders) for key, cylinders in groups.items())

    def grouped(self, key: Callable[[Cylinder], T]) -> dict[T, tuple[Cylinder, ...]]:
        """Return the cylinders in groups of one key each, in the order of the first of each."""
        groups: dict[T, list[Cylinder]] = {}
        for cylinder in self.cylinders:
            groups.setdefault(key(cylinder), []).append(cylinder)
        return {value: tuple(cylinders) for value, cylinders in groups.items()}

    @cached_property
    def has_common_harmonics(self) -> bool:
        """Whether every cylinder pushes with one A_n cos n p: one group, of a centred slider-crank.

        Then geometry and kinematics stand apart: an order is its A_n times a sum over angles, which is
        exact whatever lambda is. Where an angle is a letter, masses may differ: each cylinder's m r over
        that of the first is then a weight of the sum, since no number could hold the letter.
        """
        mechanisms = {group.mechanism for group in self.groups}
        is_one = len(self.groups) == 1 or (self.has_symbols and len(mechanisms) == 1)
        return is_one and _is_centred(self.groups[0].mechanism)

    @cached_property
    def counts_in_orders(self) -> bool:
        """Whether every order is geometry in units of its own F_n = A_n m r omega^2, whatever lambda is.

        So it is where all cylinders have one A_n and every weight above the crank's speed is a share of
        it: one in kg mm needs A_n as a number.
        """
        fast = (s for s in self.balancers.shafts if abs(s.speed) > 1)
        return self.has_common_harmonics and not any(w.in_kg_mm for s in fast for w in s.weights)

    @cached_property
    def rotating_masses(self) -> tuple[RotatingMass, ...]:
        """All that turns and is not balanced by itself, each in the unit of its order."""
        return tuple(rotating_masses(self))

    @property
    def unit_unbalance(self) -> Fraction | None:
        """M r of the first cylinder in kg mm, None where its mass or stroke is not given."""
        mass, radius = self.first.reciprocating_mass, self.first.radius
        return mass * radius if mass and radius else None

    @cached_property
    def rotating_sizes(self) -> tuple[Fraction, ...]:
        """Every cylinder's rotating mass times crank radius over m r of the first; 0 where not given.

        Refused where it is given, and no reciprocating mass to compare it with.
        """
        masses, unit = [c.rotating_mass for c in self.cylinders], self.first.reciprocating_mass
        if not any(masses):
            return tuple(masses)
        if not unit:
            rule = "counts in units of the reciprocating mass"
            raise SymbalanceError("rotating_mass", rule, "give reciprocating_mass, kg, above 0")
        return tuple(m / unit * r for m, r in zip(masses, self.radii, strict=True))

    @property
    def mean_station(self) -> Fraction:
        """The mean of all stations: the default reference plane of couples."""
        return sum((c.station for c in self.cylinders), Fraction(0)) / len(self.cylinders)

    def plane(self, reference: object = None) -> Fraction:
        """Return the station couples are taken about: `reference`, exactly, or the stations' mean."""
        return self.mean_station if reference is None else exact(reference, "reference")

    def lever_arms(self, plane: Fraction | None = None) -> list[Fraction]:
        """Return every cylinder's station from a plane (default: the stations' mean), in pitches."""
        level = self.mean_station if plane is None else plane
        return [c.station - level for c in self.cylinders]

    def firing_order(self) -> list[int] | None:
        """Return the cylinders' numbers as they fire, or None where that is not known."""
        if any(c.fires is None for c in self.cylinders):
            return None
        cycle = 180 * self.strokes
        fired = sorted(((c.fires or 0) % cycle, c.number) for c in self.cylinders)
        return [number for _, number in fired]

    def with_ratio(self, ratio: object) -> Engine:
        """Return the engine with another rod ratio lambda = l/r of the rods that run on crank pins."""
        known = checked_ratio(ratio)
        if len({c.ratio for c in self.cylinders if c.link is None}) > 1:
            rule = f"cannot be set for {self.name}, whose cylinders have ratios of their own"
            raise SymbalanceError(f"ratio = {brief(ratio)}", rule, "give each its stroke and rod")
        changed = [c if c.link else c.with_ratio(known) for c in self.cylinders]
        return unchecked_copy(self, cylinders=joined_cylinders(changed))

    def with_sizes(
        self,
        *,
        stroke: object = None,
        rod: object = None,
        reciprocating_mass: object = None,
        pitch: object = None,
        bore: object = None,
    ) -> Engine:
        """Return the engine with sizes that it lacks, mm and kg, the same for every cylinder.

        A size that some cylinder has already otherwise is refused: which of the two counts would be a
        guess. A rod takes the place of a ratio that is given alone.

        >>> from symbalance.engine.builders import inline
        >>> inline("1-3-4-2").with_sizes(stroke=80, rod=140).ratio
        Fraction(7, 2)
        """
        sizes = {"stroke": stroke, "rod": rod, "reciprocating_mass": reciprocating_mass}
        added: dict[str, Fraction | None] = {
            key: checked_size(key, value) for key, value in sizes.items() if value is not None
        }
        for key, value in added.items():
            has_own = [c for c in self.cylinders if c.link is None or key == "reciprocating_mass"]
            present = [v for c in has_own if (v := getattr(c.sizes, key)) not in (None, value)]
            if present:
                rule = f"is given by the engine already, as {brief(present[0])}"
                raise SymbalanceError(f"{key} = {brief(value)}", rule, "leave it out, or change the file")
        for key, value, known in (("pitch", pitch, self.pitch), ("bore", bore, self.bore)):
            if value is not None and known not in (None, checked_size(key, value)):
                rule = f"is given by the engine already, as {brief(known)}"
                raise SymbalanceError(f"{key} = {brief(value)}", rule, "leave it out, or change the file")
        on_pins = [c for c in self.cylinders if c.link is None]
        if "rod" in added and "stroke" not in added and any(c.sizes.stroke is None for c in on_pins):
            rule = "makes a rod ratio with the stroke only, which is not known"
            raise SymbalanceError(f"rod = {brief(rod)}", rule, "give the stroke too, mm")
        if "rod" in added:
            added["given_ratio"] = None  # as a cylinder's own rod ends the ratio that all share
        of_link_rods = {key: value for key, value in added.items() if key == "reciprocating_mass"}
        with_sizes = [
            unchecked_copy(c, sizes=replace(c.sizes, **(of_link_rods if c.link else added)))
            for c in self.cylinders
        ]
        return Engine(
            with_sizes,
            strokes=self.strokes,
            name=self.name,
            pitch=self.pitch if pitch is None else pitch,
            bore=self.bore if bore is None else bore,
            balancers=self.balancers,
        )

    def balanced_by(self, *added: Counterweight | BalanceShaft) -> Engine:
        """Return the engine with counterweights and balance shafts added to those it has.

        >>> single = Engine([Cylinder(1)]).balanced_by(Counterweight(throw=1, overbalance="1/2"))
        >>> len(single.balancers.counterweights)
        1
        """
        had = self.balancers
        weights = tuple(a for a in added if not isinstance(a, BalanceShaft))
        shafts = tuple(a for a in added if isinstance(a, BalanceShaft))
        balancers = Balancers(had.counterweights + weights, had.shafts + shafts)
        about = {"strokes": self.strokes, "name": self.name, "pitch": self.pitch, "bore": self.bore}
        return Engine(self.cylinders, balancers=balancers, **about)


def checked_engine(value: object, ratio: object = None) -> Engine:
    """Return an engine, with another rod ratio where one is given, or refuse what is none.

    >>> checked_engine("v12-60")  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    symbalance.errors.SymbalanceError: engine = v12-60: must be an Engine; load("v12-60"), or ...
    """
    if not isinstance(value, Engine):
        remedy = 'load("v12-60"), or build one, as inline("1-3-4-2")'
        raise SymbalanceError(f"engine = {brief(value)}", "must be an Engine", remedy)
    return value if ratio is None else value.with_ratio(ratio)


def _is_centred(mechanism: Mechanism | None) -> bool:
    return mechanism is None or mechanism.is_centred


def joined_cylinders(cylinders: Sequence[Cylinder]) -> tuple[Cylinder, ...]:
    """Return the cylinders, those on link rods each with its master's."""
    by_number = {c.number: c for c in cylinders}
    joined = [c.on_master(by_number[c.link.master]) if c.link else c for c in cylinders]
    for cylinder in joined:
        _ = cylinder.mechanism  # refuses what does not reach, or lacks a size that it needs
    return tuple(joined)


def checked_name(name: object) -> str:
    """Return an engine's name, or refuse what would break a table's heading."""
    if isinstance(name, str) and name.isprintable() and name.strip() and len(name) <= LONGEST_NAME:
        return name
    rule = f"must be one line of 1 to {LONGEST_NAME} characters"
    raise SymbalanceError(f"name = {brief(str(name))!r}", rule, "it heads the tables")


def checked_cylinders(cylinders: Iterable[Cylinder]) -> tuple[Cylinder, ...]:
    """Return the cylinders of an engine, or refuse what are none, too many, or of one number."""
    cylinders = tuple(as_list(cylinders, "cylinders"))
    for cylinder in cylinders:
        if not isinstance(cylinder, Cylinder):
            raise SymbalanceError(
                f"cylinders hold {brief(cylinder)}",
                "must be Cylinder values",
                "make each with Cylinder(...)",
            )
    if not 1 <= len(cylinders) <= MOST_CYLINDERS:
        rule = f"an engine has 1 to {MOST_CYLINDERS}"
        raise SymbalanceError(f"{len(cylinders)} cylinders", rule, "list each once")
    numbers: set[int] = set()
    for cylinder in cylinders:
        if cylinder.number in numbers:
            raise SymbalanceError(
                f"number = {cylinder.number}", "names two cylinders", "number each cylinder once"
            )
        numbers.add(cylinder.number)
    return cylinders


def _check_links(cylinders: Sequence[Cylinder]) -> None:
    """Refuse link rods on masters that are not there, are links themselves, or have another pin."""
    by_number = {c.number: c for c in cylinders}
    for cylinder in cylinders:
        if cylinder.link is None:
            continue
        what, master = f"master = {cylinder.link.master}", by_number.get(cylinder.link.master)
        if master is None or master is cylinder:
            raise SymbalanceError(what, "names no other cylinder", "name the cylinder of the master rod")
        if master.link is not None:
            raise SymbalanceError(
                what, "hangs on a link rod itself", "name the cylinder of the master rod"
            )
        if master.throw != cylinder.throw:
            rule = f"has its pin at {master.throw.as_text()}, this cylinder at {cylinder.throw.as_text()}"
            raise SymbalanceError(what, rule, "a link rod shares its master's pin: give both one throw")
        if cylinder.sizes.stroke is not None:
            rule = "is not a link rod's to choose"
            raise SymbalanceError(
                f"stroke = {cylinder.sizes.stroke}", rule, "its master's crank gives it"
            )
        if cylinder.sizes.rod is None:
            raise SymbalanceError(
                f"cylinder {cylinder.number}", "needs rod", "the link rod's own length, mm"
            )


def _check_fires(cylinders: Iterable[Cylinder]) -> None:
    """Refuse firing angles that the throws contradict: all cylinders fire at a top dead centre.

    An offset or a link rod moves that; there `fires` need only say which of them it is.
    """
    fixed: dict[SymbolPart, tuple[Fraction, Cylinder]] = {}
    for cylinder in cylinders:
        if cylinder.fires is None:
            continue
        delay = cylinder.delay
        start = (delay.turns + cylinder.fires / 360) % 1
        first, earlier = fixed.setdefault(delay.symbols, (start, cylinder))
        is_shifted = any(c.offset or c.link for c in (cylinder, earlier))
        half = Fraction(1, 2)
        if abs((start - first + half) % 1 - half) > (NEAR_TOP if is_shifted else 0):
            what = f"throw = {cylinder.throw.as_text()} and fires = {cylinder.fires}"
            nearly = "nearly " if is_shifted else ""
            rule = f"contradict cylinder {earlier.number}'s: throw - bank + fires must be "
            rule += f"{nearly}the same"
            rule += ", modulo 360"
            at_top = (first - delay.turns) % 1 * 360
            raise SymbalanceError(what, rule, f"it is at top dead centre at fires = {at_top}")


def checked_strokes(strokes: object) -> int:
    """Return 2 or 4, or refuse."""
    if isinstance(strokes, bool) or strokes not in (2, 4) or not isinstance(strokes, int):
        what = f"strokes = {literal(strokes)}"
        raise SymbalanceError(what, "must be 2 or 4", "a number, without quotes")
    return strokes
