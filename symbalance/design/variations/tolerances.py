"""Tolerances as drawings state them (kg, mm, degrees, percent), and relative to an engine's sizes."""

from __future__ import annotations

from dataclasses import dataclass, fields
from fractions import Fraction
from math import pi

from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError, brief
from symbalance.text.numbers import exact

UNITS = {
    "mass": "kg",
    "throw": "degrees",
    "bank": "degrees",
    "station": "mm",
    "stroke": "mm",
    "rod": "mm",
    "offset": "mm",
    "rotating": "kg",
}
PARTS_OF = {"mass": "m", "rotating": "m", "station": "a"}
"""Tolerances that may be percentages, and of what."""
WIDEST_ANGLE = 45
"""Degrees, plus or minus, that a throw or a bank may have."""


@dataclass(frozen=True, init=False)
class Tolerances:
    """Tolerances (plus or minus) of every cylinder, in kg, degrees and mm; 0 where none is given.

    Keywords: `mass` the reciprocating and `rotating` the rotating mass, `throw` the crank pin's angle,
    `bank` the axis' angle, `station` its place along the crank, `stroke`, `rod` its length, `offset` of
    the axis from the crank. `mass` and `rotating` may be percent of cylinder 1's reciprocating mass
    ("0.5%"), `station` percent of the pitch.

    >>> Tolerances(mass=0.002, throw="0.1").mass
    Fraction(1, 500)
    """

    mass: Fraction | str
    throw: Fraction
    bank: Fraction
    station: Fraction | str
    stroke: Fraction
    rod: Fraction
    offset: Fraction
    rotating: Fraction | str

    def __init__(self, **tolerances: object) -> None:
        for name in tolerances:
            if name not in UNITS:
                raise TypeError(f"Tolerances has no {name!r}; it has {', '.join(UNITS)}")
        for name in UNITS:
            object.__setattr__(self, name, _checked(name, tolerances.get(name, 0)))

    def relative(self, engine: Engine) -> RelativeTolerances:
        """Return them in the units of `sensitivities`, for an engine that has the sizes they need."""
        mass, radius, pitch = engine.first.reciprocating_mass, engine.first.radius, engine.pitch
        units = {"m": (mass, "reciprocating_mass"), "a": (pitch, "pitch"), "r": (radius, "stroke")}
        angles = {"throw": self.throw, "bank": self.bank}
        sizes: dict[str, Fraction | float] = {k: float(v) * pi / 180 for k, v in angles.items()}
        for name in (f.name for f in fields(RelativeTolerances) if f.name not in angles):
            unit, key = units[PARTS_OF.get(name, "r")]
            sizes[name] = _over(name, getattr(self, name), unit, key)
        return RelativeTolerances(**{**sizes, "stroke": Fraction(sizes["stroke"]) / 2})  # type: ignore[arg-type]


def _checked(name: str, value: object) -> Fraction | str:
    percent = isinstance(value, str) and value.strip().endswith("%")
    number = exact(str(value).strip().removesuffix("%") if percent else value, name)
    if number < 0:
        raise SymbalanceError(f"{name} = {brief(value)}", "must not be negative", "it is plus or minus")
    if percent:
        if name not in PARTS_OF:
            raise SymbalanceError(f"{name} = {brief(value)}", "is no percentage", f"give {UNITS[name]}")
        return f"{number}%"
    if name in ("throw", "bank") and number > WIDEST_ANGLE:
        rule = f"must be at most {WIDEST_ANGLE}"
        raise SymbalanceError(f"{name} = {brief(value)}", rule, "degrees, plus or minus")
    return number


def _over(name: str, value: Fraction | str, unit: Fraction | None, key: str) -> Fraction:
    if isinstance(value, str):
        return Fraction(value[:-1]) / 100
    if not value:
        return Fraction(0)
    if not unit:
        remedy = f"give {key} in [crank_train]" + (", or percent: 0.5%" if name in PARTS_OF else "")
        raise SymbalanceError(
            f"{name} = {float(value):g} {UNITS[name]}", f"needs the engine's {key}", remedy
        )
    return value / unit


@dataclass(frozen=True)
class RelativeTolerances:
    """Tolerances over m, r or a of cylinder 1, angles in radians; `stroke` is that of the radius."""

    mass: Fraction
    throw: float
    bank: float
    station: Fraction
    stroke: Fraction
    rod: Fraction
    offset: Fraction
    rotating: Fraction

    @property
    def steps(self) -> dict[str, float]:
        """The tolerances as floats, by name."""
        return {f.name: float(getattr(self, f.name)) for f in fields(self)}

    @property
    def parameters(self) -> list[str]:
        """The names of those that are not zero."""
        return [name for name, step in self.steps.items() if step]
