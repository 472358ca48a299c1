"""The Pareto front of a search: every star is judged here that no float could judge, by the exact core.

Stars come in blocks. Those whose sums have the same squares, integer by integer, are judged once. A
point of the front is a vector of exact values that no other one beats: not larger in any, smaller in
one. With it stand how many cranks, stars and classes attain it, and the first few of them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache, cmp_to_key
from itertools import pairwise
from typing import Any

import numpy as np

from symbalance.exact.phasor import ZERO
from symbalance.search.counting import Counts
from symbalance.search.firing_variants import FiringVariants, TorsionTable
from symbalance.search.integer_ring import Array, IntegerRing
from symbalance.search.magnitudes import Magnitude, compare, largest
from symbalance.search.objectives import Condition, Objective
from symbalance.search.tables import SLACK, Tables

MOST_VARIANT_ROWS = 100_000
"""Stars times their firing orders that are judged at once."""

TINY = 1e-300
"""What stands for a value that is not zero, where its float is."""

Member = tuple[tuple[int, ...], tuple[int, ...]]
"""A star's rays, by pin, and its firing moments in ticks, by cylinder; the latter empty where any do."""


@dataclass(eq=False)
class FrontPoint:
    """Values that no star beats, how many attain them, and the first of those that do.

    `floats` hold the values to within the front's margin, zeros exact; `exactly` returns one of them as
    the exact number.
    """

    floats: tuple[float, ...]
    marks: tuple[bytes, ...]
    """The integers that each value was worked out from: equal ones need no comparison."""
    exactly: Callable[[int], Magnitude]
    counts: Counts = field(default_factory=Counts)
    members: list[Member] = field(default_factory=list)


class Front:
    """Points none of which beats another; of those that attain the same the first `listed` are named.

    Two values that differ by more than `margin` in floats do so for certain; all others are compared by
    the exact core.
    """

    def __init__(self, listed: int, order: Sequence[int], margin: float) -> None:
        self.points: list[FrontPoint] = []
        self.listed, self.margin = listed, margin
        self._order = tuple(order)
        self.changes = 0
        self.exact_comparisons = 0

    def point(
        self,
        floats: tuple[float, ...],
        marks: tuple[bytes, ...],
        exactly: Callable[[int], Magnitude],
    ) -> FrontPoint | None:
        """Return the point of these values, put into the front if need be; None if another beats them."""
        added = FrontPoint(floats, marks, exactly)
        beaten = []
        for point in self.points:
            signs = [self._compare(point, added, i) for i in range(len(floats))]
            better, worse = all(s <= 0 for s in signs), all(s >= 0 for s in signs)
            if better and worse:
                return point
            if better:
                return None
            if worse:
                beaten.append(point)
        self.points = [point for point in self.points if point not in beaten] + [added]
        self.changes += 1
        return added

    def ordered(self) -> list[FrontPoint]:
        """Return the points, by their first value, those that are equal in it by the next."""

        def order(left: FrontPoint, right: FrontPoint) -> int:
            signs = (self._compare(left, right, i) for i in range(len(left.floats)))
            return next((sign for sign in signs if sign), 0)

        return sorted(self.points, key=cmp_to_key(order))

    def _compare(self, left: FrontPoint, right: FrontPoint, place: int) -> int:
        first, second = left.floats[place], right.floats[place]
        if abs(first - second) > self.margin:
            return 1 if first > second else -1
        if first == second == 0.0 or left.marks[place] == right.marks[place]:
            return 0
        self.exact_comparisons += 1
        return compare(left.exactly(place), right.exactly(place))

    def add_members(self, point: FrontPoint, members: list[Member]) -> None:
        """Add stars to those listed of a point: the first stay, in the order of the walk."""

        def rank(member: Member) -> tuple[tuple[int, ...], tuple[int, ...]]:
            return tuple(member[0][p] for p in self._order), member[1]

        point.members = sorted({*point.members, *members}, key=rank)[: self.listed]


