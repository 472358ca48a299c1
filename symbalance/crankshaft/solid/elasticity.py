"""Linear elasticity on quadratic tetrahedra: stiffness and mass, mirror planes, rigid motions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.rotor.parts import Material

NEAR = 1e-7
"""A node lies in a plane when it is closer than this, in m."""


@dataclass(frozen=True)
class ElasticBody:
    """A meshed body's sparse matrices; unknown k is component `across[k]` at `places[:, k]`, SI."""

    stiffness: Any
    mass: Any
    places: Array
    across: Any

    @property
    def size(self) -> int:
        """The number of unknowns."""
        return len(self.across)

    def on_plane(self, axis: int, value: float) -> Any:
        """Return which unknowns lie on the plane where coordinate `axis` is `value`."""
        return np.abs(self.places[axis] - value) < NEAR

    def zero_at_mirror(self, axis: int, value: float, *, even: bool) -> Any:
        """Return which unknowns are zero where the body is cut at a mirror plane.

        An `even` motion has none across the plane, an odd one none in it.
        """
        normal = self.across == axis
        return self.on_plane(axis, value) & (normal if even else ~normal)

    def rigid(self, about: Array) -> Array:
        """Return the six rigid motions (size, 6), turns about a point."""
        arms = self.places - about[:, None]
        motions = np.zeros((3, self.size, DOF))
        for turn in range(3):
            motions[turn, :, turn] = 1
            motions[:, :, 3 + turn] = np.cross(np.eye(3)[turn], arms.T).T
        return motions[self.across, np.arange(self.size)]


def elastic_solid(mesh: Any, material: Material) -> ElasticBody:
    """Return the stiffness and mass of a scikit-fem mesh in m."""
    from skfem import Basis, BilinearForm, ElementTetP2, ElementVector
    from skfem.helpers import ddot, div, dot, sym_grad

    shear = material.shear
    first = 2 * shear * material.poisson / (1 - 2 * material.poisson)

    @BilinearForm
    def elastic(u: Any, v: Any, _: Any) -> Any:
        return 2 * shear * ddot(sym_grad(u), sym_grad(v)) + first * div(u) * div(v)

    @BilinearForm
    def inert(u: Any, v: Any, _: Any) -> Any:
        return material.density * dot(u, v)

    basis = Basis(mesh, ElementVector(ElementTetP2()), intorder=4)
    across = np.zeros(basis.N, dtype=int)
    for numbers in (basis.dofs.nodal_dofs, basis.dofs.edge_dofs):
        if numbers is None:
            continue
        for component in range(3):
            across[numbers[component]] = component
    return ElasticBody(elastic.assemble(basis), inert.assemble(basis), basis.doflocs, across)


def sparse_factors(matrix: Any, free: Sequence[bool]) -> Any:
    """Return SciPy's sparse factors of the rows and columns that are `free`."""
    from scipy.sparse.linalg import splu

    part = matrix.tocsr()[free][:, free].tocsc()
    options = {"SymmetricMode": True}
    return splu(part, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options)
