"""What mass, radius, omega and pitch are where a call leaves them out: 1 each, or those at a speed."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import prod

from symbalance.engine.engine import Engine
from symbalance.forces.operating_point import MILLI, OperatingPoint, checked_rpm, needed, omega_at

KEYS = {"mass": "reciprocating_mass", "radius": "stroke", "pitch": "pitch"}
"""The keywords that are sizes, and the keys of an engine file that say them."""


@dataclass(frozen=True)
class KeywordDefaults:
    """The keywords of a function in SI units, as they are where none is given; `rpm` None: all are 1.

    >>> KeywordDefaults(mass=0.5, radius=0.04, omega=600.0, rpm=Fraction(5730)).unit(("mass", "radius"))
    0.02
    """

    mass: float = 1.0
    radius: float = 1.0
    omega: float = 1.0
    pitch: float = 1.0
    rpm: Fraction | None = None
    unknown: tuple[str, ...] = ()
    """The keywords that are 1 because the engine does not say them, and no output takes them."""

    @property
    def at_speed(self) -> bool:
        """Whether they are sizes and a speed, rather than 1."""
        return self.rpm is not None

    @property
    def values(self) -> Mapping[str, float]:
        """The keywords by name, in the order that functions take them in."""
        return {"mass": self.mass, "radius": self.radius, "omega": self.omega, "pitch": self.pitch}

    def unit(self, factors: Collection[str]) -> float:
        """Return what a value of 1 becomes by a product of keywords."""
        return prod(self.values[factor] for factor in factors)

    def words(self) -> str:
        """Return the speed and the sizes in words."""
        units = {"mass": "kg", "radius": "m", "omega": "rad/s", "pitch": "m"}
        sizes = ", ".join(
            f"{name} {value!r} {units[name]}"
            for name, value in self.values.items()
            if name not in self.unknown
        )
        return f"{float(self.rpm or 0):.8g} rpm: {sizes}"


ALL_ONE = KeywordDefaults()
"""The defaults where no speed is given: values are in units of m r omega^2."""


def defaults_of(point: OperatingPoint | None) -> KeywordDefaults:
    """Return the defaults of a result at its operating point, 1 each where it has none."""
    if point is None:
        return ALL_ONE
    pitch = {} if point.pitch is None else {"pitch": float(point.pitch)}
    omega, unknown = float(point.omega), () if pitch else ("pitch",)
    sizes = {"mass": float(point.mass), "radius": float(point.radius), **pitch}
    return KeywordDefaults(**sizes, omega=omega, rpm=point.rpm, unknown=unknown)


def defaults_at(engine: Engine, rpm: object, factors: Collection[str]) -> KeywordDefaults:
    """Return the defaults of an engine at a speed; refused where a size is not known that `factors` need.

    >>> from symbalance.engine.catalogue import load
    >>> defaults_at(load("vq30de"), 6000, ["mass", "radius", "omega"]).mass
    0.673
    """
    speed, first = checked_rpm(rpm), engine.first
    sizes = {
        "mass": first.reciprocating_mass or None,
        "radius": None if first.radius is None else first.radius * MILLI,
        "pitch": None if engine.pitch is None else engine.pitch * MILLI,
    }
    unknown = tuple(name for name, value in sizes.items() if value is None)
    # In the order in which a drawing, and every other refusal, has them.
    missing = [KEYS[name] for name in ("radius", "mass", "pitch") if name in unknown and name in factors]
    if missing:
        raise needed(rpm, missing)
    known = {name: float(value) for name, value in sizes.items() if value is not None}
    return KeywordDefaults(**known, omega=float(omega_at(speed)), rpm=speed, unknown=unknown)
