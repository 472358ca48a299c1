"""Flexibility of half a crank throw meshed as a solid, and the web's share of it.

Half the journal, the web and half the pin are meshed; the journal's middle section is clamped, the pin's
moved as a rigid section by six unit motions. Their reactions are K, and S_half = K^-1. Loads pass along
the chain unchanged, so flexibilities add, each transferred to the last end:

    S_half = T_1 S_journal T_1' + T_2 S_web T_2' + S_pin,

which gives S_web, fillets and the stiffening of the neighbouring sections included. The web's near half,
with heel and counterweight, is loaded too, as its own inertia would load it: S is (12, 12). Where web and
counterweight are their own mirror image in the throw's plane, half the body is solved twice.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.crank import Journal, Pin
from symbalance.crankshaft.rotor.beams import circular, flexibility, transfer
from symbalance.crankshaft.solid.elasticity import NEAR, ElasticBody, elastic_solid, sparse_factors
from symbalance.crankshaft.solid.meshing import draw_half_throw, halved, mesh_solid
from symbalance.crankshaft.webs.arm import Arm, WebCompliance

Flags = NDArray[np.bool_]
EVEN, ODD = [0, 2, 4], [1, 3, 5]
"""Motions of a section that keep to the throw's plane (u, w, theta_v), and those across it."""


def element_size(arm: Arm) -> float:
    """Return the element size (m) that solves a half throw within about 1.5 %.

    No less than a fifteenth of the width: a very thin web keeps one element through it, and ends.
    """
    thin = min(arm.web.thickness, arm.near.diameter / 2, arm.far.diameter / 2)
    return max(0.45 * thin, arm.web.width / 15)


def solve_web(arm: Arm, size: float = 0.0) -> WebCompliance:
    """Return a web's flexibility, far face and body against near face; `size` of the elements in m."""
    own = arm.canonical()
    whole, body = half_throw_flexibility(own, size or element_size(own))
    return WebCompliance(web_share(own, whole, body), body)


def half_throw_flexibility(arm: Arm, size: float) -> tuple[Array, Array]:
    """Return the flexibility (12, 12) of the far part's middle and of the web's near half; own axes.

    And the place (3,) of that half's centre from the near node. Its motion is the mean that works with
    inertia forces: loads are spread over it as rigid accelerations would spread them.
    """
    own = arm.canonical()
    cuts = [1] if is_flat(own) else []
    mesh = mesh_solid(lambda occ: halved(occ, draw_half_throw(occ, own), cuts), size)
    solid = elastic_solid(mesh, own.material)
    near_half = _near_half(solid, own)
    centre = _centre(solid, near_half, flat=bool(cuts))
    total = np.zeros((2 * DOF, 2 * DOF))
    for motions in (EVEN, ODD) if cuts else ([*range(DOF)],):
        mirror_zeros = (
            solid.zero_at_mirror(1, 0.0, even=motions == EVEN) if cuts else np.zeros(solid.size, bool)
        )
        both = [*motions, *(DOF + k for k in motions)]
        part = _Part(solid, own, near_half, centre, motions, mirror_zeros, 2 if cuts else 1)
        total[np.ix_(both, both)] = part.flexibility()
    return (total + total.T) / 2, centre - np.array([*own.axis, 0.0])


def _near_half(solid: ElasticBody, arm: Arm) -> Flags:
    """Return which unknowns belong to the web's half around the near axis, counterweight included."""
    u, w = solid.places[0] - arm.axis[0], solid.places[2]
    return (u <= arm.reach / 2) & (w > -NEAR) & (w < arm.web.thickness + NEAR)


def _centre(solid: ElasticBody, region: Flags, *, flat: bool) -> Array:
    mass = solid.mass @ np.where(solid.across == 0, 1.0, 0.0)
    weights = np.where(region & (solid.across == 0), mass, 0.0)
    centre = solid.places @ weights / weights.sum()
    return centre * [1.0, 0.0 if flat else 1.0, 1.0]


@dataclass(frozen=True)
class _Part:
    """A half throw, or `share` equal parts of one that move alike, with the motions it is loaded in."""

    solid: ElasticBody
    arm: Arm
    near_half: Flags
    centre: Array
    motions: list[int]
    mirror_zeros: Flags
    share: int

    def flexibility(self) -> Array:
        """Return the flexibility of the far section and the near half, the near section clamped.

        Inside, u = Y f - X q under unit body loads f, with the far section moved by q; q follows from
        the balance of the far section, k q + B'Y f = p.
        """
        stop = self.arm.web.thickness + self.arm.far.length / 2
        near = self.solid.on_plane(2, -self.arm.near.length / 2)
        far = self.solid.on_plane(2, stop)
        free = ~(near | far | self.mirror_zeros)
        middle = np.array([self.arm.axis[0] + self.arm.reach, self.arm.axis[1], stop])
        far_motion = np.where(far[:, None], self.solid.rigid(middle)[:, self.motions], 0.0)
        forces, loads = self.solid.stiffness @ far_motion, self._body_loads()
        inside = sparse_factors(self.solid.stiffness, free).solve(np.hstack([forces[free], loads[free]]))
        count = len(self.motions)
        by_far, by_body = inside[:, :count], inside[:, count:]
        stiffness = far_motion.T @ forces - forces[free].T @ by_far
        far_by_body = -np.linalg.solve(stiffness, forces[free].T @ by_body)
        own = self.share * loads[free].T @ (by_body - by_far @ far_by_body)
        end = np.linalg.inv(self.share * stiffness)
        return np.block([[end, far_by_body], [far_by_body.T, own]])

    def _body_loads(self) -> Array:
        """Return loads (n, m) of unit resultants, spread as the body's rigid accelerations would."""
        rigid = np.where(self.near_half[:, None], self.solid.rigid(self.centre)[:, self.motions], 0.0)
        momentum = np.where(self.near_half[:, None], self.solid.mass @ rigid, 0.0)
        return momentum @ np.linalg.inv(self.share * rigid.T @ momentum)


def web_share(arm: Arm, whole: Array, body: Array) -> Array:
    """Return the web's flexibility from the half throw's: less journal's and pin's, face to face."""
    beyond = np.array([0.0, 0.0, arm.far.length / 2])
    to_ends = np.vstack([transfer(arm.lever + beyond), transfer(body)])
    rest = whole - to_ends @ _half(arm, arm.near) @ to_ends.T
    rest[:DOF, :DOF] -= _half(arm, arm.far)
    back = np.eye(2 * DOF)
    back[:DOF, :DOF] = np.linalg.inv(transfer(beyond))
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
