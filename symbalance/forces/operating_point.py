"""Operating point of an engine: its speed and the sizes that make forces newtons.

A force of A_n m r omega^2 is in N where the reciprocating mass m of a cylinder, the crank radius r and
the speed are known; a couple of A_n m r omega^2 a in N m where the pitch a is known too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, TypedDict

from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError, brief
from symbalance.text.numbers import decimal_text, evenly_spaced, exact
from symbalance.text.reals import Real, pi

FASTEST = 100_000
"""Turns a minute: small engines of models reach 50,000."""
MOST_SPEEDS = 1000
MILLI = Fraction(1, 1000)
UNITS = {"force": "N", "couple": "N m"}
"""What forces and couples are in at an operating point."""


@dataclass(frozen=True)
class OperatingPoint:
    """A speed with the sizes of cylinder 1: `mass` reciprocates, kg; `radius` and `pitch` in m.

    >>> OperatingPoint(Fraction(6000), Fraction(1, 2), Fraction(4, 100)).force.rounded(6)
    Real('7895.68', 6)
    """

    rpm: Fraction
    mass: Fraction
    radius: Fraction
    pitch: Fraction | None = None

    @cached_property
    def omega(self) -> Real:
        """The crank's speed in rad/s."""
        return omega_at(self.rpm)

    @cached_property
    def force(self) -> Real:
        """The unit of forces, m r omega^2, in N: what one piston's first order is."""
        return acceleration_at(self.rpm, self.radius) * self.mass

    @property
    def couple(self) -> Real | None:
        """The unit of couples, m r omega^2 a, in N m; None where no pitch is known."""
        return None if self.pitch is None else self.force * self.pitch

    @property
    def torque(self) -> Real:
        """The unit of torques, m r^2 omega^2, in N m."""
        return self.force * self.radius

    def data(self) -> dict[str, Any]:
        """Return the speed, the mass, the radius and the pitch as strings, SI but for rpm."""
        return {
            "rpm": str(self.rpm),
            "mass": _text(self.mass),
            "radius": _text(self.radius),
            "pitch": None if self.pitch is None else _text(self.pitch),
        }


def _text(value: Fraction) -> str:
    return decimal_text(Real(value), 17)


def omega_at(rpm: Fraction) -> Real:
    """Return turns a minute in rad/s."""
    return pi() * rpm / 30


def acceleration_at(rpm: Fraction, radius: Fraction) -> Real:
    """Return r omega^2 in m/s^2, of a radius in m: what 1 kg at the crank pins pushes with, in N."""
    return omega_at(rpm) ** 2 * radius


class Sizes(TypedDict, total=False):
    """Sizes that an engine lacks, as every result's `at` takes them beside the speed.

    `mass` is the reciprocating mass of a cylinder in kg; `stroke`, `rod`, `pitch` and `bore` are in mm.
    """

    mass: object
    stroke: object
    rod: object
    pitch: object
    bore: object


def operating_point(
    engine: Engine, rpm: object, *, needs_pitch: bool = True, needs_ratio: bool = False
) -> OperatingPoint:
    """Return an engine's operating point at a speed, or refuse, naming every key that is missing.

    >>> from symbalance.engine.catalogue import load
    >>> operating_point(load("vq30de"), 6000).mass
    Fraction(673, 1000)
    """
    speed = checked_rpm(rpm)
    first = engine.first
    missing = [
        key
        for key, value in (
            ("stroke", first.radius),
            ("reciprocating_mass", first.reciprocating_mass),
            ("pitch", engine.pitch if needs_pitch else 1),
            ("rod", engine.ratio if needs_ratio else 1),
        )
        if value is None
    ]
    if missing:
        raise needed(rpm, missing)
    if not first.reciprocating_mass:
        rule = "is the unit that forces are in, and must be above 0"
        raise SymbalanceError("reciprocating_mass = 0", rule, "give it in kg")
    assert first.radius is not None
    pitch = None if engine.pitch is None else engine.pitch * MILLI
    return OperatingPoint(speed, first.reciprocating_mass, first.radius * MILLI, pitch)


def needed(rpm: object, missing: Sequence[str]) -> SymbalanceError:
    """Return the refusal of a speed without the sizes that it needs, by their keys in an engine file."""
    keys = " and ".join([", ".join(missing[:-1]), missing[-1]] if missing[1:] else missing)
    options = " ".join(OPTIONS[key] for key in missing)
    remedy = f"add {keys} to [crank_train], or append your own figures like {options}"
    return SymbalanceError(f"rpm = {brief(rpm)}", f"needs the engine's {keys} for newtons", remedy)


def sized(engine: Engine, sizes: Mapping[str, object]) -> Engine:
    """Return an engine with sizes that it lacks: `stroke`, `rod`, `pitch`, `bore` in mm, `mass` in kg.

    >>> from symbalance.engine.catalogue import load
    >>> sized(load("inline-4"), {"stroke": 80, "mass": "0.5"}).unit_unbalance
    Fraction(20, 1)
    """
    check_size_names(sizes)
    return engine.with_sizes(**{SIZES[name]: value for name, value in sizes.items()}) if sizes else engine


def check_size_names(sizes: Mapping[str, object]) -> None:
    """Refuse a keyword that is no size, as Python refuses one that a function does not have."""
    unknown = [name for name in sizes if name not in SIZES]
    if unknown:
        raise TypeError(f"the sizes are {', '.join(SIZES)}, not {unknown[0]!r}")


SIZES = {
    "stroke": "stroke",
    "rod": "rod",
    "pitch": "pitch",
    "mass": "reciprocating_mass",
    "bore": "bore",
}
"""What the sizes of an operating point are called, and their keys in an engine file."""
OPTIONS = {
    "stroke": "--stroke 86",
    "reciprocating_mass": "--mass 0.5",
    "pitch": "--pitch 100",
    "rod": "--rod 145",
}
"""How the command line gives what an engine file lacks, mm and kg, with a figure to replace."""


def checked_rpm(rpm: object) -> Fraction:
    """Return a speed in turns a minute, or refuse."""
    speed = exact(rpm, "rpm")
    if not 0 < speed <= FASTEST:
        raise SymbalanceError(f"rpm = {brief(rpm)}", f"must lie in (0, {FASTEST}]", "turns a minute")
    return speed


def checked_speeds(text: str) -> tuple[Fraction, ...]:
    """Return the speeds of an option: one, or those from a first to a last by a step.

    >>> [str(s) for s in checked_speeds("1000:2000:500")], checked_speeds("6000")
    (['1000', '1500', '2000'], (Fraction(6000, 1),))
    """
    parts = text.split(":")
    if len(parts) == 1:
        return (checked_rpm(text),)
    remedy = "write a speed, or from:to:step, as in --rpm 1000:7000:500"
    if len(parts) != 3:
        raise SymbalanceError(f"--rpm {brief(text)}", "must be a speed or from:to:step", remedy)
    first, last, step = (checked_rpm(part) for part in parts)
    if first > last:
        raise SymbalanceError(f"--rpm {brief(text)}", "must go upwards", remedy)
    what = f"--rpm {brief(text)}"
    return tuple(
        evenly_spaced(first, last, step, most=MOST_SPEEDS, what=what, things="speeds", remedy=remedy)
    )
