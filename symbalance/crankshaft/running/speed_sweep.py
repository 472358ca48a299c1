"""All speeds of an engine, one after the other; what is finished is kept and not done again."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from functools import partial
from pathlib import Path

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.bearings.series import quasi_static as in_series
from symbalance.crankshaft.files.operation import speed_text
from symbalance.crankshaft.running.about_orbit import shifted
from symbalance.crankshaft.running.configuration import MOST_STEPS, Loads, Setting
from symbalance.crankshaft.running.loading import bearing_points, stationary
from symbalance.crankshaft.running.oil_films import Orbits, periodic, shell_places
from symbalance.crankshaft.running.outcome import Outcome, Restored, file_of, key_of, restored, save
from symbalance.crankshaft.steady import steady_state
from symbalance.crankshaft.system import PeriodicSystem, Trajectory, UnsolvedError

SETTLED = 0.05
"""The departure, over the clearance, at which films need not be made anew."""
FINER = (1, 2, 4)
"""By how much the steps are multiplied, one after the other, until the films settle."""
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
            outcome = run(made, rpm, progress)
            if folder is not None:
                save(folder, key, outcome)
        how = outcome.reason or ("found" if kept.outcome else "solved")
        progress(f"{speed_text(rpm)} rpm ({number} of {len(speeds)}): {how}, {outcome.seconds:.1f} s")
        found.append(outcome)
    return found


def saved_key(made: Setting, rpm: float) -> str:
    """Return the key of all that a speed's outcome depends on; a measured curve is no part of that."""
    engine = made.engine.at_speeds([rpm])
    operation = replace(engine.operation, overlay=None)
    return key_of(replace(engine, operation=operation), made.how, made.compliances)


def run(made: Setting, rpm: float, progress: Progress = lambda line: None) -> Outcome:
    """Return the outcome of one speed, with a `reason` where it is not to be relied on.

    Films about orbits that do not settle are tried at finer steps, and `progress` is told.
    """
    if made.about == "centre" or made.table is not None:
        return _about_centre(made, rpm)
    tried: list[Outcome] = []
    finer = _finer(made)
    for number, at in enumerate(finer, 1):
        outcome, orbits = _iterated(at, rpm)
        tried.append(outcome)
        if not outcome.reason:
            assert orbits is not None
            solve = partial(_about, rpm=rpm, orbits=orbits, multipliers=False)
            error = _step_error(at, outcome, solve)
            return replace(outcome, seconds=sum(o.seconds for o in tried), error=error)
        if number < len(finer):
            trying = f"trying {finer[number].steps} steps"
            progress(f"{speed_text(rpm)} rpm: {outcome.reason}: {trying}")
    nearest = min(tried, key=lambda o: o.departure if o.departure >= 0 else float("inf"))
    others = " or ".join(str(o.steps) for o in tried if o is not nearest)
    reason = nearest.reason + (f"; nor at {others} steps" if others else "")
    return replace(nearest, seconds=sum(o.seconds for o in tried), reason=reason)


def _finer(made: Setting) -> list[Setting]:
    """Return the setting and those of finer steps; a single pass iterates nothing, at any steps."""
    factors = FINER if made.passes > 1 else FINER[:1]
    steps = [made.steps * factor for factor in factors]
    return [replace(made, steps=count) for count in steps if count <= MOST_STEPS]


def _about_centre(made: Setting, rpm: float) -> Outcome:
    """Return the outcome with films that are springs about the bearings' centres."""
    try:
        full = made.system(rpm)
        outcome = _outcome(made, rpm, full, _solved(made, full))
    except UnsolvedError as problem:
        return _unsolved(made, rpm, f"no steady state: {problem}")

    def solve(at: Setting) -> Outcome:
        return _outcome(at, rpm, full, _solved(at, full, multipliers=False))

    return replace(outcome, error=_step_error(made, outcome, solve))


