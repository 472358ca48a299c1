"""How long an array of angles takes, held against copying the array, and against the alternatives."""

from __future__ import annotations

import tracemalloc
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from symbalance.bench.evaluating.alternatives import (
    LAMBDIFY,
    NUMBA_COS,
    PER_CYLINDER,
    alternative,
    present,
)
from symbalance.bench.evaluating.candidates import COMPILED, NUMBA, NUMPY, Candidate, calls, ours
from symbalance.bench.evaluating.cases import Case
from symbalance.bench.evaluating.rounds import Times, in_turn
from symbalance.bench.timing import Measurement, progress, seconds

CASES = (
    Case("inline-6", "force.vertical"),
    Case("v12-60", "force.vertical"),
    Case("v8-90", "force.vertical"),
    Case("v8-90", "couple.vertical"),
    Case("inline-4", "force.vertical"),
)
COPY, NEW = "np.copyto", ", new array"
AS_COPY, MEMORY, LONG = 1.5, 1.1, 10**7
PER_CYLINDER_TIMES = {"inline-6": 200, "v12-60": 500}
CANCELLED_TIMES = 20
NUMPY_TIMES = {LAMBDIFY: 1.5, PER_CYLINDER: 20}
SMALL = (1, 10, 1000)
REPEAT = {1: 300, 10: 300, 1000: 60}


@dataclass(frozen=True)
class Timed:
    """The times of all candidates for one case, at so many angles."""

    case: Case
    count: int
    times: dict[str, Times]

    def best(self, name: str) -> float:
        """Return a candidate's best time, seconds."""
        return self.times[name].best

    def ratio(self, slow: str, fast: str) -> float:
        """Return how many times longer one candidate takes than another."""
        return self.best(slow) / self.best(fast)


def candidates(case: Case, targets: Sequence[str]) -> dict[str, Candidate]:
    """Return ours and the alternatives by name, compiled."""
    found = {target: ours(case, target) for target in targets}
    return found | {name: alternative(case, name) for name in present()}


def timed(case: Case, targets: Sequence[str], count: int, rounds: int, budget: float) -> Timed:
    """Time all candidates in turn on `count` random angles over two turns, arrays touched before."""
    progress(f"{case.engine} {case.output} at {count:.0e} angles")
    theta, out = angles(count), np.ones(count)
    found = candidates(case, targets)
    functions: dict[str, Callable[[], object]] = {COPY: lambda: np.copyto(out, theta)}
    functions |= calls(found, theta, out)
    for target in targets:
        functions[target + NEW] = lambda one=found[target]: one(theta)
    return Timed(case, count, in_turn(functions, rounds, budget))


def small(case: Case, targets: Sequence[str], rounds: int) -> list[Timed]:
    """Time single calls with few angles."""
    progress(f"{case.engine}: calls with few angles")
    found = candidates(case, targets)
    rows = []
    for count in SMALL:
        theta, out = angles(count), np.ones(count)
        functions = {COPY: lambda theta=theta, out=out: np.copyto(out, theta)} | calls(found, theta, out)
        rows.append(Timed(case, count, in_turn(functions, rounds, 2.0, REPEAT[count])))
    return rows


def angles(count: int) -> np.ndarray:
    """Return random crank angles over two turns."""
    return np.random.default_rng(1).uniform(0.0, 4 * np.pi, count)


def speed_table(rows: Sequence[Timed]) -> str:
    """Return nanoseconds an angle, best and (median), and how many copies that is."""
    heads = [f"{row.case.engine} {row.case.output[:6].rstrip('.')}" for row in rows]
    lines = [f"{'':<20}" + "".join(f"{head:>23}" for head in heads)]
    for name in rows[0].times:
        cells = [_cell(row, name) for row in rows]
        lines.append(f"{name:<20}" + "".join(f"{cell:>23}" for cell in cells))
    return "\n".join([*lines, "nanoseconds an angle: best, (median), and the best in times of np.copyto"])


def _cell(row: Timed, name: str) -> str:
    times = row.times[name].over(row.count)
    cells = (times.best * 1e9, times.median * 1e9, row.ratio(name, COPY))
    return "{} ({}) {:>6}x".format(*map(short, cells))


def short(value: float) -> str:
    """Return three digits, or a whole number.

    >>> short(1083.2), short(0.74031)
    ('1083', '0.74')
    """
    return f"{value:.0f}" if value >= 100 else f"{value:.3g}"


def small_table(rows: Sequence[Timed]) -> str:
    """Return the time of a call by the number of angles."""
    lines = [f"{'':<20}" + "".join(f"{f'{row.count} angles':>16}" for row in rows)]
    for name in rows[0].times:
        lines.append(f"{name:<20}" + "".join(f"{seconds(row.best(name)):>16}" for row in rows))
    return "\n".join(lines)


def against_copy(row: Timed) -> list[Measurement]:
    """Judge the compiled targets by np.copyto: of arrays too long for any cache."""
    found = []
    for target in COMPILED:
        if target in row.times:
            ratio = row.ratio(target, COPY)
            where = "" if row.count >= LONG else f" at {LONG:.0e} angles"
            wanted = f"at most {AS_COPY:g} times as long{where} (here {ratio:.2f} times)"
            met = ratio <= AS_COPY if row.count >= LONG else None
            found.append(_measured(row, target, COPY, wanted, met))
    return found


def against_alternatives(row: Timed) -> list[Measurement]:
    """Judge Numba and NumPy alone by the alternatives."""
    wanted = [(NUMPY, name, times) for name, times in NUMPY_TIMES.items()]
    if NUMBA in row.times:
        wanted += [(NUMBA, name, CANCELLED_TIMES) for name in (LAMBDIFY, NUMBA_COS)]
        if row.case.engine in PER_CYLINDER_TIMES:
            wanted.append((NUMBA, PER_CYLINDER, PER_CYLINDER_TIMES[row.case.engine]))
    return [
        _measured(row, target, name, f"at least {times:g} times faster", row.ratio(name, target) >= times)
        for target, name, times in wanted
    ]


def _measured(row: Timed, target: str, other: str, wanted: str, met: bool | None) -> Measurement:
    what = f"{row.case.engine} {row.case.output}, {target}, {row.count:.0e} angles"
    return Measurement(what, row.best(target), other, row.best(other), wanted, met)


def memory(case: Case, count: int) -> Measurement:
    """Measure what the NumPy target allocates for a new array of values, which NumPy reports."""
    function, theta = ours(case, NUMPY), angles(count)
    tracemalloc.start()
    try:
        values = function(theta)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    part = (theta.nbytes + peak) / (theta.nbytes + values.nbytes)
    spent = in_turn({NUMPY: lambda: function(theta)}, 2)[NUMPY].best
    return Measurement(
        f"{case.engine}, numpy, {count:.0e} angles, new array",
        spent,
        wanted=f"peak memory at most {MEMORY:g} times inputs plus outputs (here {part:.3f} times)",
        met=part <= MEMORY,
    )
