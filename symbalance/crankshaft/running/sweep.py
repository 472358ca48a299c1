"""All speeds of an engine, one after the other; what is finished is kept and not done again."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from symbalance.crankshaft.rotor import Array
from symbalance.crankshaft.bearings.series import quasi_static as in_series
from symbalance.crankshaft.running.outcome import Outcome
from symbalance.crankshaft.running.reactions import bearing_points, stationary
from symbalance.crankshaft.running.saved import key_of, restored, save
from symbalance.crankshaft.running.setting import Setting
from symbalance.crankshaft.steady import steady_state
from symbalance.crankshaft.system import PeriodicSystem, Trajectory

Progress = Callable[[str], None]


def swept(
    made: Setting, folder: Path | None = None, progress: Progress = lambda line: None
) -> list[Outcome]:
    """Return the outcome of every speed; with a `folder` each is saved at once and found again."""
    speeds, found = made.engine.operation.rpm, []
    for number, rpm in enumerate(speeds, 1):
        key = key_of(made.engine.at_speeds([rpm]), made.webs, made.modes, made.connection, made.steps)
        outcome = restored(folder, key, rpm) if folder else None
        how = "found" if outcome else "solved"
        if outcome is None:
            outcome = run(made, rpm)
            if folder:
                save(folder, key, outcome)
        progress(f"{rpm:g} rpm ({number} of {len(speeds)}): {how}, {outcome.seconds:.1f} s")
        found.append(outcome)
    return found


def run(made: Setting, rpm: float) -> Outcome:
    """Return the outcome of one speed."""
    full = made.system(rpm)
    system = in_series(full) if made.connection == "equivalent" else full
    motion, trajectory = _solved(made, system)
    supports, shown = made.engine.supports, made.channels
    size = trajectory.multipliers
    return Outcome(
        rpm=rpm,
        theta=trajectory.theta,
        names=tuple(c.name for c in shown),
        units=tuple(c.unit for c in shown),
        values=motion @ made.stress.T,
        orbits=_orbits(made, full, motion, trajectory),
        bearings=-trajectory.bearing,
        clearance=np.array(supports.clearance),
        largest=float(np.abs(size).max()) if size is not None and len(size) else float("nan"),
        error=trajectory.error,
        seconds=trajectory.seconds,
    )


def _solved(made: Setting, system: PeriodicSystem) -> tuple[Array, Trajectory]:
    """Return the displacements of all unknowns (s, n) and the trajectory they come from."""
    if not made.modes:
        found = steady_state(system, steps=made.steps)
        return found.position, found
    from symbalance.crankshaft.reduction import reduced

    small, basis = reduced(system, made.modes)
    found = steady_state(small, steps=made.steps)
    return found.position @ basis.T, found


def _orbits(made: Setting, full: PeriodicSystem, motion: Array, found: Trajectory) -> Array:
    """Return the journals' displacements in their shells, stationary axes (s, b, 2).

    A shell moves by z, K_B z + C_B z' = the shaft's force on it, solved order by order.
    """
    flat = bearing_points(made.rotor)
    journals = stationary(np.einsum("bin,sn->sbi", flat, motion), found.theta)
    housing = full.housing
    if housing is None:
        return journals
    spectrum = np.fft.rfft(-found.bearing, axis=0)
    rates = 1j * np.arange(len(spectrum)) * 2 * np.pi / full.cycle * full.omega
    springs = housing.stiffness + rates[:, None, None, None] * housing.damping
    shells = np.linalg.solve(springs, spectrum[..., None])[..., 0]
    return journals - np.fft.irfft(shells, n=len(motion), axis=0)


def speeds_between(low: float, high: float, step: float) -> tuple[float, ...]:
    """Return the speeds from `low` to `high` in steps.

    >>> speeds_between(1000, 2000, 500)
    (1000.0, 1500.0, 2000.0)
    """
    count = int((high - low) / step * (1 + 1e-12)) + 1
    return tuple(float(low + step * i) for i in range(count))


