"""One cycle of a crankshaft by each integrator: CPU seconds, and error against harmonic balance.

Each starts from the reference's periodic state and integrates one cycle. The error is the largest of
three, each over the largest value of its kind within the cycle: the journals' displacements, and the
shifts and the turns of all nodes, the crank's turning as a whole taken out. `measure` is to be called in
a process with one thread.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from time import process_time

import numpy as np

from symbalance.bench.inline_four import Case, film_tables, full_system, spin
from symbalance.bench.timing import progress
from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.harmonic_balance import harmonic_state
from symbalance.crankshaft.integrators.coefficients import bearing_rows
from symbalance.crankshaft.integrators.first_order import SCIPY, scipy_states
from symbalance.crankshaft.integrators.methods import FIXED, linear_steps
from symbalance.crankshaft.reduction import reduce_system
from symbalance.crankshaft.steady import steady_state
from symbalance.crankshaft.system import PeriodicSystem
from symbalance.errors import SymbalanceError

INTERVALS, LOW_ERROR = 90, 1e-4
"""The intervals of the cycle between the angles at which states are compared; an error that is low
enough not to go on where the reference is not known better."""
LONG_RUN = 10.0
"""Seconds beyond which a run is not repeated."""
MODES = 20
STEPS: dict[str, tuple[int, ...]] = {
    "radau-iia": (90, 180, 360, 720, 1440, 2880),
    "radau-iia-9": (90, 180, 360, 720),
    "newmark": (360, 720, 1440, 2880, 5760),
}
TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)
BASE = Case("2200 rpm")
EXTREMES = (
    Case("housing 1e11 N/m", housing=1e11),
    Case("housing 1e13 N/m", housing=1e13),
    Case("films on the ground", housing=0.0),
    Case("film x 100", film=100.0),
    Case("film x 0.001", film=0.001),
    Case("no structural damping", damping=0.0),
    Case("all stiff: 1e13 N/m, x 100, undamped", housing=1e13, film=100.0, damping=0.0),
    Case("500 rpm", rpm=500.0),
    Case("1000 rpm", rpm=1000.0),
    Case("5000 rpm", rpm=5000.0),
    Case("10000 rpm", rpm=10000.0),
)


@dataclass(frozen=True)
class Effort:
    """How much is spent: on which of SciPy's methods, at most how long on a run, how often.

    `limit` is in seconds; `harmonics` are the reference's. Settings tighten until an error is within
    `enough`, or, where that is 0, until the reference knows no better.
    """

    scipy: tuple[str, ...] = tuple(SCIPY)
    scipy_in_extremes: tuple[str, ...] = ("radau", "lsoda")
    extremes: tuple[Case, ...] = EXTREMES
    stiffest: tuple[Case, ...] = (EXTREMES[0], EXTREMES[6])
    limit: float = 60.0
    harmonics: int = 260
    repeats: int = 3
    enough: float = 0.0


FULL = Effort()
QUICK = Effort(
    scipy=("radau", "lsoda"),  # its two fastest within 1e-4, by the full run
    scipy_in_extremes=("radau",),
    extremes=(EXTREMES[0], EXTREMES[3], EXTREMES[4], EXTREMES[6]),
    stiffest=(),
    limit=10.0,
    harmonics=150,
    repeats=1,
    enough=LOW_ERROR,
)


@dataclass(frozen=True)
class Run:
    """One run: method, its steps or relative tolerance, CPU seconds (the best), error; NaN: no end."""

    case: str
    model: str
    method: str
    setting: str
    seconds: float
    error: float

    @property
    def label(self) -> str:
        """Method and setting."""
        return f"{self.method} {self.setting}"


@dataclass(frozen=True)
class Reference:
    """The periodic state (s, size) at the ends of all `INTERVALS`, and the error of fewer harmonics."""

    system: PeriodicSystem
    kinds: Sequence[Array]
    states: Array
    uncertainty: float

    @classmethod
    def of(cls, system: PeriodicSystem, kinds: Sequence[Array], harmonics: int = 150) -> Reference:
        """Return the reference; `kinds` (k, n) each take displacements to what is compared."""
        theta = system.cycle / INTERVALS * np.arange(INTERVALS + 1)
        best = cls(system, kinds, harmonic_state(system, harmonics).states(theta), np.nan)
        fewer = harmonic_state(system, harmonics * 3 // 4).states(theta)
        return cls(system, kinds, best.states, best.error(fewer))

    def error(self, states: Array) -> float:
        """Return the error of states (s, size) at the same angles."""
        n = self.system.size
        if not np.isfinite(states).all():
            return float("nan")
        largest = 0.0
        for kind in self.kinds:
            true = self.states[:, :n] @ kind.T
            off = np.abs(states[:, :n] @ kind.T - true).max()
            largest = max(largest, off / np.abs(true).max())
        return float(largest)

    def run_fixed_steps(self, method: str, steps: int, repeats: int = 3) -> tuple[float, float]:
        """Return seconds, all preparation in, and error of a fixed-step method."""
        seconds, states = np.inf, self.states
        for _ in range(repeats):
            start = process_time()
            states = linear_steps(self.system, method, steps).march(self.states[0])
            seconds = min(seconds, process_time() - start)
        return seconds, self.error(states[:: steps // INTERVALS])

    def run_scipy(self, method: str, rtol: float, limit: float, repeats: int = 3) -> tuple[float, float]:
        """Return seconds and error of one of SciPy's; NaN both where it gives up or passes `limit`.

        The best of the repeats counts, as for a fixed step, unless one alone is longer than `LONG_RUN`.
        """
        theta = self.system.cycle / INTERVALS * np.arange(INTERVALS + 1)
        size = np.abs(self.states).max(axis=0)
        seconds, states = np.inf, self.states
        for _ in range(repeats):
            start = process_time()
            try:
                states = scipy_states(self.system, method, theta, self.states[0], rtol, size, limit)
            except (TimeoutError, SymbalanceError):
                return float("nan"), float("nan")
            seconds = min(seconds, process_time() - start)
            if seconds > LONG_RUN:
                break
        return seconds, self.error(states)


def kinds(system: PeriodicSystem, spin: Array, basis: Array | None = None) -> list[Array]:
    """Return what is compared: journals' displacements, all shifts, all turns, without the spin."""
    n = len(spin)
    basis = np.eye(n) if basis is None else basis
    weight = system.mass if len(system.mass) == n else np.eye(n)
    rest = np.eye(n) - np.outer(spin, weight @ spin) / (spin @ weight @ spin)
    shifts = (np.arange(n) % DOF) < 3
    return [bearing_rows(system), (rest @ basis)[shifts], (rest @ basis)[~shifts]]


