"""Sums of vectors, one for each part in its place: their length, and what none of them passes below.

For every unit vector y, |sum| >= y . sum, whose least value over all arrangements of a set is an
assignment problem. The best y is sought in turn, as Frank and Wolfe do (Naval Research Logistics
Quarterly 3 (1956), An algorithm for quadratic programming).
"""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt
from operator import add

from symbalance.design.variations.matching import least_matching

Vector = tuple[float, ...]
Table = Sequence[Sequence[Vector]]
"""v[part][place]."""
Order = tuple[int, ...]
"""The part in each place."""

STEPS = 200
SLACK = 1e-9
"""What the rounding of floats may be worth."""


def norm(vector: Vector) -> float:
    """Return a vector's length."""
    return sqrt(sum(x * x for x in vector))


def plus(one: Vector, other: Vector) -> Vector:
    """Return the sum of two vectors."""
    return tuple(map(add, one, other))


def total(start: Vector, tables: Sequence[Table], orders: Sequence[Order]) -> Vector:
    """Return c + sum of v for an arrangement."""
    for table, order in zip(tables, orders, strict=True):
        for place, part in enumerate(order):
            start = plus(start, table[part][place])
    return start


def dot(one: Vector, other: Vector) -> float:
    """Return the inner product of two vectors."""
    return sum(x * y for x, y in zip(one, other, strict=True))


def minus(one: Vector, other: Vector) -> Vector:
    """Return the difference of two vectors."""
    return tuple(x - y for x, y in zip(one, other, strict=True))


def lower_bound(start: Vector, tables: Sequence[Table]) -> float:
    """Return a length that no arrangement passes below, by linear bounds in directions sought in turn."""
    count = len(tables[0])
    point = total(start, tables, [tuple(range(count))] * len(tables))
    best = 0.0
    for _ in range(STEPS):
        size = norm(point)
        if size <= 1e-12 * (1 + norm(start)):
            break
        direction = tuple(x / size for x in point)
        corner = start
        for table in tables:
            costs = [[dot(direction, v) for v in row] for row in table]
            order = least_matching(costs)
            corner = total(corner, [table], [order])
        best = max(best, dot(direction, corner))
        step = tuple(c - x for c, x in zip(corner, point, strict=True))
        length = dot(step, step)
        share = min(1.0, max(0.0, -dot(point, step) / length)) if length else 0.0
        if share <= 0:
            break
        point = tuple(x + share * d for x, d in zip(point, step, strict=True))
    return best * (1 - SLACK)
