"""Parts of a crank drawn and meshed by gmsh, as a scikit-fem mesh whose edges follow the surface.

Lengths in mm while drawing, so that the modeller's tolerances fit. Journals and pins are bodies of
revolution whose profile flares into the fillet at each web; the web is its outline extruded; the
counterweight a sector from the near axis out to its `outer` radius. A bore ends at the web's faces.
"""

from __future__ import annotations

import ctypes
import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from math import pi
from typing import Any

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.crank import Crank, Journal, Pin, Web
from symbalance.crankshaft.webs.arm import Arm, arms, axis_of
from symbalance.errors import MissingPartError, SymbalanceError

REMEDY = "pip install 'symbalance[crankshaft]'"
EDGES = ((0, 1), (1, 2), (0, 2), (0, 3), (2, 3), (1, 3))
"""gmsh's order of a quadratic tetrahedron's middle nodes."""
MM = 1e3
Entity = tuple[int, int]


@contextmanager
def gmsh_session() -> Iterator[Any]:
    """Open gmsh, quietly; close it whatever happens."""
    try:
        import gmsh
    except (ImportError, OSError) as err:  # OSError: one of its system libraries is missing
        raise MissingPartError("webs = 'solid'", f"gmsh does not load ({err})", REMEDY) from err
    gmsh.initialize(interruptible=False)
    _ignore_broken_pipes()
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.option.setNumber("Mesh.HighOrderOptimize", 1)
        yield gmsh
    finally:
        gmsh.finalize()


def _ignore_broken_pipes() -> None:
    """Ignore SIGPIPE again where Python does: the first start of gmsh makes it deadly for the process.

    Python turns a write to a closed pipe into an exception. Without that, a pool of which one worker
    was killed takes the whole process with it, without a word.
    """
    if not hasattr(signal, "SIGPIPE"):  # Windows
        return
    # Python still holds what it set before gmsh.
    before = signal.getsignal(signal.SIGPIPE)
    try:
        signal.signal(signal.SIGPIPE, before)
    except ValueError:  # only the main thread may; C's own function works in any
        if before == signal.SIG_IGN:
            ctypes.CDLL(None).signal(signal.SIGPIPE, ctypes.c_void_p(int(signal.SIG_IGN)))


def mesh_solid(draw: Callable[[Any], Any], size: float) -> Any:
    """Return the scikit-fem mesh (MeshTet2, in m) of what `draw` draws in mm; `size` of elements, m."""
    try:
        import skfem
    except ImportError as err:
        raise MissingPartError("webs = 'solid'", "scikit-fem is not installed", REMEDY) from err
    with gmsh_session() as gmsh:
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
    return _quadratic_mesh(skfem, points, tets)


def _read(gmsh: Any) -> tuple[Array, Any]:
    tags, places, _ = gmsh.model.mesh.getNodes()
    number = np.zeros(int(tags.max()) + 1, dtype=np.int64)
    number[tags] = np.arange(len(tags))
    _, nodes = gmsh.model.mesh.getElementsByType(11)
    return places.reshape(-1, 3) / 1e3, number[nodes.reshape(-1, 10)]


def _quadratic_mesh(skfem: Any, points: Array, tets: Any) -> Any:
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


