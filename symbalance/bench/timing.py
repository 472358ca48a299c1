"""Timing that holds on a noisy machine: the best of many, two commands in turn, ratios in one run."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from statistics import median
from time import perf_counter


@dataclass(frozen=True)
class Measurement:
    """One line of a report: a time, what it is held against, and what was wanted of it."""

    what: str
    seconds: float
    against: str = ""
    other: float | None = None
    wanted: str = ""
    met: bool | None = None

    @property
    def ratio(self) -> float | None:
        """How many times longer the alternative takes."""
        return None if self.other is None else self.other / self.seconds


@dataclass(frozen=True)
class Report:
    """Measurements under titles, below a line on what they were made with."""

    head: str
    parts: Sequence[tuple[str, Sequence[Measurement]]]

    def text(self) -> str:
        """Return the report as it is printed."""
        body = "\n\n".join(f"{title}\n{'─' * len(title)}\n{table(rows)}" for title, rows in self.parts)
        return f"{self.head}\n\n{body}\n"

    def missed(self) -> list[Measurement]:
        """Return what did not reach the target stated for it."""
        return [m for _, rows in self.parts for m in rows if m.met is False]


def best(
    function: Callable[[], object],
    budget: float = 0.3,
    most: int = 1000,
    before: Callable[[], object] | None = None,
) -> float:
    """Return the least time of one call, over calls that fill `budget` seconds (at least one).

    `before` runs untimed before each call, to empty caches that would make a second call free.
    """
    least, spent, calls = float("inf"), 0.0, 0
    while calls == 0 or (spent < budget and calls < most):
        if before is not None:
            before()
        start = perf_counter()
        function()
        taken = perf_counter() - start
        least, spent, calls = min(least, taken), spent + taken, calls + 1
    return least


def processes(left: Sequence[str], right: Sequence[str], runs: int = 7) -> tuple[float, float, float]:
    """Return the median times of two commands run in turn, and the median of left/right pair by pair."""
    for command in (left, right):
        _process(command)
    pairs = [(_process(left), _process(right)) for _ in range(runs)]
    return median(p[0] for p in pairs), median(p[1] for p in pairs), median(a / b for a, b in pairs)


def _process(command: Sequence[str]) -> float:
    start = perf_counter()
    subprocess.run([sys.executable, *command], check=True, stdout=subprocess.DEVNULL)
    return perf_counter() - start


def progress(line: str) -> None:
    """Say on stderr what is being measured."""
    print(f"  {line} ...", file=sys.stderr, flush=True)


def seconds(value: float) -> str:
    """Return a time in a unit that suits it.

    >>> seconds(1.2e-5), seconds(0.0031), seconds(2.5)
    ('12.0 µs', '3.10 ms', '2.50 s')
    """
    for limit, factor, unit in ((1e-3, 1e6, "µs"), (1.0, 1e3, "ms")):
        if value < limit:
            return (
                f"{value * factor:.3g} {unit}"
                if value * factor >= 100
                else f"{value * factor:#.3g} {unit}"
            )
    return f"{value:#.3g} s"


def table(measurements: Sequence[Measurement]) -> str:
    """Return measurements as text, one paragraph each."""
    lines = []
    for m in measurements:
        verdict = "" if m.met is None else ("  met" if m.met else "  MISSED")
        lines.append(f"{m.what:<58} {seconds(m.seconds):>10}")
        if m.other is not None and m.ratio is not None:
            lines.append(f"  {m.against:<56} {seconds(m.other):>10}   {m.ratio:,.3g} times ours")
        if m.wanted:
            lines.append(f"  wanted: {m.wanted}{verdict}")
    return "\n".join(lines)
