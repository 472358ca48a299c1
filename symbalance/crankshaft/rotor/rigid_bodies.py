"""Mass, gyroscopic and centrifugal matrices of rigid bodies at nodes of a turning rotor.

A body of mass m sits at a node (U, V, W) of axes that turn about W; its mass centre is e from the node
and I is its inertia tensor about that centre. With [a] the matrix of a x, w the unit vector along W,
P = diag(1, 1, 0), J = I - m [e][e] the tensor about the node, c = P ((U, V, W) + e), h = I w,

    M   = | m 1      -m [e] |      G = | 2 m [w]          -2 m [w][e]                        |
          | m [e]     J     |          | 2 m [e][w]       tr(I) [w] - 2 [h] - 2 m [e][w][e]  |

    dK  = | -m P      m P [e]                                                                |
          | -m [e] P  [w] I [w] + m [e] P [e] - sym(h, w) + h.w 1 - m sym(c, e) + m c.e 1    |

    F_M = ( m c,  m e x c - w x h ),       sym(a, b) = (a b^T + b a^T)/2.

The coordinates are a shift and a rotation vector. Derived in `symbalance.crankshaft.equations`, which
the tests compare with; signs as in M x'' + omega G x' + omega^2 dK x = F + omega^2 F_M.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.rotor.parts import Disc

AXIS: Array = np.array([0.0, 0.0, 1.0])
ACROSS: Array = np.diag([1.0, 1.0, 0.0])


def skew_matrix(vector: ArrayLike) -> Array:
    """Return [a], the skew matrix with [a] b = a x b; shape (..., 3) to (..., 3, 3).

    >>> skew_matrix([1.0, 2.0, 3.0]) @ [0.0, 0.0, 1.0]
    array([ 2., -1.,  0.])
    """
    return -np.cross(np.asarray(vector, dtype=float)[..., None, :], np.eye(3), axis=-1)


def node_matrices(
    mass: float, offset: ArrayLike, inertia: ArrayLike, point: ArrayLike = (0.0, 0.0, 0.0)
) -> tuple[Array, Array, Array]:
    """Return M, G and dK (6 x 6) of a rigid body at a node: kg, m, kg m^2.

    `offset` (3,) leads from the node to the mass centre, `inertia` (3, 3) is the tensor about that
    centre in U, V, W, products of inertia with their minus sign. `point` (3,) is the node's place: it
    matters to dK only, and only where there is an offset (the centrifugal force then has an arm that
    turns with the node).

    The paper's node, M, I_u, I_v, I_w:

    >>> M, G, dK = node_matrices(2.0, (0, 0, 0), np.diag([3.0, 4.0, 6.0]))
    >>> M.diagonal(), dK.diagonal() + 0.0
    (array([2., 2., 2., 3., 4., 6.]), array([-2., -2.,  0.,  2.,  3.,  0.]))
    >>> float(G[0, 1]), float(G[3, 4])
    (-4.0, -1.0)
    """
    e, tensor, across = skew_matrix(offset), np.asarray(inertia, dtype=float), ACROSS
    turn, arm = skew_matrix(AXIS), tensor @ AXIS
    centre = across @ (np.asarray(point, dtype=float) + np.asarray(offset, dtype=float))
    M = _blocks(mass * np.eye(3), -mass * e, tensor - mass * e @ e)
    spin = np.trace(tensor) * turn - 2 * skew_matrix(arm)
    G = _blocks(2 * mass * turn, -2 * mass * turn @ e, spin - 2 * mass * e @ turn @ e, sign=-1)
    load = _stiffening(arm, AXIS) + mass * _stiffening(centre, offset)
    dK = _blocks(-mass * across, mass * across @ e, turn @ tensor @ turn + mass * e @ across @ e + load)
    return M, G, dK


def node_force(mass: float, point: ArrayLike, offset: ArrayLike, inertia: ArrayLike) -> Array:
    """Return F_M (6,): the centrifugal force and couple of the same body, per omega^2; kg m, kg m^2.

    >>> node_force(2.0, (0.1, 0, 0.5), (0, 0, 0.2), np.diag([3.0, 4.0, 6.0])).round(12) + 0.0
    array([0.2 , 0.  , 0.  , 0.  , 0.04, 0.  ])
    """
    centre = ACROSS @ (np.asarray(point, dtype=float) + np.asarray(offset, dtype=float))
    couple = mass * np.cross(np.asarray(offset, dtype=float), centre)
    couple -= np.cross(AXIS, np.asarray(inertia, dtype=float) @ AXIS)
    return np.concatenate([mass * centre, couple])


def _stiffening(one: ArrayLike, other: ArrayLike) -> Array:
    """Return a.b 1 - (a b^T + b a^T)/2: the second derivative of -a.(t x (t x b))/2 by t."""
    product = np.multiply.outer(np.asarray(one), np.asarray(other))
    return np.trace(product) * np.eye(3) - (product + product.T) / 2


def _blocks(shift: Array, coupling: Array, turning: Array, sign: int = 1) -> Array:
    """Return the 6 x 6 matrix of these blocks, symmetric or (sign -1) skew."""
    whole = np.empty((DOF, DOF))
    whole[:3, :3], whole[:3, 3:] = shift, coupling
    whole[3:, :3], whole[3:, 3:] = sign * coupling.T, turning
    return whole


@dataclass(frozen=True)
class RigidBody:
    """A rigid body: mass, `offset` (3,) from node to mass centre, `inertia` (3, 3) about that centre."""

    mass: float
    offset: Array
    inertia: Array

    def turned(self, angle: float) -> RigidBody:
        """Return the body turned by `angle` about W."""
        turn = turn_about_w(angle)
        return RigidBody(self.mass, turn @ self.offset, turn @ self.inertia @ turn.T)

    def mirrored(self) -> RigidBody:
        """Return the body reflected front to rear."""
        flip = np.diag([1.0, 1.0, -1.0])
        return RigidBody(self.mass, flip @ self.offset, flip @ self.inertia @ flip)

    def shifted(self, lever: Array) -> RigidBody:
        """Return the same body about a node that lies `lever` before the old one."""
        return RigidBody(self.mass, self.offset + lever, self.inertia)


def turn_about_w(angle: float) -> Array:
    """Return the rotation (3, 3) by `angle` radians about W.

    >>> turn_about_w(np.pi / 2).round(12) @ [1.0, 0.0, 0.0]
    array([0., 1., 0.])
    """
    cos, sin = np.cos(angle), np.sin(angle)
    return np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])


def disc_body(disc: Disc) -> RigidBody:
    """Return a disc as a body centred on its node.

    >>> disc_body(Disc(2.0, 3.0, 4.0)).inertia.diagonal()
    array([4., 4., 3.])
    """
    return RigidBody(disc.mass, np.zeros(3), np.diag([disc.diametral, disc.diametral, disc.polar]))


def ring(area: float, radius: float, place: float, density: float) -> RigidBody:
    """Return a thin ring about W of cross-section `area` and mean `radius`, `place` along W."""
    mass = 2 * np.pi * radius * area * density
    about = mass * radius**2
    return RigidBody(mass, np.array([0.0, 0.0, place]), np.diag([about / 2, about / 2, about]))
