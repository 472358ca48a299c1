"""Lumping of a crank web's mass to the nodes at its two faces.

The web is cut midway between its two axes: the half around the near axis, with the counterweight, moves
with the near node or, in a solved web, as a body of its own; the other half with the far node. Mass,
mass centre and inertia of the whole are exact. Against a crank meshed whole
(`derivations/crankshaft-model.md`) this did better than mass divided in proportion to the place between
the axes: where journal or pin joins the web it hardly bends.

The outline is a rectangle, `width` across, from `heel` behind the near axis to `tip` beyond the far one,
its corners rounded with the radius min(width/2, heel) at one end, min(width/2, tip) at the other.
"""

from __future__ import annotations

from itertools import pairwise
from math import pi

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.crank import WebCounterweight
from symbalance.crankshaft.rotor.rigid_bodies import RigidBody, ring, turn_about_w
from symbalance.crankshaft.webs.arm import Arm
from symbalance.crankshaft.webs.sector import outline_half_width, sector_plate


def near_bodies(arm: Arm) -> list[RigidBody]:
    """Return the bodies on the web's near end, about the near node in U, V, W: half, counterweight."""
    bodies = [arm.in_rotor_axes(_half_web(arm, near=True))]
    if (weight := arm.web.counterweight) and weight.mass > 0:
        bodies.append(_counterweight(arm, weight))
    return bodies


def near_fillet(arm: Arm) -> list[RigidBody]:
    """Return the near part's fillet, about the near node in U, V, W."""
    fillet = _fillet(arm.near.diameter, arm.near.fillet, -1, arm)
    return [arm.in_rotor_axes(fillet)] if fillet.mass > 0 else []


def far_bodies(arm: Arm) -> list[RigidBody]:
    """Return the bodies at the web's far node, in U, V, W: half of the web, fillet."""
    share = _half_web(arm, near=False).shifted(-arm.lever)
    fillet = _fillet(arm.far.diameter, arm.far.fillet, 1, arm)
    return [arm.in_rotor_axes(body) for body in (share, fillet) if body.mass > 0]


def half_width(arm: Arm, u: Array) -> Array:
    """Return half the outline's width at u along the arm."""
    sizes = (arm.web.width, arm.near_margin, arm.far_margin)
    return np.maximum(outline_half_width(sizes, u, arm.reach), 0.0)


def _half_web(arm: Arm, *, near: bool) -> RigidBody:
    """Return the web's half at its near or far end, about the near node; own axes."""
    u, steps = _strips(arm)
    inside = u < arm.reach / 2 if near else u > arm.reach / 2
    half, thick = half_width(arm, u), arm.web.thickness
    mass = np.where(inside, arm.material.density * thick * 2 * half * steps, 0.0)
    total = float(mass.sum())
    if total == 0:
        return RigidBody(0.0, np.zeros(3), np.zeros((3, 3)))
    centre = float(mass @ u) / total
    along, across, through = mass @ (u - centre) ** 2, mass @ half**2 / 3, total * thick**2 / 12
    inertia = np.diag([across + through, along + through, along + across])
    return RigidBody(total, np.array([centre, 0.0, thick / 2]), inertia)


def _strips(arm: Arm) -> tuple[Array, Array]:
    """Return places and weights for integrals along u: Gauss points between the outline's breaks.

    Each end piece is integrated in the angle of its rounded corner, where the outline is smooth.
    """
    start, stop = -arm.near_margin, arm.reach + arm.far_margin
    near, far = (min(arm.web.width / 2, m) for m in (arm.near_margin, arm.far_margin))
    angles, weights = np.polynomial.legendre.leggauss(40)
    angles, weights = (angles + 1) * pi / 4, weights * pi / 4
    places = [start + near * (1 - np.cos(angles)), stop - far * (1 - np.cos(angles))]
    steps = [near * np.sin(angles) * weights, far * np.sin(angles) * weights]
    for start_of, right in pairwise((start + near, arm.reach / 2, stop - far)):
        points, width = np.polynomial.legendre.leggauss(8)
        places.append(start_of + (right - start_of) * (points + 1) / 2)
        steps.append(width * (right - start_of) / 2)
    return np.concatenate(places), np.concatenate(steps)


def _fillet(diameter: float, radius: float, side: int, arm: Arm) -> RigidBody:
    """Return the ring a fillet adds outside the web, on the face before (-1) or behind (1) it.

    Area (1 - pi/4) r^2, centroid (10 - 3 pi)/(12 - 3 pi) r from both faces of the corner.
    """
    inward = (10 - 3 * pi) / (12 - 3 * pi) * radius
    return ring((1 - pi / 4) * radius**2, diameter / 2 + inward, side * inward, arm.material.density)


def _counterweight(arm: Arm, weight: WebCounterweight) -> RigidBody:
    """Return the counterweight about the near node, a flat piece as thick as the web.

    Its inertia about the axis' direction is divided as the drawn sector's is; into halves without one.
    """
    turn = turn_about_w(weight.angle)
    through = (-1 if arm.mirrored else 1) * arm.web.thickness / 2
    offset = turn @ [weight.radius, 0.0, 0.0] - [*arm.axis, -through]
    thick = weight.mass * arm.web.thickness**2 / 12
    along = _along(arm, weight) * weight.inertia
    own = np.diag([weight.inertia - along + thick, along + thick, weight.inertia])
    return RigidBody(weight.mass, offset, turn @ own @ turn.T)


def _along(arm: Arm, weight: WebCounterweight) -> float:
    """Return the share of a counterweight's inertia due to its extent along its own radius."""
    if not weight.outer or arm.axis != (0.0, 0.0):
        return 0.5
    web, turn = arm.web, weight.angle - arm.angle
    sizes = (web.width, web.heel, web.tip, arm.reach)
    plate = sector_plate(*sizes, weight.outer, weight.half_angle, turn)
    total = plate.along + plate.across
    return plate.along / total if total else 0.5
