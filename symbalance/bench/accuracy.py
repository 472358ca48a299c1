"""`symbalance bench accuracy`: error against run time of the evaluators, the alternatives beside them.

All that is timed runs in turn on one thread of this machine; errors are taken against exact kinematics
in mpmath. The parts: `speed` (long arrays, small calls, memory), `error_sweep` (order, rod ratio and
target), `crossover` (when a closed form pays), and here the coefficients as doubles beside mpmath.
"""

from __future__ import annotations

import os
import platform
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from math import ulp
from pathlib import Path

from symbalance.bench.accuracy_alternatives import lacking
from symbalance.bench.crossover import CASES as CLOSED_FORMS
from symbalance.bench.crossover import COUNTS, crossover_table, crossovers
from symbalance.bench.error_sweep import ErrorSweep, Point, draw_points, points_csv, points_table
from symbalance.bench.evaluated_outputs import C, available_targets
from symbalance.bench.speed import (
    CASES,
    LONG,
    beside_alternatives,
    beside_copy,
    memory,
    small_table,
    speed_table,
    time_case,
    time_small_calls,
)
from symbalance.bench.timing import Measurement, Report, best, progress
from symbalance.bench.true_values import Number, mp
from symbalance.errors import MissingPartError
from symbalance.kinematics.slider_crank import acceleration_floats

FULL, QUICK = LONG, 10**6
"""Angles that are timed."""
QUICK_RATIOS, QUICK_ORDERS = (Fraction(4), Fraction(10, 9)), (8, None)
"""Few, because every case is compiled by Numba and by `cc`, which takes most of the time."""
HIGHEST = 40
"""The highest order of the coefficients."""
COEFFICIENT_TIMES, COEFFICIENT_ULP = 50, 4.0
RHOS = {
    "1/4": Fraction(4),
    "0.9": Fraction(10, 9),
    "1 - 1e-6": 1 / (1 - Fraction(1, 10**6)),
    "1 - 1e-9": 1 / (1 - Fraction(1, 10**9)),
}
"""Rod ratios lambda = 1/rho, by rho as it is printed."""


@dataclass(frozen=True)
class AccuracyReport:
    """Tables, then the targets of the numbers in them; `points` are those of the sweep."""

    head: str
    tables: Sequence[tuple[str, str]]
    targets: Report
    points: Sequence[Point]

    def text(self) -> str:
        """Return the report as it is printed."""
        tables = "\n\n".join(f"{title}\n{'─' * len(title)}\n{table}" for title, table in self.tables)
        return f"{self.head}\n\n{tables}\n\n{self.targets.text()}"

    def missed_targets(self) -> list[Measurement]:
        """Return the measurements that miss their target."""
        return self.targets.missed_targets()

    def files(self) -> dict[str, str | bytes]:
        """Return the files that go with the report, by the endings of their names."""
        return {".csv": points_csv(self.points), **draw_points(self.points)}


def check_files() -> None:
    """Refuse, before the long run, if its picture could not be drawn."""
    if find_spec("matplotlib") is None:
        rule = "Matplotlib, which draws the picture, is not installed"
        raise MissingPartError("--output", rule, "pip install matplotlib")


def report(quick: bool = False) -> AccuracyReport:
    """Return all measurements; `quick` takes fewer angles, rod ratios and orders."""
    available = available_targets()
    count, rounds, budget = (QUICK, 5, 0.3) if quick else (FULL, 15, 2.5)
    rows = [time_case(case, available.targets, count, rounds, budget) for case in CASES]
    calls = time_small_calls(CASES[0], available.targets, rounds)
    sweep = ErrorSweep(ratios=QUICK_RATIOS, orders=QUICK_ORDERS, passes=2) if quick else ErrorSweep()
    points = sweep.points(available.targets)
    forms = [t for t in available.targets if t == C] or list(available.targets[1:])
    cases, counts = (CLOSED_FORMS[1:3], (8, 16, 32)) if quick else (CLOSED_FORMS, COUNTS)
    crossings = crossovers(cases, [available.targets[0], *forms], counts)
    progress("coefficients")
    notes = "\n".join((*available.notes, *lacking()))
    tables = [
        (f"Time at {count:.0e} random angles, order 12", _with_notes(speed_table(rows), notes)),
        (f"Calls with few angles: {CASES[0].engine}", small_table(calls)),
        ("Error against run time, by engine, rod ratio and order", points_table(points)),
        ("Closed form or polynomial", crossover_table(crossings)),
    ]
    parts = [
        ("Beside copying the array", [m for row in rows for m in beside_copy(row)]),
        ("Beside the alternatives", [m for row in rows for m in beside_alternatives(row)]),
        ("Memory", [memory(CASES[1], count)]),
        ("Coefficients", time_coefficients(0.2 if quick else 1.0)),
    ]
    return AccuracyReport(_head(), tables, Report("Targets", parts), points)


def time_coefficients(budget: float = 0.5) -> list[Measurement]:
    """Measure all A_n to order 40 at some rod ratios, and their worst error in ulp."""
    return [_at(rho, ratio, budget) for rho, ratio in RHOS.items()]


def _at(rho: str, ratio: Fraction, budget: float) -> Measurement:
    seconds = best(lambda: acceleration_floats(HIGHEST, ratio), budget=0.1)
    other = best(lambda: by_mpmath(ratio, 15), budget=budget)
    off = worst_ulp(acceleration_floats(HIGHEST, ratio), ratio)
    return Measurement(
        f"A_2 to A_{HIGHEST} at rho = {rho}",
        seconds,
        "mpmath hyp2f1, 15 digits",
        other,
        f"at least {COEFFICIENT_TIMES} times as long, within {COEFFICIENT_ULP:g} ulp (here {off:.2f})",
        other >= COEFFICIENT_TIMES * seconds and off <= COEFFICIENT_ULP,
    )


def worst_ulp(values: dict[int, float], ratio: Fraction) -> float:
    """Return how many ulp the values of A_2, A_4, ... are off, at most."""
    with mp.workdps(60):
        true = by_mpmath(ratio, 40)
        return max(float(abs(values[n] - a) / ulp(float(abs(a)))) for n, a in true.items())


def by_mpmath(ratio: Fraction, digits: int) -> dict[int, Number]:
    """Return A_2 to A_40 from the closed form as it is written, each by itself.

    A_2k = (4 k^2/rho)(1 + k') C(1/2, k) q^k 2F1(-1/2, k - 1/2; k + 1; q^2), with q = (rho/(1 + k'))^2.
    """
    with mp.workdps(digits):
        rho, half, values = mp.mpf(ratio.denominator) / ratio.numerator, mp.mpf(0.5), {}
        for k in range(1, HIGHEST // 2 + 1):
            root = mp.sqrt((1 - rho) * (1 + rho))
            q = (rho / (1 + root)) ** 2
            lead = 4 * k * k / rho * (1 + root) * mp.binomial(half, k) * q**k
            values[2 * k] = lead * mp.hyp2f1(-half, k - half, k + 1, q * q)
        return values


def _with_notes(table: str, notes: str) -> str:
    return f"{table}\n{notes}" if notes else table


def _head() -> str:
    """Return the programs' versions and the processor."""
    parts = [f"Python {platform.python_version()}"]
    for name in ("numpy", "numba", "sympy", "mpmath", "heyoka"):
        try:
            parts.append(f"{name} {version(name)}")
        except PackageNotFoundError:
            continue
    return (
        f"{', '.join(parts)}\n{_processor()}, {os.cpu_count()} cores; times are the best of many, in turn"
    )


def _processor() -> str:
    """Return the processor's name where the system has it."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or platform.machine()
