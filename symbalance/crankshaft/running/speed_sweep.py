"""Sweep over an engine's speeds: each solved once and saved, its oil films iterated until they settle."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import replace
from fractions import Fraction
from functools import partial
from pathlib import Path

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.bearings.series import equivalent_system as in_series
from symbalance.crankshaft.files.operation import speed_text
from symbalance.crankshaft.running.about_orbit import system_about_orbit
from symbalance.crankshaft.running.configuration import MOST_STEPS, Loads, RunConfiguration
from symbalance.crankshaft.running.loading import bearing_points, to_stationary_axes
from symbalance.crankshaft.running.oil_films import OrbitFilms, housing_places, periodic_spline
from symbalance.crankshaft.running.outcome import CODEC, SpeedOutcome, key_of, slot_of
from symbalance.crankshaft.steady import steady_state
from symbalance.crankshaft.system import PeriodicSystem, Trajectory, UnsolvedError
from symbalance.jobs.progress import Progress
from symbalance.jobs.running import Job, note, run_jobs
from symbalance.jobs.store import Store
from symbalance.text.numbers import evenly_spaced

MOST_SPEEDS = 1000
SETTLED = 0.05
"""The departure, over the clearance, at which films need not be computed again."""
FINER = (1, 2, 4)
"""By how much the steps are multiplied, one after the other, until the films settle."""
Say = Callable[[str], None]


def run_speeds(
    configuration: RunConfiguration,
    folder: Path | None = None,
    progress: Progress | None = None,
    *,
    workers: int = 1,
    executor: Executor | None = None,
) -> list[SpeedOutcome]:
    """Return the outcome of every speed; each is saved in `folder`, if given, and reused by later runs.

    A saved one that is not of this engine, these settings and this program is solved anew, as is a
    damaged one, and a line of `progress` says why. Speeds are jobs (`symbalance.jobs`): with several
    `workers`, or an `executor`, they are solved side by side, and the outcomes are the same, provided
    that BLAS has the same number of threads here and there. What one speed meets, the others outlive;
    then it is raised.
    """
    progress = progress or Progress()
    store = None if folder is None else Store(folder, "--output")
    jobs = [
        Job(f"{speed_text(rpm)} rpm", rpm, key, slot_of(rpm) if key else "")
        for rpm in configuration.engine.operation.rpm
        for key in ["" if store is None else saved_key(configuration, rpm)]
    ]
    if store is not None:
        for job in jobs:
            older = store.folder / f"{job.slot}.npz"
            if older.exists() and not store.path(job.slot).exists():
                progress.say(f"{older}: is of an earlier version: solved anew")
    solve, done, failed = partial(_solve_job, configuration), [], []
    means = {"executor": executor, "workers": workers, "store": store, "progress": progress}
    for number, (job, outcome) in enumerate(run_jobs(solve, jobs, codec=CODEC, **means), 1):
        if not outcome.is_done:
            failed.append((job, outcome))
            continue
        place = f"{job.name} ({number} of {len(jobs)})"
        result = outcome.value.reason or ("found" if outcome.saved else "solved")
        progress.say(f"{place}: {result}, {outcome.value.seconds:.1f} s")
        done.append(outcome.value)
    for job, outcome in failed[1:]:
        progress.say(str(outcome.problem or f"{job.name}: {outcome.fault}"))
    for job, outcome in failed:
        outcome.result(job.name)
    return done


def _solve_job(configuration: RunConfiguration, rpm: float) -> SpeedOutcome:
    return run_speed(configuration, rpm, note)


def saved_key(configuration: RunConfiguration, rpm: float) -> str:
    """Return the key of all that a speed's outcome depends on; a measured curve is no part of that."""
    engine = configuration.engine.at_speeds([rpm])
    operation = replace(engine.operation, overlay=None)
    return key_of(
        replace(engine, operation=operation), configuration.solver_options, configuration.compliances
    )


