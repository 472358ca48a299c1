"""The loads that bearings carry where the crank has no inertia: the start of a film table."""

from __future__ import annotations

import numpy as np

from symbalance.crankshaft.frames import rotation
from symbalance.crankshaft.rotor import Array


def bearing_loads(stiffness: Array, points: Array, force: Array, theta: Array, support: float) -> Array:
    """Return the shaft's forces on its bearings (s, b, 2) in N, stationary axes, without inertia.

    The crank's `stiffness` (n, n), centrifugal part included, rests on equal springs `support` (N/m) at
    `points` (b, 2, n) under `force` (s, n) at angles (s,), all in turning axes: statically indeterminate,
    so that stiffer supports give the bearings next to a throw more of its load.
    """
    rows = points.reshape(-1, points.shape[-1])
    supported = stiffness + support * rows.T @ rows
    place = np.linalg.solve(supported, np.ascontiguousarray(force.T))
    turning = (support * rows @ place).T.reshape(len(theta), -1, 2)
    return (rotation(theta)[:, None] @ turning[..., None])[..., 0]
