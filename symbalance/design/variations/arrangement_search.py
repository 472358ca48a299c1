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

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations
from math import sqrt
from random import Random
from typing import Any

from symbalance.design.variations.assignment_bounds import (
    SLACK,
    Order,
    Table,
    Vector,
    arrangement_sum,
    lower_bound,
    norm,
)

MOST_PLACES = {1: 13, 2: 8}
"""The places up to which the best arrangement of one set, or of two, is searched for exactly."""
MOST_PAIRS = 100_000_000
"""Pairs of half arrangements looked at in all before the search ends without a proof: some seconds."""
BLOCK_OF_PAIRS, ROWS = 500_000, 4096
"""Pairs looked at at once, and half arrangements whose partners are: they bound the memory."""
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
    length = norm(arrangement_sum(start, tables, good))
    places = list(range(count)) if fixed is None else list(fixed)
    bound, direction = lower_bound(start, tables)
    if count <= MOST_PLACES.get(len(tables), 0):
        # Sums of all arrangements lie beyond the bound along its direction; those below the best so far
        # lie between the two. Where the bound is nothing they are told apart by their widest coordinate.
        widest = (1.0, *(0.0 for _ in start[1:]))
        best = _Best(good, length, direction if bound > 0 else widest)
        good = (_by_halves if len(tables) == 1 else _by_pairs)(start, tables, best, places)
        length = norm(arrangement_sum(start, tables, good))
        if best.pairs >= 0:
            return Arrangement(good, length, length, True)
    return Arrangement(good, length, min(bound, length), False)


def _listed(
    table: Any, parts: Sequence[int], places: Sequence[int], start: Vector, fixed: Sequence[int]
) -> tuple[Any, Any]:
    """Return the sums of all arrangements of parts in places, and the arrangements, a row each.

    Equal parts keep their order. The first part goes to a place of `fixed` where it is among `parts`; it
    may pass parts that equal it, for their places are not restricted.
    """
    import numpy as np

    orders = np.array(parts, dtype=np.int16)[_permutations(len(parts))]
    if 0 in parts:
        allowed = [place in fixed for place in places]
        orders = orders[((orders == 0) & np.array(allowed)).any(axis=1)]
    for i, part in enumerate(parts):
        twin = next((q for q in parts[i + 1 :] if part and np.array_equal(table[part], table[q])), None)
        if twin is not None:
            orders = orders[(orders == part).argmax(axis=1) < (orders == twin).argmax(axis=1)]
    sums = np.broadcast_to(np.array(start), (len(orders), len(start)))
    for column, place in enumerate(places):
        sums = sums + table[orders[:, column], place]
    return sums, orders


@lru_cache(maxsize=4)
def _permutations(count: int) -> Any:
    """Return all permutations of the first whole numbers in lexicographic order, a row each."""
    import numpy as np

    rows = np.zeros((1, 0), dtype=np.int8)
    for size in range(1, count + 1):
        first = np.repeat(np.arange(size, dtype=np.int8), len(rows))[:, None]
        rest = np.tile(rows, (size, 1))
        rows = np.hstack([first, rest + (rest >= first)])
    return rows


class _Best:
    """The best arrangement so far, and how many pairs may still be looked at for a better one."""

    def __init__(self, orders: tuple[Order, ...], length: float, key: Vector) -> None:
        self.orders, self.length, self.key = orders, length, key
        self.pairs = MOST_PAIRS

    def join(self, fronts: tuple[Any, Any], rears: tuple[Any, Any], flat: bool) -> None:
        """Look at all pairs whose sum may be shorter: along the key they nearly cancel.

        None are looked at beyond `MOST_PAIRS`; `pairs` is then below 0.
        """
        import numpy as np

        (front_sums, front_orders), (rear_sums, rear_orders) = fronts, rears
        if not (len(front_sums) and len(rear_sums)):
            return
        keys = rear_sums @ np.array(self.key)
        ranks = np.argsort(keys, kind="stable")
        keys, rear_sums, rear_orders = keys[ranks], rear_sums[ranks], rear_orders[ranks]
        goals = -(front_sums @ np.array(self.key))
        for begin in range(0, len(goals), ROWS):
            some = slice(begin, begin + ROWS)
            reach = self.length * (1 + SLACK)
            low = np.searchsorted(keys, goals[some] - reach, "left")
            counts = np.searchsorted(keys, goals[some] + reach, "right") - low
            ends = np.cumsum(counts)
            first = 0
            while first < len(counts):  # a block of pairs at a time, of at least one front
                done = int(ends[first - 1]) if first else 0
                last = max(first + 1, int(np.searchsorted(ends, done + BLOCK_OF_PAIRS, "right")))
                self.pairs -= int(ends[last - 1]) - done
                if self.pairs < 0:
                    return
                number = counts[first:last]
                front = np.repeat(np.arange(first, last), number) + begin
                offset = np.arange(int(number.sum())) - np.repeat(np.cumsum(number) - number, number)
                rear = np.repeat(low[first:last], number) + offset
                squares = np.zeros(len(front))
                for column in range(front_sums.shape[1]):
                    squares += (front_sums[front, column] + rear_sums[rear, column]) ** 2
                for i in np.flatnonzero(squares < self.length**2 * (1 - SLACK)):
                    if squares[i] < self.length**2 * (1 - SLACK):
                        self.length = sqrt(float(squares[i]))
                        order = tuple(map(int, front_orders[front[i]]))
                        rest = tuple(map(int, rear_orders[rear[i]]))
                        self.orders = ((*order, *rest),) if flat else (order, rest)
                first = last


def _by_halves(
    start: Vector, tables: Sequence[Table], best: _Best, fixed: Sequence[int]
) -> tuple[Order, ...]:
    """Return the best arrangement of one set, by halves."""
    import numpy as np

    table, count = np.array(tables[0]), len(tables[0])
    half = (count + 1) // 2
    first, second = list(range(half)), list(range(half, count))
    zero = tuple(0.0 for _ in start)
    halves = set()
    for parts in combinations(range(count), half):
        kind = tuple(sorted(table[p].tobytes() for p in parts)) if 0 not in parts else None
        if kind is not None and kind in halves:
            continue
        halves.add(kind)
        rest = [p for p in range(count) if p not in parts]
        fronts = _listed(table, parts, first, start, fixed)
        best.join(fronts, _listed(table, rest, second, zero, fixed), flat=True)
        if best.pairs < 0:
            break
    return best.orders


def _by_pairs(
    start: Vector, tables: Sequence[Table], best: _Best, fixed: Sequence[int]
) -> tuple[Order, ...]:
    """Return the best arrangement of two sets, all of one against all of the other."""
    import numpy as np

    one, other = map(np.array, tables)
    places = list(range(len(tables[0])))
    zero = tuple(0.0 for _ in start)
    best.join(
        _listed(one, places, places, start, fixed),
        _listed(other, places, places, zero, places),
        flat=False,
    )
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
    good = (tuple(range(len(places))),)
    widest = (1.0, *(0.0 for _ in start[1:]))
    length = norm(arrangement_sum(fixed, [small], good))
    best = _by_halves(fixed, [small], _Best(good, length, widest), range(len(places)))[0]
    rearrangement = list(order)
    for place, k in zip(places, best, strict=True):
        rearrangement[place] = order[places[k]]
    return tuple(tuple(rearrangement) if k == s else o for k, o in enumerate(orders))
