"""Drawings against positions worked out apart: circles and lines, read back out of the SVG.

Engines without symmetry: on a V12 a flipped offset or a reversed rotation would show nothing.
"""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET
from fractions import Fraction

import numpy as np
import pytest

import symbalance as sb
from symbalance import draw
from tests.placed import direction, heights

ENGINES = ["vw-vr6", "kharkiv-v2", "r-985", "honda-nt650", "v8-90", "boxer-4", "inline-3"]
SVG = "{http://www.w3.org/2000/svg}"


def parts(engine: sb.Engine, theta: float) -> dict[str, tuple[complex, float]]:
    """Return where each part of the section stands in the SVG, up + i right, pixels, and its turn."""
    root = ET.fromstring(draw.to_svg(draw.section(engine, theta), standalone=True))
    places = {}
    for group in root.iter(f"{SVG}g"):
        name, transform = group.get("data-part"), group.get("transform", "")
        if name is None:
            continue
        place, turn = transform.removeprefix("translate(").split(") rotate(")
        x, y = map(float, place.split())
        places[name] = (complex(-y, x), float(turn.rstrip(")")))
    return places


def pin(engine: sb.Engine, cylinder: sb.Cylinder, theta: float) -> complex:
    throw = (cylinder.master or cylinder).throw
    return np.exp(1j * theta) * direction(throw)


def scale_of(engine: sb.Engine, places: dict[str, tuple[complex, float]], theta: float) -> float:
    """Return pixels to the length of one: from the first piston's height alone."""
    first = engine.first
    height = heights(engine, first, np.array([theta]))[0]
    offset = float(first.offset or 0)
    return abs(places[f"piston-{first.number}"][0]) / math.hypot(height, offset)


@pytest.mark.parametrize("name", [n for n in ENGINES if sb.load(n).first.stroke])
@pytest.mark.parametrize("degrees", [10, 137, 251])
def test_pistons_stand_where_rods_of_their_length_meet_their_axes(name: str, degrees: int) -> None:
    engine, theta = sb.load(name), math.radians(degrees)
    places = parts(engine, degrees)
    scale = scale_of(engine, places, theta)
    for cylinder in engine.cylinders:
        height = heights(engine, cylinder, np.array([theta]))[0]
        axis = direction(cylinder.bank)
        expected = scale * complex(height, float(cylinder.offset or 0)) * axis
        place, turn = places[f"piston-{cylinder.number}"]
        assert abs(place - expected) < 2e-5, cylinder
        assert abs(np.exp(1j * math.radians(turn)) - axis) < 1e-6
        rod_place, rod_turn = places[f"rod-{cylinder.number}"]
        length = scale * float(cylinder.sizes.rod or 0)
        assert abs(rod_place + length * np.exp(1j * math.radians(rod_turn)) - place) < 2e-4
        if cylinder.link is None:
            radius = float(cylinder.radius or 0) * scale
            assert abs(rod_place - radius * pin(engine, cylinder, theta)) < 2e-5


def test_a_pin_goes_right_after_the_top() -> None:
    places = parts(sb.load("inline-3"), 10)
    place, _ = places["rod-1"]
    assert place.imag > 0
    assert place.real > 0
    assert places["crank"][1] == 10


@pytest.mark.parametrize("name", ["kharkiv-v2", pytest.param("r-985", marks=pytest.mark.slow)])
def test_a_link_pin_stays_on_its_master_rod(name: str) -> None:
    engine = sb.load(name)
    linked = [c for c in engine.cylinders if c.link is not None and c.link.radius]
    for cylinder in linked:
        arms = []
        assert cylinder.link is not None
        for degrees in (0, 50, 170, 290):
            places = parts(engine, degrees)
            crank = places[f"rod-{cylinder.link.master}"]
            arm = (places[f"rod-{cylinder.number}"][0] - crank[0]) / np.exp(1j * math.radians(crank[1]))
            arms.append(arm)
        assert np.ptp(np.real(arms)) < 1e-4
        assert np.ptp(np.imag(arms)) < 1e-4


