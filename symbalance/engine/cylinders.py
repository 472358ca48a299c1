"""The class `Cylinder`: its number, station, axis, crank pin, firing angle and sizes.

Angles are positive in the sense of rotation, from straight up, the engine seen from the front turning
clockwise. A cylinder's own crank angle is theta + throw - bank: top dead centre where that is 0.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, TypeVar

from symbalance.engine.crank_train import CYLINDER_SIZES, CrankTrain, Link, check_reach, checked_sizes
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.angles import Angle, angle, degrees
from symbalance.kinematics.mechanisms import LinkRod, Mechanism, RodSplit, SliderCrank
from symbalance.text.numbers import checked_whole, exact

if TYPE_CHECKING:
    from _typeshed import DataclassInstance

Frozen = TypeVar("Frozen", bound="DataclassInstance")
NONE = CrankTrain()
"""No size of one's own."""
CRANKS = 1
"""Cranks of one engine: several, geared together, would each have a speed of their own."""
MOST_CYLINDERS = 1000
LONGEST_STATION = 10_000


def unchecked_copy(value: Frozen, **changes: object) -> Frozen:
    """Return a copy of a frozen dataclass with other fields, which the caller has checked.

    The constructors of `Cylinder` and `Engine` take what a person writes, not their fields, so that
    `dataclasses.replace` is not for them. Cached properties, which depend on the fields, are not copied.
    """
    copy = object.__new__(type(value))
    for field in fields(value):
        object.__setattr__(copy, field.name, changes.pop(field.name, getattr(value, field.name)))
    assert not changes, f"no fields: {', '.join(changes)}"
    return copy


@dataclass(frozen=True, init=False)
class Cylinder:
    """A cylinder: its number, station, bank angle, crank throw, firing angle and sizes.

    `throw` is its crank pin's angle at theta = 0 and `bank` its axis' angle, degrees if numbers or
    text, the angle itself if a SymPy expression. `station` is its place along the crank, in cylinder
    pitches, positive towards the front. `fires` is its firing angle in degrees after cylinder 1's
    firing top dead centre, or None if that is not known. Its sizes (stroke, rod, reciprocating_mass,
    rotating_mass, offset, ...; mm and kg) are keywords of these names, held in `sizes`. `link` hangs its
    rod on another cylinder's, `rod` then being the link rod's own length; `master` is that cylinder,
    known once both are in an `Engine`. `crank` numbers the crank it works on: an engine has one.

    >>> Cylinder(1, throw="360/7", station="5/2")
    Cylinder(1, throw='360/7', bank='0', station='5/2')
    """

    number: int
    throw: Angle
    bank: Angle
    station: Fraction
    fires: Fraction | None
    sizes: CrankTrain
    link: Link | None
    crank: int
    master: Cylinder | None

    def __init__(
        self,
        number: int,
        throw: object = 0,
        bank: object = 0,
        station: object = 0,
        fires: object = None,
        *,
        link: Link | None = None,
        crank: object = 1,
        **sizes: object,
    ) -> None:
        set_field = object.__setattr__
        set_field(
            self, "number", checked_whole(number, "number", 1, MOST_CYLINDERS, "count from the front")
        )
        set_field(self, "throw", angle(throw, "throw").normalized())
        set_field(self, "bank", checked_bank(bank))
        set_field(self, "station", _checked_station(station))
        set_field(self, "fires", None if fires is None else _checked_fires(fires))
        unknown = [key for key in sizes if key not in CYLINDER_SIZES]
        if unknown:
            raise TypeError(
                f"Cylinder has no {unknown[0]!r}; its own sizes are {', '.join(CYLINDER_SIZES)}"
            )
        set_field(self, "sizes", checked_sizes(sizes))
        if link is not None and not isinstance(link, Link):
            what = f"link of type {type(link).__name__}"
            raise SymbalanceError(what, "must be a Link", "make it with Link(master, angle, radius)")
        set_field(self, "link", link)
        set_field(self, "crank", checked_whole(crank, "crank", 1, CRANKS, "an engine has one crank"))
        set_field(self, "master", None)

    def __repr__(self) -> str:
        parts = f"throw={self.throw.as_text()!r}, bank={self.bank.as_text()!r}"
        fires = "" if self.fires is None else f", fires='{self.fires}'"
        return f"Cylinder({self.number}, {parts}, station='{self.station}'{fires})"

    @cached_property
    def delay(self) -> Angle:
        """How far its pin leads its axis at theta = 0: throw - bank."""
        return (self.throw - self.bank).normalized()

    @cached_property
    def mechanism(self) -> Mechanism | None:
        """What joins its piston to the crank, lengths over the crank radius; None if only centred.

        A centred cylinder of unknown rod ratio has none: its harmonics are series in 1/lambda. Refused
        where an offset or a link rod lacks a length it needs, or a rod does not reach.

        >>> Cylinder(1, stroke=80, rod=150, offset=4).mechanism
        SliderCrank(ratio=Fraction(15, 4), offset=Fraction(1, 10))
        """
        if self.link is not None:
            return _link_rod(self, self.link)
        if self.offset:
            check_reach(self.sizes)
            offset = self.sizes.offset_ratio
            return SliderCrank(_needed_ratio(self), offset)
        return None if self.ratio is None else _centred(self.ratio)

    @property
    def known_mechanism(self) -> Mechanism:
        """Its mechanism, refused where no rod ratio is known.

        >>> Cylinder(1, stroke=80, rod=150).known_mechanism
        SliderCrank(ratio=Fraction(15, 4), offset=Fraction(0, 1))
        """
        return self.mechanism or SliderCrank(_needed_ratio(self))

    @property
    def ratio(self) -> Fraction | None:
        """The rod ratio lambda = l/r, None where it is not known."""
        if self.master is None:
            return self.sizes.ratio
        stroke = self.stroke
        return 2 * self.sizes.rod / stroke if stroke and self.sizes.rod else None

    @property
    def stroke(self) -> Fraction | None:
        """Twice the crank radius that moves it, mm: a link rod's is its master's; None if not known."""
        return self.sizes.stroke if self.master is None else self.master.stroke

    @property
    def radius(self) -> Fraction | None:
        """The crank radius that moves it, in mm, None where it is not known."""
        return None if self.stroke is None else self.stroke / 2

    @property
    def offset(self) -> Fraction:
        """How far its axis passes the crank, mm, towards the side the pin moves to after the top."""
        return self.sizes.offset or Fraction(0)

    @property
    def reciprocating_mass(self) -> Fraction | None:
        """What goes up and down, in kg, None where it is not known."""
        return self.sizes.reciprocating_mass

    @property
    def rotating_mass(self) -> Fraction:
        """What its rod adds at the crank pin, or at its link pin, in kg; 0 where not given."""
        return self.sizes.rotating_mass or Fraction(0)

    @property
    def rod_split(self) -> RodSplit | None:
        """Its rod as two masses and a couple, kg and mm; None where the inertia is not given."""
        return self.sizes.rod_split

    @property
    def excess(self) -> Fraction:
        """The moment of inertia J_x in kg mm^2 that its rod's two masses lack; 0 where not given."""
        split = self.rod_split
        return split.excess if split else Fraction(0)

    def with_ratio(self, ratio: Fraction) -> Cylinder:
        """Return the cylinder with another rod ratio; its other sizes stay as they are."""
        return unchecked_copy(self, sizes=replace(self.sizes, given_ratio=ratio))

    def on_master(self, master: Cylinder) -> Cylinder:
        """Return the cylinder of a link rod with the cylinder that its rod hangs on."""
        return unchecked_copy(self, master=master)

    def with_shared(self, shared: CrankTrain) -> Cylinder:
        """Return the cylinder with sizes that all cylinders share, where it has none of its own.

        Of those a link rod takes no stroke, rod and ratio: they are its master's.
        """
        if self.link is not None:
            shared = replace(shared, stroke=None, rod=None, given_ratio=None)
        return unchecked_copy(self, sizes=shared if self.sizes == NONE else shared.overridden(self.sizes))


