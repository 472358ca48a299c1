"""Stroke, rod, masses and offset of a cylinder's moving parts, shared by all cylinders or its own."""

from __future__ import annotations

from dataclasses import dataclass, fields
from fractions import Fraction

from symbalance.errors import SymbalanceError, brief
from symbalance.exact.angles import degrees
from symbalance.kinematics.mechanisms import RodSplit
from symbalance.text.numbers import checked_whole, exact

MASSES = ("reciprocating_mass", "rotating_mass")
ROD = ("rod_mass", "rod_centre", "rod_inertia")
"""The keys of a rod's own inertia: kg, mm from the big end, kg mm^2 about the centre of gravity."""
CYLINDER_SIZES = ("stroke", "rod", *MASSES, "offset", *ROD)
"""Sizes a cylinder may have of its own."""


@dataclass(frozen=True)
class CrankTrain:
    """Bore, stroke, rod, offset and masses of a cylinder, mm and kg; None where not given.

    A Fraction is taken as it is, another number or text is read as one; what is no size is refused.

    `offset` (désaxé) is how far the cylinder's axis passes the crank, towards the side the pin moves to
    after top dead centre. The rod's own mass, centre of gravity and moment of inertia give its couple
    alone (`rod_split`): what it adds to the reciprocating and the rotating mass is counted there already.
    """

    stroke: Fraction | None = None
    rod: Fraction | None = None
    pitch: Fraction | None = None
    bore: Fraction | None = None
    reciprocating_mass: Fraction | None = None
    rotating_mass: Fraction | None = None
    given_ratio: Fraction | None = None
    offset: Fraction | None = None
    rod_mass: Fraction | None = None
    rod_centre: Fraction | None = None
    rod_inertia: Fraction | None = None

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if value is not None and not isinstance(value, Fraction):
                object.__setattr__(self, field.name, checked_size(field.name, value))

    @property
    def ratio(self) -> Fraction | None:
        """The rod ratio lambda = l/r = 2 rod/stroke, or None where it is not known."""
        if self.given_ratio is not None:
            return self.given_ratio
        if self.rod is None or self.stroke is None:
            return None
        return 2 * self.rod / self.stroke

    @property
    def offset_ratio(self) -> Fraction:
        """The offset over the crank radius, e/r; refused where the stroke is not known."""
        if not self.offset:
            return Fraction(0)
        if self.stroke is None:
            what = f"offset = {brief(self.offset)}"
            raise SymbalanceError(
                what, "needs the stroke", "give stroke = ..., in mm: e/r = 2 offset/stroke"
            )
        return 2 * self.offset / self.stroke

    @property
    def rod_split(self) -> RodSplit | None:
        """The rod as two masses and a couple, kg and mm; None where its inertia is not given."""
        sizes = {key: getattr(self, key) for key in ROD}
        missing = [key for key, value in sizes.items() if value is None]
        if len(missing) == len(ROD):
            return None
        if missing:
            rule = f"belong together: {missing[0]} is missing"
            raise SymbalanceError(", ".join(k for k in ROD if k not in missing), rule, "give all three")
        if self.rod is None:
            raise SymbalanceError("rod_mass", "needs the rod's length", "give rod = ..., in mm")
        if sizes["rod_centre"] > self.rod:
            what = f"rod_centre = {brief(sizes['rod_centre'])}"
            rule = f"must lie between the rod's ends, within 0 and {brief(self.rod)}"
            raise SymbalanceError(what, rule, "count mm from the big end")
        return RodSplit(sizes["rod_mass"], self.rod, sizes["rod_centre"], sizes["rod_inertia"])

    def overridden(self, overrides: CrankTrain) -> CrankTrain:
        """Return these sizes with those of `overrides` put in; its rod or stroke ends a given ratio."""
        values = {f.name: getattr(self, f.name) for f in fields(self)}
        present = {f.name: v for f in fields(overrides) if (v := getattr(overrides, f.name)) is not None}
        if "stroke" in present or "rod" in present:
            values["given_ratio"] = None
        return CrankTrain(**{**values, **present})


@dataclass(frozen=True, init=False)
class Link:
    """Where a link rod is attached to its master rod.

    `master` is that cylinder's number, `angle` the link pin's direction from the master rod (from the
    crank pin towards the master piston) in the sense of rotation, in turns, `radius` its distance from
    the crank pin in mm.
    """

    master: int
    angle: Fraction
    radius: Fraction

    def __init__(self, master: object, angle: object = 0, radius: object = 0) -> None:
        set_field = object.__setattr__
        set_field(self, "master", checked_whole(master, "master", 1, 1000, "name the master's cylinder"))
        direction = degrees(angle, "link_angle")
        if direction.symbols:
            raise SymbalanceError(f"link_angle = {brief(angle)}", "must be a number", "degrees")
        set_field(self, "angle", direction.normalized().turns)
        set_field(self, "radius", checked_size("link_radius", radius))


def checked_size(key: str, value: object) -> Fraction:
    """Return a size in mm or kg, exactly, or refuse what cannot be one."""
    number = exact(value, key)
    if key == "offset":
        return number
    if number < 0 or (not number and key not in (*MASSES, *ROD, "link_radius")):
        raise SymbalanceError(f"{key} = {brief(value)}", "must be positive", "sizes are in mm and kg")
    return number


def check_reach(train: CrankTrain) -> None:
    """Refuse an offset at which the crank cannot turn, in the units of the file."""
    if train.offset and train.rod is not None and train.stroke is not None:
        most = train.rod - train.stroke / 2
        if most > 0 and abs(train.offset) >= most:
            rule = f"must lie within {float(-most):.12g} and {float(most):.12g} mm (rod - stroke/2)"
            remedy = "nearer the crank's axis, or a longer rod: the crank could not turn"
            raise SymbalanceError(f"offset = {float(train.offset):.12g}", rule, remedy)


def checked_sizes(sizes: dict[str, object]) -> CrankTrain:
    """Return the sizes a cylinder has of its own, from those given (None is not given)."""
    return CrankTrain(**{k: checked_size(k, v) for k, v in sizes.items() if v is not None})