@pytest.mark.parametrize("name", ["v8-90", "inline-5", "kharkiv-v2", "boxer-4"])
@pytest.mark.parametrize("order", [1, 2, 3])
def test_a_star_leaves_the_sum_of_its_arrows(name: str, order: int) -> None:
    from symbalance.drawing.crank_star import star_resultant

    engine = sb.load(name)
    for _, cylinders in engine.grouped(lambda c: c.bank).items():
        exact = star_resultant(cylinders, Fraction(order))
        angles = [2 * math.pi * order * float(c.throw.turns - c.bank.turns) for c in cylinders]
        total = sum(complex(math.cos(a), math.sin(a)) for a in angles)
        assert abs(complex(exact.evaluated(20)) - total) < 1e-12
        assert exact.is_zero() == (abs(total) < 1e-9)


def test_a_half_order_s_star_counts_from_the_firing_dead_centres() -> None:
    from symbalance.drawing.crank_star import star_resultant

    for name, order in (("v8-90", 0.5), ("buick-231", 2.5), ("honda-nt650", 1.5), ("honda-nt650", 0.5)):
        engine = sb.load(name)
        total = sum(np.exp(-1j * math.radians(order * float(c.fires or 0))) for c in engine.cylinders)
        exact = star_resultant(engine.cylinders, Fraction(order))
        assert abs(complex(exact.evaluated(20)) - total) < 1e-12
    assert abs(total.imag) > 0.1  # not one that its mirror image would leave too


@pytest.mark.parametrize("name", ["v8-90", "honda-nt650", "inline-5", "r-985"])
def test_firing_intervals_fill_the_cycle_in_firing_order(name: str) -> None:
    from symbalance.drawing.firing_diagram import firing_intervals

    engine = sb.load(name)
    rows = firing_intervals(engine)
    assert [n for n, _, _ in rows] == engine.firing_order()
    assert abs(sum(float(step) for _, _, step in rows) - 180 * engine.strokes) < 1e-4


@pytest.mark.parametrize("of", ["force.vertical", "force.lateral", "couple.vertical", "couple.lateral"])
@pytest.mark.parametrize("name", ["kharkiv-v2", "vw-vr6", "v8-90"])
def test_curves_are_those_of_the_fast_functions(name: str, of: str) -> None:
    from symbalance.forces.pictures import component_over_a_turn

    result = sb.balance(sb.load(name))
    values = component_over_a_turn(result, of)
    function = sb.to_function(result, outputs=(of,))
    theta = np.radians(np.linspace(0, 360, len(values)))
    expected = np.asarray(function(theta)) * np.ones(len(values))
    assert np.abs(np.array(values) - expected).max() < 1e-9


@pytest.mark.parametrize("name", ["vw-vr6", "r-985", "v8-90"])
def test_tikz_puts_every_part_where_the_svg_has_it(name: str) -> None:
    drawing = draw.section(sb.load(name), 35)
    svg, tikz = draw.to_svg(drawing), draw.to_tikz(drawing)
    number = r"(-?[\d.]+)"
    placed = [
        (float(x), -float(y), float(turn))
        for x, y, turn in re.findall(rf"translate\({number} {number}\) rotate\({number}\)", svg)
    ]
    scopes = []
    for options in re.findall(r"\\begin\{scope\}\[(.*)\]", tikz):
        shift = re.search(rf"shift=\{{\({number},{number}\)\}}", options)
        turned = re.search(rf"rotate={number}", options)
        place = tuple(map(float, shift.groups())) if shift else (0.0, 0.0)
        scopes.append((*place, -float(turned[1]) if turned else 0.0))
    # A group that neither stands elsewhere nor is turned has no scope in TikZ.
    moved = [each for each in placed if each != (0.0, 0.0, 0.0)]
    kept = [each for each in scopes if each != (0.0, 0.0, 0.0)]
    assert len(moved) == len(kept) > 5
    assert np.array(kept) == pytest.approx(np.array(moved), abs=1e-3)
    assert len({turn for *_, turn in kept}) > 2
