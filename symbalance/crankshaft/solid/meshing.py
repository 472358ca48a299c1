"""A gmsh session, and its quadratic tetrahedra as a scikit-fem mesh whose edges follow the surface."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from symbalance.crankshaft.rotor import Array
from symbalance.errors import MissingPartError, SymbalanceError

REMEDY = "pip install 'symbalance[crankshaft]'"
EDGES = ((0, 1), (1, 2), (0, 2), (0, 3), (2, 3), (1, 3))
"""gmsh's order of a quadratic tetrahedron's middle nodes."""


@contextmanager
def session() -> Iterator[Any]:
    """Open gmsh, quietly; close it whatever happens."""
    try:
        import gmsh
    except (ImportError, OSError) as err:  # OSError: one of its system libraries is missing
        raise MissingPartError("webs = 'solid'", f"gmsh does not load ({err})", REMEDY) from err
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.option.setNumber("Mesh.HighOrderOptimize", 1)
        yield gmsh
    finally:
        gmsh.finalize()


def meshed(draw: Callable[[Any], Any], size: float) -> Any:
    """Return the scikit-fem mesh (MeshTet2, in m) of what `draw` draws in mm; `size` of elements, m."""
    try:
        import skfem
    except ImportError as err:
        raise MissingPartError("webs = 'solid'", "scikit-fem is not installed", REMEDY) from err
    with session() as gmsh:
        gmsh.option.setNumber("Mesh.MeshSizeMax", size * 1e3)
        gmsh.option.setNumber("Mesh.MeshSizeFromCurvature", 12)
        gmsh.option.setNumber("Mesh.MeshSizeMin", size * 1e3 / 3)
        try:
            draw(gmsh.model.occ)
            gmsh.model.occ.synchronize()
            gmsh.model.mesh.generate(3)
            gmsh.model.mesh.setOrder(2)
        except Exception as err:
            if type(err) is not Exception:  # gmsh raises bare ones; any other is a fault of this program
                raise
            rule = f"cannot be meshed ({err})"
            raise SymbalanceError(
                "the crank's solid", rule, "check its sizes, or webs = 'fitted'"
            ) from err
        points, tets = _read(gmsh)
    return _curved(skfem, points, tets)


def _read(gmsh: Any) -> tuple[Array, Any]:
    tags, places, _ = gmsh.model.mesh.getNodes()
    number = np.zeros(int(tags.max()) + 1, dtype=np.int64)
    number[tags] = np.arange(len(tags))
    _, nodes = gmsh.model.mesh.getElementsByType(11)
    return places.reshape(-1, 3) / 1e3, number[nodes.reshape(-1, 10)]


def _curved(skfem: Any, points: Array, tets: Any) -> Any:
    """Return the mesh with each edge's middle node where gmsh put it."""
    corners, place = np.unique(tets[:, :4], return_inverse=True)
    flat = skfem.MeshTet(points[corners].T.copy(), place.reshape(-1, 4).T.copy())
    middle = {}
    for column, (a, b) in enumerate(EDGES, start=4):
        ends = np.sort(place.reshape(-1, 4)[:, [a, b]], axis=1)
        middle.update(zip(map(tuple, ends.tolist()), tets[:, column].tolist(), strict=True))
    order = [middle[pair] for pair in map(tuple, np.sort(flat.edges.T, axis=1).tolist())]
    places = np.hstack([flat.p, points[order].T])
    return skfem.MeshTet2(places, flat.t)
