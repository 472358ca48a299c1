"""Search over all cranks and firing orders: the whole Pareto front, or all that meet some conditions."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from symbalance.errors import SymbalanceError, brief
from symbalance.jobs.progress import Progress
from symbalance.jobs.running import Job, run_jobs
from symbalance.jobs.store import Store, key_of
from symbalance.search.counting import Counts, count_all
from symbalance.search.firing_variants import FiringVariants
from symbalance.search.front import Front, Judge, Member
from symbalance.search.magnitudes import Magnitude
from symbalance.search.objectives import (
    Objective,
    read_after,
    read_conditions,
    read_modes,
    read_objective,
)
from symbalance.search.problem import SearchProblem, search_problem
from symbalance.search.search_result import CrankSearch, SearchPoint, SearchStar
from symbalance.search.subtrees import SearchPart, SearchSpec, Tally, parts_of, search_part
from symbalance.search.tables import preserved_symmetries
from symbalance.text.numbers import checked_whole

SHOWN = ("couple.1", "couple.2")
"""What is said of every star, besides what was asked for."""
MOST_LISTED = 100_000
NOT_COMPILED = 20_000
"""Cranks up to which a question is walked in NumPy."""
MOST_OBJECTIVES = 12


def search_cranks(
    cylinders: object,
    *,
    minimize: Sequence[str] = (),
    require: Sequence[str] = (),
    limit: Sequence[str] = (),
    after: object = None,
    modes: Sequence[Sequence[object]] = (),
    listed: int = 100,
    workers: int = 1,
    executor: Executor | None = None,
    store: Store | str | Path | None = None,
    progress: Progress | None = None,
    compiled: bool | None = None,
    **question: Any,
) -> CrankSearch:
    """Return the best of all cranks of so many cylinders, with all their firing orders.

    `question`: strokes, banks, pins, intervals, grid, stations, as `search_problem` takes them.
    `minimize` names what is to be small, as couple.1; several give the whole Pareto front. `require`
    ("couple.1=0") and `limit` ("couple.2<=0.5") are conditions, decided exactly. `after`:
    "counterweights", or ("balance-shafts", 1): what these would balance counts no more. `modes` are mode
    shapes for torsion. Of the classes that attain a point the first `listed` are named; all are counted.
    `workers`, `executor`, `store` and `progress` as in `run_jobs`: the answer does not depend on them.
    Without Numba, or where `compiled` is False, the same walk runs in NumPy, some twenty times slower;
    by itself it does for small questions, which take less time than to load Numba.

    >>> result = search_cranks(5, minimize=["couple.1"])
    >>> result.searched.cranks, result.searched.stars, result.searched.classes
    (24, 12, 8)
    >>> [(star.firing_order, star.values["couple.1"].spelling) for star in result]
    [((1, 2, 4, 5, 3), 'sqrt(25/2 - 11*sqrt(5)/2)')]
    """
    asked: dict[str, Any] = {"minimize": minimize, "require": require, "limit": limit, "after": after}
    spec = search_spec(cylinders, **asked, modes=modes, listed=listed, compiled=compiled, **question)
    problem, conditions, wanted = spec.problem, spec.conditions, spec.minimized
    balanced, shapes = read_after(after), read_modes(modes, problem.cylinders)
    named = list(dict.fromkeys([*wanted, *(c.name for c in conditions)]))
    searched = count_all(problem, spec.symmetries)
    jobs = [
        Job(
            part.name,
            part,
            "" if store is None else key_of("search", part.mark, part.pattern, part.prefix),
        )
        for part in parts_of(spec, searched.cranks)
    ]
    if isinstance(store, str | Path):
        store = Store(Path(store))
    merged = _Merged(spec)
    means: dict[str, Any] = {
        "executor": executor,
        "workers": workers,
        "store": store,
        "progress": progress,
    }
    for job, outcome in run_jobs(search_part, jobs, **means):
        merged.add(job.value, outcome.result(job.name))
    shown = [
        read_objective(name, problem, balanced, shapes) for name in dict.fromkeys([*named, *SHOWN])
    ]  # fmt: skip
    return CrankSearch(
        problem,
        conditions,
        wanted,
        balanced,
        shapes,
        searched,
        merged.found,
        merged.firings,
        tuple(o.name for o in shown),
        _points(spec, merged, shown),
        merged.tally,
        tuple(o.name for o in spec.of_stars),
        len(jobs),
        any(one.along == -1 for one in problem.symmetries)
        and not any(one.along == -1 for one in spec.symmetries),
    )


def search_spec(
    cylinders: object,
    *,
    minimize: Sequence[str] = (),
    require: Sequence[str] = (),
    limit: Sequence[str] = (),
    after: object = None,
    modes: Sequence[Sequence[object]] = (),
    listed: int = 100,
    compiled: bool | None = None,
    **question: Any,
) -> SearchSpec:
    """Return a question and all that is asked of its stars, checked; arguments as of `search_cranks`."""
    problem = search_problem(cylinders, **question)
    balanced = read_after(after)
    conditions = read_conditions(require, limit)
    wanted = tuple(dict.fromkeys(minimize))
    shapes = read_modes(modes, problem.cylinders)
    named = list(dict.fromkeys([*(c.name for c in conditions), *wanted]))
    if len(named) > MOST_OBJECTIVES:
        what = f"{len(named)} quantities"
        raise SymbalanceError(what, f"are more than {MOST_OBJECTIVES}", "ask for fewer at once")
    repeated = next((c.name for c in conditions if [d.name for d in conditions].count(c.name) > 1), None)
    if repeated is not None:
        raise SymbalanceError(f"conditions on {brief(repeated)}", "must be one", "leave the others out")
    objectives = [read_objective(name, problem, balanced, shapes) for name in named]
    objectives.sort(key=lambda o: o.by_firing)
    spec = SearchSpec(
        problem,
        tuple(objectives),
        conditions,
        wanted,
        preserved_symmetries(problem, objectives),
        checked_whole(listed, "listed", 1, MOST_LISTED, "classes named of each point"),
    )
    if compiled is None:
        compiled = count_all(problem, ()).cranks > NOT_COMPILED
    return replace(spec, compiled=compiled)


class _Merged:
    """What the parts of a search come to, put together by the exact core."""

    def __init__(self, spec: SearchSpec) -> None:
        self.spec, self.found, self.firings, self.tally = spec, Counts(), 0, Tally()
        tables, patterns = spec.tables(), spec.problem.patterns
        nothing = np.zeros((0, len(spec.minimized)))
        self.judges = [
            Judge(
                spec.objectives,
                spec.conditions,
                spec.minimized,
                tables,
                FiringVariants(spec.problem, pattern),
                spec.listed,
                nothing,
            )
            for pattern in patterns
        ]
        self.front = Front(spec.listed, spec.problem.order, self.judges[0].margin)
        self.patterns: dict[Member, int] = {}

    def add(self, part: SearchPart, data: dict[str, Any]) -> None:
        """Add what a part came to."""
        self.found += Counts(*data["found"])
        self.firings += data["firings"]
        self.tally += Tally(data["nodes"], data["leaves"], tuple(data["cuts"]), data["exact"])
        for entry in data["points"]:
            members: list[Member] = [(tuple(rays), tuple(fires)) for rays, fires in entry["members"]]
            self.patterns |= dict.fromkeys(members, part.pattern)
            point = self.front.point(*self.judges[part.pattern].values_of(members[0]))
            if point is not None:
                point.counts += Counts(*entry["counts"])
                self.front.add_members(point, members)


def _points(spec: SearchSpec, merged: _Merged, shown: list[Objective]) -> tuple[SearchPoint, ...]:
    """Return the points of the front, smallest values first, with what is shown of their stars."""
    points = []
    for point in merged.front.ordered():
        stars = tuple(
            _star(spec.problem, merged.judges[merged.patterns[member]].variants, member, shown)
            for member in point.members
        )
        points.append(SearchPoint(point.counts, stars))
    return tuple(points)


def _star(
    problem: SearchProblem, variants: FiringVariants, member: Member, shown: list[Objective]
) -> SearchStar:
    """Return a star with a firing order: the one that attains the values, else the first of all."""
    rays, fires = member
    if fires:
        moments = np.array(fires)
    else:
        moments = variants.moments(np.array([rays]))[0, 0] if not problem.is_any else None
    order = () if moments is None else variants.order_of(moments)
    firing = {} if moments is None else variants.fires(moments)
    values: dict[str, Magnitude] = {}
    for objective in shown:
        if objective.by_firing and moments is None:
            continue
        values[objective.name] = star_value(problem, variants, objective, rays, moments)
    return SearchStar(problem, rays, order, firing, 1 if fires else _firings(problem, variants), values)


def _firings(problem: SearchProblem, variants: FiringVariants) -> int:
    return problem.cycle ** (problem.cylinders - 1) if problem.is_any else variants.count


def star_value(
    problem: SearchProblem,
    variants: FiringVariants,
    objective: Objective,
    rays: tuple[int, ...],
    moments: Any,
) -> Magnitude:
    """Return one quantity of one star: summed up anew in the exact core, not from the walk's tables."""
    from fractions import Fraction

    from symbalance.exact.phasor import Phasor, amplitude_sum
    from symbalance.search.front import firing_count
    from symbalance.search.magnitudes import largest

    if objective.kind == "adjacent":
        return Magnitude.rational(
            firing_count(objective, int(variants.adjacent(moments)), variants.ticks)
        )
    if objective.kind == "evenness":
        return Magnitude.rational(
            firing_count(objective, int(variants.unevenness(moments)), variants.ticks)
        )
    throws = problem.throws(rays)

    def angle(number: int, fixed: Fraction, turn: Fraction) -> Fraction:
        if objective.by_firing:
            return objective.order * Fraction(int(moments[number - 1]), variants.ticks)
        return fixed + turn * throws[number]

    groups = []
    for group in objective.groups:
        squares = []
        for form in group:
            total = amplitude_sum(
                [
                    Phasor.root(angle(n, fixed, turn)).scaled(w)
                    for n, (w, fixed, turn) in form.weights.items()
                ]
            )
            squares.append(total.multiplied(total.conjugate()))
        groups.append(Magnitude(*squares))
    return largest(groups)