@dataclass(frozen=True)
class SolidDrawing:
    """The gmsh modeller, where drawing happens."""

    occ: Any

    def round_bar(
        self, part: Journal | Pin, start: float, stop: float, flares: tuple[bool, bool]
    ) -> Entity:
        """Draw a journal or pin from W = start to stop on its axis, with its fillets where it flares."""
        outer, inner, f = part.diameter / 2 * MM, part.bore / 2 * MM, part.fillet * MM
        z0, z1 = start * MM, stop * MM
        corners = self._profile(outer, inner, z0, z1, (f if flares[0] else 0.0, f if flares[1] else 0.0))
        loop = self.occ.addCurveLoop(corners)
        face = self.occ.addPlaneSurface([loop])
        swept = self.occ.revolve([(2, face)], 0, 0, 0, 0, 0, 1, 2 * pi)
        solid = next(entity for entity in swept if entity[0] == 3)
        x, y = axis_of(part)
        self.occ.translate([solid], x * MM, y * MM, 0)
        return solid

    def _profile(
        self, outer: float, inner: float, z0: float, z1: float, fillets: tuple[float, float]
    ) -> list[int]:
        """Draw the half section in the x-z plane: up the outside, down the inside."""
        point, line, arc = self.occ.addPoint, self.occ.addLine, self.occ.addCircleArc
        front, rear = fillets
        first = point(outer + front, 0, z0)
        low = point(outer, 0, z0 + front) if front else first
        high = point(outer, 0, z1 - rear)
        last = point(outer + rear, 0, z1) if rear else high
        inside = (point(inner, 0, z1), point(inner, 0, z0))
        curves = [arc(first, point(outer + front, 0, z0 + front), low)] if front else []
        curves.append(line(low, high))
        if rear:
            curves.append(arc(high, point(outer + rear, 0, z1 - rear), last))
        return [*curves, line(last, inside[0]), line(inside[0], inside[1]), line(inside[1], first)]

    def slab(self, arm: Arm, start: float) -> list[Entity]:
        """Draw a web, and its counterweight if it has an outline, with its front face at W = start."""
        half, t = arm.web.width / 2 * MM, arm.web.thickness * MM
        near, far = arm.near_margin * MM, arm.far_margin * MM
        solids = [self._outline(half, near, arm.reach * MM + far, (min(half, near), min(half, far)), t)]
        self.occ.rotate(solids, 0, 0, 0, 0, 0, 1, arm.angle)
        self.occ.translate(solids, arm.axis[0] * MM, arm.axis[1] * MM, 0)
        weight = arm.web.counterweight
        if weight and weight.outer > 0:
            solids.append(self._sector(weight.outer * MM, weight.angle, weight.half_angle, t))
        self.occ.translate(solids, 0, 0, start * MM)
        return solids

    def _outline(
        self, half: float, near: float, stop: float, radii: tuple[float, float], t: float
    ) -> Entity:
        point, line, arc = self.occ.addPoint, self.occ.addLine, self.occ.addCircleArc
        (a, b), start = radii, -near
        centres = [point(start + a, a - half, 0), point(stop - b, b - half, 0)]
        centres += [point(stop - b, half - b, 0), point(start + a, half - a, 0)]
        around = [(start, a - half), (start + a, -half), (stop - b, -half), (stop, b - half)]
        around += [(stop, half - b), (stop - b, half), (start + a, half), (start, half - a)]
        points: list[int] = []
        for index, (x, y) in enumerate(around):
            same = index and around[index - 1] == (x, y)
            points.append(points[-1] if same else point(x, y, 0))
        if around[-1] == around[0]:
            points[-1] = points[0]
        curves = []
        for index, centre in enumerate(centres):
            curves.append(arc(points[2 * index], centre, points[2 * index + 1]))
            one, other = points[2 * index + 1], points[(2 * index + 2) % 8]
            if one != other:
                curves.append(line(one, other))
        face = self.occ.addPlaneSurface([self.occ.addCurveLoop(curves)])
        return next(e for e in self.occ.extrude([(2, face)], 0, 0, t) if e[0] == 3)

    def _sector(self, outer: float, angle: float, half_angle: float, t: float) -> Entity:
        solid = self.occ.addCylinder(0, 0, 0, 0, 0, t, outer, angle=2 * half_angle)
        self.occ.rotate([(3, solid)], 0, 0, 0, 0, 0, 1, angle - half_angle)
        return (3, solid)

    def union(self, solids: list[Entity]) -> list[Entity]:
        """Return the union of solids."""
        return self.occ.fuse(solids[:1], solids[1:])[0]


def draw_half_throw(occ: Any, arm: Arm) -> list[Entity]:
    """Draw half the near part, the web and half the far part; front face of the web at 0, arm along U."""
    own = arm.canonical()
    pencil, t = SolidDrawing(occ), own.web.thickness
    near = pencil.round_bar(own.near, -own.near.length / 2, 0.0, (False, True))
    far = pencil.round_bar(own.far, t, t + own.far.length / 2, (True, False))
    return pencil.union([near, *pencil.slab(own, 0.0), far])


def draw_crank(occ: Any, crank: Crank) -> list[Entity]:
    """Draw the whole chain, without what sits at its ends."""
    pencil, webs = SolidDrawing(occ), dict(arms(crank))
    solids: list[Entity] = []
    stations = [*crank.stations()]
    for index, (part, start, stop) in enumerate(stations):
        if isinstance(part, Web):
            solids += pencil.slab(webs[index], start)
            continue
        flares = (index - 1 in webs, index + 1 in webs)
        solids.append(pencil.round_bar(part, start, stop, flares))
    return pencil.union(solids)


def halved(occ: Any, solids: list[Entity], axes: list[int], place: float = 0.0) -> list[Entity]:
    """Return what lies where v > 0 (axis 1) and W < place (axis 2), in mm, for the axes given."""
    big = 1e4
    low = [-big, 0.0 if 1 in axes else -big, -big]
    high = [big, big, place if 2 in axes else big]
    if not axes:
        return solids
    box = (3, occ.addBox(*low, *(b - a for a, b in zip(low, high, strict=True))))
    return occ.intersect(solids, [box])[0]
