"""`symbalance bench crankshaft`: integrators of the running crankshaft, error against run time.

An in-line four on five bearings, in 39 unknowns (modes and attachment vectors) and in full, then stiff
and extreme cases. Everything timed runs in one process on one thread, in CPU seconds, which other work on
the machine disturbs least; the reference is harmonic balance.
"""

from __future__ import annotations

import csv
import io
import math
import multiprocessing
import os
import platform
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from importlib.util import find_spec

from symbalance.bench.integrating.measuring import Extreme, Measured, measure
from symbalance.bench.integrating.picture import OURS, drawn
from symbalance.bench.integrating.runs import Run
from symbalance.bench.timing import Measurement, Report
from symbalance.errors import MissingPartError

WANTED, TIMES = 1e-4, 15.0
THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")
INSTALL = "pip install 'symbalance[crankshaft]'"


@dataclass(frozen=True)
class CrankshaftReport:
    """Tables of the sweeps and of the extremes, then what was wanted."""

    measured: Measured

    def text(self) -> str:
        """Return the report as it is printed."""
        found = self.measured
        tables = [
            f"One cycle at {e.case}, {e.model} model\n{_rule(e)}\n{sweep_table(e)}" for e in found.sweeps
        ]
        title = "Stiff and extreme cases: fewest steps or loosest tolerance within 1e-4, else the best"
        tables.append(f"{title}\n{'─' * len(title)}\n{extreme_table(found.extremes)}")
        return f"{_head(found)}\n\n" + "\n\n".join(tables) + f"\n\n{self.judged().text()}"

    def judged(self) -> Report:
        """Return the goal, and whether it is met."""
        return Report("What was wanted", [("On the full model", [goal(self.measured.sweeps[1])])])

    def missed(self) -> list[Measurement]:
        """Return what did not reach the target stated for it."""
        return self.judged().missed()

    def files(self) -> dict[str, str | bytes]:
        """Return what is written beside the report, by the ending of the file's name."""
        every = [*self.measured.sweeps, *self.measured.extremes]
        pictured = drawn([run for e in self.measured.sweeps for run in e.runs])
        return {".csv": as_csv(every), **pictured}


def check_files() -> None:
    """Refuse, before the long run, if its picture could not be drawn."""
    if find_spec("matplotlib") is None:
        raise MissingPartError(
            "--output", "Matplotlib, which draws the picture, is not installed", INSTALL
        )


def report(quick: bool = False) -> CrankshaftReport:
    """Return all measurements, made in a process of their own with one thread."""
    if find_spec("scipy") is None:
        raise MissingPartError("bench crankshaft", "SciPy, the alternative, is not installed", INSTALL)
    before = {name: os.environ.get(name) for name in THREADS}
    os.environ.update(dict.fromkeys(THREADS, "1"))
    try:
        with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as one:
            return CrankshaftReport(one.submit(measure, quick).result())
    finally:
        for name, value in before.items():
            os.environ.pop(name) if value is None else os.environ.update({name: value})


def reaching(runs: Sequence[Run]) -> list[Run]:
    """Return each method's first run within `WANTED`: the fewest steps, the loosest tolerance."""
    first: dict[str, Run] = {}
    for run in runs:
        if run.error <= WANTED and run.method not in first:
            first[run.method] = run
    return list(first.values())


def goal(sweep: Extreme) -> Measurement:
    """Return ours beside the fastest of SciPy's, both at their loosest setting within `WANTED`."""
    reached = reaching(sweep.runs)
    ours = min((r for r in reached if r.method in OURS), key=lambda r: r.seconds, default=None)
    others = [r for r in reached if r.method not in (*OURS, "newmark")]
    other = min(others, key=lambda r: r.seconds, default=None)
    wanted = (
        f"an error of {WANTED:g} at least {TIMES:g} times faster than SciPy's fastest that reaches it"
    )
    if ours is None:
        return Measurement("none of ours reaches it", math.inf, "", None, wanted, False)
    what = f"{ours.named}, error {ours.error:.1e}"
    if other is None:
        return Measurement(what, ours.seconds, "", None, f"{wanted}; none did within its time", None)
    against = f"scipy {other.named}, error {other.error:.1e}"
    met = other.seconds / ours.seconds >= TIMES
    return Measurement(what, ours.seconds, against, other.seconds, wanted, met)


def sweep_table(sweep: Extreme) -> str:
    """Return a sweep as text: a method a line, seconds and error per setting."""
    lines = []
    for method in dict.fromkeys(r.method for r in sweep.runs):
        cells = [_cell(r) for r in sweep.runs if r.method == method]
        lines.append(f"{method:<12} " + "  ".join(f"{c:<26}" for c in cells).rstrip())
    doubt = f"reference: harmonic balance, itself within {sweep.uncertain:.0e}"
    return "\n".join(
        [*lines, doubt, f"largest multiplier {sweep.multipliers[0]:.4f}, {sweep.multipliers[1]:.4f}"]
    )


def _cell(run: Run) -> str:
    if math.isnan(run.error):
        return f"{run.setting}: out of time"
    return f"{run.setting}: {run.error:.1e}, {run.seconds:.3g} s"


def extreme_table(extremes: Sequence[Extreme]) -> str:
    """Return the extremes as text: per case each method's first run within 1e-4, or its best."""
    lines = []
    for e in extremes:
        lines.append(
            f"{e.case}, {e.model}: |multiplier| {e.multipliers[0]:.4g}, reference to {e.uncertain:.0e}"
        )
        for method in dict.fromkeys(r.method for r in e.runs):
            runs = [r for r in e.runs if r.method == method]
            best = min(runs, key=lambda r: math.inf if math.isnan(r.error) else r.error)
            shown = next((r for r in runs if r.error <= WANTED), best)
            lines.append(f"  {method:<12} {_cell(shown)}")
    return "\n".join(lines)


def as_csv(extremes: Sequence[Extreme]) -> str:
    """Return all runs as CSV."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(["case", "model", "method", "setting", "seconds", "error", "reference", "multiplier"])
    for e in extremes:
        for r in e.runs:
            row = [r.case, r.model, r.method, r.setting, f"{r.seconds:.6g}", f"{r.error:.6g}"]
            writer.writerow([*row, f"{e.uncertain:.3g}", f"{e.multipliers[0]:.6g}"])
    return stream.getvalue()


def _rule(sweep: Extreme) -> str:
    return "─" * len(f"One cycle at {sweep.case}, {sweep.model} model")


def _head(found: Measured) -> str:
    from importlib.metadata import version

    made = f"Python {platform.python_version()}, numpy {version('numpy')}, scipy {version('scipy')}"
    low, high, most = found.film
    return (
        f"{made}; one thread, CPU seconds, {os.cpu_count()} cores\n"
        f"In-line four, {found.sizes[0]} unknowns reduced, {found.sizes[1]} in full, "
        f"five bearings with housings; films at 2200 rpm: direct terms {low:.1e} to {high:.1e} N/m, "
        f"cross terms to {most:.1e} N/m"
    )
