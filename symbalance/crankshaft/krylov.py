"""Krylov spaces for maps known only by what they do to a vector: GMRES, and the largest eigenvalues."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from symbalance.crankshaft.rotor import Array

Map = Callable[[Array], Array]


def solved(apply: Map, side: Array, tolerance: float = 1e-11, most: int = 400) -> Array:
    """Return x with apply(x) = side, by GMRES without restarts (Saad and Schultz 1986, from memory).

    >>> solved(lambda x: np.array([2 * x[0], x[1] - x[0]]), np.array([2.0, 3.0])).round(9)
    array([1., 4.])
    """
    size = float(np.linalg.norm(side))
    if size == 0:
        return np.zeros_like(side)
    basis: list[Array] = [side / size]
    columns: list[Array] = []
    weights: Array = np.zeros(0)
    for k in range(min(most, len(side))):
        basis, column = _grown(apply, basis)
        columns.append(column)
        table = _hessenberg(columns)
        first = np.zeros(len(table))
        first[0] = size
        weights = np.linalg.lstsq(table, first, rcond=None)[0]
        if np.linalg.norm(table @ weights - first) <= tolerance * size or len(basis) == k + 1:
            break
    return np.array(basis[: len(weights)]).T @ weights


def leading(apply: Map, size: int, wanted: int = 12, most: int = 120) -> NDArray[np.complex128]:
    """Return the `wanted` largest eigenvalues of a map, by Arnoldi's method from a random start.

    Stops when the largest eight have settled to 1e-8 of the largest.

    >>> leading(lambda x: np.arange(60.0) * x, 60, wanted=2).real.round(6)
    array([59., 58.])
    """
    start = np.random.default_rng(1).standard_normal(size)
    basis: list[Array] = [start / np.linalg.norm(start)]
    columns: list[Array] = []
    before = found = np.zeros(0, dtype=complex)
    for k in range(min(most, size)):
        basis, column = _grown(apply, basis)
        columns.append(column)
        if len(basis) == k + 1:
            break
        if k % 8 == 7:
            found = _ritz(columns)[:8]
            if len(before) == 8 and np.abs(found - before).max() <= 1e-8 * abs(found[0]):
                break
            before = found
    return _ritz(columns)[:wanted]


def _grown(apply: Map, basis: list[Array]) -> tuple[list[Array], Array]:
    """Return the basis with one more direction, orthogonalised twice, and the column it leaves."""
    moved = apply(basis[-1])
    scale, matrix = float(np.linalg.norm(moved)), np.array(basis)
    column = matrix @ moved
    moved = moved - column @ matrix
    again = matrix @ moved
    moved = moved - again @ matrix
    left = float(np.linalg.norm(moved))
    column = np.append(column + again, left)
    return (basis, column) if left <= 1e-14 * scale else ([*basis, moved / left], column)


def _hessenberg(columns: list[Array]) -> Array:
    table = np.zeros((len(columns) + 1, len(columns)))
    for k, column in enumerate(columns):
        table[: len(column), k] = column
    return table


def _ritz(columns: list[Array]) -> NDArray[np.complex128]:
    values = np.linalg.eigvals(_hessenberg(columns)[:-1]).astype(complex)
    return values[np.argsort(-np.abs(values))]
