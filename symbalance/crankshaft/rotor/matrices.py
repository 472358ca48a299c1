"""A rotor, cranked or straight, as nodes and matrices in coordinates that turn with it.

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
class AttachedBody:
    """A body attached to a web at a `node` of its own: `stiffness` (18, 18) of front, rear, that node.

    `in_front`: it sits on the web's front end, so that its inertia forces do not pass the web's middle.
    """

    node: int
    stiffness: Array
    in_front: bool


@dataclass(frozen=True)
class Member:
    """An elastic element between two nodes, from which section loads follow for given displacements.

    `stiffness` is 12 x 12 in U, V, W axes; `kind` is journal, web, pin or shaft, `index` the place of its
    part in the crank's chain (-1: a shaft at an end). A `body` attached to a web is a third node;
    `stiffness` is then that of the two ends with no force on it.
    """

    front: int
    rear: int
    stiffness: Array
    kind: str
    index: int
    body: AttachedBody | None = None

    @property
    def nodes(self) -> tuple[int, ...]:
        """The nodes: front, rear, and that of an attached body."""
        return (self.front, self.rear) if self.body is None else (self.front, self.rear, self.body.node)

    @property
    def whole(self) -> Array:
        """The stiffness of all `nodes`: 12 x 12, or 18 x 18."""
        return self.stiffness if self.body is None else self.body.stiffness


@dataclass(frozen=True)
class Rotor:
    """A free rotor. `points` (n, 3) are the nodes' U, V, W in m; matrices are (6n, 6n), SI.

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
        """Return (6, n): the load of the part in front of a member's middle on the part behind it.

        Per displacement; forces, and moments about the front node. The member's own inertia is left
        out; an attached body counts with the end that carries it.
        """
        loads = member.whole[:DOF].copy()
        if member.body is not None and member.body.in_front:
            lever = self.points[member.body.node] - self.points[member.front]
            pull = member.whole[2 * DOF :]
            loads += pull
            loads[3:] += np.cross(lever, pull[:3], axisb=0, axisc=0)
        rows = np.zeros((DOF, self.size))
        for place, node in enumerate(member.nodes):
            rows[:, DOF * node : DOF * node + DOF] += loads[:, DOF * place : DOF * place + DOF]
        return rows

    def rigid_motions(self) -> Array:
        """Return the six rigid-body motions as columns: three shifts, three turns about the origin."""
        motions = np.zeros((len(self.points), DOF, DOF))
        motions[:] = np.eye(DOF)
        for axis in range(3):
            turn = np.eye(3)[axis]
            motions[:, :3, 3 + axis] = np.cross(turn, self.points)
        return motions.reshape(self.size, DOF)


def check_rotor(value: object) -> None:
    """Refuse what is no rotor: a crank or a shaft must have been assembled to one."""
    check_kind(
        value,
        Rotor,
        "rotor",
        "sb.crankshaft.assemble(crank) or sb.crankshaft.rotor.shaft(tubes) makes one",
    )
