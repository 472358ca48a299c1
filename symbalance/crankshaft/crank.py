"""A crankshaft's geometry: a chain of journals, webs and pins from the front to the rear. SI units.

The chain is the whole truth: journal, web, pin, web, journal for a throw between bearings; web, pin, web,
pin, web without a bearing between; two pins with a thin web between for a split pin. Pins' angles are
those of the layout's throws at theta = 0.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from symbalance.errors import SymbalanceError, shown


@dataclass(frozen=True)
class Material:
    """Young's modulus in Pa, Poisson's ratio, density in kg/m^3; forged steel by default."""

    young: float = 206e9
    poisson: float = 0.29
    density: float = 7850.0

    @property
    def shear(self) -> float:
        """The shear modulus E/(2 (1 + nu)), in Pa."""
        return self.young / (2 * (1 + self.poisson))


@dataclass(frozen=True)
class Journal:
    """A main journal: diameter, length, bore, `fillet` radius at its webs (m); with a bearing or not."""

    diameter: float
    length: float
    bore: float = 0.0
    fillet: float = 0.0
    bearing: bool = True


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


@dataclass(frozen=True)
class Counterweight:
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


@dataclass(frozen=True)
class Web:
    """A crank web: a slab `thickness` along W and `width` across, rounded at both ends.

    It reaches `tip` beyond the pin's axis and `heel` beyond the journal's axis, away from the pin.
    """

    thickness: float
    width: float
    tip: float
    heel: float
    counterweight: Counterweight | None = None


@dataclass(frozen=True)
class Disc:
    """A rigid body at an end of the crank: mass, moments of inertia, distance from the end of the crank.

    `polar` about W and `diametral` about a line across it, through its centre of gravity, in kg m^2.
    """

    mass: float
    polar: float
    diametral: float
    distance: float = 0.0
    diameter: float = 0.0
    """The diameter of the shaft that carries it; 0: the end journal's."""


Part = Journal | Web | Pin


@dataclass(frozen=True)
class Crank:
    """A crankshaft: `parts` front to rear, material, what sits at its ends."""

    parts: tuple[Part, ...]
    material: Material = Material()
    pulley: Disc | None = None
    flywheel: Disc | None = None

    def __post_init__(self) -> None:
        _check_chain(self.parts)

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
                what = f"{type(part).__name__.lower()} {name} = {shown(value)}"
                raise SymbalanceError(what, "must be positive", "in m here, mm in files")
