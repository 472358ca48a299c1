"""The published equation of motion of a crankshaft's node, compared with the derived one entry by entry.

Source: J. Mizuhaya, I. Honda, K. Ota, H. Shimokouchi, T. Tsubota, "Analysis of Dynamic Stress of Engine
Crankshaft in Operating Condition" (Mitsubishi Heavy Industries), equation (1). Its M, I_u, I_v, I_w are
m, I_uu, I_vv, I_ww here.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import sympy

from symbalance.crankshaft.equations.node import NodeEquations
from symbalance.crankshaft.equations.quantities import MOMENTS, PLACE, M

HOLDS, MISSING, DIFFERS = "holds", "missing", "differs"


@dataclass(frozen=True)
class PublishedEntry:
    """One entry of a published matrix (rows and columns count from 0), what it is, and the verdict.

    "holds": equal; "missing": zero in print only; "differs": both there and not equal.
    """

    matrix: str
    row: int
    column: int
    published_value: Any
    derived_value: Any

    @property
    def verdict(self) -> str:
        """One of "holds", "missing", "differs"; every entry is a polynomial, so the test is exact."""
        if sympy.expand(self.published_value - self.derived_value) == 0:
            return HOLDS
        return MISSING if self.published_value == 0 else DIFFERS


def published_matrices() -> dict[str, sympy.ImmutableMatrix]:
    """Return the matrices of equation (1) as printed.

    >>> published_matrices()["gyroscopic"][4, 3]
    I_uu + I_vv - I_ww
    """
    uu, vv, ww = MOMENTS
    U, V, _ = PLACE
    gyroscopic = {(0, 1): -2 * M, (1, 0): 2 * M, (3, 4): ww - uu - vv, (4, 3): -ww + uu + vv}
    return {
        "mass": sympy.ImmutableMatrix(sympy.diag(M, M, M, uu, vv, ww)),
        "gyroscopic": sympy.ImmutableMatrix(6, 6, lambda i, j: gyroscopic.get((i, j), 0)),
        "centrifugal": sympy.ImmutableMatrix(sympy.diag(-M, -M, 0, ww - vv, ww - uu, 0)),
        "centrifugal_force": sympy.ImmutableMatrix([M * U, M * V, 0, 0, 0, 0]),
    }


def compare_with_published(equations: NodeEquations) -> Iterator[PublishedEntry]:
    """Yield every entry of equation (1), 114 in all, beside the one derived.

    >>> from symbalance.crankshaft.equations import node_equations
    >>> {entry.verdict for entry in compare_with_published(node_equations().principal())}
    {'holds'}
    """
    matrices = equations.parts()
    for name, print_ in published_matrices().items():
        for row in range(print_.rows):
            for column in range(print_.cols):
                yield PublishedEntry(name, row, column, print_[row, column], matrices[name][row, column])
