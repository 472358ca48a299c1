"""What forces and couples in m r omega^2 (a) are at a speed, in N and N m."""

from __future__ import annotations

from fractions import Fraction
from math import pi
from typing import NamedTuple

from symbalance.engine.engine import Engine
from symbalance.forces.operating_point import needed


class Scale(NamedTuple):
    """What forces and couples in m r omega^2 (a) are multiplied by, and the units they then have."""

    force: float
    couple: float
    units: tuple[str, str]


def speed_scale(engine: Engine, speed: Fraction | None) -> Scale:
    """Return what m r omega^2 and m r omega^2 a of cylinder 1 are at a speed, in N and N m."""
    if speed is None:
        return Scale(1.0, 1.0, ("m r ω²", "m r ω² a"))
    mass, radius, pitch = engine.first.reciprocating_mass, engine.first.radius, engine.pitch
    if not mass or radius is None:
        missing = {"stroke": radius is None, "reciprocating_mass": not mass}
        raise needed(speed, [key for key, lacks in missing.items() if lacks])
    force = float(mass * radius) / 1000 * (float(speed) * pi / 30) ** 2
    if pitch is None:
        return Scale(force, force, ("N", "N a (the engine gives no pitch)"))
    return Scale(force, force * float(pitch) / 1000, ("N", "N m"))
