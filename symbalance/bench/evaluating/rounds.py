"""Times taken in turn: every candidate once a round, so that a noisy minute hits all alike."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from statistics import median
from time import perf_counter
from typing import TypeVar

Key = TypeVar("Key", bound=Hashable)
LEAST = 3


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
    least: int = LEAST,
) -> dict[Key, Times]:
    """Return each function's times over so many rounds; who has spent `budget` seconds sits out.

    Everyone has at least `least` rounds. `repeat` calls make one measurement, for what is too short for
    the clock; the times are those of one call.
    """
    taken: dict[Key, list[float]] = {name: [] for name in functions}
    for _ in range(rounds):
        for name, function in functions.items():
            if len(taken[name]) < least or sum(taken[name]) < budget:
                start = perf_counter()
                for _ in range(repeat):
                    function()
                taken[name].append(perf_counter() - start)
    return {name: Times(min(t), median(t)).over(repeat) for name, t in taken.items()}
