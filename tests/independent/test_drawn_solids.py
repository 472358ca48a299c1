"""Drawn cranks against points: a point belongs to journal, pin, web or sector by their definitions alone.

Volume, centre and second moments of what the modeller draws are compared with sums over a cloud of
points that fills a box evenly (Sobol's), each judged by the sizes of the parts.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.stats import qmc

from symbalance.crankshaft.crank import Crank, Journal, Pin, Web, WebCounterweight
from symbalance.crankshaft.webs.arm import arms

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(importlib.util.find_spec("gmsh") is None, reason="gmsh is optional"),
]
BOX = np.array([[-0.11, -0.11, 0.0], [0.11, 0.11, 0.22]])

PLAIN = Web(0.021, 0.084, 0.033, 0.047)
WEIGHTED = replace(PLAIN, counterweight=WebCounterweight(1.0, 0.05, 2.1, 0.0, 0.078, 0.9))
NARROW = Web(0.017, 0.078, 0.042, 0.036)
"""Its pin end is wider than round: corners with a straight line between."""
FRONT = Journal(0.06, 0.031, 0.012, 0.006)
MIDDLE = Journal(0.064, 0.028, 0.0, 0.005)
PIN = Pin(0.052, 0.026, 0.041, 0.6, (1,), 0.018, 0.007)
SECOND = replace(PIN, angle=-1.4, cylinders=(2,), bore=0.0, length=0.022)
CHAINS = {
    "two throws between bearings": (
        FRONT, WEIGHTED, PIN, PLAIN, MIDDLE, PLAIN, SECOND, NARROW, replace(FRONT, length=0.024),
    ),
    "two pins and no bearing between": (
        FRONT, PLAIN, PIN, Web(0.02, 0.12, 0.05, 0.05), SECOND, PLAIN, FRONT,
    ),
}  # fmt: skip


def is_inside(crank: Crank, points: np.ndarray) -> np.ndarray:
    """Tell which points (n, 3) lie in a crank's metal."""
    u, v, w = points.T
    parts = list(crank.stations())
    inside = np.zeros(len(points), bool)
    for index, (part, start, stop) in enumerate(parts):
        within = (w >= start) & (w < stop)
        if not isinstance(part, Web):
            cu, cv = axis(part)
            radius, f = np.full(len(points), part.diameter / 2), part.fillet
            for edge, neighbour in ((w - start, index > 0), (stop - w, index < len(parts) - 1)):
                # The fillet is a quarter of a circle that touches both the round and the web's face.
                flare = f - np.sqrt(np.maximum(f**2 - (f - np.minimum(edge, f)) ** 2, 0))
                radius = radius + (flare if neighbour else 0)
            distance = np.hypot(u - cu, v - cv)
            inside |= within & (distance < radius) & (distance >= part.bore / 2)
            continue
        (before, _, _), (after, _, _) = parts[index - 1], parts[index + 1]
        inside |= within & is_in_slab(part, before, after, u, v)
        weight = part.counterweight
        if weight:
            turn = np.angle(np.exp(1j * (np.arctan2(v, u) - weight.angle)))
            inside |= within & (np.hypot(u, v) < weight.outer) & (np.abs(turn) < weight.half_angle)
    return inside


def axis(part: Any) -> tuple[float, float]:
    if isinstance(part, Journal):
        return 0.0, 0.0
    return part.radius * np.cos(part.angle), part.radius * np.sin(part.angle)


def is_in_slab(web: Web, before: Any, after: Any, u: np.ndarray, v: np.ndarray) -> np.ndarray:
    """A slab whose four corners are rounded as far as width and margin let them."""
    first, last = np.array(axis(before)), np.array(axis(after))
    reach = np.hypot(*(last - first))
    along = ((u - first[0]) * (last - first)[0] + (v - first[1]) * (last - first)[1]) / reach
    across = ((v - first[1]) * (last - first)[0] - (u - first[0]) * (last - first)[1]) / reach
    half, inside = web.width / 2, np.abs(across) < web.width / 2
    for part, beyond in ((before, -along), (after, along - reach)):
        margin = web.heel if isinstance(part, Journal) else web.tip
        corner = min(half, margin)
        a, b = beyond - (margin - corner), np.abs(across) - (half - corner)
        inside &= (beyond < margin) & ((a < 0) | (b < 0) | (a**2 + b**2 < corner**2))
    return inside


def moments_of_points(points: np.ndarray, inside: np.ndarray) -> np.ndarray:
    """Volume, centre and second moments about it, as ten numbers."""
    volume = np.prod(BOX[1] - BOX[0]) / len(points)
    metal = points[inside]
    centre = metal.mean(0)
    second = (metal - centre).T @ (metal - centre) * volume
    return np.array([len(metal) * volume, *centre, *second[np.triu_indices(3)]])


