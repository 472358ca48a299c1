"""The flexibility of half a throw as a solid, and the web's share of it.

Half the journal, the web and half the pin are meshed; the journal's middle section is held, the pin's
moved as a rigid section by six unit motions. Their reactions are K, and S_half = K^-1. Loads pass along
the chain unchanged, so flexibilities add, each transferred to the last end:

    S_half = T_1 S_journal T_1' + T_2 S_web T_2' + S_pin,

which gives S_web, fillets and the web's hold on the neighbouring sections included. Where web and
counterweight are their own mirror image in the throw's plane, half the body is solved twice.
"""

from __future__ import annotations

import numpy as np

from symbalance.crankshaft.beams import circular, flexibility, transfer
from symbalance.crankshaft.crank import Journal, Pin
from symbalance.crankshaft.rotor import DOF, Array
from symbalance.crankshaft.solid.drawing import draw_half_throw, halved
from symbalance.crankshaft.solid.elasticity import Solid, elastic_solid, factored
from symbalance.crankshaft.solid.meshing import meshed
from symbalance.crankshaft.webs.arm import Arm

EVEN, ODD = [0, 2, 4], [1, 3, 5]
"""Motions of a section that keep to the throw's plane (u, w, theta_v), and those across it."""


def fine(arm: Arm) -> float:
    """Return the element size that solves a half throw within about 1.5 % (m)."""
    return 0.45 * min(arm.web.thickness, arm.near.diameter / 2, arm.far.diameter / 2)


def solved_web(arm: Arm, size: float = 0.0) -> Array:
    """Return the web's flexibility (6, 6), far face against near, own axes; `size` of elements, m."""
    own = arm.canonical()
    return web_share(own, half_throw_flexibility(own, size or fine(arm)))


def half_throw_flexibility(arm: Arm, size: float) -> Array:
    """Return the flexibility (6, 6) of the far part's middle against the near part's; own axes."""
    own = arm.canonical()
    cuts = [1] if is_flat(own) else []
    solid = elastic_solid(
        meshed(lambda occ: halved(occ, draw_half_throw(occ, own), cuts), size), own.material
    )
    total = np.zeros((DOF, DOF))
    for motions in (EVEN, ODD) if cuts else ([*range(DOF)],):
        held = solid.held_by_mirror(1, 0.0, even=motions == EVEN) if cuts else np.zeros(solid.size, bool)
        total[np.ix_(motions, motions)] = (2 if cuts else 1) * _reactions(solid, own, motions, held)
    return np.linalg.inv((total + total.T) / 2)


def _reactions(solid: Solid, arm: Arm, motions: list[int], held: Array) -> Array:
    """Return the stiffness of the far section against `motions`, the near one held."""
    start, stop = -arm.near.length / 2, arm.web.thickness + arm.far.length / 2
    near, far = solid.on_plane(2, start), solid.on_plane(2, stop)
    free = ~(near | far | held)
    middle = np.array([arm.axis[0] + arm.reach, arm.axis[1], stop])
    moved = np.where(far[:, None], solid.rigid(middle)[:, motions], 0.0)
    forces = solid.stiffness @ moved
    inside = factored(solid.stiffness, free).solve(forces[free])
    return moved.T @ forces - forces[free].T @ inside


def web_share(arm: Arm, whole: Array) -> Array:
    """Return the web's flexibility from the half throw's: less journal's and pin's, face to face."""
    halves = [_half(arm, arm.near), _half(arm, arm.far)]
    after = transfer(np.array([0.0, 0.0, arm.far.length / 2]))
    across = after @ transfer(arm.lever)
    rest = whole - across @ halves[0] @ across.T - halves[1]
    back = np.linalg.inv(after)
    web = back @ rest @ back.T
    return (web + web.T) / 2


def _half(arm: Arm, part: Journal | Pin) -> Array:
    section = circular(part.diameter, part.bore, arm.material.poisson)
    return flexibility(section, arm.material, part.length / 2)


def is_flat(arm: Arm) -> bool:
    """Tell whether a web in own axes is its own mirror image in the plane v = 0."""
    weight = arm.web.counterweight
    straight = arm.axis[1] == 0 if isinstance(arm.near, Journal) else abs(arm.axis[1]) < 1e-12
    return straight and (weight is None or not weight.outer or abs(np.sin(weight.angle)) < 1e-9)
