"""Lower bounds on the length of a sum of vectors, one for each part in its place.

For every unit vector y, |sum| >= y . sum, whose least value over all arrangements of a set is an
assignment problem. The best y is sought in turn, as Frank and Wolfe do (Naval Research Logistics
Quarterly 3 (1956), An algorithm for quadratic programming). Assignment problems are solved by shortest
augmenting paths with potentials (H. W. Kuhn, The Hungarian method, Naval Research Logistics Quarterly 2
(1955); R. Jonker and A. Volgenant, Computing 38 (1987)).
"""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt
from operator import add

Vector = tuple[float, ...]
Table = Sequence[Sequence[Vector]]
"""v[part][place]."""
Order = tuple[int, ...]
"""The part in each place."""

Generators = Sequence[tuple[Vector, Vector]]
"""What 1 kg of reciprocating and of rotating mass in each place adds."""
STEPS = 200
"""Directions tried at most; the bound is proved after each."""
SLACK = 1e-9
"""What the rounding of floats may be worth."""


def norm(vector: Vector) -> float:
    """Return a vector's length."""
    return sqrt(sum(x * x for x in vector))


def vector_sum(one: Vector, other: Vector) -> Vector:
    """Return the sum of two vectors."""
    return tuple(map(add, one, other))


def arrangement_sum(start: Vector, tables: Sequence[Table], orders: Sequence[Order]) -> Vector:
    """Return c + sum of v for an arrangement."""
    for table, order in zip(tables, orders, strict=True):
        for place, part in enumerate(order):
            start = vector_sum(start, table[part][place])
    return start


def inner_product(one: Vector, other: Vector) -> float:
    """Return the inner product of two vectors."""
    return sum(x * y for x, y in zip(one, other, strict=True))


def difference(one: Vector, other: Vector) -> Vector:
    """Return the difference of two vectors."""
    return tuple(x - y for x, y in zip(one, other, strict=True))


def lower_bound(start: Vector, tables: Sequence[Table]) -> tuple[float, Vector]:
    """Return a length that no arrangement passes below, and the direction along which none does.

    They are the best of linear bounds in directions sought in turn; the direction of 0 means nothing.
    """
    count = len(tables[0])
    point = arrangement_sum(start, tables, [tuple(range(count))] * len(tables))
    best, along = 0.0, start
    for _ in range(STEPS):
        size = norm(point)
        if size <= 1e-12 * (1 + norm(start)):
            break
        direction = tuple(x / size for x in point)
        corner = start
        for table in tables:
            costs = [[inner_product(direction, v) for v in row] for row in table]
            order = least_matching(costs)
            corner = arrangement_sum(corner, [table], [order])
        if inner_product(direction, corner) > best:
            best, along = inner_product(direction, corner), direction
        step = tuple(c - x for c, x in zip(corner, point, strict=True))
        length = inner_product(step, step)
        fraction = min(1.0, max(0.0, -inner_product(point, step) / length)) if length else 0.0
        if fraction <= 0:
            break
        point = tuple(x + fraction * d for x, d in zip(point, step, strict=True))
    return best * (1 - SLACK), along


def least_matching(costs: Sequence[Sequence[float]]) -> tuple[int, ...]:
    """Return, for each column, the row that it goes to when the sum of costs[row][column] is least.

    >>> least_matching([[4.0, 1.0, 3.0], [2.0, 0.0, 5.0], [3.0, 2.0, 2.0]])
    (1, 0, 2)
    """
    count = len(costs)
    rows, columns = [0.0] * (count + 1), [0.0] * (count + 1)
    owner = [count] * (count + 1)  # the row of each column; the last column is a place to start from
    for row in range(count):
        _augment(costs, row, rows, columns, owner)
    return tuple(owner[:count])


def _augment(
    costs: Sequence[Sequence[float]], row: int, rows: list[float], columns: list[float], owner: list[int]
) -> None:
    """Give one more row a column, moving others along the cheapest path."""
    count = len(costs)
    owner[count] = row
    column, before = count, [count] * count
    least, used = [float("inf")] * count, [False] * (count + 1)
    while True:
        used[column] = True
        here, nearest, step = owner[column], count, float("inf")
        for j in range(count):
            if used[j]:
                continue
            cost = costs[here][j] - rows[here] - columns[j]
            if cost < least[j]:
                least[j], before[j] = cost, column
            if least[j] < step:
                nearest, step = j, least[j]
        for j in range(count + 1):
            if used[j]:
                rows[owner[j]] += step
                columns[j] -= step
            elif j < count:
                least[j] -= step
        column = nearest
        if owner[column] == count:
            break
    while column != count:
        owner[column] = owner[before[column]]
        column = before[column]
