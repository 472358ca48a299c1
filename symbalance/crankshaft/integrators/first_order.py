"""A periodic system as first-order equations y' = A(theta) y + g(theta), for general solvers.

A state is y = (x, x', z); z are the housings' displacements, stationary. They have no mass: with the
journals' displacements s, (C + C_B) z' = K (s - z) + C s' - K_B z.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from time import perf_counter
from typing import Any

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.integrators.coefficients import (
    diagonal,
    film_laws,
    gathered,
    housing_size,
    units,
)
from symbalance.crankshaft.system import PeriodicSystem
from symbalance.errors import MissingPartError, SymbalanceError, shown

INSTALL = "pip install 'symbalance[crankshaft]'"
SCIPY = {"rk45": "RK45", "dop853": "DOP853", "radau": "Radau", "bdf": "BDF", "lsoda": "LSODA"}
EXPLICIT = ("rk45", "dop853")
FLOOR = 1e-3
"""The absolute tolerance, as a share of the relative one times each kind of unknown's largest value."""
SPARSE = 0.2
"""The share of entries up to which a matrix is handled as sparse."""


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


def scipy_states(
    system: PeriodicSystem,
    method: str,
    theta: Array,
    start: Array,
    rtol: float,
    size: Array | None = None,
    limit: float = math.inf,
) -> Array:
    """Return the states (s, size) at angles (s,) from `start` at theta[0], by `method` of SciPy.

    `size` are the typical sizes of the states; by default those of the start. Raises `SymbalanceError`
    where the solver gives up, `TimeoutError` after `limit` seconds.
    """
    try:
        from scipy.integrate import solve_ivp
        from scipy.sparse import csc_array, csr_array
    except ImportError:
        raise MissingPartError(f"method = {method!r}", "SciPy is not installed", INSTALL) from None
    first, omega = FirstOrder.of(system), system.omega
    sparse = np.count_nonzero(first.constant) < SPARSE * first.constant.size
    packed = csc_array if sparse and method in ("radau", "bdf") else np.asarray
    extra: dict[str, Any] = (
        {} if method in EXPLICIT else {"jac": lambda t, _: packed(first.matrix(omega * t))}
    )
    first = replace(first, product=(csr_array(first.constant) if sparse else first.constant).__matmul__)
    until = perf_counter() + limit

    def slope(t: float, y: Array) -> Array:
        if perf_counter() > until:
            raise TimeoutError
        return first.slope(omega * t, y)

    scale = _scales(system, start if size is None else size)
    found = solve_ivp(
        slope,
        (theta[0] / omega, theta[-1] / omega),
        start,
        method=SCIPY[method],
        t_eval=theta / omega,
        rtol=rtol,
        atol=FLOOR * rtol * scale,
        **extra,
    )
    if not found.success:
        raise SymbalanceError(f"method = {shown(method)}", f"gave up: {found.message}", "another rtol")
    return found.y.T


def _scales(system: PeriodicSystem, size: Array) -> Array:
    """Return one size for each kind of unknown: displacements, velocities, housing states."""
    n, scale = system.size, np.empty(len(size))
    parts = (slice(0, n), slice(n, 2 * n), slice(2 * n, 2 * n + housing_size(system)))
    for part in parts:
        if size[part].size:
            scale[part] = np.abs(size[part]).max()
    return np.where(scale > 0, scale, 1e-9 * units(system))
