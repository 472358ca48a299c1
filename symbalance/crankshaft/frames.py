"""Bearing matrices and vectors transformed between stationary axes and axes that turn with the crank.

With Q = R(theta) = [cos, -sin; sin, cos] a journal's displacement is (vertical, lateral) = Q (u, v), and
Q' = omega Q S with S = [0, -1; 1, 0] gives its stationary velocity Q (u', v') + omega Q S (u, v). So a
bearing with stationary stiffness K and damping C acts on the shaft, in turning axes, as

    -(Q^T C Q) (u', v') - (Q^T K Q + omega Q^T C Q S) (u, v):

stationary damping brings a circulatory stiffness, which an isotropic C makes skew: c omega S.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from symbalance.crankshaft.arrays import Array

QUARTER_TURN: Array = np.array([[0.0, -1.0], [1.0, 0.0]])
"""S, a quarter of a turn from U towards V: S = R(pi/2), and R' = omega R S."""

GRAVITY = 9.80665
"""Standard acceleration of free fall, m/s^2 (3rd CGPM, 1901)."""


def rotation(theta: ArrayLike) -> Array:
    """Return R(theta), which takes (u, v) to (vertical, lateral); shape of theta + (2, 2).

    >>> rotation(np.pi / 2).round(12) + 0.0
    array([[ 0., -1.],
           [ 1.,  0.]])
    """
    cosine, sine = np.cos(theta), np.sin(theta)
    rows = [np.stack([cosine, -sine], axis=-1), np.stack([sine, cosine], axis=-1)]
    return np.stack(rows, axis=-2)


def turned_damping(damping: ArrayLike, theta: ArrayLike) -> Array:
    """Return Q^T C Q in turning axes: C (..., b, 2, 2) stationary, theta (s,); gives (s, b, 2, 2).

    C is (b, 2, 2), one value for all angles, or (s, b, 2, 2). With (2, 2) and one angle: (2, 2).

    >>> turned_damping([[3.0, 0.0], [0.0, 1.0]], np.pi / 2).round(12) + 0.0
    array([[1., 0.],
           [0., 3.]])
    """
    matrix = np.asarray(damping, dtype=float)
    angles = np.asarray(theta, dtype=float)
    turn = rotation(angles.reshape(angles.shape + (1,) * (matrix.ndim > 2)))
    return np.swapaxes(turn, -1, -2) @ matrix @ turn


def turned_stiffness(stiffness: ArrayLike, damping: ArrayLike, theta: ArrayLike, omega: float) -> Array:
    """Return Q^T K Q + omega Q^T C Q S in turning axes, shapes as in `turned_damping`; N/m.

    >>> turned_stiffness(np.eye(2), 5 * np.eye(2), 0.0, 2.0)
    array([[  1., -10.],
           [ 10.,   1.]])
    """
    circulatory = turned_damping(damping, theta) @ QUARTER_TURN
    return turned_damping(stiffness, theta) + omega * circulatory


def turned_vectors(vectors: ArrayLike, theta: ArrayLike) -> Array:
    """Return Q^T f: stationary vectors (..., b, 2) or (s, b, 2), theta (s,), in turning axes.

    >>> turned_vectors([1.0, 0.0], np.pi / 2).round(12)
    array([ 0., -1.])
    """
    array = np.asarray(vectors, dtype=float)
    angles = np.asarray(theta, dtype=float)
    turn = rotation(angles.reshape(angles.shape + (1,) * (array.ndim > 1)))
    return (np.swapaxes(turn, -1, -2) @ array[..., None])[..., 0]


def gravity(theta: ArrayLike) -> Array:
    """Return the acceleration of free fall along U, V, W: g (-cos, sin, 0), shape of theta + (3,).

    >>> gravity(np.pi / 2).round(5) + 0.0
    array([0.     , 9.80665, 0.     ])
    """
    angles = np.asarray(theta, dtype=float)
    return GRAVITY * np.stack([-np.cos(angles), np.sin(angles), np.zeros_like(angles)], axis=-1)
