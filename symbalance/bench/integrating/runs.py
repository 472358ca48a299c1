"""One cycle of a system by each integrator: run time, and error against harmonic balance.

Each starts from the reference's periodic state and integrates one cycle. The error is the largest of
three, each over the largest value of its kind within the cycle: the journals' displacements, and the
shifts and the turns of all nodes, the crank's turning as a whole taken out.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from time import process_time

import numpy as np

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.harmonic_balance import harmonic_state
from symbalance.crankshaft.integrators.coefficients import bearing_rows
from symbalance.crankshaft.integrators.first_order import scipy_states
from symbalance.crankshaft.integrators.methods import FIXED, linear_steps
from symbalance.crankshaft.system import PeriodicSystem
from symbalance.errors import SymbalanceError

ASKED, ENOUGH = 90, 1e-4
"""The number of intervals in the cycle between the angles at which states are compared; an error that is
low enough not to go on where the reference is not known better."""
LONG = 10.0
"""Seconds beyond which a run is not repeated."""


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
    def named(self) -> str:
        """Method and setting."""
        return f"{self.method} {self.setting}"


@dataclass(frozen=True)
class Reference:
    """The periodic state at `ASKED` + 1 angles (s, size) and how far fewer harmonics differ from it."""

    system: PeriodicSystem
    kinds: Sequence[Array]
    states: Array
    uncertain: float

    @classmethod
    def of(cls, system: PeriodicSystem, kinds: Sequence[Array], harmonics: int = 150) -> Reference:
        """Return the reference; `kinds` (k, n) each take displacements to what is compared."""
        theta = system.cycle / ASKED * np.arange(ASKED + 1)
        made = cls(system, kinds, harmonic_state(system, harmonics).states(theta), np.nan)
        fewer = harmonic_state(system, harmonics * 3 // 4).states(theta)
        return cls(system, kinds, made.states, made.error(fewer))

    def error(self, states: Array) -> float:
        """Return the error of states (s, size) at the same angles."""
        n = self.system.size
        if not np.isfinite(states).all():
            return float("nan")
        found = 0.0
        for kind in self.kinds:
            known = self.states[:, :n] @ kind.T
            off = np.abs(states[:, :n] @ kind.T - known).max()
            found = max(found, off / np.abs(known).max())
        return float(found)

    def fixed(self, method: str, steps: int, repeats: int = 3) -> tuple[float, float]:
        """Return seconds, all preparation in, and error of a fixed-step method."""
        seconds, states = np.inf, self.states
        for _ in range(repeats):
            begun = process_time()
            states = linear_steps(self.system, method, steps).march(self.states[0])
            seconds = min(seconds, process_time() - begun)
        return seconds, self.error(states[:: steps // ASKED])

    def by_scipy(self, method: str, rtol: float, limit: float, repeats: int = 3) -> tuple[float, float]:
        """Return seconds and error of one of SciPy's; NaN both where it gives up or passes `limit`.

        The best of three runs counts, as for a fixed step, unless one alone is longer than `LONG`.
        """
        theta = self.system.cycle / ASKED * np.arange(ASKED + 1)
        size = np.abs(self.states).max(axis=0)
        seconds, states = np.inf, self.states
        for _ in range(repeats):
            begun = process_time()
            try:
                states = scipy_states(self.system, method, theta, self.states[0], rtol, size, limit)
            except (TimeoutError, SymbalanceError):
                return float("nan"), float("nan")
            seconds = min(seconds, process_time() - begun)
            if seconds > LONG:
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


Progress = Callable[[str], None]
STEPS: dict[str, tuple[int, ...]] = {
    "radau-iia": (90, 180, 360, 720, 1440, 2880),
    "radau-iia-9": (90, 180, 360, 720),
    "newmark": (360, 720, 1440, 2880, 5760),
}
TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)


def swept(
    case: str, model: str, reference: Reference, methods: Sequence[str], limit: float, say: Progress
) -> list[Run]:
    """Return runs of all `methods`; settings tighten until one passes the limit or is exact."""
    runs: list[Run] = []
    for method in methods:
        say(f"{case}, {model}: {method}")
        for setting in STEPS[method] if method in FIXED else TOLERANCES:
            if method in FIXED:
                run = reference.fixed(method, int(setting))
                runs.append(Run(case, model, method, str(setting), *run))
            else:
                run = reference.by_scipy(method, setting, limit)
                runs.append(Run(case, model, method, f"{setting:.0e}", *run))
            known = min(4 * reference.uncertain, ENOUGH)
            if run[1] <= known or (np.isnan(run[1]) and method not in FIXED):
                break
    return runs
