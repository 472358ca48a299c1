"""The right side of the equations in turning coordinates, against the crank angle."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from symbalance.crankshaft.frames import gravity
from symbalance.crankshaft.loads import PinLoads
from symbalance.crankshaft.rotor import DOF, Array, Rotor
from symbalance.crankshaft.running.holding import driven_node


@dataclass(frozen=True)
class Loading:
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
        found = np.tile(self._steady, (len(theta), 1))
        loads = self.pins.at(theta)
        for place, node in enumerate(self.rotor.pins):
            found[:, DOF * node : DOF * node + DOF] += loads[:, place]
        if self.weight:
            found += gravity(theta)[:, :2] @ self._heaviness
        return found

    @cached_property
    def _steady(self) -> Array:
        force = self.pins.rods.omega**2 * self.rotor.centrifugal_force
        force[DOF * driven_node(self.rotor) + 5] -= self.pins.mean_torque
        return force

    @cached_property
    def _heaviness(self) -> Array:
        """Return M times the shifts along U and V, (2, n)."""
        return (self.rotor.mass @ self.rotor.rigid_motions()[:, :2]).T
