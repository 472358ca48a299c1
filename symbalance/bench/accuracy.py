"""`symbalance bench accuracy`: error against run time of the evaluators, the alternatives beside them.

All that is timed runs in turn on one thread of this machine; errors are taken against exact kinematics
in mpmath. The parts are in `evaluating`: `speed` (long arrays, small calls, memory), `sweep` (order, rod
ratio and target), `crossover` (when a closed form pays), `coefficients`.
"""

from __future__ import annotations

import os
import platform
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from pathlib import Path

from symbalance.bench.evaluating.alternatives import lacking
from symbalance.bench.evaluating.candidates import C, standing
from symbalance.bench.evaluating.coefficients import coefficients
from symbalance.bench.evaluating.crossover import CASES as CLOSED
from symbalance.bench.evaluating.crossover import COUNTS, crossover_table, crossovers
from symbalance.bench.evaluating.picture import drawn
from symbalance.bench.evaluating.speed import (
    CASES,
    LONG,
    against_alternatives,
    against_copy,
    memory,
    small,
    small_table,
    speed_table,
    timed,
)
from symbalance.bench.evaluating.sweep import Point, Sweep, as_csv, sweep_table
from symbalance.bench.timing import Measurement, Report, progress
from symbalance.errors import MissingPartError

FULL, QUICK = LONG, 10**6
QUICK_RATIOS, QUICK_ORDERS = (Fraction(4), Fraction(10, 9)), (2, 8, None)


@dataclass(frozen=True)
class AccuracyReport:
    """Tables, then what was wanted of the numbers in them; `points` are those of the sweep."""

    head: str
    tables: Sequence[tuple[str, str]]
    judged: Report
    points: Sequence[Point]

    def text(self) -> str:
        """Return the report as it is printed."""
        tables = "\n\n".join(f"{title}\n{'─' * len(title)}\n{table}" for title, table in self.tables)
        return f"{self.head}\n\n{tables}\n\n{self.judged.text()}"

    def missed(self) -> list[Measurement]:
        """Return what did not reach the target stated for it."""
        return self.judged.missed()

    def files(self) -> dict[str, str | bytes]:
        """Return what is written beside the report, by the ending of the file's name."""
        return {".csv": as_csv(self.points), **drawn(self.points)}


def check_files() -> None:
    """Refuse, before the long run, if its picture could not be drawn."""
    if find_spec("matplotlib") is None:
        rule = "Matplotlib, which draws the picture, is not installed"
        raise MissingPartError("--output", rule, "pip install matplotlib")


def report(quick: bool = False) -> AccuracyReport:
    """Return all measurements; `quick` takes fewer angles, rod ratios and orders."""
    here = standing()
    count = QUICK if quick else FULL
    rows = [timed(case, here.targets, count, 5 if quick else 15, 1.0 if quick else 2.5) for case in CASES]
    calls = small(CASES[0], here.targets, 5 if quick else 15)
    sweep = Sweep(ratios=QUICK_RATIOS, orders=QUICK_ORDERS, passes=2) if quick else Sweep()
    points = sweep.points(here.targets)
    forms = [t for t in here.targets if t == C] or list(here.targets[1:])
    cases, counts = ((CLOSED[1], CLOSED[2]), (8, 16, 32)) if quick else (CLOSED, COUNTS)
    crossed = crossovers(cases, [here.targets[0], *forms], counts)
    progress("coefficients")
    notes = "\n".join((*here.notes, *lacking()))
    tables = [
        (f"Time at {count:.0e} random angles, order 12", _noted(speed_table(rows), notes)),
        (f"Calls with few angles: {CASES[0].engine}", small_table(calls)),
        ("Error against run time, by engine, rod ratio and order", sweep_table(points)),
        ("Closed form or polynomial", crossover_table(crossed)),
    ]
    parts = [
        ("Against copying the array", [m for row in rows for m in against_copy(row)]),
        ("Against the alternatives", [m for row in rows for m in against_alternatives(row)]),
        ("Memory", [memory(CASES[1], count)]),
        ("Coefficients", coefficients(0.2 if quick else 1.0)),
    ]
    return AccuracyReport(_head(), tables, Report("What was wanted", parts), points)


def _noted(table: str, notes: str) -> str:
    return f"{table}\n{notes}" if notes else table


def _head() -> str:
    """Return what the numbers were made with."""
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
    """Return the processor's name where the system tells it."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or platform.machine()
