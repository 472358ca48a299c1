"""Motion of a crankshaft on its bearings from an initial state, by fixed steps or by SciPy."""

from __future__ import annotations

from time import perf_counter

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.integrators.coefficients import film_forces, state_size
from symbalance.crankshaft.integrators.first_order import SCIPY, scipy_states
from symbalance.crankshaft.integrators.methods import FIXED, linear_steps
from symbalance.crankshaft.system import PeriodicSystem, Trajectory, check_consistency, check_steps
from symbalance.errors import SymbalanceError, brief

METHODS = (*FIXED, *SCIPY)


def integrate(
    system: PeriodicSystem,
    *,
    method: str = "radau-iia",
    steps: int = 720,
    cycles: int = 1,
    start: Array | None = None,
    rtol: float = 1e-6,
) -> Trajectory:
    """Return displacements, velocities and bearing forces over `cycles` cycles from 0, both ends in.

    `start` is a state (x, x', z), rest by default; z are the housings' displacements, stationary.
    `steps` a cycle are taken by the fixed-step methods, and returned by SciPy's, which keep to `rtol`.
    """
    if method not in METHODS:
        raise SymbalanceError(
            f"method = {brief(method)!r}", "is not known", f"one of {', '.join(METHODS)}"
        )
    check_steps(steps)
    check_consistency(system)
    if not isinstance(cycles, int | np.integer) or cycles < 1:
        raise SymbalanceError(f"cycles = {brief(cycles)}", "must be a whole number, at least 1")
    if not 0 < rtol < 1:
        raise SymbalanceError(f"rtol = {brief(rtol)}", "must lie between 0 and 1", "1e-6 is usual")
    size = state_size(system)
    state = np.zeros(size) if start is None else np.asarray(start, dtype=float)
    if state.shape != (size,) or not np.isfinite(state).all():
        rule = f"must be {size} finite numbers"
        raise SymbalanceError(
            f"start of shape {state.shape}", rule, "displacements, velocities, housings"
        )
    begin = perf_counter()
    theta = system.cycle / steps * np.arange(cycles * steps + 1)
    if method in FIXED:
        states = linear_steps(system, method, steps).march(state, cycles)
    else:
        states = scipy_states(system, method, theta, state, rtol)
    forces = film_forces(system, theta, states)
    n, seconds = system.size, perf_counter() - begin
    return Trajectory(theta, states[:, :n], states[:, n : 2 * n], forces, seconds=seconds)
