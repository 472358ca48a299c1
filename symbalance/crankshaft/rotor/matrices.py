"""A crankshaft as nodes and matrices in coordinates that turn with it.

At a node, in this order: u, v, w, theta_u, theta_v, theta_w. For constant speed omega and no bearings,

    M x'' + (C + omega G) x' + (K + omega^2 dK) x = F + omega^2 F_M.

The matrices are dense: a crank has some hundred unknowns.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from symbalance.crankshaft.arguments import check_kind
from symbalance.crankshaft.arrays import DOF, Array


@dataclass(frozen=True)
class Hanging:
    """What hangs on a web, at a `node` of its own: `stiffness` (18, 18) of front, rear and that node.

    `in_front`: it hangs on the web's front end, so that its weight does not pass the web's middle.
    """

    node: int
    stiffness: Array
    in_front: bool


@dataclass(frozen=True)
class Member:
    """An elastic element between two nodes, kept so that section loads follow from displacements.

    `stiffness` is 12 x 12 in U, V, W axes; `kind` is journal, web, pin or shaft, `index` the place of its
    part in the crank's chain (-1: a shaft at an end). What `hangs` on a web is a third node; `stiffness`
    is then that of the two ends with nothing pulling there.
    """

    front: int
    rear: int
    stiffness: Array
    kind: str
    index: int
    hangs: Hanging | None = None

    @property
    def nodes(self) -> tuple[int, ...]:
        """The nodes: front, rear, and what hangs between."""
        return (self.front, self.rear) if self.hangs is None else (self.front, self.rear, self.hangs.node)

    @property
    def whole(self) -> Array:
        """The stiffness of all `nodes`: 12 x 12, or 18 x 18."""
        return self.stiffness if self.hangs is None else self.hangs.stiffness


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

    def passing(self, member: Member) -> Array:
        """Return (6, n): what the part in front of a member's middle bears on the part behind it.

        Per displacement; forces, and moments about the front node. What the member itself weighs is left
        out, what hangs on it counts with the end it hangs on.
        """
        loads = member.whole[:DOF].copy()
        if member.hangs is not None and member.hangs.in_front:
            lever = self.points[member.hangs.node] - self.points[member.front]
            pull = member.whole[2 * DOF :]
            loads += pull
            loads[3:] += np.cross(lever, pull[:3], axisb=0, axisc=0)
        rows = np.zeros((DOF, self.size))
        for place, node in enumerate(member.nodes):
            rows[:, DOF * node : DOF * node + DOF] += loads[:, DOF * place : DOF * place + DOF]
        return rows

    def rigid_motions(self) -> Array:
        """Return the six rigid motions as columns, three shifts, three small turns about the origin."""
        motions = np.zeros((len(self.points), DOF, DOF))
        motions[:] = np.eye(DOF)
        for axis in range(3):
            turn = np.eye(3)[axis]
            motions[:, :3, 3 + axis] = np.cross(turn, self.points)
        return motions.reshape(self.size, DOF)


def check_rotor(value: object) -> None:
    """Refuse what is no rotor: a crank or a shaft must have been assembled to one."""
    check_kind(value, Rotor, "rotor", "sb.assemble(crank) or sb.shaft(tubes) makes one")
