"""SciPy's integrators on the first-order equations, with the settings that suit each.

The implicit ones get the exact Jacobian, dense: M^-1 S of a chain of consistent beams is full. The linear
part is one product; films, housings and loads come from the system's own functions at every call.
"""

from __future__ import annotations

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


def scipy_states(
    system: PeriodicSystem, method: str, theta: Array, start: Array, rtol: float, size: Array | None = None
) -> Array:
    """Return the states (s, size) at angles (s,) from `start` at theta[0], by `method` of SciPy.

    `size` are the typical sizes of the states; by default those of the start. Raises `SymbalanceError`
    where the solver gives up.
    """
    try:
        from scipy.integrate import solve_ivp
    except ImportError:
        raise MissingPartError(f"method = {method!r}", "SciPy is not installed", INSTALL) from None
    first, omega = FirstOrder.of(system), system.omega
    extra = {} if method in EXPLICIT else {"jac": lambda t, _: first.matrix(omega * t)}
    scale = _scales(system, start if size is None else size)
    found = solve_ivp(
        lambda t, y: first.slope(omega * t, y),
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
