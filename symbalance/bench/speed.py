"""Time of evaluating arrays of crank angles, beside copying the array and beside the alternatives."""

from __future__ import annotations

import tracemalloc
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from symbalance.bench.accuracy_alternatives import (
    HEYOKA,
    HEYOKA_POWERS,
    LAMBDIFY,
    NUMBA_COS,
    PER_CYLINDER,
    alternative,
    present,
)
from symbalance.bench.evaluated_outputs import (
    COMPILED,
    NUMBA,
    NUMPY,
    Candidate,
    EvaluatedOutput,
    calls,
    candidate,
)
from symbalance.bench.timing import Measurement, Times, at_least, at_most, in_turn, progress, time_text

CASES = (
    EvaluatedOutput("inline-6", "force.vertical"),
    EvaluatedOutput("v12-60", "force.vertical"),
    EvaluatedOutput("v8-90", "force.vertical"),
    EvaluatedOutput("v8-90", "couple.vertical"),
    EvaluatedOutput("inline-4", "force.vertical"),
)
COPY, NEW = "np.copyto", ", new array"
COPY_TIMES, MEMORY, LONG = 1.5, 1.1, 10**7
"""Targets: a compiled function takes at most so many times as long as a copy, of arrays too long for any
cache; the peak memory is at most so many times inputs plus outputs."""
PER_CYLINDER_TIMES = {"inline-6": 200, "v12-60": 500}
NUMBA_TIMES = {LAMBDIFY: 20, NUMBA_COS: 20, HEYOKA: 1.5, HEYOKA_POWERS: 1.5}
NUMPY_TIMES = {LAMBDIFY: 1.5, PER_CYLINDER: 20}
"""How many times as long the alternatives take, at least, by the target they are compared with."""
NUMPY_AT_MOST = {HEYOKA_POWERS: 8}
"""heyoka compiles, NumPy alone does not: how many times as long it takes than that, at most."""
SMALL = (1, 10, 1000)
REPEAT = {1: 300, 10: 300, 1000: 60}


@dataclass(frozen=True)
class CaseTimes:
    """The times of all candidates for one case, at so many angles."""

    case: EvaluatedOutput
    count: int
    times: dict[str, Times]

    def best(self, name: str) -> float:
        """Return a candidate's best time, seconds."""
        return self.times[name].best

    def ratio(self, slow: str, fast: str) -> float:
        """Return how many times longer one candidate takes than another."""
        return self.best(slow) / self.best(fast)


def candidates(case: EvaluatedOutput, targets: Sequence[str]) -> dict[str, Candidate]:
    """Return symbalance's functions and the alternatives by name, compiled."""
    functions = {target: candidate(case, target) for target in targets}
    return functions | {name: alternative(case, name) for name in present()}


def time_case(
    case: EvaluatedOutput, targets: Sequence[str], count: int, rounds: int, budget: float
) -> CaseTimes:
    """Time all candidates in turn on `count` random angles over two turns, arrays touched before."""
    progress(f"{case.engine} {case.output} at {count:.0e} angles")
    theta, out = angles(count), np.ones(count)
    rivals = candidates(case, targets)
    functions: dict[str, Callable[[], object]] = {COPY: lambda: np.copyto(out, theta)}
    functions |= calls(rivals, theta, out)
    for target in targets:
        functions[target + NEW] = lambda one=rivals[target]: one(theta)
    return CaseTimes(case, count, in_turn(functions, rounds, budget))


def time_small_calls(case: EvaluatedOutput, targets: Sequence[str], rounds: int) -> list[CaseTimes]:
    """Time single calls with few angles."""
    progress(f"{case.engine}: calls with few angles")
    rivals = candidates(case, targets)
    rows = []
    for count in SMALL:
        theta, out = angles(count), np.ones(count)
        functions = {COPY: lambda theta=theta, out=out: np.copyto(out, theta)} | calls(rivals, theta, out)
        rows.append(CaseTimes(case, count, in_turn(functions, rounds, 2.0, REPEAT[count])))
    return rows


