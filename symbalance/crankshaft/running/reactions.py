"""Main bearing loads of a quasi-static crank: elastic, on springs, without vibration."""

from __future__ import annotations

import numpy as np

from symbalance.crankshaft.frames import rotation
from symbalance.crankshaft.rotor import DOF, Array, Rotor
from symbalance.crankshaft.running.holding import driven_node

SPRING = 1e9
"""N/m, of the order of a film and its housing in series; the loads change little with it."""


def bearing_points(rotor: Rotor) -> Array:
    """Return B (b, 2, n): each main bearing's u and v out of the displacements."""
    points = np.zeros((len(rotor.journals), 2, rotor.size))
    for place, node in enumerate(rotor.journals):
        points[place, 0, DOF * node] = points[place, 1, DOF * node + 1] = 1.0
    return points


def quasi_static(rotor: Rotor, force: Array, spring: float = SPRING) -> Array:
    """Return (s, b, 2): the shaft's force on each bearing in turning axes, N, for forces (s, n).

    (K + sum k B^T B) x = f: the reactions of an elastic crank on equal springs, not of throws cut apart.
    The flywheel's spin and the last bearing's axial place are held: they take what torque is left.
    """
    flat = bearing_points(rotor).reshape(-1, rotor.size)
    own = rotor.stiffness + spring * flat.T @ flat
    for unknown in (DOF * driven_node(rotor) + 5, DOF * rotor.journals[-1] + 2):
        own[unknown, unknown] += spring
    displaced = np.linalg.solve(own, force.T)
    return (spring * flat @ displaced).T.reshape(len(force), -1, 2)


def stationary(vectors: Array, theta: Array) -> Array:
    """Return (s, b, 2) in stationary axes from turning ones at angles (s,)."""
    return np.einsum("sij,sbj->sbi", rotation(theta), vectors)
