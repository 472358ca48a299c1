"""`symbalance bench crankshaft`: error against run time of integrators for a running crankshaft.

An in-line four on five bearings, in 39 unknowns (modes and attachment vectors) and in full, then stiff
and extreme cases; symbalance's integrators beside SciPy's. Everything timed runs in one process on one
thread, in CPU seconds, which other work on the machine disturbs least; the reference is harmonic balance.
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
from dataclasses import dataclass, replace
from importlib import import_module
from importlib.metadata import version
from importlib.util import find_spec
from typing import Any

from symbalance.bench.integrator_runs import IntegratorSweep, Measurements, Run, measure
from symbalance.bench.timing import Measurement, Report, at_least
from symbalance.errors import MissingPartError

SYMBALANCE = ("radau-iia", "radau-iia-9")
"""symbalance's integrators; Newmark's rule, which it has too, is an alternative here."""
ERROR, TIMES = 1e-4, 15.0
"""The target: an error no larger, at least so many times as fast as SciPy's fastest that reaches it."""
THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")
INSTALL = "pip install 'symbalance[crankshaft]'"


@dataclass(frozen=True)
class CrankshaftReport:
    """Tables of the sweeps and of the extremes, then the target."""

    measurements: Measurements

    def text(self) -> str:
        """Return the report as it is printed."""
        sweeps = self.measurements.sweeps
        tables = [_with_title(f"One cycle at {s.case}, {s.model} model", runs_table(s)) for s in sweeps]
        title = "Stiff and extreme cases: fewest steps or loosest tolerance within 1e-4, else the best"
        tables.append(_with_title(title, extreme_table(self.measurements.extremes)))
        return "\n\n".join([_head(self.measurements), *tables, self.targets().text()])

    def targets(self) -> Report:
        """Return the goal, and whether it is met."""
        return Report("Targets", [("On the full model", [goal(self.measurements.sweeps[1])])])

    def missed_targets(self) -> list[Measurement]:
        """Return the measurements that miss their target."""
        return self.targets().missed_targets()

    def files(self) -> dict[str, str | bytes]:
        """Return the files that go with the report, by the endings of their names."""
        sweeps = [*self.measurements.sweeps, *self.measurements.extremes]
        pictures = draw_runs([run for s in self.measurements.sweeps for run in s.runs])
        return {".csv": runs_csv(sweeps), **pictures}


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


def loosest_within(runs: Sequence[Run]) -> list[Run]:
    """Return each method's first run within `ERROR`: the fewest steps, the loosest tolerance."""
    first: dict[str, Run] = {}
    for run in runs:
        if run.error <= ERROR and run.method not in first:
            first[run.method] = run
    return list(first.values())


def goal(sweep: IntegratorSweep) -> Measurement:
    """Return symbalance's fastest run beside SciPy's, each at its loosest setting within `ERROR`."""
    runs = loosest_within(sweep.runs)
    fastest = min((r for r in runs if r.method in SYMBALANCE), key=lambda r: r.seconds, default=None)
    others = [r for r in runs if r.method not in (*SYMBALANCE, "newmark")]
    other = min(others, key=lambda r: r.seconds, default=None)
    target = f"an error of {ERROR:g}, SciPy's fastest that has it taking {TIMES:g} times as long"
    if fastest is None:
        return Measurement("no integrator of symbalance is within it", math.inf, "", None, target, False)
    name = f"{fastest.label}, error {fastest.error:.1e}"
    if other is None:
        return Measurement(name, fastest.seconds, "", None, f"{target}; none did within its time", None)
    alternative = f"scipy {other.label}, error {other.error:.1e}"
    row = at_least(TIMES, name, fastest.seconds, alternative, other.seconds)
    return replace(row, target=target)


def runs_table(sweep: IntegratorSweep) -> str:
    """Return a sweep as text: a method a line, seconds and error per setting."""
    lines = []
    for method in dict.fromkeys(r.method for r in sweep.runs):
        cells = [_cell(r) for r in sweep.runs if r.method == method]
        lines.append(f"{method:<12} " + "  ".join(f"{c:<26}" for c in cells).rstrip())
    one, other = sweep.multipliers
    lines.append(f"reference: harmonic balance, itself within {sweep.uncertainty:.0e}")
    return "\n".join([*lines, f"largest multiplier {one:.4f}, {other:.4f}"])


