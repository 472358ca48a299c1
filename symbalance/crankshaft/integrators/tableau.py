"""Radau IIA collocation: nodes, weights, and the transform that decouples its stages."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symbalance.crankshaft.arrays import Array
from symbalance.errors import SymbalanceError, shown

Complex = NDArray[np.complexfloating[Any, Any]]
MOST_STAGES = 9
"""Of order 17."""


@dataclass(frozen=True)
class Tableau:
    """Nodes c (s,) and matrix A (s, s) of a stiffly accurate method: its weights are A's last row.

    A = T diag(poles) T^-1; `pole_indices` names one pole of each conjugate pair, `pole_weights` the
    factor, 1 or 2, with which its real part counts.
    """

    nodes: Array
    matrix: Array
    transform: Complex
    inverse: Complex
    poles: Complex
    pole_indices: tuple[int, ...]
    pole_weights: Array

    @property
    def stages(self) -> int:
        """The number of stages."""
        return len(self.nodes)

    @property
    def order(self) -> int:
        """The order of convergence, 2 s - 1."""
        return 2 * self.stages - 1


@cache
def radau_iia(stages: int = 3) -> Tableau:
    """Return Radau IIA with s stages, of order 2 s - 1: L-stable, exact at the right end.

    The nodes are the roots of P_{s-1} - P_s on [0, 1], Legendre polynomials; A integrates the Lagrange
    polynomials through them. Source: derived so; the three-stage nodes c = (4 -+ sqrt 6)/10, 1 are those
    of SciPy's `Radau`, which names Hairer and Wanner, Solving Ordinary Differential Equations II, IV.8.

    >>> [round(float(c), 6) for c in radau_iia(3).nodes], round((4 - 6**0.5) / 10, 6)
    ([0.155051, 0.644949, 1.0], 0.155051)
    """
    if not 1 <= stages <= MOST_STAGES:
        what = f"{shown(stages)} stages"
        raise SymbalanceError(what, f"must lie in 1 to {MOST_STAGES}", "3 has order 5, 5 has order 9")
    legendre = np.polynomial.legendre.Legendre
    difference = legendre.basis(stages) - (legendre.basis(stages - 1) if stages else 0)
    roots = np.sort(np.real(difference.roots()))
    roots[-1] = 1.0
    nodes = (roots + 1) / 2
    powers = np.arange(stages)
    lagrange = np.linalg.inv(nodes[:, None] ** powers)
    matrix = (nodes[:, None] ** (powers + 1) / (powers + 1)) @ lagrange
    poles, transform = np.linalg.eig(matrix)
    return _diagonalise(nodes, matrix, poles.astype(complex), transform.astype(complex))


def _diagonalise(nodes: Array, matrix: Array, poles: Any, transform: Any) -> Tableau:
    pole_indices = tuple(int(i) for i in np.flatnonzero(poles.imag >= 0))
    pole_weights = np.array([1.0 if poles[i].imag == 0 else 2.0 for i in pole_indices])
    return Tableau(nodes, matrix, transform, np.linalg.inv(transform), poles, pole_indices, pole_weights)
