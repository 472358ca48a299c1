"""The periodic steady state of a crankshaft on its bearings, by shooting, and its Floquet multipliers.

A cycle takes the state s at its start to Psi s + r, exactly linearly. The periodic state solves
(1 - Psi) s = r; the eigenvalues of Psi, the multipliers, say by what factor a deviation grows in a cycle:
the engine is stable where all are less than 1 in size. Eigenvalues at a frozen crank angle say nothing.
"""

from __future__ import annotations

from dataclasses import replace
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symbalance.crankshaft.integrators.first_order import film_forces
from symbalance.crankshaft.integrators.marching import LinearSteps
from symbalance.crankshaft.integrators.methods import linear_steps
from symbalance.crankshaft.krylov import leading, solved
from symbalance.crankshaft.rotor import Array
from symbalance.crankshaft.system import PeriodicSystem, Trajectory, UnsolvedError
from symbalance.errors import SymbalanceError, shown

DENSE = 320
"""States up to which the whole monodromy matrix is made; beyond, its action on a Krylov space."""
CLOSED = 1e-6
UNBOUNDED = 1e6
"""A steady state this much larger than what one cycle makes from rest has no damping to speak of."""
MOST_STEPS = 46080


def steady_state(
    system: PeriodicSystem,
    *,
    method: str = "radau-iia",
    steps: int = 720,
    tolerance: float | None = None,
    multipliers: bool = True,
) -> Trajectory:
    """Return the periodic steady state over one cycle, at `steps` equal angles from 0, the end left out.

    `method` is one of `FIXED`: radau-iia (order 5), radau-iia-9, newmark. With a `tolerance` the
    steps are doubled until the displacements' relative change, over 7, is below it; `error` holds
    that estimate, else NaN. `multipliers` are sorted by size, largest first (the largest dozen for
    systems beyond `DENSE` states). Refuses a system without a periodic state: a mean load unheld.
    """
    if tolerance is not None and not tolerance > 0:
        raise SymbalanceError(f"tolerance = {shown(tolerance)}", "must be positive", "1e-4 is usual")
    begun = perf_counter()
    found, previous = _at(system, method, steps, multipliers), None
    while tolerance is not None and not found.error <= tolerance:
        if 2 * steps > MOST_STEPS:
            rule = f"not reached within {MOST_STEPS} steps"
            raise SymbalanceError(f"tolerance = {shown(tolerance)}", rule, "ask for less")
        steps, previous = 2 * steps, found
        found = _at(system, method, steps, multipliers)
        change = np.abs(found.position[::2] - previous.position).max(axis=0)
        found = replace(found, error=_relative(change, found.position) / 7)
    return replace(found, seconds=perf_counter() - begun)


def _at(system: PeriodicSystem, method: str, steps: int, multipliers: bool) -> Trajectory:
    made = linear_steps(system, method, steps)
    start, factors = closed(made, multipliers)
    states = made.marched(start)[:-1]
    theta = system.cycle / steps * np.arange(steps)
    n = system.size
    forces = film_forces(system, theta, states)
    return Trajectory(theta, states[:, :n], states[:, n : 2 * n], forces, factors)


def _relative(change: Array, position: Array) -> float:
    """Return the norm of the largest changes over that of the largest displacements."""
    return float(np.linalg.norm(change) / np.linalg.norm(np.abs(position).max(axis=0)))


def closed(
    made: LinearSteps, multipliers: bool = True
) -> tuple[Array, NDArray[np.complexfloating[Any, Any]] | None]:
    """Return the state that comes back after a cycle, and the multipliers, largest first (or None)."""
    units = made.units
    with np.errstate(over="ignore", invalid="ignore"):
        pushed = made.marched(np.zeros(made.state_size))[-1] / units
    if not np.isfinite(pushed).all():
        rule = "must be finite after a cycle; a load is not, or it grows past all bounds"
        remedy = "take more steps a cycle, or look at pressures, masses and films"
        raise UnsolvedError("the motion", rule, remedy)
    factors = None
    if made.state_size > DENSE:
        start = solved(lambda s: s - made.carried(units * s) / units, pushed)
        if multipliers:
            factors = leading(lambda s: made.carried(units * s) / units, made.state_size)
    else:
        carried = made.carried(np.diag(units)) / units[:, None]
        start = np.linalg.lstsq(np.eye(len(carried)) - carried, pushed, rcond=1e-12)[0]
        factors = np.linalg.eigvals(carried).astype(complex) if multipliers else None
    missing = np.linalg.norm(start - made.carried(units * start) / units - pushed)
    if not missing <= CLOSED * (np.linalg.norm(pushed) + np.linalg.norm(start)):
        rule = "there is no periodic state: a mean load is held by nothing, or a multiplier is 1"
        raise UnsolvedError("steady state", rule, "balance the mean torque, or hold the spin")
    if np.linalg.norm(start) > UNBOUNDED * np.linalg.norm(pushed):
        rule = "is a resonance that nothing damps: only the integrator's own damping bounds the motion"
        raise UnsolvedError("steady state", rule, "give the rotor or its bearings damping")
    return units * start, None if factors is None else factors[np.argsort(-np.abs(factors))]