def _cell(run: Run) -> str:
    if math.isnan(run.error):
        return f"{run.setting}: out of time"
    return f"{run.setting}: {run.error:.1e}, {run.seconds:.3g} s"


def extreme_table(sweeps: Sequence[IntegratorSweep]) -> str:
    """Return the extremes as text: per case each method's first run within `ERROR`, or its best."""
    lines = []
    for sweep in sweeps:
        lines.append(
            f"{sweep.case}, {sweep.model}: |multiplier| {sweep.multipliers[0]:.4g}, "
            f"reference to {sweep.uncertainty:.0e}"
        )
        for method in dict.fromkeys(r.method for r in sweep.runs):
            runs = [r for r in sweep.runs if r.method == method]
            best = min(runs, key=lambda r: math.inf if math.isnan(r.error) else r.error)
            run = next((r for r in runs if r.error <= ERROR), best)
            lines.append(f"  {method:<12} {_cell(run)}")
    return "\n".join(lines)


def runs_csv(sweeps: Sequence[IntegratorSweep]) -> str:
    """Return all runs as CSV."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(["case", "model", "method", "setting", "seconds", "error", "reference", "multiplier"])
    for sweep in sweeps:
        for r in sweep.runs:
            row = [r.case, r.model, r.method, r.setting, f"{r.seconds:.6g}", f"{r.error:.6g}"]
            writer.writerow([*row, f"{sweep.uncertainty:.3g}", f"{sweep.multipliers[0]:.6g}"])
    return stream.getvalue()


def _with_title(title: str, table: str) -> str:
    return f"{title}\n{'─' * len(title)}\n{table}"


def _head(measurements: Measurements) -> str:
    programs = f"Python {platform.python_version()}, numpy {version('numpy')}, scipy {version('scipy')}"
    low, high, most = measurements.film
    return (
        f"{programs}; one thread, CPU seconds, {os.cpu_count()} cores\n"
        f"In-line four, {measurements.sizes[0]} unknowns reduced, {measurements.sizes[1]} in full, "
        f"five bearings with housings; films at 2200 rpm: direct terms {low:.1e} to {high:.1e} N/m, "
        f"cross terms to {most:.1e} N/m"
    )


def draw_runs(runs: Sequence[Run]) -> dict[str, bytes]:
    """Return error against run time as .png and .pdf, one panel a model."""
    import_module("matplotlib").use("Agg")
    pyplot = import_module("matplotlib.pyplot")
    panels = list(dict.fromkeys((r.case, r.model) for r in runs))
    figure, axes = pyplot.subplots(1, len(panels), figsize=(5.5 * len(panels), 4.5), squeeze=False)
    for axis, panel in zip(axes[0], panels, strict=True):
        _panel(axis, [r for r in runs if (r.case, r.model) == panel])
        axis.set_title(", ".join(panel))
    figure.tight_layout()
    files = {}
    for ending in ("png", "pdf"):
        stream = io.BytesIO()
        figure.savefig(
            stream, format=ending, dpi=130, metadata={"CreationDate": None} if ending == "pdf" else None
        )
        files[f".{ending}"] = stream.getvalue()
    pyplot.close(figure)
    return files


def _panel(axis: Any, runs: Sequence[Run]) -> None:
    for method in dict.fromkeys(r.method for r in runs):
        points = [(r.seconds, r.error) for r in runs if r.method == method and not math.isnan(r.error)]
        if points:
            style = (
                {"linewidth": 2.2, "marker": "o"}
                if method in SYMBALANCE
                else {"linewidth": 1, "marker": "x"}
            )
            axis.loglog(*zip(*points, strict=True), label=method, **style)
    axis.axhline(1e-4, color="grey", linewidth=0.7, linestyle=":")
    axis.set_xlabel("CPU seconds for one cycle, preparation included")
    axis.set_ylabel("largest error, relative")
    axis.grid(True, which="major", linewidth=0.3)
    axis.legend(fontsize=8)