@dataclass
class Judge:
    """What a walk over the stars of one pattern hands its stars to."""

    objectives: tuple[Objective, ...]
    """Those of the star, in the order of the tables, and behind them those of the firing order."""
    conditions: tuple[Condition, ...]
    minimized: tuple[str, ...]
    tables: Tables
    variants: FiringVariants
    listed: int
    known: Array
    """[star, minimized]: floats of stars that are known already: what they beat is not wanted."""
    found: Counts = field(default_factory=Counts)
    firings_found: int = 0
    exact_decisions: int = 0

    def __post_init__(self) -> None:
        named = {c.name for c in self.conditions} | {*self.minimized}
        self._star = [o for o in self.objectives if not o.by_firing and o.name in named]
        self._firing = [o for o in self.objectives if o.by_firing and o.name in named]
        firsts, place = {}, 0
        for o in self.objectives:
            if not o.by_firing:
                firsts[o.name] = place
                place += sum(map(len, o.groups))
        self._forms = {
            o.name: list(range(firsts[o.name], firsts[o.name] + sum(map(len, o.groups))))
            for o in self._star
        }
        self._torsion = {o.name: self.variants.torsion(o) for o in self._firing if not o.is_count}
        self._names = [o.name for o in (*self._star, *self._firing)]
        weights = [
            abs(w) for o in self._firing for g in o.groups for f in g for w, _, _ in f.weights.values()
        ]
        self.margin = float(self.tables.slack.sum()) + SLACK * (1.0 + float(sum(weights)))
        self.front = Front(self.listed, self.tables.order.tolist(), self.margin)
        self._float_changes = -1

    @property
    def needs_firing(self) -> bool:
        """Whether a star alone does not tell whether it is wanted."""
        return bool(self._firing)

    def float_front(self) -> tuple[Array, int]:
        """Return the points' values in floats, zeros exact, and last the margin of a comparison."""
        if not self.minimized or self._firing:
            return np.zeros((1, len(self.minimized) + 1)), 0
        rows = self._beaters()
        margins = np.full((len(rows), 1), self.margin)
        return np.concatenate([rows, margins], axis=1) if len(rows) else np.zeros((1, 1)), len(rows)

    def values_of(
        self, member: Member
    ) -> tuple[tuple[float, ...], tuple[bytes, ...], Callable[[int], Magnitude]]:
        """Return the values of one star: in floats, the integers they are of, and, on demand, exactly."""
        keys, sizes, parts = self._star_keys(np.array([member[0]]))
        if self._firing:
            more, more_sizes, more_parts = self._firing_keys(np.array([[member[1]]]))
            parts |= {name: place + keys.shape[1] for name, place in more_parts.items()}
            keys = np.concatenate([keys, more.reshape(1, -1)], 1)
            sizes = np.concatenate([sizes, more_sizes.reshape(1, -1)], 1)
        columns = [self._names.index(name) for name in self.minimized]
        marks = self._marks(keys[0], parts)
        return tuple(sizes[0, columns].tolist()), marks, self._exactly(keys[0], parts)

    def is_list_full(self) -> bool:
        """Whether all that is left to do is to count."""
        if self.minimized or self._firing:
            return False
        return self.front.listed == 0 or bool(
            self.front.points and len(self.front.points[0].members) >= self.front.listed
        )

    def offer(self, stars: Array, weights: Array) -> None:
        """Judge a block of stars, each the first of its class, with its cranks and stars."""
        step = max(1, MOST_VARIANT_ROWS // self.variants.count) if self._firing else len(stars)
        for start in range(0, len(stars), step):
            self._judge(stars[start : start + step], weights[start : start + step])

    def _judge(self, stars: Array, weights: Array) -> None:
        keys, sizes, parts = self._star_keys(stars)
        moments: Array | None = None
        count = 1
        if self._firing:
            moments = self.variants.moments(stars)
            count = moments.shape[1]
            more, more_sizes, more_parts = self._firing_keys(moments)
            width = keys.shape[1]
            keys = np.concatenate(
                [np.repeat(keys, count, axis=0), more.reshape(len(stars) * count, -1)], 1
            )
            sizes = np.concatenate(
                [np.repeat(sizes, count, axis=0), more_sizes.reshape(len(keys), -1)], 1
            )
            parts |= {name: place + width for name, place in more_parts.items()}
        unique, first, owner = _unique_rows(keys)
        met = self._met(unique, sizes[first], np.repeat(weights[:, 2], count)[first], parts)
        rows_met = met[owner]
        if self.minimized:
            order = np.argsort(owner, kind="stable")
            bounds = np.searchsorted(owner[order], np.arange(len(unique) + 1))
            columns = [self._names.index(name) for name in self.minimized]
            # Small values first: what they beat is not looked at by the exact core.
            for u in np.lexsort(sizes[first][:, columns].T[::-1]).tolist():
                if met[u] and not self._is_beaten(sizes[first[u], columns]):
                    point = self._placed(unique[u], sizes[first[u], columns], parts)
                    if point is not None:
                        rows = np.sort(order[bounds[u] : bounds[u + 1]])
                        self._enter(point, stars, weights, moments, rows, count)
        elif rows_met.any():
            point = self.front.point((), (), _no_value)
            assert point is not None
            self._enter(point, stars, weights, moments, np.flatnonzero(rows_met), count)
        by_star = rows_met.reshape(len(stars), count)
        self.found += _counts(weights[by_star.any(1)])
        self.firings_found += int((by_star.sum(1) * weights[:, 1]).sum())

    def _enter(
        self,
        point: FrontPoint,
        stars: Array,
        weights: Array,
        moments: Array | None,
        rows: Array,
        count: int,
    ) -> None:
        """Count the stars of some rows with a point, and list the first of them."""
        point.counts += _counts(weights[np.unique(rows // count)])
        self._list(point, stars, moments, rows, count)

    def _is_beaten(self, sizes: Array) -> bool:
        """Tell whether some point beats these values for certain, in floats."""
        beaters = self._beaters()
        if not len(beaters):
            return False
        below = beaters < sizes - self.margin
        return bool((below.any(1) & (below | (beaters == 0.0)).all(1)).any())

    def _beaters(self) -> Array:
        """Return the values of all stars known so far that others may be beaten by, in floats."""
        if self._float_changes != self.front.changes:
            own = np.array([p.floats for p in self.front.points]).reshape(-1, len(self.minimized))
            self._floats = np.concatenate([own, self.known])
            self._float_changes = self.front.changes
        return self._floats

    def _met(self, unique: Array, sizes: Array, doubtful: Array, parts: dict[str, int]) -> Array:
        """Return which keys meet every condition: by floats where they are certain, else exactly."""
        met = np.ones(len(unique), bool)
        doubt = doubtful > 0
        for condition in self.conditions:
            if not next(o for o in self.objectives if o.name == condition.name).by_firing:
                continue  # decided in the walk, but for those in doubt
            size, limit = sizes[:, self._names.index(condition.name)], float(condition.limit)
            met &= size <= limit + self.margin
            if condition.exactly:
                met &= size >= limit - self.margin
            doubt |= abs(size - limit) <= self.margin
        for u in np.flatnonzero(met & doubt).tolist():
            values = self._sizes(unique[u], parts)
            met[u] = all(_holds(c, values[c.name]) for c in self.conditions)
        return met

    def _placed(self, key: Array, sizes: Array, parts: dict[str, int]) -> FrontPoint | None:
        """Return the point of a key's values, which are worked out exactly if floats do not decide."""

        marks = self._marks(key, parts)
        return self.front.point(tuple(sizes.tolist()), marks, self._exactly(key, parts))

    def _marks(self, key: Array, parts: dict[str, int]) -> tuple[bytes, ...]:
        """Return the integers of each value to be minimized, as bytes."""
        starts = sorted({*parts.values(), len(key)})
        ends = dict(pairwise(starts))
        return tuple(
            b"" if parts[n] not in ends else key[parts[n] : ends[parts[n]]].tobytes()
            for n in self.minimized
        )

    def _exactly(self, key: Array, parts: dict[str, int]) -> Callable[[int], Magnitude]:
        """Return the exact values of a key, each worked out when it is first wanted."""

        @cache
        def exactly(place: int) -> Magnitude:
            self.exact_decisions += 1
            name = self.minimized[place]
            one = next(o for o in (*self._star, *self._firing) if o.name == name)
            return self._size(one, key, parts[name])

        return exactly

    def _list(
        self, point: FrontPoint, stars: Array, moments: Array | None, rows: Array, count: int
    ) -> None:
        """Add the first of some rows to a point's members: of one star, its first firing order."""
        which = np.unique(rows // count)
        order = np.lexsort(stars[which][:, self.tables.order[::-1]].T)
        chosen = which[order[: self.front.listed]].tolist()
        first = {i: int(rows[np.searchsorted(rows, i * count)]) % count for i in chosen}
        members = []
        for i in chosen:
            fires = () if moments is None else tuple(moments[i, first[i]].tolist())
            members.append((tuple(stars[i].tolist()), fires))
        self.front.add_members(point, members)

    # Keys: the integers on which a verdict depends

    def _star_keys(self, stars: Array) -> tuple[Array, Array, dict[str, int]]:
        """Return squares as integers, values as floats (zeros exact), and where each objective begins."""
        parts: dict[str, int] = {}
        columns, sizes, place = [], [], 0
        pins = np.arange(self.tables.pins)[None, :]
        for o in self._star:
            parts[o.name] = place
            form = self._forms[o.name][0] if o.groups else 0
            value = np.zeros(len(stars))
            for group in o.groups:
                total = np.zeros(len(stars))
                for _ in group:
                    squares = self.tables.ring.squares(self.tables.integers[form][pins, stars].sum(1))
                    near = abs(self.tables.floats[form][pins, stars].sum(1))
                    total += np.where((squares == 0).all(1), 0.0, np.maximum(near, TINY))
                    columns.append(squares)
                    form, place = form + 1, place + squares.shape[1]
                value = np.maximum(value, total)
            sizes.append(value)
        if not columns:
            columns.append(np.zeros((len(stars), 1), np.int64))
        if not sizes:
            return columns[0], np.zeros((len(stars), 0)), parts
        return np.concatenate(columns, axis=1), np.stack(sizes, axis=1), parts

    def _firing_keys(self, moments: Array) -> tuple[Array, Array, dict[str, int]]:
        """Return the same for what depends on the firing order."""
        parts: dict[str, int] = {}
        columns, sizes, place = [], [], 0
        for o in self._firing:
            parts[o.name] = place
            if o.is_count:
                kind = self.variants.adjacent if o.kind == "adjacent" else self.variants.unevenness
                column = kind(moments)[..., None]
                size = column[..., 0] * float(firing_count(o, 1, self.variants.ticks))
            else:
                column, size = self._torsion[o.name].squares(moments)
                size = np.where((column == 0).all(-1), 0.0, np.maximum(size, TINY))
            columns.append(column)
            sizes.append(size)
            place += column.shape[-1]
        return np.concatenate(columns, axis=-1), np.stack(sizes, axis=-1), parts

    def _sizes(self, key: Array, parts: dict[str, int]) -> dict[str, Magnitude]:
        """Return the exact values of a key."""
        self.exact_decisions += 1
        return {o.name: self._size(o, key, parts[o.name]) for o in (*self._star, *self._firing)}

    def _size(self, objective: Objective, row: Array, place: int) -> Magnitude:
        if objective.by_firing and objective.is_count:
            return Magnitude.rational(firing_count(objective, int(row[place]), self.variants.ticks))
        if objective.by_firing:
            table: TorsionTable = self._torsion[objective.name]
            return Magnitude(_square(table.ring, row[place : place + table.ring.degree], table.unit))
        degree = self.tables.ring.degree
        groups, form = [], self._forms[objective.name][0] if objective.groups else 0
        for group in objective.groups:
            squares = []
            for _ in group:
                unit = self.tables.units[form]
                squares.append(_square(self.tables.ring, row[place : place + degree], unit))
                form, place = form + 1, place + degree
            groups.append(Magnitude(*squares))
        return largest(groups)


def _no_value(place: int) -> Magnitude:
    raise AssertionError(f"there is no value {place}")


def firing_count(objective: Objective, count: int, ticks: int) -> Fraction:
    """Return what a count of a firing order means: neighbours, or degrees."""
    return Fraction(360 * count, ticks) if objective.kind == "evenness" else Fraction(count)


def _holds(condition: Condition, size: Magnitude) -> bool:
    sign = compare(size, Magnitude.rational(condition.limit))
    return sign == 0 if condition.exactly else sign <= 0


def _square(ring: IntegerRing, vector: Array, unit: Fraction) -> Any:
    return ring.phasor(vector).scaled(unit * unit) if vector.any() else ZERO


def _counts(weights: Array) -> Counts:
    return Counts(int(weights[:, 0].sum()), int(weights[:, 1].sum()), len(weights))


def _unique_rows(keys: Array) -> tuple[Array, Array, Array]:
    """Return the rows that differ, the first place of each, and of each row which of them it is."""
    packed = np.ascontiguousarray(keys).view(np.dtype((np.void, keys.dtype.itemsize * keys.shape[1])))
    _, first, owner = np.unique(packed.ravel(), return_index=True, return_inverse=True)
    return keys[first], first, owner
