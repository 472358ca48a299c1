"""Mass and inertia of a drawn counterweight: a sector about the axis, less its part within the web."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import pi

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.crank import Web, WebCounterweight
from symbalance.crankshaft.rotor.parts import Material
from symbalance.errors import SymbalanceError, shown

STEPS = 600
"""Steps each way of the integrals over a sector: some 1e-4 of its mass."""


@dataclass(frozen=True)
class Plate:
    """A flat piece per unit of mass per area: `area`, distance of its centre from the axis along the
    sector's middle, second moments about the centre `along` the middle and `across` it; m.
    """

    area: float
    centre: float
    along: float
    across: float


def sector_counterweight(
    web: Web, pin_angle: float, reach: float, outer: float, half_angle: float, material: Material
) -> WebCounterweight:
    """Return the counterweight of a web whose sector, opposite the pin, reaches to `outer` (m).

    Mass, centre and inertia about it of the sector's part outside the web's outline. SI; `half_angle` in
    radians.

    >>> web = Web(0.02, 1e-6, 1e-6, 1e-6)
    >>> weight = sector_counterweight(web, 0.0, 1e-6, 0.08, np.pi / 2, Material(density=7850.0))
    >>> round(weight.mass, 3), round(weight.radius * 1e3, 2), round(weight.angle, 4)
    (1.578, 33.95, 3.1416)
    """
    if not (0 < half_angle <= pi and outer > 0):
        what = f"counterweight outer = {shown(outer)}, half_angle = {shown(half_angle)}"
        raise SymbalanceError(what, "must be positive, the angle at most 180 degrees", "m and radians")
    plate = sector_plate(web.width, web.heel, web.tip, reach, outer, half_angle, pi)
    if plate.area == 0:
        what = f"counterweight outer = {shown(outer)}"
        raise SymbalanceError(what, "must reach beyond the web", "a greater radius or angle")
    weight = material.density * web.thickness
    inertia = weight * (plate.along + plate.across)
    angle = (pin_angle + pi) % (2 * pi)
    return WebCounterweight(weight * plate.area, abs(plate.centre), angle, inertia, outer, half_angle)


@lru_cache(maxsize=64)
def sector_plate(
    width: float, heel: float, tip: float, reach: float, outer: float, half_angle: float, turn: float
) -> Plate:
    """Return what of a sector lies outside a web's outline; `turn` is its middle's angle from the arm."""
    about, step = _middles(-half_angle, half_angle)
    out, rise = _middles(0.0, outer)
    along, across = np.outer(out, np.cos(about)), np.outer(out, np.sin(about))
    u, v = along * np.cos(turn) - across * np.sin(turn), along * np.sin(turn) + across * np.cos(turn)
    beyond = np.abs(v) > outline_half_width((width, heel, tip), u, reach)
    area = np.where(beyond, out[:, None] * rise * step, 0.0)
    total = float(area.sum())
    if total == 0:
        return Plate(0.0, 0.0, 0.0, 0.0)
    centre = float((area * along).sum()) / total
    return Plate(
        total, centre, float((area * (along - centre) ** 2).sum()), float((area * across**2).sum())
    )


def _middles(start: float, stop: float) -> tuple[Array, float]:
    """Return the middles and the width of equal steps: the web's edge cuts the integrand anywhere."""
    width = (stop - start) / STEPS
    return np.linspace(start + width / 2, stop - width / 2, STEPS), width


def outline_half_width(sizes: tuple[float, float, float], u: Array, reach: float) -> Array:
    """Return half a web's width at u along its arm, negative beyond its ends.

    `sizes` are its width and its margins beyond the near axis, at u = 0, and the far one, at `reach`: a
    rectangle whose corners are rounded with the radius min(width/2, margin) at either end.
    """
    width, heel, tip = sizes
    half, narrow = width / 2, np.zeros_like(u)
    for margin, place in ((heel, -u), (tip, u - reach)):
        radius = min(half, margin)
        into = np.clip(place - (margin - radius), 0.0, radius)
        narrow = narrow + radius - np.sqrt(np.maximum(radius**2 - into**2, 0.0))
    return np.where((u >= -heel) & (u <= reach + tip), half - narrow, -1.0)
