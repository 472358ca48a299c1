"""Equations of motion for departures from given journal orbits, about which oil films are linear.

With journals at Q^T (r_0 + z_0) in turning axes, let X_0 = Phi d(theta) bend the crank to them (Phi:
static shapes, one a bearing direction, rotation and axial place fixed) and x = X_0 + eta. Then eta obeys
the same equations with the right side

    f - B^T Q^T F_0 - (M X_0'' + D X_0' + S X_0),

films and housings acting on its departures alone. X_0 is any field that meets the orbits: what it lacks
of the motion, eta holds.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.frames import turned_vectors
from symbalance.crankshaft.rotor.constraints import driven_node
from symbalance.crankshaft.rotor.matrices import Rotor
from symbalance.crankshaft.running.oil_films import OrbitFilms, periodic_spline
from symbalance.crankshaft.system import PeriodicSystem


@dataclass(frozen=True)
class SystemAboutOrbit:
    """A periodic system for the departures, and `field`: X_0 (s, n) at angles (s,)."""

    system: PeriodicSystem
    field: Callable[[Array], Array]


def system_about_orbit(full: PeriodicSystem, rotor: Rotor, orbits: OrbitFilms) -> SystemAboutOrbit:
    """Return the system of the departures from `orbits`; `full` holds the orbits' own film."""
    flat = full.points.reshape(-1, full.size)
    shapes = static_shapes(rotor, flat)
    there = turned_vectors(orbits.place + orbits.housing_place, orbits.theta).reshape(
        len(orbits.theta), -1
    )
    bearing_motion = periodic_spline(orbits.theta, there, full.cycle)
    bearing_force = periodic_spline(
        orbits.theta, turned_vectors(orbits.force, orbits.theta).reshape(there.shape), full.cycle
    )
    omega = full.omega
    parts = [
        (omega**2 * full.mass @ shapes).T,
        (omega * full.damping @ shapes).T,
        (full.stiffness @ shapes).T,
    ]

    def force(theta: Array) -> Array:
        inertia = sum((bearing_motion(theta, 2 - k) @ part for k, part in enumerate(parts)), np.zeros(()))
        return full.force(theta) - bearing_force(theta) @ flat - inertia

    return SystemAboutOrbit(replace(full, force=force), lambda theta: bearing_motion(theta) @ shapes.T)


def static_shapes(rotor: Rotor, flat: Array) -> Array:
    """Return Phi (n, 2b): the crank bent by one bearing's unit displacement, the others' fixed."""
    size, count = rotor.size, len(flat)
    rows = np.zeros((2, size))
    rows[0, DOF * driven_node(rotor) + 5] = rows[1, DOF * rotor.journals[-1] + 2] = 1.0
    constraints = np.vstack([flat, rows])
    scale = float(np.abs(rotor.stiffness).max())
    matrix = np.block(
        [[rotor.stiffness / scale, constraints.T], [constraints, np.zeros((len(constraints),) * 2)]]
    )
    sides = np.zeros((size + len(constraints), count))
    sides[size : size + count] = np.eye(count)
    return np.asarray(np.linalg.solve(matrix, sides)[:size], dtype=np.float64)
