"""`symbalance bench search`: stars and nodes a second, what workers add, and how far more cylinders are.

Stars are those of which an in-line twelve's four orders are known exactly; nodes those of a search with
bounds. What 18 and 20 cylinders would take is on paper: their nodes under the same
bounds, estimated from subtrees that are walked (`symbalance.search.tree_size`), over the nodes a second
measured here; the same estimate of 15 cylinders stands beside what was walked.
"""

from __future__ import annotations

import os
import platform
from time import perf_counter
from typing import Any

from symbalance.bench.timing import Measurement, Report, progress
from symbalance.search.cranks_search import search_cranks, search_spec
from symbalance.search.search_result import CrankSearch
from symbalance.search.tree_size import estimate_nodes

STARS, NODES = 3_000_000, 20_000_000
"""Targets, a second of one core."""
ORDERS = ("couple.1", "couple.2", "couple.4", "couple.6")
BOUNDED = ("couple.1<=0.05", "couple.2<=0.05")


def report(quick: bool = False) -> Report:
    """Return all measurements; `quick` leaves out what takes a minute."""
    search_cranks(5, compiled=True, minimize=["couple.1"])  # Numba compiles, or loads, once
    twelve = 11 if quick else 12
    timed = [_timed(twelve, minimize=ORDERS), _timed(14, limit=BOUNDED), _timed(15, limit=BOUNDED)]
    (free, free_seconds), *bounded = timed
    most, most_seconds = bounded[-1]
    parts = [
        (
            "One core",
            [
                _rate(
                    f"stars of an in-line {twelve}, four orders", free.searched.stars, free_seconds, STARS
                ),
                _rate("nodes of an in-line 15 with bounds", most.tally.nodes, most_seconds, NODES),
            ],
        ),
        (f"Workers, the in-line {SHARED}", [] if quick else _shared()),
        (
            "On paper, 1,000 cores, the same bounds",
            _on_paper(most.tally.nodes, most_seconds, SAMPLES // 25 if quick else SAMPLES),
        ),
    ]
    head = f"Python {platform.python_version()}, {platform.machine()}"
    return Report(head, [(title, rows) for title, rows in parts if rows])


def _timed(count: int, **asked: Any) -> tuple[CrankSearch, float]:
    progress(f"{count} cylinders")
    began = perf_counter()
    result = search_cranks(count, strokes=2, compiled=True, **asked)
    return result, perf_counter() - began


def _rate(name: str, count: int, seconds: float, least: int) -> Measurement:
    target = f"at least {least:,} a second (here {count / seconds:,.0f})"
    return Measurement(f"{name}: {count:,}", seconds, target=target, is_met=count / seconds >= least)


SHARED = 16
"""Cylinders of the search that workers share: less would be over before they have started."""


def _shared() -> list[Measurement]:
    """Return what one, two, four, … workers take for one search, as many as there are cores."""
    rows: list[Measurement] = []
    alone: CrankSearch | None = None
    seconds = 0.0
    workers = 1
    while workers <= (os.cpu_count() or 1):
        shared, needed = _timed(SHARED, limit=BOUNDED, workers=workers)
        alone, seconds = (shared, needed) if alone is None else (alone, seconds)
        if shared.data() != alone.data():
            raise AssertionError("the answer depends on the workers")
        name = f"{workers} worker{'s, their start included' if workers > 1 else ''}"
        rate = f"{name}: {shared.tally.nodes / needed:,.0f} nodes a second"
        if workers == 1:
            rows.append(Measurement(rate, needed))
        else:
            rows.append(Measurement(rate, needed, "1 worker", seconds))
        workers *= 2
    return rows


SAMPLES = 500
"""Subtrees of which the nodes of a search are estimated."""


def _on_paper(nodes: int, seconds: float, samples: int) -> list[Measurement]:
    """Return what further cylinders would take at the nodes a second that 15 took, with the spread."""
    rows = []
    for count in (15, 18, 20):
        progress(f"{count} cylinders, sampled")
        spec = search_spec(count, strokes=2, limit=BOUNDED, compiled=True)
        # Deeper beginnings cost less, and spread more: these take some ten seconds each, of one core.
        size = estimate_nodes(spec, count // 2 - 3, samples)
        name = f"{count} cylinders: {size.nodes:.3g} nodes ± {100 * size.error / size.nodes:.0f} %"
        also = f", walked were {nodes:.3g}" if count == 15 else ""
        rows.append(Measurement(f"{name}{also}", size.nodes / nodes * seconds / 1000))
    return rows
