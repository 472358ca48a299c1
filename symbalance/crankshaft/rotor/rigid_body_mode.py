"""The rigid-body rotation of a rotor about its axis, falsely unstable in linear equations: two remedies.

A rotor turned as a whole about W by a small angle is as much in equilibrium as before. The linear
equations do not know: they turn the shape, phi = (-V, U, 0, 0, 0, 1) at every node, but not the stresses
that balance the centrifugal forces (their geometric stiffness, omega^2 K_g, is left out of K), and

    phi^T (K + omega^2 dK) phi = -omega^2 sum m (U^2 + V^2) < 0 = phi^T G phi:

a divergence at the rate omega sqrt(sum m (U^2 + V^2)/J), J = phi^T M phi, that no real shaft has. Either
one unknown is taken out (`without_unknown`: the flywheel then turns at exactly constant speed, as the
paper has it), or the false stiffness is (`deflated`): dK becomes P^T dK P with P = 1 - phi (M phi)^T/J,
symmetric, dK phi = 0.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.errors import SymbalanceError, shown


def spin_motion(points: ArrayLike) -> Array:
    """Return phi (6n,), the turn by one radian about the W axis, for nodes at `points` (n, 3).

    >>> spin_motion([[0.06, 0.0, 0.1]])
    array([-0.  ,  0.06,  0.  ,  0.  ,  0.  ,  1.  ])
    """
    places = np.asarray(points, dtype=float)
    motion = np.zeros((len(places), DOF))
    motion[:, 0], motion[:, 1], motion[:, 5] = -places[:, 1], places[:, 0], 1.0
    return motion.ravel()


def deflated(centrifugal: Array, mass: Array, spin: Array) -> Array:
    """Return P^T dK P, P = 1 - phi (M phi)^T/J: the centrifugal matrix with nothing along the rotation.

    Symmetric where dK is, the same on every motion without angular momentum about the axis.

    >>> deflated(np.diag([-1.0, -1.0]), np.eye(2), np.array([1.0, 0.0]))
    array([[ 0.,  0.],
           [ 0., -1.]])
    """
    momentum = mass @ spin
    inertia = float(spin @ momentum)
    if not inertia > 0:
        what = f"moment of inertia about the axis = {shown(inertia)}"
        raise SymbalanceError(what, "must be positive", "a mass matrix in kg, m, and the motion it turns")
    rest = np.eye(len(spin)) - np.outer(spin, momentum) / inertia
    return rest.T @ centrifugal @ rest


def spin_growth(centrifugal: Array, mass: Array, spin: Array) -> float:
    """Return the rate at which the rotation falsely diverges, per omega: sqrt(-phi^T dK phi/J).

    >>> spin_growth(np.diag([-0.25, 0.0]), np.eye(2), np.array([1.0, 0.0]))
    0.5
    """
    return float(np.sqrt(max(0.0, -(spin @ centrifugal @ spin) / (spin @ mass @ spin))))


def without_unknown(matrix: Array, unknown: int) -> Array:
    """Return a matrix without the row and column of one unknown: the flywheel's theta_w, say.

    >>> without_unknown(np.diag([1.0, 2.0, 3.0]), 1)
    array([[1., 0.],
           [0., 3.]])
    """
    return np.delete(np.delete(matrix, unknown, axis=0), unknown, axis=1)
