"""Loads on the rotor against the crank angle, and the bearing loads of a quasi-static crank."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.frames import gravity, rotation
from symbalance.crankshaft.loads import PinLoads
from symbalance.crankshaft.rotor.constraints import driven_node
from symbalance.crankshaft.rotor.matrices import Rotor

SPRING = 1e9
"""N/m, of the order of a film and its housing in series; the loads change little with it."""


@dataclass(frozen=True)
class RotorLoads:
    """All loads on a rotor but the bearings': F_C at the pins, omega^2 F_M, weight, the load's torque.

    The load takes the mean torque of the rods at the flywheel; the big ends' centrifugal force is in
    F_M, as their mass is the rotor's.
    """

    rotor: Rotor
    pins: PinLoads
    weight: bool = True

    def at(self, theta: Array) -> Array:
        """Return the forces (s, n) at crank angles (s,), N and N m."""
        theta = np.asarray(theta, dtype=float)
        forces = np.tile(self._steady, (len(theta), 1))
        loads = self.pins.at(theta)
        for place, node in enumerate(self.rotor.pins):
            forces[:, DOF * node : DOF * node + DOF] += loads[:, place]
        if self.weight:
            forces += gravity(theta)[:, :2] @ self._mass_across
        return forces

    @cached_property
    def _steady(self) -> Array:
        force = self.pins.rods.omega**2 * self.rotor.centrifugal_force
        force[DOF * driven_node(self.rotor) + 5] -= self.pins.mean_torque
        return force

    @cached_property
    def _mass_across(self) -> Array:
        """Return M times the shifts along U and V, (2, n)."""
        return (self.rotor.mass @ self.rotor.rigid_motions()[:, :2]).T


def bearing_points(rotor: Rotor) -> Array:
    """Return B (b, 2, n): each main bearing's u and v out of the displacements."""
    points = np.zeros((len(rotor.journals), 2, rotor.size))
    for place, node in enumerate(rotor.journals):
        points[place, 0, DOF * node] = points[place, 1, DOF * node + 1] = 1.0
    return points


def quasi_static_reactions(rotor: Rotor, force: Array, spring: float = SPRING) -> Array:
    """Return (s, b, 2): the shaft's force on each bearing in turning axes, N, for forces (s, n).

    (K + sum k B^T B) x = f: the reactions of an elastic crank on equal springs, not of throws cut apart.
    Springs hold the flywheel's rotation and the last bearing's axial place: they take the torque that
    the loads do not balance.
    """
    flat = bearing_points(rotor).reshape(-1, rotor.size)
    own = rotor.stiffness + spring * flat.T @ flat
    for unknown in (DOF * driven_node(rotor) + 5, DOF * rotor.journals[-1] + 2):
        own[unknown, unknown] += spring
    displacements = np.linalg.solve(own, force.T)
    return (spring * flat @ displacements).T.reshape(len(force), -1, 2)


def to_stationary_axes(vectors: Array, theta: Array) -> Array:
    """Return (s, b, 2) in stationary axes from turning ones at angles (s,)."""
    return np.einsum("sij,sbj->sbi", rotation(theta), vectors)