def _iterated(made: Setting, rpm: float) -> tuple[Outcome, Orbits | None]:
    """Return the outcome whose films were made on the orbits nearest its own, and those orbits.

    Films about orbits are made anew for the mean of the loads they were made for and those found, until
    orbits and films agree, up to `passes` times. Loads taken over whole need not converge where a film
    is almost dry, and may grow past all bounds where the steps are too coarse for it: then the passes
    end. The outcome has a `reason` unless films and orbits agree within the clearance.
    """
    loads, seconds, ended = _quasi_static(made, rpm), 0.0, ""
    best: Outcome | None = None
    about: Orbits | None = None
    for _ in range(made.passes):
        try:
            orbits = made.orbits(rpm, loads)
            found = _about(made, rpm, orbits)
        except UnsolvedError as problem:
            ended = f"; then {problem}" if best else f": {problem}"
            break
        seconds += found.seconds
        if best is None or found.departure < best.departure:
            best, about = found, orbits
        if _settled(found):
            return replace(found, seconds=seconds), orbits
        loads = periodic(found.theta, (loads(found.theta) + found.bearings) / 2, found.cycle)
    if best is None:
        return _unsolved(made, rpm, f"films do not settle at {made.steps} steps a cycle{ended}"), None
    most = float(best.eccentricity.max())
    passes = "1 pass" if made.passes == 1 else f"{made.passes} passes"
    reason = (
        f"films do not settle at {made.steps} steps a cycle and {passes}: orbits off "
        f"theirs by {best.departure:.2f} of the clearance, journals at {most:.2f} of it{ended}"
    )
    return replace(best, seconds=seconds, reason=reason), about


def _settled(outcome: Outcome) -> bool:
    return outcome.departure < SETTLED and outcome.within_clearance


def _step_error(made: Setting, outcome: Outcome, solve: Callable[[Setting], Outcome]) -> float:
    """Return the largest change of a stress when the steps are halved, over the largest stress.

    The films are kept. Not divided by what the method's order promises: pressures and films have kinks,
    and the error falls with little more than the step. NaN where the halved steps give no motion.
    """
    try:
        finer = solve(replace(made, steps=2 * made.steps))
    except UnsolvedError:
        return float("nan")
    stresses = [i for i, unit in enumerate(outcome.units) if unit == "Pa"]
    change = np.abs(finer.values[::2, stresses] - outcome.values[:, stresses]).max()
    return float(change / np.abs(outcome.values[:, stresses]).max())


def _unsolved(made: Setting, rpm: float, reason: str) -> Outcome:
    """Return the outcome of a speed that has none."""
    bearings = np.full((made.steps, len(made.engine.supports.clearance), 2), np.nan)
    return Outcome(
        rpm=rpm,
        theta=made.engine.layout.strokes * np.pi * np.arange(made.steps) / made.steps,
        names=tuple(c.name for c in made.channels),
        units=tuple(c.unit for c in made.channels),
        values=np.full((made.steps, len(made.channels)), np.nan),
        orbits=bearings,
        bearings=bearings,
        clearance=np.array(made.engine.supports.clearance),
        largest=float("nan"),
        error=float("nan"),
        seconds=0.0,
        reason=reason,
    )


def _quasi_static(made: Setting, rpm: float) -> Loads:
    return lambda theta: made.bearing_loads(rpm, theta)


def _about(made: Setting, rpm: float, orbits: Orbits, multipliers: bool = True) -> Outcome:
    """Return the outcome with films linear about given orbits."""
    full = made.system(rpm, orbits.film)
    moved = shifted(full, made.rotor, orbits)
    found = _solved(made, moved.system, multipliers)
    theta = found.theta
    bearing = found.bearing - periodic(orbits.theta, orbits.force, full.cycle)(theta)
    position = found.position + moved.field(theta)
    outcome = _outcome(made, rpm, full, replace(found, position=position, bearing=bearing))
    off = outcome.orbits - periodic(orbits.theta, orbits.place, full.cycle)(theta)
    most = np.linalg.norm(off, axis=-1) / outcome.clearance
    return replace(outcome, departure=float(most.max()))


def _solved(made: Setting, full: PeriodicSystem, multipliers: bool = True) -> Trajectory:
    """Return the periodic motion of all unknowns."""
    system = in_series(full) if made.connection == "equivalent" else full
    if not made.modes:
        return steady_state(system, steps=made.steps, multipliers=multipliers)
    from symbalance.crankshaft.reduction import reduced

    small, basis = reduced(system, made.modes)
    found = steady_state(small, steps=made.steps, multipliers=multipliers)
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