_centred = lru_cache(maxsize=256)(SliderCrank)
"""The one mechanism of all centred cylinders of a ratio, which is checked once."""


def _needed_ratio(cylinder: Cylinder) -> Fraction:
    if cylinder.ratio is None:
        what, remedy = f"cylinder {cylinder.number}", "give stroke and rod in mm, or ratio"
        raise SymbalanceError(what, "has no rod ratio, and the engine's cylinders are not alike", remedy)
    return cylinder.ratio


def _link_rod(cylinder: Cylinder, link: Link) -> LinkRod:
    master = cylinder.master
    if master is None:
        rule = f"hangs on cylinder {link.master}, which is not known here"
        raise SymbalanceError(f"cylinder {cylinder.number}", rule, "put both into an Engine")
    radius, rod = master.radius, cylinder.sizes.rod
    if radius is None or rod is None:
        what = f"cylinder {cylinder.number}"
        raise SymbalanceError(
            what, "hangs on a rod of unknown size", "give stroke and rod in [crank_train]"
        )
    between = cylinder.bank - master.bank
    if between.symbols:
        rule = "hangs on a link rod, and its bank from the master's is a symbol"
        raise SymbalanceError(f"cylinder {cylinder.number}", rule, "give the banks in numbers")
    first = SliderCrank(_needed_ratio(master), master.sizes.offset_ratio)
    lengths = link.radius / radius, rod / radius
    return LinkRod(first, link.angle, *lengths, between.turns, cylinder.offset / radius)


def _checked_fires(fires: object) -> Fraction:
    value = degrees(fires, "fires").in_degrees()
    if not 0 <= value < 720:
        what = f"fires = {brief(fires)}"
        raise SymbalanceError(what, "must lie in [0, 720)", "degrees after cylinder 1's firing")
    return value


def checked_bank(bank: object, name: str = "bank") -> Angle:
    """Return a bank's angle from vertical; a number is taken modulo 360, to (-180, 180].

    >>> checked_bank(270) == checked_bank(-90)
    True
    """
    result = angle(bank, name)
    return result if result.symbols else result.normalized()


def _checked_station(station: object) -> Fraction:
    value = exact(station, "station")
    if abs(value) > LONGEST_STATION:
        raise SymbalanceError(
            f"station = {brief(station)}",
            f"must lie within {-LONGEST_STATION} and {LONGEST_STATION}",
            "give cylinder pitches, not millimetres",
        )
    return value
