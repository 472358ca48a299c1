"""First-order form y' = A(theta) y + g(theta) of a rotor on its bearings, and SciPy's integrators on it.

A state is y = (x, x', z); z are the housings' displacements, stationary. They have no mass: with the
journals' displacements s, (C + C_B) z' = K (s - z) + C s' - K_B z.

SciPy's implicit methods get the exact Jacobian: sparse for Radau and BDF where it is (a crank of lumped
slices), as they then factor it sparse, dense for LSODA, whose alternative is a narrow band, which
housings and bearings break. The constant part of the slope is one sparse product; films, housings and
loads come from the system's own functions at every call.
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
    bearing_rows,
    block_matrix,
    film_laws,
    housing_size,
    state_units,
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
class FirstOrderForm:
    """The constant part of A, and the bearings' part at an angle."""

    system: PeriodicSystem
    constant: Array
    force_response: Array
    """-M^-1 B^T below zeros (2n, 2b): what forces on the films do to the rotor's state."""
    inverse_mass: Array
    product: Callable[[Array], Array]
    """The constant part times a vector."""

    @classmethod
    def of(cls, system: PeriodicSystem) -> FirstOrderForm:
        """Return the first-order form of a system."""
        n, points = system.size, bearing_rows(system)
        sides = np.hstack([system.stiffness, system.damping, points.T, np.eye(n)])
        accelerations = np.linalg.solve(system.mass, sides)
        constant = np.zeros((2 * n, 2 * n))
        constant[:n, n:], constant[n:] = np.eye(n), -accelerations[:, : 2 * n]
        force_response = np.vstack(
            [np.zeros((n, len(points))), -accelerations[:, 2 * n : 2 * n + len(points)]]
        )
        inverse = accelerations[:, 2 * n + len(points) :]
        return cls(system, cleaned(constant), force_response, inverse, constant.__matmul__)

    @property
    def size(self) -> int:
        """The length of y."""
        return len(self.constant) + housing_size(self.system)

    def bearings(self, theta: float) -> tuple[Array, Array]:
        """Return b = P (B x, B x', z) in turning axes, (2b, 6b or 4b), and the rates z' likewise."""
        per_film, per_rate = film_laws(self.system, np.array([theta]))
        return block_matrix(per_film[0]), block_matrix(per_rate[0])

    def matrix(self, theta: float) -> Array:
        """Return A(theta), dense."""
        n, points = self.system.size, bearing_rows(self.system)
        count, size = len(points), self.size
        force, rate = self.bearings(theta)
        full = np.zeros((size, size))
        full[: 2 * n, : 2 * n] = self.constant
        full[n : 2 * n, :n] += self.force_response[n:] @ force[:, :count] @ points
        full[n : 2 * n, n : 2 * n] += self.force_response[n:] @ force[:, count : 2 * count] @ points
        full[n : 2 * n, 2 * n :] = self.force_response[n:] @ force[:, 2 * count :]
        full[2 * n :, :n] = rate[:, :count] @ points
        full[2 * n :, n : 2 * n] = rate[:, count : 2 * count] @ points
        full[2 * n :, 2 * n :] = rate[:, 2 * count :]
        return full

    def slope(self, theta: float, state: Array) -> Array:
        """Return y' at an angle: the products, without the matrix."""
        n, points = self.system.size, bearing_rows(self.system)
        force, rate = self.bearings(theta)
        journals = np.concatenate([points @ state[:n], points @ state[n : 2 * n], state[2 * n :]])
        rates = self.product(state[: 2 * n]) + self.force_response @ (force @ journals)
        rates[n:] += self.inverse_mass @ self.system.force(np.array([theta]))[0]
        return np.concatenate([rates, rate @ journals])


def cleaned(matrix: Array) -> Array:
    """Return a matrix with the rounding taken out: entries below 1e-17 of their row's largest."""
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
    first, omega = FirstOrderForm.of(system), system.omega
    sparse = np.count_nonzero(first.constant) < SPARSE * first.constant.size
    as_matrix = csc_array if sparse and method in ("radau", "bdf") else np.asarray
    extra: dict[str, Any] = (
        {} if method in EXPLICIT else {"jac": lambda t, _: as_matrix(first.matrix(omega * t))}
    )
    first = replace(first, product=(csr_array(first.constant) if sparse else first.constant).__matmul__)
    until = perf_counter() + limit

    def slope(t: float, y: Array) -> Array:
        if perf_counter() > until:
            raise TimeoutError
        return first.slope(omega * t, y)

    scale = _scales(system, start if size is None else size)
    solution = solve_ivp(
        slope,
        (theta[0] / omega, theta[-1] / omega),
        start,
        method=SCIPY[method],
        t_eval=theta / omega,
        rtol=rtol,
        atol=FLOOR * rtol * scale,
        **extra,
    )
    if not solution.success:
        raise SymbalanceError(f"method = {shown(method)}", f"gave up: {solution.message}", "another rtol")
    return solution.y.T


def _scales(system: PeriodicSystem, size: Array) -> Array:
    """Return one size for each kind of unknown: displacements, velocities, housing states."""
    n, scale = system.size, np.empty(len(size))
    parts = (slice(0, n), slice(n, 2 * n), slice(2 * n, 2 * n + housing_size(system)))
    for part in parts:
        if size[part].size:
            scale[part] = np.abs(size[part]).max()
    return np.where(scale > 0, scale, 1e-9 * state_units(system))
