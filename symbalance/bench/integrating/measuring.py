"""All measurements of `symbalance bench crankshaft`, to be made in a process with one thread."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from symbalance.bench.integrating.four import Case, film_tables, full_system, spin
from symbalance.bench.integrating.runs import Reference, Run, kinds, swept
from symbalance.bench.timing import progress
from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.integrators.first_order import SCIPY
from symbalance.crankshaft.integrators.methods import FIXED
from symbalance.crankshaft.reduction import reduced
from symbalance.crankshaft.steady import steady_state
from symbalance.crankshaft.system import PeriodicSystem

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
QUICK = (EXTREMES[0], EXTREMES[3], EXTREMES[4], EXTREMES[6])
MODES = 20
LIMIT, QUICK_LIMIT = 60.0, 10.0
HARMONICS, QUICK_HARMONICS = 260, 150


@dataclass(frozen=True)
class Extreme:
    """A case's runs, its reference's doubt, the largest multiplier by two methods."""

    case: str
    model: str
    runs: Sequence[Run]
    uncertain: float
    multipliers: tuple[float, float]


@dataclass(frozen=True)
class Measured:
    """The two sweeps at the base case, the extremes, and films' least and largest stiffness (N/m)."""

    sweeps: Sequence[Extreme]
    extremes: Sequence[Extreme]
    film: tuple[float, float, float]
    sizes: tuple[int, int]


def measure(quick: bool) -> Measured:
    """Return everything; `quick` leaves out what takes SciPy longer than ten seconds."""
    limit, harmonics = (QUICK_LIMIT, QUICK_HARMONICS) if quick else (LIMIT, HARMONICS)
    methods = (*FIXED, *SCIPY)
    sweeps = [_case(BASE, model, methods, limit, harmonics) for model in ("reduced", "full")]
    few = (*FIXED, "radau", "lsoda")
    extremes = [_case(case, "reduced", few, limit, harmonics) for case in (QUICK if quick else EXTREMES)]
    if not quick:
        stiffest = (EXTREMES[0], EXTREMES[6])
        extremes += [_case(case, "full", (*FIXED, "radau"), limit, harmonics) for case in stiffest]
    stiffness, _ = film_tables(BASE.rpm)
    direct = stiffness[..., [0, 1], [0, 1]]
    film = (float(direct.min()), float(direct.max()), float(np.abs(stiffness).max()))
    return Measured(sweeps, extremes, film, (_system(BASE, "reduced")[0].size, full_system(BASE).size))


def _system(case: Case, model: str) -> tuple[PeriodicSystem, Array | None]:
    system = full_system(case)
    return (system, None) if model == "full" else reduced(system, MODES)


def _case(case: Case, model: str, methods: Sequence[str], limit: float, harmonics: int) -> Extreme:
    progress(f"{case.name}, {model}: reference")
    system, basis = _system(case, model)
    reference = Reference.of(system, kinds(system, spin(), basis), harmonics)
    runs = swept(case.name, model, reference, methods, limit, progress)
    few = [steady_state(system, method=m, steps=360).multipliers for m in ("radau-iia", "radau-iia-9")]
    largest = tuple(float(np.abs(m).max()) if m is not None else float("nan") for m in few)
    return Extreme(case.name, model, runs, reference.uncertain, (largest[0], largest[1]))
