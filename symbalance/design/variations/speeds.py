"""What forces and couples in m r omega^2 (a) are at a speed, in N and N m."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from symbalance.engine.engine import Engine
from symbalance.forces.operating_point import operating_point


class Scale(NamedTuple):
    """What forces and couples in m r omega^2 (a) are multiplied by, and the units they then have."""

    force: float
    couple: float
    units: tuple[str, str]


def speed_scale(engine: Engine, speed: Fraction | None) -> Scale:
    """Return what m r omega^2 and m r omega^2 a of cylinder 1 are at a speed, in N and N m."""
    if speed is None:
        return Scale(1.0, 1.0, ("m r ω²", "m r ω² a"))
    point = operating_point(engine, speed, needs_pitch=False)
    if point.couple is None:
        force = float(point.force)
        return Scale(force, force, ("N", "N a (the engine gives no pitch)"))
    return Scale(float(point.force), float(point.couple), ("N", "N m"))
