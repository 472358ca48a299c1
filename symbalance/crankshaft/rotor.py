"""A crankshaft as nodes and matrices in coordinates that turn with it.

At a node, in this order: u, v, w, theta_u, theta_v, theta_w. For constant speed omega and no bearings,

    M x'' + (C + omega G) x' + (K + omega^2 dK) x = F + omega^2 F_M.

The matrices are dense: a crank has some hundred unknowns.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.floating[Any]]
DOF = 6


@dataclass(frozen=True)
class Member:
    """An elastic element between two nodes, kept so that section loads follow from displacements.

    `stiffness` is 12 x 12 in U, V, W axes; `kind` is journal, web, pin or shaft, `index` the place of its
    part in the crank's chain (-1: a shaft at an end).
    """

    front: int
    rear: int
    stiffness: Array
    kind: str
    index: int


@dataclass(frozen=True)
class Rotor:
    """A free crankshaft. `points` (n, 3) are the nodes' U, V, W in m; matrices are (6n, 6n), SI.

    `journals` are the nodes of the main bearings, `pins` those of the pins' middles, front to rear,
    `pulley` and `flywheel` the nodes of the end discs, None where there is none.
    """

    points: Array
    mass: Array
    stiffness: Array
    damping: Array
    gyroscopic: Array
    centrifugal: Array
    centrifugal_force: Array
    journals: tuple[int, ...]
    pins: tuple[int, ...]
    pulley: int | None = None
    flywheel: int | None = None
    members: tuple[Member, ...] = field(default=())

    @property
    def size(self) -> int:
        """The number of unknowns."""
        return len(self.mass)

    def rigid_motions(self) -> Array:
        """Return the six rigid motions as columns, three shifts, three small turns about the origin."""
        motions = np.zeros((len(self.points), DOF, DOF))
        motions[:] = np.eye(DOF)
        for axis in range(3):
            turn = np.eye(3)[axis]
            motions[:, :3, 3 + axis] = np.cross(turn, self.points)
        return motions.reshape(self.size, DOF)
