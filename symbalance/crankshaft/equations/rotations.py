"""Matrices of small rotations to the second order, for a rotation vector and six orders of Cardan angles.

The first order is the same for all. The second is not, and enters the linear equations wherever a force
or couple stands at rest: there the choice of coordinates is part of what a coefficient means.
"""

from __future__ import annotations

from itertools import permutations

from symbalance.crankshaft.equations.quantities import (
    RING,
    TURN,
    RingElement,
    RingMatrix,
    matrix_product,
    ring_elements,
    ring_sum,
)
from symbalance.errors import SymbalanceError, shown

CARDAN = tuple("".join(order) for order in permutations("uvw"))
ROTATIONS = ("vector", *CARDAN)


def rotation_rows(kind: str) -> RingMatrix:
    """Return a small rotation as a matrix that takes body axes to those of the frame, second order.

    "vector" is 1 + [t] + [t][t]/2 for the rotation vector t; "uvw" the product R_u R_v R_w of turns
    about the frame's axes U, V, W (applied from the right), and so for the other orders.

    >>> rotation_rows("uvw")[0][1], rotation_rows("wvu")[0][1]
    (-theta_w, theta_u*theta_v - theta_w)
    """
    angles = dict(zip("uvw", ring_elements(TURN), strict=True))
    if kind == "vector":
        return _exponential([_axis_rows(axis, angle) for axis, angle in angles.items()])
    if kind not in CARDAN:
        names = ", ".join(ROTATIONS)
        raise SymbalanceError(f"rotation = {shown(kind)}", "is unknown", f"known: {names}")
    first, second, third = (_exponential([_axis_rows(axis, angles[axis])]) for axis in kind)
    return matrix_product(matrix_product(first, second), third)


def _axis_rows(axis: str, angle: RingElement) -> RingMatrix:
    """Return the skew matrix of a vector of this length along an axis."""
    rows = [[RING.zero] * 3 for _ in range(3)]
    i, j = {"u": (1, 2), "v": (2, 0), "w": (0, 1)}[axis]
    rows[i][j], rows[j][i] = -angle, angle
    return rows


def _exponential(generators: list[RingMatrix]) -> RingMatrix:
    """Return 1 + S + S S/2 for the sum S of skew matrices."""
    rows = zip(*generators, strict=True)
    skew = [[ring_sum(cells) for cells in zip(*row, strict=True)] for row in rows]
    square = matrix_product(skew, skew)
    one = [[RING.one if i == j else RING.zero for j in range(3)] for i in range(3)]
    return [[one[i][j] + skew[i][j] + square[i][j] / 2 for j in range(3)] for i in range(3)]
