"""A crankshaft's geometry: a chain of journals, webs and pins from the front to the rear. SI units.

The chain is the whole truth: journal, web, pin, web, journal for a throw between bearings; web, pin, web,
pin, web without a bearing between; two pins with a thin web between for a split pin. Pins' angles are
those of the engine's throws at theta = 0.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from symbalance.crankshaft.arguments import check_fields, check_kind, check_number
from symbalance.crankshaft.rotor.parts import STEEL, Disc, Material
from symbalance.errors import SymbalanceError, brief
from symbalance.text.numbers import as_list, whole

ROUND = tuple((name, "m") for name in ("diameter", "length", "bore", "fillet"))


@dataclass(frozen=True)
class Journal:
    """A main journal: diameter, length, bore, `fillet` radius at its webs (m); with a bearing or not."""

    diameter: float
    length: float
    bore: float = 0.0
    fillet: float = 0.0
    bearing: bool = True

    def __post_init__(self) -> None:
        check_fields(self, "journal", ROUND)
        check_kind(self.bearing, bool, "journal bearing", "True, or False for a journal without one")


@dataclass(frozen=True)
class Pin:
    """A crank pin at `angle` (radians from U towards V) and `radius` m, and its cylinders' numbers."""

    diameter: float
    length: float
    radius: float
    angle: float
    cylinders: tuple[int, ...]
    bore: float = 0.0
    fillet: float = 0.0

    def __post_init__(self) -> None:
        check_fields(self, "pin", (*ROUND, ("radius", "m from the crank's axis")))
        check_number(self.angle, "pin angle", "radians from U towards V", signed=True)
        numbers = as_list(self.cylinders, "pin cylinders", "(1,), the numbers of its cylinders")
        if None in map(whole, numbers):
            what, rule = f"pin cylinders = {brief(numbers)}", "must be whole numbers"
            raise SymbalanceError(what, rule, "the numbers of its cylinders, as in (1, 2)")
        object.__setattr__(self, "cylinders", tuple(numbers))


@dataclass(frozen=True)
class WebCounterweight:
    """A web's counterweight: mass in kg, its centre `radius` m from the axis at `angle` radians from U.

    `inertia` is its moment of inertia about the line parallel to W through its centre, kg m^2.
    `outer` (m) and `half_angle` (radians) describe the ring sector a solid model draws, if it draws one.
    """

    mass: float
    radius: float
    angle: float
    inertia: float = 0.0
    outer: float = 0.0
    half_angle: float = 0.0

    def __post_init__(self) -> None:
        units = {"mass": "kg", "radius": "m", "inertia": "kg m^2", "outer": "m", "half_angle": "radians"}
        check_fields(self, "counterweight", units.items())
        check_number(self.angle, "counterweight angle", "radians from U", signed=True)


@dataclass(frozen=True)
class Web:
    """A crank web: a slab `thickness` along W and `width` across, rounded at both ends.

    It reaches `tip` beyond the pin's axis and `heel` beyond the journal's axis, away from the pin.
    """

    thickness: float
    width: float
    tip: float
    heel: float
    counterweight: WebCounterweight | None = None

    def __post_init__(self) -> None:
        check_fields(self, "web", ((name, "m") for name in ("thickness", "width", "tip", "heel")))
        if self.counterweight is not None:
            remedy = (
                "a web's own is sb.crankshaft.WebCounterweight(mass, radius, angle): kg, m, radians; "
                "sb.Counterweight is an engine's, in shares of its crank train"
            )
            check_kind(self.counterweight, WebCounterweight, "web counterweight", remedy)


Part = Journal | Web | Pin


@dataclass(frozen=True)
class Crank:
    """A crankshaft: `parts` front to rear, material, what sits at its ends."""

    parts: tuple[Part, ...]
    material: Material = STEEL
    pulley: Disc | None = None
    flywheel: Disc | None = None

    def __post_init__(self) -> None:
        parts = tuple(as_list(self.parts, "parts", "(journal, web, pin, web, journal)"))
        for number, part in enumerate(parts, 1):
            if not isinstance(part, Journal | Web | Pin):
                what = f"crank part {number} of type {type(part).__name__}"
                raise SymbalanceError(what, "must be a Journal, Web or Pin", "front to rear")
        object.__setattr__(self, "parts", parts)
        check_kind(
            self.material, Material, "crank material", "sb.crankshaft.Material(young, poisson, density)"
        )
        for name in ("pulley", "flywheel"):
            if getattr(self, name) is not None:
                check_kind(
                    getattr(self, name), Disc, name, "sb.crankshaft.Disc(mass, polar, diametral), or None"
                )
        _check_chain(parts)

    def stations(self) -> Iterator[tuple[Part, float, float]]:
        """Yield each part with the W of its front and rear end, the first part's front end at 0."""
        end = 0.0
        for part in self.parts:
            start, end = end, end + (part.thickness if isinstance(part, Web) else part.length)
            yield part, start, end

    @property
    def length(self) -> float:
        """The length of the chain."""
        return sum(p.thickness if isinstance(p, Web) else p.length for p in self.parts)

    @property
    def pins(self) -> tuple[Pin, ...]:
        """The pins, front to rear."""
        return tuple(p for p in self.parts if isinstance(p, Pin))


def _check_chain(parts: Sequence[Part]) -> None:
    if len(parts) < 3 or not isinstance(parts[0], Journal) or not isinstance(parts[-1], Journal):
        rule = "must begin and end with a journal"
        raise SymbalanceError(f"{len(parts)} crank parts", rule, "journal, web, pin, web, journal, …")
    for before, after in pairwise(parts):
        if isinstance(before, Web) == isinstance(after, Web) and not (
            isinstance(before, Pin) and isinstance(after, Pin)
        ):
            what = f"{type(before).__name__} beside {type(after).__name__}"
            raise SymbalanceError(what, "must have a web between", "journal, web, pin, web, journal, …")
    for part in parts:
        sizes = {k: v for k, v in vars(part).items() if k in ("diameter", "length", "thickness", "width")}
        for name, value in sizes.items():
            if not value > 0:
                what = f"{type(part).__name__.lower()} {name} = {brief(value)}"
                raise SymbalanceError(what, "must be positive", "in m here, mm in files")
