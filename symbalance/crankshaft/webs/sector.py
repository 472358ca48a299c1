"""A counterweight from its drawing: a sector about the axis, less what lies within the web."""

from __future__ import annotations

from math import pi

import numpy as np

from symbalance.crankshaft.crank import Counterweight, Material, Web
from symbalance.errors import SymbalanceError, shown

STEPS = 600
"""Steps each way of the integrals over a sector: some 1e-4 of its mass."""


def sector_counterweight(
    web: Web, pin_angle: float, reach: float, outer: float, half_angle: float, material: Material
) -> Counterweight:
    """Return the counterweight of a web whose sector, opposite the pin, reaches to `outer` (m).

    Mass, centre and inertia about it of the sector's part outside the web's outline, integrated in polar
    coordinates about the journal's axis. SI; `half_angle` in radians.

    >>> web = Web(0.02, 1e-6, 1e-6, 1e-6)
    >>> weight = sector_counterweight(web, 0.0, 1e-6, 0.08, np.pi / 2, Material(density=7850.0))
    >>> round(weight.mass, 3), round(weight.radius * 1e3, 2), round(weight.angle, 4)
    (1.578, 33.95, 3.1416)
    """
    if not (0 < half_angle <= pi and outer > 0):
        what = f"counterweight outer = {shown(outer)}, half_angle = {shown(half_angle)}"
        raise SymbalanceError(what, "must be positive, the angle at most 180 degrees", "m and radians")
    turn, turn_weight = _gauss(-half_angle, half_angle)
    out, out_weight = _gauss(0.0, outer)
    u, v = -np.outer(out, np.cos(turn)), np.outer(out, np.sin(turn))
    beyond = np.abs(v) > _outline(web, u, reach)
    area = np.outer(out * out_weight, turn_weight) * beyond * material.density * web.thickness
    mass = float(area.sum())
    if mass == 0:
        what = f"counterweight outer = {shown(outer)}"
        raise SymbalanceError(what, "must reach beyond the web", "a greater radius or angle")
    centre = float((area * u).sum()) / mass
    inertia = float((area * ((u - centre) ** 2 + v**2)).sum())
    return Counterweight(mass, abs(centre), (pin_angle + pi) % (2 * pi), inertia, outer, half_angle)


def _gauss(start: float, stop: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the middles and widths of equal steps: the web's edge cuts the integrand anywhere."""
    width = (stop - start) / STEPS
    return start + width * (np.arange(STEPS) + 0.5), np.full(STEPS, width)


def _outline(web: Web, u: np.ndarray, reach: float) -> np.ndarray:
    """Return half the web's width at u, zero beyond its ends."""
    half = web.width / 2
    narrow = np.zeros_like(u)
    for margin, place in ((web.heel, -u), (web.tip, u - reach)):
        radius = min(half, margin)
        into = np.clip(place - (margin - radius), 0.0, radius)
        narrow = narrow + radius - np.sqrt(np.maximum(radius**2 - into**2, 0.0))
    return np.where((u >= -web.heel) & (u <= reach + web.tip), half - narrow, -1.0)
