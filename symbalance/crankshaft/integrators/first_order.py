"""A periodic system as first-order equations y' = A(theta) y + g(theta), for general solvers.

A state is y = (x, x', z); z are the housings' displacements, stationary. They have no mass: with the
journals' displacements s, (C + C_B) z' = K (s - z) + C s' - K_B z.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from symbalance.crankshaft.integrators.coefficients import coefficients, gathered, housing_size
from symbalance.crankshaft.rotor import Array
from symbalance.crankshaft.system import PeriodicSystem


@dataclass(frozen=True)
class FirstOrder:
    """The constant part of A, and what the bearings add to it at an angle."""

    system: PeriodicSystem
    constant: Array
    spread: Array
    """-M^-1 B^T below zeros (2n, 2b): what forces on the films do to the rotor's state."""
    inverse_mass: Array
    product: Callable[[Array], Array]
    """The constant part times a vector."""

    @classmethod
    def of(cls, system: PeriodicSystem) -> FirstOrder:
        """Return the first-order form of a system."""
        n, points = system.size, gathered(system)
        sides = np.hstack([system.stiffness, system.damping, points.T, np.eye(n)])
        solved = np.linalg.solve(system.mass, sides)
        constant = np.zeros((2 * n, 2 * n))
        constant[:n, n:], constant[n:] = np.eye(n), -solved[:, : 2 * n]
        spread = np.vstack([np.zeros((n, len(points))), -solved[:, 2 * n : 2 * n + len(points)]])
        inverse = solved[:, 2 * n + len(points) :]
        return cls(system, cleaned(constant), spread, inverse, constant.__matmul__)

    @property
    def size(self) -> int:
        """The length of y."""
        return len(self.constant) + housing_size(self.system)

    def bearings(self, theta: float) -> tuple[Array, Array]:
        """Return b = P (B x, B x', z) in turning axes, (2b, 6b or 4b), and the rates z' likewise."""
        per_film, per_rate = film_laws(self.system, np.array([theta]))
        return diagonal(per_film[0]), diagonal(per_rate[0])

    def matrix(self, theta: float) -> Array:
        """Return A(theta), dense."""
        n, points = self.system.size, gathered(self.system)
        count, size = len(points), self.size
        force, rate = self.bearings(theta)
        full = np.zeros((size, size))
        full[: 2 * n, : 2 * n] = self.constant
        full[n : 2 * n, :n] += self.spread[n:] @ force[:, :count] @ points
        full[n : 2 * n, n : 2 * n] += self.spread[n:] @ force[:, count : 2 * count] @ points
        full[n : 2 * n, 2 * n :] = self.spread[n:] @ force[:, 2 * count :]
        full[2 * n :, :n] = rate[:, :count] @ points
        full[2 * n :, n : 2 * n] = rate[:, count : 2 * count] @ points
        full[2 * n :, 2 * n :] = rate[:, 2 * count :]
        return full

    def slope(self, theta: float, state: Array) -> Array:
        """Return y' at an angle: the products, without the matrix."""
        n, points = self.system.size, gathered(self.system)
        force, rate = self.bearings(theta)
        seen = np.concatenate([points @ state[:n], points @ state[n : 2 * n], state[2 * n :]])
        moved = self.product(state[: 2 * n]) + self.spread @ (force @ seen)
        moved[n:] += self.inverse_mass @ self.system.force(np.array([theta]))[0]
        return np.concatenate([moved, rate @ seen])


def cleaned(matrix: Array) -> Array:
    """Return a matrix without what rounding left in it: entries below 1e-17 of their row's largest."""
    largest = np.abs(matrix).max(axis=1, keepdims=True)
    return np.where(np.abs(matrix) > 1e-17 * largest, matrix, 0.0)


def film_laws(system: PeriodicSystem, theta: Array) -> tuple[Array, Array]:
    """Return, per angle and bearing, the film's force in turning axes and z' per (d, d', z).

    Shapes (s, b, 2, 6) and (s, b, 2, 6); without a housing (s, b, 2, 4) and (s, b, 0, 4). Where neither
    film nor housing damps a direction, its z follows without delay and this form does not exist: the
    least-squares rate is taken, right for z' = 0.
    """
    at = coefficients(system, theta)
    back = np.swapaxes(at.turn, -1, -2)[:, None]
    direct = np.concatenate([at.stiffness, at.damping], axis=-1)
    if system.housing is None:
        return back @ direct, np.zeros((*direct.shape[:2], 0, 4))
    stiffness = np.broadcast_to(system.housing.stiffness, at.film_stiffness.shape)
    inverse = np.linalg.pinv(at.film_damping + system.housing.damping)
    rate = inverse @ np.concatenate([direct, -at.film_stiffness - stiffness], axis=-1)
    film = np.concatenate([direct, -at.film_stiffness], axis=-1) - at.film_damping @ rate
    return back @ film, rate


def film_forces(system: PeriodicSystem, theta: Array, states: Array) -> Array:
    """Return the bearings' forces on the shaft, stationary axes, (s, b, 2), of states (s, size)."""
    n, count = system.size, len(system.points)
    laws, _ = film_laws(system, theta)
    place = np.einsum("bcn,sn->sbc", system.points, states[:, :n])
    speed = np.einsum("bcn,sn->sbc", system.points, states[:, n : 2 * n])
    rest = states[:, 2 * n :].reshape(len(theta), count, -1)
    turning = laws @ np.concatenate([place, speed, rest], axis=-1)[..., None]
    return -(coefficients(system, theta).turn[:, None] @ turning)[..., 0]


def diagonal(laws: Array) -> Array:
    """Return one angle's (b, r, 2 k) as one matrix (b r, k 2b), columns by kind, then bearing."""
    count, rows, columns = laws.shape
    full = np.zeros((count, rows, columns // 2, count, 2))
    for j in range(count):
        full[j, :, :, j, :] = laws[j].reshape(rows, columns // 2, 2)
    return full.reshape(count * rows, columns * count)