def run_speed(configuration: RunConfiguration, rpm: float, say: Say = lambda line: None) -> SpeedOutcome:
    """Return the outcome of one speed, with a `reason` where it is not to be relied on.

    Films about orbits that do not settle are tried at finer steps; a line to `say` says so.
    """
    if configuration.about == "centre" or configuration.table is not None:
        return _solve_about_centre(configuration, rpm)
    attempts: list[SpeedOutcome] = []
    finer = _refinements(configuration)
    for number, at in enumerate(finer, 1):
        outcome, orbits = _iterate_films(at, rpm)
        attempts.append(outcome)
        if not outcome.reason:
            assert orbits is not None
            solve = partial(_solve_about_orbits, rpm=rpm, orbits=orbits, multipliers=False)
            error = _step_error(at, outcome, solve)
            return replace(outcome, seconds=sum(o.seconds for o in attempts), error=error)
        if number < len(finer):
            next_try = f"trying {finer[number].steps} steps"
            say(f"{speed_text(rpm)} rpm: {outcome.reason}: {next_try}")
    nearest = min(attempts, key=lambda o: o.departure if o.departure >= 0 else float("inf"))
    others = " or ".join(str(o.steps) for o in attempts if o is not nearest)
    reason = nearest.reason + (f"; nor at {others} steps" if others else "")
    return replace(nearest, seconds=sum(o.seconds for o in attempts), reason=reason)


def _refinements(configuration: RunConfiguration) -> list[RunConfiguration]:
    """Return the configuration and those of finer steps; a single pass iterates nothing, at any steps."""
    factors = FINER if configuration.iterations > 1 else FINER[:1]
    steps = [configuration.steps * factor for factor in factors]
    return [replace(configuration, steps=count) for count in steps if count <= MOST_STEPS]


def _solve_about_centre(configuration: RunConfiguration, rpm: float) -> SpeedOutcome:
    """Return the outcome with films that are springs about the bearings' centres."""
    try:
        full = configuration.system(rpm)
        outcome = _outcome(configuration, rpm, full, _solve_periodic(configuration, full))
    except UnsolvedError as problem:
        return _no_outcome(configuration, rpm, f"no steady state: {problem}")

    def solve(at: RunConfiguration) -> SpeedOutcome:
        return _outcome(at, rpm, full, _solve_periodic(at, full, multipliers=False))

    return replace(outcome, error=_step_error(configuration, outcome, solve))


def _iterate_films(configuration: RunConfiguration, rpm: float) -> tuple[SpeedOutcome, OrbitFilms | None]:
    """Return the outcome whose films are linear about the orbits nearest its own, and those orbits.

    Films are computed again for the mean of the loads before and those of the solution, until
    orbits and films agree, up to `iterations` times. Loads taken over whole need not converge where a
    film is almost dry, and may grow past all bounds where the steps are too coarse for it: then the
    passes end. The outcome has a `reason` unless films and orbits agree within the clearance.
    """
    loads, seconds, ending = _quasi_static(configuration, rpm), 0.0, ""
    best: SpeedOutcome | None = None
    about: OrbitFilms | None = None
    for _ in range(configuration.iterations):
        try:
            orbits = configuration.orbits(rpm, loads)
            outcome = _solve_about_orbits(configuration, rpm, orbits)
        except UnsolvedError as problem:
            ending = f"; then {problem}" if best else f": {problem}"
            break
        seconds += outcome.seconds
        if best is None or outcome.departure < best.departure:
            best, about = outcome, orbits
        if _is_settled(outcome):
            return replace(outcome, seconds=seconds), orbits
        loads = periodic_spline(
            outcome.theta, (loads(outcome.theta) + outcome.bearings) / 2, outcome.cycle
        )
    if best is None:
        return _no_outcome(
            configuration, rpm, f"films do not settle at {configuration.steps} steps a cycle{ending}"
        ), None
    most = float(best.eccentricity.max())
    passes = "1 pass" if configuration.iterations == 1 else f"{configuration.iterations} passes"
    reason = (
        f"films do not settle at {configuration.steps} steps a cycle and {passes}: orbits off "
        f"theirs by {best.departure:.2f} of the clearance, journals at {most:.2f} of it{ending}"
    )
    return replace(best, seconds=seconds, reason=reason), about


def _is_settled(outcome: SpeedOutcome) -> bool:
    return outcome.departure < SETTLED and outcome.within_clearance


def _step_error(
    configuration: RunConfiguration,
    outcome: SpeedOutcome,
    solve: Callable[[RunConfiguration], SpeedOutcome],
) -> float:
    """Return the largest change of a stress when the steps are halved, over the largest stress.

    The films stay the same. Not divided by what the method's order promises: pressures and films have
    kinks, and the error falls with little more than the step. NaN where the halved steps give no motion.
    """
    try:
        finer = solve(replace(configuration, steps=2 * configuration.steps))
    except UnsolvedError:
        return float("nan")
    stresses = [i for i, unit in enumerate(outcome.units) if unit == "Pa"]
    change = np.abs(finer.values[::2, stresses] - outcome.values[:, stresses]).max()
    return float(change / np.abs(outcome.values[:, stresses]).max())