def moments_of_drawing(draw: Callable[[Any], list[tuple[int, int]]]) -> np.ndarray:
    """The same of what is drawn, in m."""
    from symbalance.crankshaft.solid.meshing import gmsh_session

    with gmsh_session() as gmsh:
        occ = gmsh.model.occ
        solids = draw(occ)
        occ.synchronize()
        assert {dimension for dimension, _ in solids} == {3}
        masses = np.array([occ.getMass(*entity) for entity in solids])
        places = np.array([occ.getCenterOfMass(*entity) for entity in solids])
        tensors = np.array([occ.getMatrixOfInertia(*entity) for entity in solids]).reshape(-1, 3, 3)
    centre = masses @ places / masses.sum()
    second = np.zeros((3, 3))
    for mass, place, tensor in zip(masses, places - centre, tensors, strict=True):
        second += np.trace(tensor) / 2 * np.eye(3) - tensor + mass * np.outer(place, place)
    return np.array([masses.sum() / 1e9, *centre / 1e3, *second[np.triu_indices(3)] / 1e15])


def assert_close(drawn: np.ndarray, points: np.ndarray) -> None:
    """Assert that moments agree to what a cloud resolves, in the measure of the body's own size."""
    volume = points[0]
    radius = np.sqrt(np.abs(points[[4, 7, 9]]).sum() / volume)
    scale = np.array([volume, *[radius] * 3, *[volume * radius**2] * 6])
    assert np.abs((drawn - points) / scale).max() < 1.5e-3


@pytest.fixture(scope="module")
def cloud() -> np.ndarray:
    return qmc.scale(qmc.Sobol(3, seed=5).random_base2(20), *BOX)


@pytest.mark.parametrize("chain", CHAINS)
def test_a_drawn_crank_has_the_moments_of_its_parts(chain: str, cloud: np.ndarray) -> None:
    from symbalance.crankshaft.solid.meshing import draw_crank

    crank = Crank(CHAINS[chain])
    inside = is_inside(crank, cloud)
    assert_close(moments_of_drawing(lambda occ: draw_crank(occ, crank)), moments_of_points(cloud, inside))


@pytest.mark.parametrize("axes", [[1], [2], [1, 2]])
def test_half_of_a_drawing_is_what_lies_on_its_side(axes: list[int], cloud: np.ndarray) -> None:
    from symbalance.crankshaft.solid.meshing import draw_crank, halved

    crank, place = Crank(CHAINS["two throws between bearings"]), 0.07
    inside = is_inside(crank, cloud)
    if 1 in axes:
        inside &= cloud[:, 1] > 0
    if 2 in axes:
        inside &= cloud[:, 2] < place
    drawn = moments_of_drawing(lambda occ: halved(occ, draw_crank(occ, crank), axes, place * 1e3))
    assert_close(drawn, moments_of_points(cloud, inside))


@pytest.mark.parametrize("web", [1, 3, 5, 7])
def test_half_a_throw_is_cut_from_its_crank(web: int, cloud: np.ndarray) -> None:
    """From the middle of one part to the middle of the next, turned into the arm's own axes."""
    from symbalance.crankshaft.solid.meshing import draw_half_throw

    crank = Crank(CHAINS["two throws between bearings"])
    arm = dict(arms(crank))[web]
    middles = [(start + stop) / 2 for _, start, stop in crank.stations()]
    _, front, rear = list(crank.stations())[web]
    inside = is_inside(crank, cloud) & (cloud[:, 2] > middles[web - 1]) & (cloud[:, 2] < middles[web + 1])
    pin = next(part for part in crank.parts[web - 1 : web + 2] if isinstance(part, Pin))
    cos, sin = np.cos(pin.angle), np.sin(pin.angle)
    is_journal_first = isinstance(crank.parts[web - 1], Journal)
    w = cloud[:, 2] - front if is_journal_first else rear - cloud[:, 2]
    turned = np.stack(
        [cos * cloud[:, 0] + sin * cloud[:, 1], cos * cloud[:, 1] - sin * cloud[:, 0], w], 1
    )
    assert_close(
        moments_of_drawing(lambda occ: draw_half_throw(occ, arm)), moments_of_points(turned, inside)
    )


def test_a_mesh_fills_the_drawing() -> None:
    """The quadratic elements' volume, by their own shape functions, is that of the drawn bodies."""
    from symbalance.crankshaft.solid.meshing import draw_half_throw, mesh_solid

    skfem = pytest.importorskip("skfem")
    arm = dict(arms(Crank(CHAINS["two throws between bearings"])))[1]
    mesh = mesh_solid(lambda occ: draw_half_throw(occ, arm), 0.012)
    basis = skfem.Basis(mesh, skfem.ElementTetP2())
    volume = moments_of_drawing(lambda occ: draw_half_throw(occ, arm))[0]
    _, weights = basis.quadrature
    assert (basis.dx / weights > 0).all()  # no element is turned inside out
    assert basis.dx.sum() == pytest.approx(volume, rel=2e-3)
    assert [mesh.p[2].min(), mesh.p[2].max()] == pytest.approx([-0.0155, 0.034], abs=1e-9)
