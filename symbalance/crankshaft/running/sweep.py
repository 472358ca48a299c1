"""All speeds of an engine, one after the other; what is finished is kept and not done again."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np

from symbalance.crankshaft.bearings.series import quasi_static as in_series
from symbalance.crankshaft.files.operation import speed_text
from symbalance.crankshaft.rotor import Array
from symbalance.crankshaft.running.films import Orbits, periodic, shell_places
from symbalance.crankshaft.running.outcome import Outcome
from symbalance.crankshaft.running.reactions import bearing_points, stationary
from symbalance.crankshaft.running.saved import Restored, file_of, key_of, restored, save
from symbalance.crankshaft.running.setting import Loads, Setting
from symbalance.crankshaft.running.shifted import shifted
from symbalance.crankshaft.steady import steady_state
from symbalance.crankshaft.system import PeriodicSystem, Trajectory
from symbalance.errors import SymbalanceError

SETTLED = 0.05
"""The departure, over the clearance, at which films need not be made anew."""
Progress = Callable[[str], None]


def swept(
    made: Setting, folder: Path | None = None, progress: Progress = lambda line: None
) -> list[Outcome]:
    """Return the outcome of every speed; with a `folder` each is saved at once and found again.

    A saved one that is not of this engine, these settings and this program is solved anew, and
    `progress` is told why; so it is of a damaged one.
    """
    speeds, found = made.engine.operation.rpm, []
    for number, rpm in enumerate(speeds, 1):
        key = "" if folder is None else saved_key(made, rpm)
        kept = Restored(None) if folder is None else restored(folder, key, rpm)
        if folder is not None and kept.why:
            progress(f"{file_of(folder, rpm)}: {kept.why}: solved anew")
        outcome = kept.outcome
        if outcome is None:
            outcome = run(made, rpm)
            if folder is not None:
                save(folder, key, outcome)
        how = "found" if kept.outcome else "solved"
        progress(f"{speed_text(rpm)} rpm ({number} of {len(speeds)}): {how}, {outcome.seconds:.1f} s")
        found.append(outcome)
    return found


def saved_key(made: Setting, rpm: float) -> str:
    """Return the key of all that a speed's outcome depends on; a measured curve is no part of that."""
    engine = made.engine.at_speeds([rpm])
    operation = replace(engine.operation, overlay=None)
    return key_of(replace(engine, operation=operation), made.how, made.compliances)


def run(made: Setting, rpm: float) -> Outcome:
    """Return the outcome of one speed.

    Films about orbits are made anew for the mean of the loads they were made for and those found, until
    orbits and films agree, up to `passes` times; of all, the outcome nearest its films' orbits counts.
    Loads taken over whole need not converge where a film is almost dry, and may grow past all bounds
    where the steps are too coarse for it: then the passes end.
    """
    if made.about == "centre" or made.table is not None:
        full = made.system(rpm)
        return _outcome(made, rpm, full, _solved(made, full))
    loads, seconds = _quasi_static(made, rpm), 0.0
    best = found = _about(made, rpm, made.orbits(rpm, loads))
    for _ in range(made.passes - 1):
        if best.departure < SETTLED:
            break
        loads = periodic(found.theta, (loads(found.theta) + found.bearings) / 2, found.cycle)
        try:
            after = _about(made, rpm, made.orbits(rpm, loads))
        except SymbalanceError:  # films of loads that run away: what was found before them stands
            break
        seconds, found = seconds + found.seconds, after
        best = min(best, found, key=lambda outcome: outcome.departure)
    return replace(best, seconds=seconds + found.seconds)


def _quasi_static(made: Setting, rpm: float) -> Loads:
    return lambda theta: made.bearing_loads(rpm, theta)


def _about(made: Setting, rpm: float, orbits: Orbits) -> Outcome:
    """Return the outcome with films linear about given orbits."""
    full = made.system(rpm, orbits.film)
    moved = shifted(full, made.rotor, orbits)
    found = _solved(made, moved.system)
    theta = found.theta
    bearing = found.bearing - periodic(orbits.theta, orbits.force, full.cycle)(theta)
    position = found.position + moved.field(theta)
    outcome = _outcome(made, rpm, full, replace(found, position=position, bearing=bearing))
    off = outcome.orbits - periodic(orbits.theta, orbits.place, full.cycle)(theta)
    most = np.linalg.norm(off, axis=-1) / outcome.clearance
    return replace(outcome, departure=float(most.max()))


def _solved(made: Setting, full: PeriodicSystem) -> Trajectory:
    """Return the periodic motion of all unknowns."""
    system = in_series(full) if made.connection == "equivalent" else full
    if not made.modes:
        return steady_state(system, steps=made.steps)
    from symbalance.crankshaft.reduction import reduced

    small, basis = reduced(system, made.modes)
    found = steady_state(small, steps=made.steps)
    return replace(found, position=found.position @ basis.T, velocity=found.velocity @ basis.T)


def _outcome(made: Setting, rpm: float, full: PeriodicSystem, found: Trajectory) -> Outcome:
    size = found.multipliers
    return Outcome(
        rpm=rpm,
        theta=found.theta,
        names=tuple(c.name for c in made.channels),
        units=tuple(c.unit for c in made.channels),
        values=found.position @ made.stress.T,
        orbits=_orbits(made, full, found),
        bearings=-found.bearing,
        clearance=np.array(made.engine.supports.clearance),
        largest=float(np.abs(size).max()) if size is not None and len(size) else float("nan"),
        error=found.error,
        seconds=found.seconds,
    )


def _orbits(made: Setting, full: PeriodicSystem, found: Trajectory) -> Array:
    """Return the journals' displacements in their shells, stationary axes (s, b, 2)."""
    turning = np.einsum("bin,sn->sbi", bearing_points(made.rotor), found.position)
    shells = shell_places(-found.bearing, full.housing, full.cycle, full.omega)
    return stationary(turning, found.theta) - shells


def speeds_between(low: float, high: float, step: float) -> tuple[float, ...]:
    """Return the speeds from `low` to `high` in steps.

    >>> speeds_between(1000, 2000, 500), speeds_between(1, 1.3, 0.1)
    ((1000.0, 1500.0, 2000.0), (1.0, 1.1, 1.2, 1.3))
    """
    # As decimals, so that no speed comes out as 1.2000000000000002, in reports and in file names.
    first, last, by = (Fraction(repr(float(x))) for x in (low, high, step))
    return tuple(float(first + by * i) for i in range(int((last - first) / by) + 1))
