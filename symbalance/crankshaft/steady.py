"""The periodic steady state of a crankshaft on its bearings, by shooting, and its Floquet multipliers.

A cycle takes the state s at its start to Psi s + r, exactly linearly. The periodic state solves
(1 - Psi) s = r; the eigenvalues of Psi, the multipliers, say by what factor a deviation grows in a cycle:
the engine is stable where all are less than 1 in size. Eigenvalues at a frozen crank angle say nothing.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from importlib import import_module
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.integrators.coefficients import film_forces
from symbalance.crankshaft.integrators.methods import linear_steps
from symbalance.crankshaft.integrators.time_stepping import LinearSteps
from symbalance.crankshaft.system import PeriodicSystem, Trajectory, UnsolvedError
from symbalance.errors import MissingPartError, SymbalanceError, brief

DENSE = 320
"""States up to which the whole monodromy matrix is computed; beyond, its action on a Krylov space."""
LEADING = 12
"""Floquet multipliers beyond `DENSE` states, the largest."""
CLOSED = 1e-6
"""How far a periodic state may be from closing, of its size and of what a cycle from rest gives."""
UNBOUNDED = 1e6
"""A steady state this much larger than what one cycle gives from rest has no damping to speak of."""
MOST_STEPS = 46080
"""Of a cycle, to which a tolerance may double them: 64 times the usual 720."""


def steady_state(
    system: PeriodicSystem,
    *,
    method: str = "radau-iia",
    steps: int = 720,
    tolerance: float | None = None,
    multipliers: bool = True,
) -> Trajectory:
    """Return the periodic steady state at `steps` equal angles of a cycle, from 0, its end left out.

    `method` is one of `FIXED`: radau-iia (order 5), radau-iia-9, newmark. With a `tolerance` the steps
    are doubled until the displacements' relative change, over 7, is below it; `error` holds that
    estimate, else NaN. `multipliers` are sorted by size, largest first (the largest dozen for systems
    beyond `DENSE` states). Refuses a system without a periodic state: a mean load that nothing carries.
    """
    if tolerance is not None and not tolerance > 0:
        raise SymbalanceError(f"tolerance = {brief(tolerance)}", "must be positive", "1e-4 is usual")
    begin = perf_counter()
    motion, previous = _solve_at(system, method, steps, multipliers), None
    while tolerance is not None and not motion.error <= tolerance:
        if 2 * steps > MOST_STEPS:
            rule = f"not reached within {MOST_STEPS} steps"
            raise SymbalanceError(f"tolerance = {brief(tolerance)}", rule, "ask for less")
        steps, previous = 2 * steps, motion
        motion = _solve_at(system, method, steps, multipliers)
        change = np.abs(motion.position[::2] - previous.position).max(axis=0)
        # Over 7 = 2^3 - 1: as if of third order, on the safe side of the fifth that smooth films give.
        motion = replace(motion, error=_relative(change, motion.position) / 7)
    return replace(motion, seconds=perf_counter() - begin)


def _solve_at(system: PeriodicSystem, method: str, steps: int, multipliers: bool) -> Trajectory:
    cycle = linear_steps(system, method, steps)
    start, factors = periodic_start(cycle, multipliers)
    states = cycle.march(start)[:-1]
    theta = system.cycle / steps * np.arange(steps)
    n = system.size
    forces = film_forces(system, theta, states)
    return Trajectory(theta, states[:, :n], states[:, n : 2 * n], forces, factors)


def _relative(change: Array, position: Array) -> float:
    """Return the norm of the largest changes over that of the largest displacements."""
    return float(np.linalg.norm(change) / np.linalg.norm(np.abs(position).max(axis=0)))


def periodic_start(
    cycle: LinearSteps, multipliers: bool = True
) -> tuple[Array, NDArray[np.complexfloating[Any, Any]] | None]:
    """Return the state that comes back after a cycle, and the multipliers, largest first (or None)."""
    units = cycle.units
    with np.errstate(over="ignore", invalid="ignore"):
        side = cycle.march(np.zeros(cycle.state_size))[-1] / units
    if not np.isfinite(side).all():
        rule = "must be finite after a cycle; a load is not, or it grows past all bounds"
        remedy = "take more steps a cycle, or look at pressures, masses and films"
        raise UnsolvedError("the motion", rule, remedy)

    def psi(states: Array) -> Array:
        scale = units if states.ndim == 1 else units[:, None]
        return cycle.propagate(scale * states) / scale

    solve = _solve_densely if cycle.state_size <= DENSE else _solve_by_krylov
    start, factors = solve(psi, side, multipliers)
    missing = np.linalg.norm(start - psi(start) - side)
    if not missing <= CLOSED * (np.linalg.norm(side) + np.linalg.norm(start)):
        rule = "there is no periodic state: a mean load is held by nothing, or a multiplier is 1"
        raise UnsolvedError("steady state", rule, "balance the mean torque, or hold the spin")
    if np.linalg.norm(start) > UNBOUNDED * np.linalg.norm(side):
        rule = "is a resonance that nothing damps: only the integrator's own damping bounds the motion"
        raise UnsolvedError("steady state", rule, "give the rotor or its bearings damping")
    return units * start, None if factors is None else factors[np.argsort(-np.abs(factors))]


Propagation = Callable[[Array], Array]
"""Psi times a state, or times states as columns."""


def _solve_densely(psi: Propagation, side: Array, multipliers: bool) -> tuple[Array, Any]:
    matrix = psi(np.eye(len(side)))
    # Least squares, because 1 - Psi is singular where nothing holds a motion that no load drives.
    start = np.linalg.lstsq(np.eye(len(side)) - matrix, side, rcond=1e-12)[0]
    return start, np.linalg.eigvals(matrix).astype(complex) if multipliers else None


def _solve_by_krylov(psi: Propagation, side: Array, multipliers: bool) -> tuple[Array, Any]:
    """Return (1 - Psi)^-1 side by GMRES, and the largest eigenvalues of Psi by Arnoldi's method.

    Both take a dozen or two of cycles where the whole matrix takes as many as there are states.
    """
    try:
        krylov: Any = import_module("scipy.sparse.linalg")
    except ImportError:
        rule, remedy = "SciPy is not installed", "pip install 'symbalance[crankshaft]'"
        raise MissingPartError(f"a steady state of {len(side)} states", rule, remedy) from None
    shape = (len(side), len(side))
    # Not restarted: the caller's check of the residual says whether it converged.
    rest = krylov.LinearOperator(shape, matvec=lambda state: state - psi(state), dtype=float)
    start = krylov.gmres(rest, side, rtol=1e-11, atol=0.0, restart=min(400, len(side)), maxiter=1)[0]
    if not multipliers:
        return start, None
    count = min(LEADING, len(side) - 2)  # ARPACK takes no more
    first = np.random.default_rng(1).standard_normal(len(side))  # the same multipliers at every run
    try:
        operator = krylov.LinearOperator(shape, matvec=psi, dtype=float)
        return start, krylov.eigs(operator, count, v0=first, return_eigenvectors=False)
    except krylov.ArpackError as problem:
        rule = f"the largest Floquet multipliers do not settle ({problem})"
        raise UnsolvedError("steady state", rule, "look at the rotor's damping and constraints") from None