def angles(count: int) -> np.ndarray:
    """Return random crank angles over two turns."""
    return np.random.default_rng(1).uniform(0.0, 4 * np.pi, count)


def speed_table(rows: Sequence[CaseTimes]) -> str:
    """Return nanoseconds an angle, best and (median), and how many copies that is."""
    heads = [f"{row.case.engine} {row.case.output[:6].rstrip('.')}" for row in rows]
    lines = [f"{'':<20}" + "".join(f"{head:>23}" for head in heads)]
    for name in rows[0].times:
        cells = [_cell(row, name) for row in rows]
        lines.append(f"{name:<20}" + "".join(f"{cell:>23}" for cell in cells))
    return "\n".join([*lines, "nanoseconds an angle: best, (median), and the best in times of np.copyto"])


def _cell(row: CaseTimes, name: str) -> str:
    times = row.times[name].over(row.count)
    cells = (times.best * 1e9, times.median * 1e9, row.ratio(name, COPY))
    return "{} ({}) {:>6}x".format(*map(three_digits, cells))


def three_digits(value: float) -> str:
    """Return three digits, or a whole number.

    >>> three_digits(1083.2), three_digits(0.74031)
    ('1083', '0.74')
    """
    return f"{value:.0f}" if value >= 100 else f"{value:.3g}"


def small_table(rows: Sequence[CaseTimes]) -> str:
    """Return the time of a call by the number of angles."""
    lines = [f"{'':<20}" + "".join(f"{f'{row.count} angles':>16}" for row in rows)]
    for name in rows[0].times:
        lines.append(f"{name:<20}" + "".join(f"{time_text(row.best(name)):>16}" for row in rows))
    return "\n".join(lines)


def beside_copy(row: CaseTimes) -> list[Measurement]:
    """Judge the compiled targets by np.copyto: of arrays too long for any cache."""
    rows = []
    for target in COMPILED:
        if target in row.times:
            ratio = row.ratio(target, COPY)
            where = "" if row.count >= LONG else f" at {LONG:.0e} angles"
            limit = f"at most {COPY_TIMES:g} times as long{where} (here {ratio:.2f} times)"
            is_met = ratio <= COPY_TIMES if row.count >= LONG else None
            times = row.best(target), COPY, row.best(COPY)
            rows.append(Measurement(_name(row, target), *times, limit, is_met))
    return rows


def beside_alternatives(row: CaseTimes) -> list[Measurement]:
    """Judge Numba and NumPy alone by the alternatives that can run here."""
    pairs = [(NUMPY, name, times) for name, times in NUMPY_TIMES.items()]
    if NUMBA in row.times:
        pairs += [(NUMBA, name, times) for name, times in NUMBA_TIMES.items()]
        if row.case.engine in PER_CYLINDER_TIMES:
            pairs.append((NUMBA, PER_CYLINDER, PER_CYLINDER_TIMES[row.case.engine]))
    rows = [
        at_least(times, _name(row, target), row.best(target), name, row.best(name))
        for target, name, times in pairs
        if name in row.times
    ]
    rows += [
        at_most(times, _name(row, NUMPY), row.best(NUMPY), name, row.best(name))
        for name, times in NUMPY_AT_MOST.items()
        if name in row.times
    ]
    return rows


def _name(row: CaseTimes, target: str) -> str:
    return f"{row.case.engine} {row.case.output}, {target}, {row.count:.0e} angles"


def memory(case: EvaluatedOutput, count: int) -> Measurement:
    """Measure what the NumPy target allocates for a new array of values, which NumPy reports."""
    function, theta = candidate(case, NUMPY), angles(count)
    tracemalloc.start()
    try:
        values = function(theta)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    part = (theta.nbytes + peak) / (theta.nbytes + values.nbytes)
    seconds = in_turn({NUMPY: lambda: function(theta)}, 2)[NUMPY].best
    return Measurement(
        f"{case.engine}, numpy, {count:.0e} angles, new array",
        seconds,
        target=f"peak memory at most {MEMORY:g} times inputs plus outputs (here {part:.3f} times)",
        is_met=part <= MEMORY,
    )
