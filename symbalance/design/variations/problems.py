"""The vectors of weighed parts in an engine, their best arrangement, and what chance would give."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import sqrt

from symbalance.design.variations.bases import spanned
from symbalance.design.variations.bounds import Table, Vector, norm
from symbalance.design.variations.placements import Placement, arranged
from symbalance.design.variations.symmetry import Generators, representatives
from symbalance.design.variations.weighed import PartSet


@dataclass(frozen=True)
class Problem:
    """What each part adds in each place, about a constant: vectors."""

    start: Vector
    tables: tuple[Table, ...]
    generators: Generators

    @staticmethod
    def of(
        sets: Sequence[PartSet], generators: Generators, whole: bool, made: Vector | None = None
    ) -> Problem:
        """Return the problem of these parts: what they differ by, or about their means if `whole`.

        `made` is what turns beside them; the means of their rotating masses are then part of it.
        """
        start = tuple(0.0 for _ in generators[0][0]) if made is None else made
        tables = []
        for one in sets:
            count = len(one.parts)
            means = [
                sum((p.reciprocating for p in one.parts), Fraction(0)) / count,
                sum((p.rotating for p in one.parts), Fraction(0)) / count,
            ]
            if whole:
                level = float(means[0]), 0.0 if made is not None else float(means[1])
                for sliding, turning in generators:
                    mean = zip(sliding, turning, start, strict=True)
                    start = tuple(x * level[0] + y * level[1] + z for x, y, z in mean)
            tables.append(
                [
                    [
                        _mixed(float(p.reciprocating - means[0]), float(p.rotating - means[1]), *pair)
                        for pair in generators
                    ]
                    for p in one.parts
                ]
            )
        return Problem(start, tuple(tables), generators)

    def solved(self) -> Placement:
        """Return the best arrangement, on a basis of what the vectors span."""
        start, tables, rest = spanned(self.start, self.tables)
        ranks = [_by_size(table) for table in tables]
        sorted_tables = [[table[p] for p in rank] for table, rank in zip(tables, ranks, strict=True)]
        fixed = representatives(self.start, self.generators)
        found = arranged(start, sorted_tables, fixed)
        orders = tuple(
            tuple(rank[p] for p in order) for rank, order in zip(ranks, found.orders, strict=True)
        )
        return Placement(
            orders, sqrt(found.length**2 + rest**2), sqrt(found.bound**2 + rest**2), found.proved
        )


def _mixed(sliding_mass: float, turning_mass: float, sliding: Vector, turning: Vector) -> Vector:
    return tuple(sliding_mass * x + turning_mass * y for x, y in zip(sliding, turning, strict=True))


def _by_size(table: Table) -> list[int]:
    return sorted(range(len(table)), key=lambda p: -max(norm(v) for v in table[p]))


def expected(start: Vector, tables: Sequence[Table]) -> float:
    """Return the root mean square length over all arrangements, each as likely.

    The variance of one set's sum is that of its table, freed of the means of rows and columns, summed and
    over N - 1 (W. Hoeffding, Annals of Mathematical Statistics 22 (1951), 558-566).
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
