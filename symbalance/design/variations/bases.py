"""An orthonormal basis of what vectors span, the longest first: fewer coordinates, the same lengths."""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt

from symbalance.design.variations.bounds import Table, Vector, dot, minus, norm

RANK = 1e-12


def spanned(start: Vector, tables: Sequence[Table]) -> tuple[Vector, tuple[Table, ...], float]:
    """Return the constant and the tables on a basis of their differences, and what is left beside it.

    Only differences between places and parts matter to an arrangement: what all of them share goes into
    the constant. The rest is the length of the constant's part outside the basis, which no arrangement
    changes.

    >>> spanned((0.0, 3.0), [[[(1.0, 0.0), (-1.0, 0.0)], [(0.0, 0.0), (0.0, 0.0)]]])[2]
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
        levelled.append([[minus(v, m) for v, m in zip(row, mean, strict=True)] for row in table])
    basis = _basis([v for table in levelled for row in table for v in row])
    constant = tuple(dot(shared, b) for b in basis)
    rest = sqrt(max(norm(shared) ** 2 - norm(constant) ** 2, 0.0))
    on_basis = tuple(
        [[tuple(dot(v, b) for b in basis) or (0.0,) for v in row] for row in table] for table in levelled
    )
    return constant or (0.0,), on_basis, rest


def _basis(vectors: Sequence[Vector]) -> list[Vector]:
    """Return an orthonormal basis, by Gram and Schmidt with the longest remainder first."""
    left, basis = list(vectors), []
    largest = max(map(norm, left), default=0.0)
    while left:
        longest = max(left, key=norm)
        size = norm(longest)
        if size <= RANK * largest:
            break
        unit = tuple(x / size for x in longest)
        basis.append(unit)
        left = [tuple(x - dot(v, unit) * u for x, u in zip(v, unit, strict=True)) for v in left]
    return basis
