"""A layout: the cylinders of an engine together, and what they share."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import lcm

from symbalance.engine.balancers import (
    Balancers,
    BalanceShaft,
    Counterweight,
    check_shares,
    checked_balancers,
)
from symbalance.engine.cylinders import MOST_CYLINDERS, Cylinder
from symbalance.engine.trains import CrankTrain
from symbalance.errors import SymbalanceError, shown, written
from symbalance.exact.angles import SymbolPart
from symbalance.exact.phasor import checked_modulus
from symbalance.kinematics.slider_crank import checked_ratio
from symbalance.text.numbers import listed

LONGEST_NAME = 60
NEAR_TOP = Fraction(1, 8)
"""Turns by which an offset or a link rod may move a top dead centre."""


@dataclass(frozen=True, init=False)
class Layout:
    """The cylinders of an engine, with its name, its strokes per cycle and its rod ratio if known.

    >>> twin = Layout([Cylinder(1, throw=0, station="1/2"), Cylinder(2, throw=180, station="-1/2")])
    >>> len(twin.cylinders), twin.strokes, twin.ratio
    (2, 4, None)
    """

    cylinders: tuple[Cylinder, ...]
    strokes: int
    name: str
    ratio: Fraction | None
    crank_train: CrankTrain
    balancers: Balancers

    def __init__(
        self,
        cylinders: Iterable[Cylinder],
        *,
        strokes: int = 4,
        name: str = "engine",
        ratio: object = None,
        crank_train: CrankTrain | None = None,
        balancers: Balancers | None = None,
    ) -> None:
        set_field = object.__setattr__
        train = _checked_train(crank_train)
        set_field(self, "cylinders", _checked_cylinders(cylinders))
        _check_links(self.cylinders)
        set_field(self, "strokes", checked_strokes(strokes))
        set_field(self, "name", checked_name(name))
        _check_fires(self.cylinders, bool(train.offset))
        known = train.ratio if ratio is None else ratio
        set_field(self, "ratio", None if known is None else checked_ratio(known))
        set_field(self, "crank_train", train)
        for cylinder in self.cylinders:
            check_link_mass(cylinder, train)
        set_field(self, "balancers", checked_balancers(balancers, self.cylinders))
        if self.balancers.shafts and self.is_uniform:
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
    def link_pins(self) -> list[int]:
        """The numbers of the cylinders whose rods hang on a link pin away from the crank pin."""
        return [c.number for c in self.cylinders if c.link and c.link.radius]

    def stroke_of(self, cylinder: Cylinder) -> Fraction | None:
        """Return twice the crank radius that moves a cylinder, in mm: a link rod's is its master's."""
        number = cylinder.link.master if cylinder.link else cylinder.number
        return self.train_of(next(c for c in self.cylinders if c.number == number)).stroke

    def train_of(self, cylinder: Cylinder) -> CrankTrain:
        """Return a cylinder's sizes: the engine's, with its own put in, and the engine's ratio."""
        shared = self.crank_train
        if shared.ratio != self.ratio:
            shared = CrankTrain(**{**vars(shared), "given_ratio": self.ratio})
        return shared.overridden(cylinder.own)

    @cached_property
    def is_uniform(self) -> bool:
        """Whether all cylinders are alike, centred, and joined to the crank by rods of their own."""
        trains = [self.train_of(c) for c in self.cylinders]
        alike = {(t.ratio, t.stroke, t.reciprocating_mass) for t in trains}
        return (
            len(alike) == 1
            and not any(t.offset for t in trains)
            and not any(c.link for c in self.cylinders)
        )

    @cached_property
    def is_geometric(self) -> bool:
        """Whether forces are geometry in units of A_n m r omega^2: no order needs its A_n to be known.

        So it is where cylinders are alike and every balance shaft above the crank's speed has shares.
        """
        fast = (s for s in self.balancers.shafts if abs(s.speed) > 1)
        return self.is_uniform and not any(w.in_kg_mm for s in fast for w in s.weights)

    @property
    def mean_station(self) -> Fraction:
        """The mean of all stations: the default reference plane of couples."""
        return sum((c.station for c in self.cylinders), Fraction(0)) / len(self.cylinders)

    def firing_order(self) -> list[int] | None:
        """Return the cylinders' numbers as they fire, or None where that is not known."""
        if any(c.fires is None for c in self.cylinders):
            return None
        cycle = 180 * self.strokes
        fired = sorted(((c.fires or 0) % cycle, c.number) for c in self.cylinders)
        return [number for _, number in fired]

    def with_ratio(self, ratio: object) -> Layout:
        """Return the layout with another rod ratio lambda = l/r."""
        return Layout(
            self.cylinders,
            strokes=self.strokes,
            name=self.name,
            ratio=ratio,
            crank_train=self.crank_train,
            balancers=self.balancers,
        )

    def balanced_by(self, *added: Counterweight | BalanceShaft) -> Layout:
        """Return the layout with counterweights and balance shafts added to those it has.

        >>> single = Layout([Cylinder(1)]).balanced_by(Counterweight(throw=1, overbalance="1/2"))
        >>> len(single.balancers.counterweights)
        1
        """
        had = self.balancers
        weights = tuple(a for a in added if not isinstance(a, BalanceShaft))
        shafts = tuple(a for a in added if isinstance(a, BalanceShaft))
        return Layout(
            self.cylinders,
            strokes=self.strokes,
            name=self.name,
            ratio=self.ratio,
            crank_train=self.crank_train,
            balancers=Balancers(had.counterweights + weights, had.shafts + shafts),
        )


