"""The assignment of parts as minimisation of a vector sum, and its average over all arrangements.

The vectors are taken on a basis of what they span, and places that a symmetry of the engine exchanges are
tried once.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import sqrt

from symbalance.design.variations.arrangement_search import Arrangement, best_arrangement
from symbalance.design.variations.assignment_bounds import (
    Generators,
    Table,
    Vector,
    difference,
    inner_product,
    norm,
)
from symbalance.design.variations.part_sets import PartSet

RANK = 1e-12
"""Remainders this small, of the longest vector, are rounding: the basis is complete."""
SAME = 1e-9
"""Inner products that agree to this part of the largest are equal."""
MOST_TRIES = 20_000
"""Partial exchanges of places looked at before a symmetry is given up: giving up costs only time."""


@dataclass(frozen=True)
class AssignmentProblem:
    """What each part adds in each place, about a constant: vectors."""

    start: Vector
    tables: tuple[Table, ...]
    generators: Generators

    @staticmethod
    def of(
        sets: Sequence[PartSet], generators: Generators, whole: bool, as_built: Vector | None = None
    ) -> AssignmentProblem:
        """Return the problem of these parts: what they differ by, or about their means if `whole`.

        `as_built` is what turns beside them; the means of their rotating masses are then part of it.
        """
        start = tuple(0.0 for _ in generators[0][0]) if as_built is None else as_built
        tables = []
        for one in sets:
            count = len(one.parts)
            means = [
                sum((p.reciprocating for p in one.parts), Fraction(0)) / count,
                sum((p.rotating for p in one.parts), Fraction(0)) / count,
            ]
            if whole:
                level = float(means[0]), 0.0 if as_built is not None else float(means[1])
                for sliding, turning in generators:
                    mean = zip(sliding, turning, start, strict=True)
                    start = tuple(x * level[0] + y * level[1] + z for x, y, z in mean)
            tables.append(
                [
                    [
                        _combine(float(p.reciprocating - means[0]), float(p.rotating - means[1]), *pair)
                        for pair in generators
                    ]
                    for p in one.parts
                ]
            )
        return AssignmentProblem(start, tuple(tables), generators)

    def solution(self) -> Arrangement:
        """Return the best arrangement, on a basis of what the vectors span."""
        start, tables, rest = on_basis(self.start, self.tables)
        ranks = [_by_size(table) for table in tables]
        sorted_tables = [[table[p] for p in rank] for table, rank in zip(tables, ranks, strict=True)]
        fixed = representatives(self.start, self.generators)
        arrangement = best_arrangement(start, sorted_tables, fixed)
        orders = tuple(
            tuple(rank[p] for p in order) for rank, order in zip(ranks, arrangement.orders, strict=True)
        )
        return Arrangement(
            orders,
            sqrt(arrangement.length**2 + rest**2),
            sqrt(arrangement.bound**2 + rest**2),
            arrangement.proved,
        )


def _combine(sliding_mass: float, turning_mass: float, sliding: Vector, turning: Vector) -> Vector:
    return tuple(sliding_mass * x + turning_mass * y for x, y in zip(sliding, turning, strict=True))


def _by_size(table: Table) -> list[int]:
    return sorted(range(len(table)), key=lambda p: -max(norm(v) for v in table[p]))


def expected_length(start: Vector, tables: Sequence[Table]) -> float:
    """Return the root mean square length over all arrangements, each as likely.

    The variance of one set's sum is that of its table, freed of the means of rows and columns, summed and
    over N - 1 (W. Hoeffding, A combinatorial central limit
    theorem, Annals of Mathematical Statistics 22 (1951), 558-566).
    """
    mean, variance = start, 0.0
    for table in tables:
        count = len(table)
        for i in range(len(start)):
            entries = [[v[i] for v in row] for row in table]
            rows = [sum(row) / count for row in entries]
            columns = [sum(row[j] for row in entries) / count for j in range(count)]
            middle = sum(rows) / count
            mean = tuple(x + middle * count if k == i else x for k, x in enumerate(mean))
            if count > 1:
                variance += sum(
                    (entries[p][j] - rows[p] - columns[j] + middle) ** 2
                    for p in range(count)
                    for j in range(count)
                ) / (count - 1)
    return sqrt(norm(mean) ** 2 + variance)


def on_basis(start: Vector, tables: Sequence[Table]) -> tuple[Vector, tuple[Table, ...], float]:
    """Return the constant and the tables on a basis of their differences, and what is left beside it.

    Only differences between places and parts matter to an arrangement: what all of them share goes into
    the constant. The rest is the length of the constant's part outside the basis, which no arrangement
    changes.

    >>> on_basis((0.0, 3.0), [[[(1.0, 0.0), (-1.0, 0.0)], [(0.0, 0.0), (0.0, 0.0)]]])[2]
    3.0
    """
    shared, levelled = start, []
    for table in tables:
        count = len(table)
        mean = [
            tuple(sum(row[j][i] for row in table) / count for i in range(len(start)))
            for j in range(count)
        ]
        for column in mean:
            shared = tuple(x + y for x, y in zip(shared, column, strict=True))
        levelled.append([[difference(v, m) for v, m in zip(row, mean, strict=True)] for row in table])
    basis = _basis([v for table in levelled for row in table for v in row])
    constant = tuple(inner_product(shared, b) for b in basis)
    rest = sqrt(max(norm(shared) ** 2 - norm(constant) ** 2, 0.0))
    on_basis = tuple(
        [[tuple(inner_product(v, b) for b in basis) or (0.0,) for v in row] for row in table]
        for table in levelled
    )
    return constant or (0.0,), on_basis, rest


def _basis(vectors: Sequence[Vector]) -> list[Vector]:
    """Return an orthonormal basis, by Gram and Schmidt with the longest remainder first."""
    remainders, basis = list(vectors), []
    largest = max(map(norm, remainders), default=0.0)
    while remainders:
        longest = max(remainders, key=norm)
        size = norm(longest)
        if size <= RANK * largest:
            break
        unit = tuple(x / size for x in longest)
        basis.append(unit)
        remainders = [
            tuple(x - inner_product(v, unit) * u for x, u in zip(v, unit, strict=True))
            for v in remainders
        ]
    return basis


def representatives(start: Vector, generators: Generators) -> list[int]:
    """Return one place of each class of places that a symmetry exchanges: the others need not be tried.

    A permutation of the cylinders that keeps all inner products between their vectors, and with the
    constant, is an isometry of what they span: arrangements it turns into one another are equally long.

    >>> one = [((1.0, 0.0), (0.0, 0.0)), ((0.0, 1.0), (0.0, 0.0)), ((-1.0, 0.0), (0.0, 0.0))]
    >>> representatives((0.0, 0.0), one)
    [0, 1]
    """
    count = len(generators)
    products = _products(start, generators)
    classes: list[int] = []
    for place in range(count):
        if not any(_extends(products, {other: place}) for other in classes):
            classes.append(place)
    return classes


Products = tuple[list[list[tuple[float, ...]]], float]


def _products(start: Vector, generators: Generators) -> Products:
    table = [
        [
            tuple(inner_product(x, y) for x in (*one, start) for y in (*other, start))
            for other in generators
        ]
        for one in generators
    ]
    return table, max((abs(x) for row in table for cell in row for x in cell), default=0.0) * SAME


def _extends(products: Products, images: dict[int, int], tries: list[int] | None = None) -> bool:
    """Tell whether a partial exchange of places extends to all of them; given up after `MOST_TRIES`."""
    table, grain = products
    tries = tries if tries is not None else [MOST_TRIES]
    tries[0] -= 1
    if tries[0] < 0 or not all(
        abs(x - y) <= grain
        for i, a in images.items()
        for j, b in images.items()
        for x, y in zip(table[i][j], table[a][b], strict=True)
    ):
        return False
    place = next((i for i in range(len(table)) if i not in images), None)
    if place is None:
        return True
    return any(
        _extends(products, {**images, place: image}, tries)
        for image in range(len(table))
        if image not in images.values()
    )
