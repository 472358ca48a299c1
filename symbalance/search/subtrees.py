"""A search in parts: the stars that begin alike are one job, and any executor may do the jobs.

A job's stars have the same first few pins. It walks them and hands back counts and its own front, as
rays; the fronts of all jobs are put together by the exact core. Which stars are in which job depends on
the question alone, never on how many workers there are, and every class belongs to one job: so nothing
is counted twice, and the answer is the same in any split.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from symbalance.jobs.digests import digest
from symbalance.search.array_walk import walk_arrays
from symbalance.search.counting import Counts
from symbalance.search.firing_variants import FiringVariants
from symbalance.search.front import Front, Judge
from symbalance.search.integer_ring import Array
from symbalance.search.objectives import Condition, Objective
from symbalance.search.problem import SearchProblem, Symmetry
from symbalance.search.star_walk import (
    BUFFER_FULL,
    CLASSES,
    CRANKS,
    FINISHED,
    FIRST_CUT,
    LEAVES,
    NODES,
    STARS,
    compiled_walk,
)
from symbalance.search.tables import Tables, build_tables

SMALL = 200_000
"""Cranks of a question that is one job: it takes less than a second."""
MOST_PARTS = 600
"""Jobs that a question is cut into, or a few more."""
FIRST_BUFFER, LARGEST_BUFFER = 64, 16_384
"""Stars handed over at once: few at first, since what they beat need not be handed over."""
MOST_KNOWN = 2000
"""Values of other parts that stars are compared with."""
NODES_AT_ONCE = 20_000_000
"""After which a compiled walk comes back, so that Ctrl-C is heard."""


@dataclass(frozen=True)
class SearchSpec:
    """A question with all that is asked of its stars: what every job needs to know."""

    problem: SearchProblem
    objectives: tuple[Objective, ...]
    """Of stars first, then of firing orders."""
    conditions: tuple[Condition, ...]
    minimized: tuple[str, ...]
    symmetries: tuple[Symmetry, ...]
    listed: int
    compiled: bool = True

    @property
    def of_stars(self) -> tuple[Objective, ...]:
        """The objectives of stars alone."""
        return tuple(o for o in self.objectives if not o.by_firing)

    def tables(self) -> Tables:
        """Return the arrays of the walk."""
        names = [o.name for o in self.of_stars]
        by_firing = any(o.by_firing and o.name in self.minimized for o in self.objectives)
        minimized = () if by_firing else tuple(map(names.index, self.minimized))
        return build_tables(self.problem, self.of_stars, self.conditions, minimized, self.symmetries)


@dataclass(frozen=True)
class SearchPart:
    """A job: a pattern of moments, and the rays of the first pins of the walk."""

    spec: SearchSpec
    pattern: int
    prefix: tuple[int, ...]
    mark: str
    """A digest of the question: parts of one share what they know."""

    @property
    def name(self) -> str:
        """What the part is called, as 0-5-3."""
        rays = "-".join(map(str, self.prefix))
        return f"pattern {self.pattern + 1}, {rays}" if self.pattern else f"rays {rays}"


@dataclass(frozen=True)
class Tally:
    """What was walked, and what was cut by which objective's bound."""

    nodes: int = 0
    leaves: int = 0
    cuts: tuple[int, ...] = ()
    exact_decisions: int = 0

    def __add__(self, other: Tally) -> Tally:
        count = max(len(self.cuts), len(other.cuts))
        cuts = [(*self.cuts, *(0,) * count)[:count], (*other.cuts, *(0,) * count)[:count]]
        return Tally(
            self.nodes + other.nodes,
            self.leaves + other.leaves,
            tuple(map(sum, zip(*cuts, strict=True))),
            self.exact_decisions + other.exact_decisions,
        )