def checked_name(name: object) -> str:
    """Return an engine's name, or refuse what would break a table's heading."""
    text = str(name)
    if not text.isprintable() or not 1 <= len(text.strip()) <= len(text) <= LONGEST_NAME:
        rule = f"must be one line of 1 to {LONGEST_NAME} characters"
        raise SymbalanceError(f"name = {shown(text)!r}", rule, "it heads the tables")
    return text


def _checked_train(train: object) -> CrankTrain:
    if train is not None and not isinstance(train, CrankTrain):
        rule = "must be a CrankTrain"
        raise SymbalanceError(f"crank_train = {shown(train)}", rule, "make it with CrankTrain(...)")
    return train or CrankTrain()


def _checked_cylinders(cylinders: Iterable[Cylinder]) -> tuple[Cylinder, ...]:
    cylinders = tuple(listed(cylinders, "cylinders"))
    for cylinder in cylinders:
        if not isinstance(cylinder, Cylinder):
            raise SymbalanceError(
                f"cylinders hold {shown(cylinder)}",
                "must be Cylinder values",
                "make each with Cylinder(...)",
            )
    if not 1 <= len(cylinders) <= MOST_CYLINDERS:
        rule = f"an engine has 1 to {MOST_CYLINDERS}"
        raise SymbalanceError(f"{len(cylinders)} cylinders", rule, "list each once")
    seen: set[int] = set()
    for cylinder in cylinders:
        if cylinder.number in seen:
            raise SymbalanceError(
                f"number = {cylinder.number}", "names two cylinders", "number each cylinder once"
            )
        seen.add(cylinder.number)
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
        if cylinder.own.stroke is not None:
            rule = "is not a link rod's to choose"
            raise SymbalanceError(f"stroke = {cylinder.own.stroke}", rule, "its master's crank gives it")
        if cylinder.own.rod is None:
            raise SymbalanceError(
                f"cylinder {cylinder.number}", "needs rod", "the link rod's own length, mm"
            )


def check_link_mass(cylinder: Cylinder, train: CrankTrain) -> None:
    """Refuse a rotating mass, its own or of the engine's sizes, of a rod that hangs on a link pin.

    It would sit on that pin, which moves with the master rod and not on a circle: its force turns
    neither steadily nor at the crank's speed alone. Link pins on the crank pin's axis (radius 0) do.
    """
    mass = train.overridden(cylinder.own).rotating_mass
    if cylinder.link is None or not cylinder.link.radius or not mass:
        return
    rule = f"of cylinder {cylinder.number} would sit on its link pin, and what that adds is not computed"
    remedy = "write rotating_mass = 0 for each link rod, and count those masses apart"
    raise SymbalanceError(f"rotating_mass = {shown(mass)}", rule, remedy)


def _check_fires(cylinders: Iterable[Cylinder], offset: bool) -> None:
    """Refuse firing angles that the throws contradict: all cylinders fire at a top dead centre.

    An offset or a link rod moves that; there `fires` need only say which of them it is.
    """
    fixed: dict[SymbolPart, tuple[Fraction, Cylinder]] = {}
    for cylinder in cylinders:
        if cylinder.fires is None:
            continue
        own = cylinder.delay
        start = (own.turns + cylinder.fires / 360) % 1
        first, other = fixed.setdefault(own.symbols, (start, cylinder))
        moved = offset or any(c.own.offset or c.link for c in (cylinder, other))
        half = Fraction(1, 2)
        if abs((start - first + half) % 1 - half) > (NEAR_TOP if moved else 0):
            what = f"throw = {cylinder.throw.as_text()} and fires = {cylinder.fires}"
            nearly = "nearly " if moved else ""
            rule = f"contradict cylinder {other.number}'s: throw - bank + fires must be {nearly}the same"
            rule += ", modulo 360"
            at_top = (first - own.turns) % 1 * 360
            raise SymbalanceError(what, rule, f"it is at top dead centre at fires = {at_top}")


def checked_strokes(strokes: object) -> int:
    """Return 2 or 4, or refuse."""
    if isinstance(strokes, bool) or strokes not in (2, 4) or not isinstance(strokes, int):
        what = f"strokes = {written(strokes)}"
        raise SymbalanceError(what, "must be 2 or 4", "a number, without quotes")
    return strokes
