"""Timing on a noisy machine: best of many calls, competitors in turn, ratios within one run."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass
from statistics import median
from time import perf_counter
from typing import TypeVar

Key = TypeVar("Key", bound=Hashable)
LEAST_ROUNDS = 3
"""Rounds that even the slowest function has, so that its median means something."""


@dataclass(frozen=True)
class Measurement:
    """One line of a report: a time, an alternative's, and the target stated for them.

    `is_met` tells whether the target is met; None where none applies.
    """

    name: str
    seconds: float
    alternative: str = ""
    alternative_seconds: float | None = None
    target: str = ""
    is_met: bool | None = None

    @property
    def ratio(self) -> float | None:
        """How many times as long the alternative takes."""
        return None if self.alternative_seconds is None else self.alternative_seconds / self.seconds


def at_least(times: float, name: str, seconds: float, other: str, other_seconds: float) -> Measurement:
    """Return a measurement whose target is that the alternative takes at least so many times as long."""
    is_met = other_seconds >= times * seconds
    return Measurement(name, seconds, other, other_seconds, f"at least {times:,g} times as long", is_met)


def at_most(times: float, name: str, seconds: float, other: str, other_seconds: float) -> Measurement:
    """Return a measurement whose target is to take at most so many times the alternative's time."""
    is_met = seconds <= times * other_seconds
    target = f"no more than {times:g} times that (here {seconds / other_seconds:.2f} times)"
    return Measurement(name, seconds, other, other_seconds, target, is_met)


@dataclass(frozen=True)
class Report:
    """Measurements under titles, below a line on the programs and the machine they are of."""

    head: str
    parts: Sequence[tuple[str, Sequence[Measurement]]]

    def text(self) -> str:
        """Return the report as it is printed."""
        body = "\n\n".join(f"{title}\n{'─' * len(title)}\n{table(rows)}" for title, rows in self.parts)
        return f"{self.head}\n\n{body}\n"

    def missed_targets(self) -> list[Measurement]:
        """Return the measurements that miss their target."""
        return [m for _, rows in self.parts for m in rows if m.is_met is False]


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
        duration = perf_counter() - start
        least, spent, calls = min(least, duration), spent + duration, calls + 1
    return least


@dataclass(frozen=True)
class Times:
    """The best and the median of some rounds, seconds."""

    best: float
    median: float

    def over(self, count: int) -> Times:
        """Return the times of one of `count` equal parts."""
        return Times(self.best / count, self.median / count)


def in_turn(
    functions: Mapping[Key, Callable[[], object]],
    rounds: int,
    budget: float = 5.0,
    repeat: int = 1,
    least: int = LEAST_ROUNDS,
) -> dict[Key, Times]:
    """Return each function's times over so many rounds; one that has spent `budget` seconds sits out.

    Every function runs once a round, so that a noisy minute hits all alike, and has at least `least`
    rounds. `repeat` calls make one measurement, for what is too short for the clock; the times are those
    of one call.
    """
    durations: dict[Key, list[float]] = {name: [] for name in functions}
    for _ in range(rounds):
        for name, function in functions.items():
            if len(durations[name]) < least or sum(durations[name]) < budget:
                start = perf_counter()
                for _ in range(repeat):
                    function()
                durations[name].append(perf_counter() - start)
    return {name: Times(min(d), median(d)).over(repeat) for name, d in durations.items()}


def processes(
    command: Sequence[str], alternative: Sequence[str], runs: int = 7
) -> tuple[float, float, float]:
    """Return the median times of two Python commands run in turn, and of their ratio pair by pair."""
    for arguments in (command, alternative):  # once untimed: the files are then in the system's cache
        _process(arguments)
    pairs = [(_process(command), _process(alternative)) for _ in range(runs)]
    return median(p[0] for p in pairs), median(p[1] for p in pairs), median(a / b for a, b in pairs)


def _process(arguments: Sequence[str]) -> float:
    start = perf_counter()
    subprocess.run([sys.executable, *arguments], check=True, stdout=subprocess.DEVNULL)
    return perf_counter() - start


def progress(line: str) -> None:
    """Write to stderr what is being measured."""
    print(f"  {line} ...", file=sys.stderr, flush=True)


def time_text(seconds: float) -> str:
    """Return a time in a unit that suits it.

    >>> time_text(1.2e-5), time_text(0.0031), time_text(2.5)
    ('12.0 µs', '3.10 ms', '2.50 s')
    """
    for limit, factor, unit in ((1e-3, 1e6, "µs"), (1.0, 1e3, "ms")):
        if seconds < limit:
            number = seconds * factor
            return f"{number:.3g} {unit}" if number >= 100 else f"{number:#.3g} {unit}"
    return f"{seconds:#.3g} s"


def table(measurements: Sequence[Measurement]) -> str:
    """Return measurements as text, one paragraph each."""
    lines = []
    for m in measurements:
        verdict = "" if m.is_met is None else ("  met" if m.is_met else "  MISSED")
        lines.append(f"{m.name:<58} {time_text(m.seconds):>10}")
        if m.alternative_seconds is not None and m.ratio is not None:
            row = f"  {m.alternative:<56} {time_text(m.alternative_seconds):>10}"
            lines.append(f"{row}   {m.ratio:,.3g} times as long")
        if m.target:
            lines.append(f"  target: {m.target}{verdict}")
    return "\n".join(lines)
