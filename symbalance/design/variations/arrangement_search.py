r"""Search for the arrangement of parts in places whose vectors have the shortest sum.

    minimise |c + sum over sets s of sum over places j of v_s[part in j][j]|

over all arrangements of every set. Vectors hold floats, on an orthonormal basis of what they span.

- Few places: exactly. One set is cut into halves: for each choice of the parts of the first half, all
  arrangements of either half are listed, and pairs are joined by their first coordinate, for a sum no
  longer than the best so far has none longer (Horowitz and Sahni, JACM 21 (1974)). Of two sets the
  arrangements of each are listed and joined. All pairs that could be better are looked at: the best is
  proved. Places that an isometry of the vectors exchanges are tried once.
- More places: exchanges of two parts, and exact rearrangement of some places at a time, from several
  starts; and a lower bound (`symbalance.design.variations.assignment_bounds`).
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from math import sqrt
from operator import add
from random import Random

from symbalance.design.variations.assignment_bounds import (
    SLACK,
    Order,
    Table,
    Vector,
    arrangement_sum,
    lower_bound,
    norm,
    vector_sum,
)

MOST_PLACES = {1: 10, 2: 7}
"""The places up to which the arrangement of one set, or of two, is found exactly."""
STARTS = 12
"""Random arrangements that the search by exchanges begins from."""
BLOCK = 9
"""Places rearranged exactly at a time: halves of 5 and 4 places, as one set of 9 would be."""
ROUNDS = 24
"""Blocks rearranged, where the best is not found exactly anyway."""


@dataclass(frozen=True)
class Arrangement:
    """An arrangement: `orders` of each set, its length, what none passes below, and whether proved."""

    orders: tuple[Order, ...]
    length: float
    bound: float
    proved: bool


def best_arrangement(
    start: Vector, tables: Sequence[Table], fixed: Sequence[int] | None = None
) -> Arrangement:
    """Return the arrangement of least length; proved where the places are few (`MOST_PLACES`).

    `fixed` are the places that the first part of the first set need be tried in (default: all).

    >>> table = [[(m,), (-m,)] for m in (3.0, 2.0)] + []
    >>> best_arrangement((0.0,), [table]).length
    1.0
    """
    count = len(tables[0])
    good = _local_search(start, tables)
    places = list(range(count)) if fixed is None else list(fixed)
    if count <= MOST_PLACES.get(len(tables), 0):
        orders = (_by_halves if len(tables) == 1 else _by_pairs)(start, tables, good, places)
        length = norm(arrangement_sum(start, tables, orders))
        return Arrangement(orders, length, length, True)
    return Arrangement(
        good, norm(arrangement_sum(start, tables, good)), lower_bound(start, tables), False
    )


def _arrangements(
    table: Table, parts: Sequence[int], places: Sequence[int], start: Vector, fixed: Sequence[int]
) -> Iterator[tuple[Vector, Order]]:
    """Yield the sums of all arrangements of parts in places; equal parts count once."""
    if not places:
        yield start, ()
        return
    component_amplitude: list[Sequence[Vector]] = []
    for part in parts:
        if (part == 0 and places[0] not in fixed) or table[part] in component_amplitude:
            continue
        component_amplitude.append(table[part])
        rest = [p for p in parts if p != part]
        for vector, order in _arrangements(
            table, rest, places[1:], vector_sum(start, table[part][places[0]]), fixed
        ):
            yield vector, (part, *order)


class _Best:
    """The best arrangement so far."""

    def __init__(self, orders: tuple[Order, ...], length: float) -> None:
        self.orders, self.length = orders, length

    def join(
        self, fronts: list[tuple[Vector, Order]], rears: list[tuple[Vector, Order]], flat: bool
    ) -> None:
        """Look at all pairs whose sum may be shorter: their first coordinates nearly cancel."""
        if not (fronts and rears):
            return
        rears.sort()
        keys = [vector[0] for vector, _ in rears]
        second = min(1, len(rears[0][0]) - 1)
        for one, order in fronts:
            reach = self.length
            low, high = bisect_left(keys, -one[0] - reach), bisect_right(keys, -one[0] + reach)
            for i in range(low, high):
                other, rest = rears[i]
                if abs(one[second] + other[second]) > reach:
                    continue
                square = sum(x * x for x in map(add, one, other))
                if square < self.length * self.length * (1 - SLACK):
                    self.length = sqrt(square)
                    self.orders = ((*order, *rest),) if flat else (order, rest)


def _by_halves(
    start: Vector, tables: Sequence[Table], good: tuple[Order, ...], fixed: Sequence[int]
) -> tuple[Order, ...]:
    """Return the best arrangement of one set, by halves."""
    (table,), count = tables, len(tables[0])
    best = _Best(good, norm(arrangement_sum(start, tables, good)))
    half = (count + 1) // 2
    first, second = list(range(half)), list(range(half, count))
    zero = tuple(0.0 for _ in start)
    halves = set()
    for parts in combinations(range(count), half):
        kind = tuple(sorted(str(table[p]) for p in parts)) if 0 not in parts else None
        if kind is not None and kind in halves:
            continue
        halves.add(kind)
        rest = [p for p in range(count) if p not in parts]
        fronts = list(_arrangements(table, parts, first, start, fixed))
        best.join(fronts, list(_arrangements(table, rest, second, zero, fixed)), flat=True)
    return best.orders


def _by_pairs(
    start: Vector, tables: Sequence[Table], good: tuple[Order, ...], fixed: Sequence[int]
) -> tuple[Order, ...]:
    """Return the best arrangement of two sets, all of one against all of the other."""
    best = _Best(good, norm(arrangement_sum(start, tables, good)))
    places = list(range(len(tables[0])))
    zero = tuple(0.0 for _ in start)
    fronts = list(_arrangements(tables[0], places, places, start, fixed))
    rears = list(_arrangements(tables[1], places, places, zero, places))
    best.join(fronts, rears, flat=False)
    return best.orders


def _local_search(start: Vector, tables: Sequence[Table]) -> tuple[Order, ...]:
    """Return a good arrangement: exchanges from several starts, then blocks of places at a time."""
    count, chance = len(tables[0]), Random(1)
    candidates = []
    for _ in range(STARTS):
        orders = [tuple(chance.sample(range(count), count)) for _ in tables]
        candidates.append(_improve_by_exchange(start, tables, orders))
    best = min(candidates, key=lambda orders: norm(arrangement_sum(start, tables, orders)))
    exact = count <= MOST_PLACES.get(len(tables), 0)
    for _ in range((count - BLOCK) // 2 if exact else ROUNDS):
        best = _rearrange_block(start, tables, best, chance)
    return best


def _improve_by_exchange(
    start: Vector, tables: Sequence[Table], orders: list[Order]
) -> tuple[Order, ...]:
    """Return an arrangement that no exchange of two parts improves."""
    now = arrangement_sum(start, tables, orders)
    pairs = list(combinations(range(len(tables[0])), 2))
    improved = True
    while improved:
        improved = False
        for s, table in enumerate(tables):
            for i, j in pairs:
                p, q = orders[s][i], orders[s][j]
                exchanged = tuple(
                    x - a - b + c + d
                    for x, a, b, c, d in zip(
                        now, table[p][i], table[q][j], table[q][i], table[p][j], strict=True
                    )
                )
                if norm(exchanged) < norm(now) * (1 - SLACK):
                    now, improved = exchanged, True
                    order = list(orders[s])
                    order[i], order[j] = q, p
                    orders[s] = tuple(order)
    return tuple(orders)


def _rearrange_block(
    start: Vector, tables: Sequence[Table], orders: tuple[Order, ...], chance: Random
) -> tuple[Order, ...]:
    """Return the arrangement with the parts of some places rearranged, exactly."""
    s = chance.randrange(len(tables))
    table, order = tables[s], orders[s]
    places = sorted(chance.sample(range(len(order)), min(BLOCK, len(order))))
    rest = [
        tuple(table[p][j] if j not in places else tuple(0.0 for _ in start) for j in range(len(order)))
        for p in range(len(order))
    ]
    others = [t if k != s else rest for k, t in enumerate(tables)]
    fixed = arrangement_sum(start, others, orders)
    small = [[table[order[j]][i] for i in places] for j in places]
    best = _by_halves(fixed, [small], (tuple(range(len(places))),), range(len(places)))[0]
    rearrangement = list(order)
    for place, k in zip(places, best, strict=True):
        rearrangement[place] = order[places[k]]
    return tuple(tuple(rearrangement) if k == s else o for k, o in enumerate(orders))