def parts_of(spec: SearchSpec, cranks: int) -> list[SearchPart]:
    """Return the jobs of a question: one where it is small, else the beginnings of its stars."""
    parts, mark = [], digest(spec)
    for place, pattern in enumerate(spec.problem.patterns):
        prefixes = [(0,)]
        if cranks > SMALL:
            while len(prefixes) * len(spec.problem.patterns) < MOST_PARTS // 4:
                longer = [after for one in prefixes for after in beginnings(spec, pattern.capacity, one)]
                if (
                    not longer
                    or len(longer[0]) > spec.problem.pin_count - 4
                    or len(longer) > 4 * MOST_PARTS
                ):
                    break
                prefixes = longer
        parts += [SearchPart(spec, place, prefix, mark) for prefix in prefixes]
    return parts


def beginnings(
    spec: SearchSpec, capacity: tuple[int, ...], prefix: tuple[int, ...]
) -> Iterator[tuple[int, ...]]:
    """Yield the beginnings that go on from one; of mirror images, on pins that they leave, the first."""
    problem, order = spec.problem, spec.problem.order
    free = list(capacity)
    for pin, ray in zip(order, prefix, strict=False):
        for tick in problem.takes[pin][ray]:
            free[tick] -= 1
    pin = order[len(prefix)]
    fixed = [
        one
        for one in spec.symmetries
        if all(one.source[p] == p for p in order[: len(prefix) + 1])
    ]  # fmt: skip
    for ray in range(problem.rays):
        ticks = problem.takes[pin][ray]
        if not problem.allowed[pin][ray] or any(free[t] < ticks.count(t) for t in ticks):
            continue
        after = (*prefix, ray)
        pins = list(zip(order, after, strict=False))
        if all(
            tuple((one.sign * s + one.shift[p]) % problem.rays for p, s in pins) >= after for one in fixed
        ):
            yield after


@dataclass
class _Shared:
    """What the parts of one question that run in one process share: the tables, and values to beat.

    A star that one of another part beats is on no front, so that it makes no difference to the answer
    which parts ran here before, only to how much of it is handed over.
    """

    mark: str
    tables: Tables
    known: Array

    def learn(self, front: Front) -> None:
        """Add the values of a part's front to those known."""
        if not front.points or not self.known.shape[1]:
            return
        rows = np.concatenate([self.known, np.array([point.floats for point in front.points])])
        keep = [
            not ((rows <= row) & (rows != row).any(1)[:, None]).all(1).any() for row in rows
        ]  # fmt: skip
        self.known = np.unique(rows[keep], axis=0)[:MOST_KNOWN]


_last: list[_Shared] = []


def _shared(part: SearchPart) -> _Shared:
    """Return what is shared with the part before, if that was of the same question."""
    if not _last or _last[0].mark != part.mark:
        tables = part.spec.tables()
        _last[:] = [_Shared(part.mark, tables, np.zeros((0, len(part.spec.minimized))))]
    return _last[0]


def search_part(part: SearchPart) -> dict[str, Any]:
    """Return what a job comes to, as plain numbers: counts, front and tally."""
    spec, pattern = part.spec, part.spec.problem.patterns[part.pattern]
    shared = _shared(part)
    tables = shared.tables
    takes = tables.takes.copy()
    for pin, ray in zip(tables.order, part.prefix, strict=False):
        takes[pin, np.arange(tables.rays) != ray] = -1
    variants = FiringVariants(spec.problem, pattern)
    judge = Judge(
        spec.objectives, spec.conditions, spec.minimized, tables, variants, spec.listed, shared.known
    )
    counters = np.zeros(FIRST_CUT + len(spec.of_stars), np.int64)
    for stars, weights in _blocks(spec, tables, takes, np.array(pattern.capacity), judge, counters):
        judge.offer(stars, weights)
    front = judge.front
    shared.learn(front)
    counted = Counts(int(counters[CRANKS]), int(counters[STARS]), int(counters[CLASSES]))
    found = judge.found + counted
    if not spec.minimized and counted.classes:
        # Counted in the walk itself, once the list was full: all of them are at the one point.
        front.points[0].counts += counted
    firings = judge.firings_found if judge.needs_firing else found.stars * variants.count
    return {
        "found": [found.cranks, found.stars, found.classes],
        "firings": firings,
        "nodes": int(counters[NODES]),
        "leaves": int(counters[LEAVES]),
        "cuts": counters[FIRST_CUT:].tolist(),
        "exact": judge.exact_decisions,
        "points": [
            {
                "counts": [point.counts.cranks, point.counts.stars, point.counts.classes],
                "members": [[list(rays), list(fires)] for rays, fires in point.members],
            }
            for point in front.points
        ],
    }