@dataclass(frozen=True)
class IntegratorSweep:
    """A case's runs, the reference's own error, the largest multiplier by two methods."""

    case: str
    model: str
    runs: Sequence[Run]
    uncertainty: float
    multipliers: tuple[float, float]


@dataclass(frozen=True)
class Measurements:
    """The sweeps of both models at the base case, the extremes, films' stiffness (N/m), unknowns.

    `film` holds the least and the largest direct stiffness and the largest of all terms.
    """

    sweeps: Sequence[IntegratorSweep]
    extremes: Sequence[IntegratorSweep]
    film: tuple[float, float, float]
    sizes: tuple[int, int]


def measure(quick: bool) -> Measurements:
    """Return everything; `quick` takes SciPy's fastest methods alone, a run each, and four extremes."""
    effort = QUICK if quick else FULL
    methods = (*FIXED, *effort.scipy)
    sweeps = [_sweep(BASE, model, methods, effort) for model in ("reduced", "full")]
    methods = (*FIXED, *effort.scipy_in_extremes)
    extremes = [_sweep(case, "reduced", methods, effort) for case in effort.extremes]
    extremes += [_sweep(case, "full", (*FIXED, "radau"), effort) for case in effort.stiffest]
    stiffness, _ = film_tables(BASE.rpm)
    direct = stiffness[..., [0, 1], [0, 1]]
    film = (float(direct.min()), float(direct.max()), float(np.abs(stiffness).max()))
    sizes = (_system(BASE, "reduced")[0].size, full_system(BASE).size)
    return Measurements(sweeps, extremes, film, sizes)


def _system(case: Case, model: str) -> tuple[PeriodicSystem, Array | None]:
    system = full_system(case)
    return (system, None) if model == "full" else reduce_system(system, MODES)


def _sweep(case: Case, model: str, methods: Sequence[str], effort: Effort) -> IntegratorSweep:
    progress(f"{case.name}, {model}: reference")
    system, basis = _system(case, model)
    reference = Reference.of(system, kinds(system, spin(), basis), effort.harmonics)
    runs = sweep_runs(case.name, model, reference, methods, effort)
    both = [steady_state(system, method=m, steps=360).multipliers for m in ("radau-iia", "radau-iia-9")]
    largest = tuple(float(np.abs(m).max()) if m is not None else float("nan") for m in both)
    return IntegratorSweep(case.name, model, runs, reference.uncertainty, (largest[0], largest[1]))


def sweep_runs(
    case: str, model: str, reference: Reference, methods: Sequence[str], effort: Effort
) -> list[Run]:
    """Return runs of all `methods`; settings tighten until one passes the limit or is exact."""
    runs: list[Run] = []
    for method in methods:
        progress(f"{case}, {model}: {method}")
        is_fixed = method in FIXED
        for setting in STEPS[method] if is_fixed else TOLERANCES:
            if is_fixed:
                times = reference.run_fixed_steps(method, int(setting), effort.repeats)
                runs.append(Run(case, model, method, str(setting), *times))
            else:
                times = reference.run_scipy(method, setting, effort.limit, effort.repeats)
                runs.append(Run(case, model, method, f"{setting:.0e}", *times))
            enough = max(min(4 * reference.uncertainty, LOW_ERROR), effort.enough)
            if times[1] <= enough or (np.isnan(times[1]) and not is_fixed):
                break
    return runs