def _no_outcome(configuration: RunConfiguration, rpm: float, reason: str) -> SpeedOutcome:
    """Return the outcome of a speed that has none."""
    cycle = configuration.engine.engine.strokes * np.pi
    bearings = np.full((configuration.steps, len(configuration.engine.bearings.clearance), 2), np.nan)
    return SpeedOutcome(
        rpm=rpm,
        theta=cycle * np.arange(configuration.steps) / configuration.steps,
        names=tuple(c.name for c in configuration.channels),
        units=tuple(c.unit for c in configuration.channels),
        values=np.full((configuration.steps, len(configuration.channels)), np.nan),
        orbits=bearings,
        bearings=bearings,
        clearance=np.array(configuration.engine.bearings.clearance),
        largest=float("nan"),
        error=float("nan"),
        seconds=0.0,
        reason=reason,
    )


def _quasi_static(configuration: RunConfiguration, rpm: float) -> Loads:
    return lambda theta: configuration.bearing_loads(rpm, theta)


def _solve_about_orbits(
    configuration: RunConfiguration, rpm: float, orbits: OrbitFilms, multipliers: bool = True
) -> SpeedOutcome:
    """Return the outcome with films linear about given orbits."""
    full = configuration.system(rpm, orbits.film)
    departures = system_about_orbit(full, configuration.rotor, orbits)
    motion = _solve_periodic(configuration, departures.system, multipliers)
    theta = motion.theta
    bearing = motion.bearing - periodic_spline(orbits.theta, orbits.force, full.cycle)(theta)
    position = motion.position + departures.field(theta)
    outcome = _outcome(configuration, rpm, full, replace(motion, position=position, bearing=bearing))
    off = outcome.orbits - periodic_spline(orbits.theta, orbits.place, full.cycle)(theta)
    most = np.linalg.norm(off, axis=-1) / outcome.clearance
    return replace(outcome, departure=float(most.max()))


def _solve_periodic(
    configuration: RunConfiguration, full: PeriodicSystem, multipliers: bool = True
) -> Trajectory:
    """Return the periodic motion of all unknowns."""
    system = in_series(full) if configuration.connection == "equivalent" else full
    if not configuration.modes:
        return steady_state(system, steps=configuration.steps, multipliers=multipliers)
    from symbalance.crankshaft.reduction import reduce_system

    small, basis = reduce_system(system, configuration.modes)
    motion = steady_state(small, steps=configuration.steps, multipliers=multipliers)
    return replace(motion, position=motion.position @ basis.T, velocity=motion.velocity @ basis.T)


def _outcome(
    configuration: RunConfiguration, rpm: float, full: PeriodicSystem, motion: Trajectory
) -> SpeedOutcome:
    size = motion.multipliers
    return SpeedOutcome(
        rpm=rpm,
        theta=motion.theta,
        names=tuple(c.name for c in configuration.channels),
        units=tuple(c.unit for c in configuration.channels),
        values=motion.position @ configuration.stress.T,
        orbits=_orbits(configuration, full, motion),
        bearings=-motion.bearing,
        clearance=np.array(configuration.engine.bearings.clearance),
        largest=float(np.abs(size).max()) if size is not None and len(size) else float("nan"),
        error=motion.error,
        seconds=motion.seconds,
    )


def _orbits(configuration: RunConfiguration, full: PeriodicSystem, motion: Trajectory) -> Array:
    """Return the journals' displacements in their bearings, stationary axes (s, b, 2)."""
    turning = np.einsum("bin,sn->sbi", bearing_points(configuration.rotor), motion.position)
    housings = housing_places(-motion.bearing, full.housing, full.cycle, full.omega)
    return to_stationary_axes(turning, motion.theta) - housings


def speeds_between(low: float, high: float, step: float, what: str = "speeds") -> tuple[float, ...]:
    """Return the speeds from `low` to `high` in steps; `what` is said to ask for too many of them.

    >>> speeds_between(1000, 2000, 500), speeds_between(1, 1.3, 0.1)
    ((1000.0, 1500.0, 2000.0), (1.0, 1.1, 1.2, 1.3))
    """
    # As decimals, so that no speed becomes 1.2000000000000002, in reports and in file names.
    first, last, by = (Fraction(repr(float(x))) for x in (low, high, step))
    limit = {"most": MOST_SPEEDS, "what": what, "things": "speeds", "remedy": "take a larger step"}
    return tuple(map(float, evenly_spaced(first, last, by, **limit)))