def _blocks(
    spec: SearchSpec, tables: Tables, takes: Array, capacity: Array, judge: Judge, counters: Array
) -> Iterator[tuple[Array, Array]]:
    """Yield blocks of stars to be judged, from the compiled walk or from that in arrays."""
    walk = compiled_walk() if spec.compiled else None
    if walk is None:
        arrays = Tables(**{**vars_of(tables), "takes": takes})

        def state() -> tuple[Array, int, bool]:
            # Not in the order of tuples: all are listed, and the first stay.
            return *judge.float_front(), judge.front.listed == 0 and judge.is_list_full()

        yield from walk_arrays(arrays, capacity, state, counters)
        return
    yield from _compiled_blocks(walk, tables, takes, capacity, judge, counters)


def vars_of(tables: Tables) -> dict[str, Any]:
    """Return the fields of tables by name."""
    return {name: getattr(tables, name) for name in tables.__dataclass_fields__}


def _compiled_blocks(
    walk: Any, tables: Tables, takes: Array, capacity: Array, judge: Judge, counters: Array
) -> Iterator[tuple[Array, Array]]:
    pins, symmetries = tables.pins, len(tables.signs)
    plain = bool(takes.shape[2] == 1 and tables.ticks == tables.rays) and all(
        (takes[:, s, 0] == s).sum() + (takes[:, s, 0] == -1).sum() == pins for s in range(tables.rays)
    )
    state = np.zeros(3, np.int64)
    capacity = capacity.astype(np.int64)
    star, placed = np.zeros(pins, np.int64), np.zeros(pins, np.int64)
    current, candidates = np.full(pins, -1, np.int64), np.zeros(pins, np.int64)
    partial = np.zeros((pins + 1, tables.forms), np.complex128)
    tied = np.zeros((pins + 1, symmetries), np.int64)
    values = np.zeros(len(tables.asked))
    sizes, is_zero = np.zeros(tables.forms), np.zeros(tables.forms, np.bool_)
    allowed = np.array([sum(1 << s for s in np.flatnonzero(row >= 0).tolist()) for row in takes[:, :, 0]])
    size = FIRST_BUFFER
    status = BUFFER_FULL
    while status != FINISHED:
        buffer, weights = np.zeros((size, pins), np.int64), np.zeros((size, 3), np.int64)
        state[1] = 0
        front, points = judge.float_front()
        status = walk(
            tables.rays,
            tables.order,
            takes,
            plain,
            allowed,
            tables.floats,
            tables.integers,
            tables.rest,
            tables.reach,
            tables.slack,
            tables.groups,
            tables.owners,
            tables.asked,
            tables.limits,
            tables.minimized,
            front,
            points,
            judge.is_list_full(),
            tables.sources,
            tables.signs,
            tables.shifts,
            tables.mirror,
            0,
            state,
            capacity,
            star,
            placed,
            current,
            candidates,
            partial,
            tied,
            values,
            sizes,
            is_zero,
            buffer,
            weights,
            counters,
            NODES_AT_ONCE,
        )
        rows = int(state[1])
        if rows:
            yield buffer[:rows], weights[:rows]
        if status == BUFFER_FULL:
            size = min(2 * size, LARGEST_BUFFER)
