"""SciPy's integrators on the first-order equations, with the settings that suit each.

The implicit ones get the exact Jacobian: sparse for Radau and BDF where it is (a crank of lumped
slices), as they then factor it sparse, dense for LSODA, whose alternative is a narrow band, which
housings and bearings break. The constant part of the slope is one sparse product; films, housings and
loads come from the system's own functions at every call.
"""

from __future__ import annotations

import math
from dataclasses import replace
from time import perf_counter
from typing import Any

import numpy as np

from symbalance.crankshaft.integrators.coefficients import housing_size, units
from symbalance.crankshaft.integrators.first_order import FirstOrder
from symbalance.crankshaft.rotor import Array
from symbalance.crankshaft.system import PeriodicSystem
from symbalance.errors import MissingPartError, SymbalanceError, shown

INSTALL = "pip install 'symbalance[crankshaft]'"
SCIPY = {"rk45": "RK45", "dop853": "DOP853", "radau": "Radau", "bdf": "BDF", "lsoda": "LSODA"}
EXPLICIT = ("rk45", "dop853")
FLOOR = 1e-3
"""The absolute tolerance, as a share of the relative one times each kind of unknown's largest value."""
SPARSE = 0.2
"""The share of entries up to which a matrix is handled as sparse."""


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
