"""What a page's script draws stands where the library, or plain geometry, has it: read from the SVG."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import symbalance as sb
from symbalance.engine.dead_centres import firing_dead_centres
from tests.browser.opened import Opened, values_of
from tests.placed import direction, heights

pytestmark = pytest.mark.rare
ASYMMETRIC = ["vw-vr6", "kharkiv-v2", "honda-nt650", "r-985"]


def attributes(opened: Opened, selector: str, *names: str) -> list[list[float]]:
    rows = opened.page.eval_on_selector_all(
        selector, "(all, names) => all.map((n) => names.map((name) => n.getAttribute(name)))", list(names)
    )
    return [[float(x) for x in row] for row in rows]


def piston(engine: sb.Engine, cylinder: sb.Cylinder, theta: float) -> complex:
    """Return where a piston pin stands, up + i right, in mm or in crank radii."""
    if cylinder.sizes.stroke is None and cylinder.link is None:
        pin = np.exp(1j * theta) * direction(cylinder.throw) / direction(cylinder.bank)
        ratio = float(cylinder.ratio or 0)
        return (pin.real + math.sqrt(ratio**2 - pin.imag**2)) * direction(cylinder.bank)
    height = heights(engine, cylinder, np.array([theta]))[0]
    return complex(height, float(cylinder.offset or 0)) * direction(cylinder.bank)


@pytest.mark.parametrize("name", ["vw-vr6", "kharkiv-v2", "v8-90", "inline-5", "bugatti-w16"])
def test_the_plan_has_every_piston_at_its_station(name: str, browser: Any, tmp_path: Path) -> None:
    engine = sb.load(name)
    opened = Opened(browser, tmp_path, engine)
    opened.show(theta=10)
    places = {}
    for cylinder in engine.cylinders:
        text = opened.page.get_attribute(f'#plan [data-part="piston-{cylinder.number}"]', "transform")
        x, y = map(float, re.findall(r"-?[\d.]+(?:e-?\d+)?", text))
        places[cylinder.number] = (x, -y)
    one, other = engine.cylinders[0], engine.cylinders[-1]
    per_pitch = (places[other.number][0] - places[one.number][0]) / float(one.station - other.station)
    assert per_pitch > 0  # the front is to the left
    sides = {c.number: piston(engine, c, math.radians(10)).imag for c in engine.cylinders}
    scale = max(y for _, y in places.values()) / (max(sides.values()) or 1)
    for cylinder in engine.cylinders:
        x, y = places[cylinder.number]
        assert x == pytest.approx(
            places[one.number][0] + per_pitch * float(one.station - cylinder.station), abs=0.01
        )
        if max(map(abs, sides.values())) > 1e-9:
            assert y == pytest.approx(scale * sides[cylinder.number], abs=0.02)


@pytest.mark.parametrize("name", ASYMMETRIC)
def test_the_oblique_view_from_the_front_is_the_section(name: str, browser: Any, tmp_path: Path) -> None:
    engine = sb.load(name)
    opened = Opened(browser, tmp_path, engine)
    opened.page.evaluate("symbalance.view.turn = 0; symbalance.view.tilt = 0")
    opened.show(theta=10)
    rods = attributes_of_points(opened, "#oblique polyline.rod")
    ends = [complex(-y, x) for points in rods for x, y in points[1:]]
    pistons = [piston(engine, c, math.radians(10)) for c in engine.cylinders]
    # All but where its middle is, and its scale, from two of them.
    spans = sorted(abs(a - b) for a in pistons for b in pistons)
    scale = max(abs(a - b) for a in ends for b in ends) / spans[-1]
    for shown in (ends,):
        middle = sum(shown) / len(shown) - scale * sum(pistons) / len(pistons)
        for place in pistons:
            assert min(abs(scale * place + middle - each) for each in shown) < 0.3


def attributes_of_points(opened: Opened, selector: str) -> list[list[tuple[float, float]]]:
    rows = opened.page.eval_on_selector_all(selector, "all => all.map((n) => n.getAttribute('points'))")
    return [[tuple(map(float, p.split(","))) for p in row.split()] for row in rows]  # type: ignore[misc]


def test_the_oblique_view_from_the_side_has_the_stations_in_order(browser: Any, tmp_path: Path) -> None:
    engine = sb.load("inline-5")
    opened = Opened(browser, tmp_path, engine)
    # Turned by a quarter the front is to the right, as the engine's right side goes away.
    opened.page.evaluate("symbalance.view.turn = Math.PI/2; symbalance.view.tilt = 0")
    opened.show(theta=10)
    labels = dict(
        opened.page.eval_on_selector_all(
            "#oblique text", "all => all.map((n) => [n.textContent, Number(n.getAttribute('x'))])"
        )
    )
    ordered = sorted(engine.cylinders, key=lambda c: c.station)
    assert sorted(labels, key=lambda n: labels[n]) == [str(c.number) for c in ordered]


@pytest.mark.parametrize("name", ASYMMETRIC)
def test_the_hand_of_the_path_is_the_force(name: str, browser: Any, tmp_path: Path) -> None:
    engine = sb.load(name)
    opened = Opened(browser, tmp_path, engine)
    theta = np.radians(range(360))
    turn = np.array([complex(*values_of(engine, t)[:2]) for t in theta[::20]])
    for degrees in (20, 100, 260):
        opened.show(theta=degrees)
        ((x, y),) = attributes(opened, "#path circle", "cx", "cy")
        up, right = values_of(engine, math.radians(degrees))[:2]
        shown, expected = complex(-y, x), complex(up, right)
        assert abs(shown / abs(shown) - expected / abs(expected)) < 1e-6
        (way,) = attributes_of_points(opened, "#path polygon.force")
        assert min(abs(complex(-v, u) - shown) for u, v in way) < 3
        # 170 pixels are the largest of the turn.
        assert abs(shown) / 170 <= 1.0001
        assert abs(expected) / abs(shown) * 170 >= max(abs(turn)) * 0.999


@pytest.mark.parametrize("name", ["vw-vr6", "kharkiv-v2", "inline-3", "r-985"])
def test_charts_have_the_library_s_extremes(name: str, browser: Any, tmp_path: Path) -> None:
    engine = sb.load(name)
    opened = Opened(browser, tmp_path, engine)
    values = np.array([values_of(engine, math.radians(t)) for t in range(0, 360, 3)])
    for figure, columns in (("forces", (0, 1)), ("couples", (2, 3)), ("torque", (4,))):
        if opened.page.locator(f"#{figure}").count() == 0:
            continue
        said = opened.page.text_content(f"#{figure} desc").replace("−", "-")
        rows = said.split(";")
        for row, column in zip(rows, columns, strict=True):
            low, high = map(float, re.findall(r"(-?[\d.e-]+) … (-?[\d.e-]+)", row)[0])
            size = max(abs(values[:, column])) or 1
            assert low == pytest.approx(values[:, column].min(), abs=0.01 * size)
            assert high == pytest.approx(values[:, column].max(), abs=0.01 * size)


@pytest.mark.parametrize("name", ["v8-90", "honda-nt650", "vw-vr6", "boxer-4", "r-985"])
def test_strokes_begin_at_the_dead_centres(name: str, browser: Any, tmp_path: Path) -> None:
    engine = sb.load(name)
    opened = Opened(browser, tmp_path, engine)
    opened.show(share=0.1)  # what is not the engine's own the script draws
    tops = firing_dead_centres(engine)
    ordered = sorted(tops, key=lambda n: tops[n])
    starts = {"solid": 0, "open": 180, "faint": 360, "shade": 540}
    # Of each row: where a stroke's box begins, or at 0 its rest.
    for look, after in starts.items():
        boxes = attributes(opened, f"#firing rect.{look}", "x", "y", "width")
        for place, number in enumerate(ordered):
            begin = (float(tops[number]) + after) % 720
            row = [
                ((x - 44) / 560 * 720, w / 560 * 720)
                for x, y, w in boxes
                if abs(y + 7.68 - 24 * (place + 1)) < 1
            ]
            assert any(abs(at - begin) < 0.01 for at, _ in row)
            assert sum(wide for _, wide in row) == pytest.approx(180, abs=0.01)
    numbers = opened.page.eval_on_selector_all(
        '#firing text[font-weight="bold"]', "all => all.map((n) => Number(n.textContent))"
    )
    assert numbers == ordered


@pytest.mark.parametrize("name", ["vw-vr6", "kharkiv-v2", "v8-90"])
def test_the_sum_of_the_directions_is_the_order_s_force(name: str, browser: Any, tmp_path: Path) -> None:
    engine = sb.load(name)
    opened = Opened(browser, tmp_path, engine)
    result = sb.balance(engine)
    for order in [n for n in result.force.orders() if n <= 6]:
        theta = math.radians(25)
        opened.show(order=order, theta=25)
        parts = [result.force.component(order, of).decimal(20) for of in ("vertical", "lateral")]
        share = float(result.share(order))
        up, right = (
            share * (float(c) * math.cos(order * theta) + float(s) * math.sin(order * theta))
            for c, s in parts
        )
        points = attributes_of_points(opened, "#banks polygon.head.force")
        if abs(complex(up, right)) < 1e-6:
            continue
        x, y = points[0][0]
        shown, expected = complex(-y, x), complex(up, right)
        assert abs(shown / abs(shown) - expected / abs(expected)) < 1e-3


@pytest.mark.parametrize("name", ["r-985", "kharkiv-v2"])
def test_knuckle_pins_go_round_with_the_rods_that_hang_on_them(
    name: str, browser: Any, tmp_path: Path
) -> None:
    engine = sb.load(name)
    opened = Opened(browser, tmp_path, engine)
    ways = attributes_of_points(opened, "#section polygon.knuckle")
    linked = [c for c in engine.cylinders if c.link]
    assert len(ways) == len(linked)
    for degrees in (0, 90, 215):
        opened.show(theta=degrees)
        for way, cylinder in zip(ways, linked, strict=True):
            place, _ = opened.transform("section", f"rod-{cylinder.number}")
            assert min(abs(complex(-y, x) - place) for x, y in way) < 3


def test_the_cursor_stands_at_the_angle(browser: Any, tmp_path: Path) -> None:
    opened = Opened(browser, tmp_path, sb.load("v8-90"))
    for degrees in (0, 90, 500):
        opened.show(theta=degrees)
        text = opened.page.get_attribute('#firing [data-part="cursor"]', "transform")
        assert float(re.findall(r"-?[\d.]+", text)[0]) == pytest.approx(560 * degrees / 720, abs=1e-3)


def test_without_scripts_no_empty_figure_stands(browser: Any, tmp_path: Path) -> None:
    context = browser.new_context(java_script_enabled=False)
    for name in ("v8-90", "r-1820"):
        file = tmp_path / f"{name}.html"
        file.write_text(sb.page(sb.load(name)).html, encoding="utf-8")
        page = context.new_page()
        page.goto(file.as_uri())
        shown = page.eval_on_selector_all(
            "figure",
            """all => all.filter((f) => f.offsetHeight)
            .map((f) => [f.id, f.querySelectorAll("svg *").length])""",
        )
        assert {"section", "forces", "orders", "firing"} <= {figure for figure, _ in shown}
        assert all(count > 10 for _, count in shown)
        assert page.is_hidden("#edit")
    context.close()
