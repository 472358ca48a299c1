"""Pages opened from disk by a browser: they show the library's numbers, and ask for nothing.

Chromium is driven by Playwright; both are rare on a machine, and so is axe-core, which npm fetches.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import symbalance as sb
from tests.browser.opened import OUTPUTS, Opened
from tests.placed import direction, heights

pytestmark = pytest.mark.rare
PRESETS = ["inline-3", "inline-5", "v8-90", "v12-60", "boxer-4", "vw-vr6", "kharkiv-v2", "honda-nt650"]
PRESETS += ["r-985", "r-1820", "bugatti-w16", "vq30de"]


@pytest.mark.parametrize("name", PRESETS)
def test_numbers_are_the_library_s_and_nothing_is_said_or_asked_for(
    name: str, browser: Any, tmp_path: Path
) -> None:
    engine = sb.load(name)
    opened = Opened(browser, tmp_path, engine)
    functions = {of: sb.to_function(sb.balance(engine), outputs=(of,), tolerance=0.0) for of in OUTPUTS}
    for degrees in range(0, 360, 45):
        values = opened.show(theta=degrees)
        expected = [float(f(math.radians(degrees))) for f in functions.values()]
        assert values == pytest.approx(expected, abs=1e-12)
    assert "agree" in opened.page.inner_text("#check")
    assert opened.messages == []
    assert [url for url in opened.requests if not url.startswith("file:")] == []


@pytest.mark.parametrize("name", ["v8-90", "vq30de", "inline-3"])
def test_the_slider_of_the_rod_ratio_shows_the_engine_of_that_ratio(
    name: str, browser: Any, tmp_path: Path
) -> None:
    engine = sb.load(name)
    opened = Opened(browser, tmp_path, engine)
    other = sb.balance(engine.with_ratio("3.3"))
    functions = [sb.to_function(other, outputs=(of,), tolerance=0.0) for of in OUTPUTS]
    for degrees in (0, 33, 170, 251):
        expected = [float(f(math.radians(degrees))) for f in functions]
        assert opened.show(theta=degrees, **{"lambda": 3.3}) == pytest.approx(expected, abs=1e-9)
    assert "numeric" in opened.page.inner_text("#now")


@pytest.mark.parametrize("reading", ["crank", "firing"])
def test_the_slider_of_the_bank_angle_shows_the_engine_of_that_angle(
    reading: str, browser: Any, tmp_path: Path
) -> None:
    engine = sb.load("v8-90")
    opened = Opened(browser, tmp_path, engine)
    cylinders = []
    for c in engine.cylinders:
        shift = -7.5 if c.bank.turns > 0 else 7.5
        bank = float(c.bank.in_degrees()) + shift
        throw = float(c.throw.in_degrees()) + (shift if reading == "firing" else 0)
        cylinders.append(sb.Cylinder(c.number, str(throw), str(bank), c.station))
    other = sb.balance(sb.Engine(cylinders).with_ratio(engine.ratio))
    functions = [sb.to_function(other, outputs=(of,), tolerance=0.0) for of in OUTPUTS]
    for degrees in (0, 33, 170, 251):
        expected = [float(f(math.radians(degrees))) for f in functions]
        assert opened.show(theta=degrees, bank=75, reading=reading) == pytest.approx(expected, abs=1e-9)


def test_counterweights_of_half_the_mass_end_what_turns_with_the_crank(
    browser: Any, tmp_path: Path
) -> None:
    opened = Opened(browser, tmp_path, sb.load("v8-90"))
    for degrees in (0, 20, 200):
        # All of a cross-plane V8's first-order couple is that, and it has no other couple.
        assert max(map(abs, opened.show(theta=degrees, share=0.5)[2:4])) < 1e-9
    assert max(map(abs, opened.show(theta=20, share=0)[2:4])) > 1


@pytest.mark.parametrize("name", ["vw-vr6", "kharkiv-v2", "r-985", "r-1820"])
def test_positions_on_asymmetric_engines(name: str, browser: Any, tmp_path: Path) -> None:
    engine = sb.load(name)
    opened = Opened(browser, tmp_path, engine)
    for degrees in (10, 137, 251):
        opened.show(theta=degrees)
        theta = math.radians(degrees)
        first = engine.first
        place, _ = opened.transform("section", f"piston-{first.number}")
        scale = abs(place) / math.hypot(
            heights(engine, first, np.array([theta]))[0], float(first.offset or 0)
        )
        for cylinder in engine.cylinders:
            height = heights(engine, cylinder, np.array([theta]))[0]
            at, _ = opened.transform("section", f"piston-{cylinder.number}")
            expected = scale * complex(height, float(cylinder.offset or 0)) * direction(cylinder.bank)
            assert abs(at - expected) < 1e-4
            rod, turn = opened.transform("section", f"rod-{cylinder.number}")
            length = scale * float(cylinder.sizes.rod or 0)
            assert abs(rod + length * np.exp(1j * math.radians(turn)) - at) < 1e-3
    opened.show(theta=10)
    assert opened.transform("section", "crank")[1] == pytest.approx(10)


def test_a_false_length_raises_the_banner(browser: Any, tmp_path: Path) -> None:
    engine = sb.load("v8-90")
    opened = Opened(browser, tmp_path, engine)
    text = (tmp_path / "page.html").read_text(encoding="utf-8")
    length = f'"length":{float(engine.ratio or 0)}'
    assert length in text
    (tmp_path / "page.html").write_text(text.replace(length, '"length":4.001', 1), encoding="utf-8")
    opened.page.reload()
    assert opened.page.get_attribute("#check", "class") == "bad"
    assert "do not rely" in opened.page.inner_text("#check")
    assert opened.page.is_hidden("#controls")


def test_without_scripts_drawings_tables_and_formulas_stand(browser: Any, tmp_path: Path) -> None:
    context = browser.new_context(java_script_enabled=False)
    file = tmp_path / "page.html"
    file.write_text(sb.page(sb.load("v8-90")).html, encoding="utf-8")
    page = context.new_page()
    page.goto(file.as_uri())
    assert page.is_visible("#section svg")
    assert page.is_visible("#star svg")
    assert page.locator("math").count() > 5
    assert page.is_hidden("#controls")
    context.close()


def test_a_link_reproduces_the_state(browser: Any, tmp_path: Path) -> None:
    opened = Opened(
        browser, tmp_path, sb.load("v8-90"), hash="#theta=33&lambda=3.3&bank=75&nonsense=1&order=999"
    )
    state = opened.page.evaluate("symbalance.state")
    assert (state["theta"], state["lambda"], state["bank"], state["order"]) == (33, 3.3, 75, 1)
    opened.page.fill("#theta", "50")
    assert "theta=50" in opened.page.url


def test_motion_stops_for_those_who_want_none(browser: Any, tmp_path: Path) -> None:
    still = Opened(browser, tmp_path, sb.load("inline-3"), hash="")
    assert still.page.get_attribute("#run", "aria-pressed") == "false"
    moving = Opened(browser, tmp_path, sb.load("inline-3"), hash="", reduced_motion="no-preference")
    assert moving.page.get_attribute("#run", "aria-pressed") == "true"


def test_a_frame_is_fast(browser: Any, tmp_path: Path) -> None:
    """A count, not a time: no more than a few elements are touched in a frame, and none is made."""
    opened = Opened(browser, tmp_path, sb.load("v12-60"))
    made = opened.page.evaluate(
        """() => { let made = 0; const own = document.createElementNS.bind(document);
        document.createElementNS = (...a) => { made++; return own(...a); };
        const input = document.getElementById("theta"); input.value = "77";
        input.dispatchEvent(new Event("input")); return made; }"""
    )
    # The oblique view alone is drawn anew.
    assert made < 120


@pytest.mark.parametrize("name", ["v8-90", "vw-vr6", "inline-5", "kharkiv-v2"])
def test_the_star_follows_the_order(name: str, browser: Any, tmp_path: Path) -> None:
    engine = sb.load(name)
    opened = Opened(browser, tmp_path, engine)
    banks = list(engine.grouped(lambda c: c.bank).values())
    for order in (1, 2):
        opened.show(order=order)
        verdicts = opened.page.eval_on_selector_all(
            "#star [data-verdict]", "all => all.map((one) => one.textContent)"
        )
        for verdict, group in zip(verdicts, banks, strict=True):
            left = abs(sum(np.exp(2j * np.pi * order * float(c.delay.turns)) for c in group))
            if left < 1e-9:
                assert verdict == "closes: 0, proved"
            else:
                assert float(verdict.split()[1]) == pytest.approx(left, rel=1e-3)


def test_the_star_follows_the_bank_angle(browser: Any, tmp_path: Path) -> None:
    opened = Opened(browser, tmp_path, sb.load("v8-90"))
    points = """() => Array.from(document.querySelectorAll("#star polygon.ink"), (p) => {
        const [x, y] = p.getAttribute("points").split(" ")[0].split(",").map(Number);
        return Math.atan2(x, -y); })"""
    before = np.exp(1j * np.array(opened.page.evaluate(points)))
    opened.show(bank=75, reading="firing")
    assert np.exp(1j * np.array(opened.page.evaluate(points))) == pytest.approx(before, abs=1e-4)
    opened.show(bank=75, reading="crank")
    after = np.exp(1j * np.array(opened.page.evaluate(points)))
    turned = np.degrees(np.angle(after / before))
    # Each axis goes 7.5 degrees towards the middle, so arrows turn as much against it.
    assert sorted(turned.round(2)) == [-7.5] * 4 + [7.5] * 4


def test_the_slider_of_the_weights_takes_them_away(browser: Any, tmp_path: Path) -> None:
    from dataclasses import replace

    from symbalance.engine.balance_masses import Balancers

    engine = sb.load("two-stroke-37")
    opened = Opened(browser, tmp_path, engine)
    bare = sb.balance(replace(engine, balancers=Balancers()))
    functions = [sb.to_function(bare, outputs=(of,), tolerance=0.0) for of in OUTPUTS]
    for degrees in (0, 33, 251):
        expected = [float(f(math.radians(degrees))) for f in functions]
        assert opened.show(theta=degrees, weights=0) == pytest.approx(expected, abs=1e-9)
        assert opened.show(theta=degrees, weights=1) != pytest.approx(expected, abs=1e-3)
