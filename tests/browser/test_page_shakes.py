"""Stars, phasors, orders, dead centres and firing on a page are the library's, or a quadrature's."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import symbalance as sb
from symbalance.engine.balance_masses import Balancers
from symbalance.engine.dead_centres import firing_dead_centres
from symbalance.kinematics.mechanisms import dead_centres
from tests.browser.opened import Opened
from tests.placed import direction, heights

pytestmark = pytest.mark.rare
TIPS = """() => Array.from(document.querySelectorAll("#star svg > g > g"), (star) =>
    Array.from(star.querySelectorAll("polygon.ink"), (p) =>
        p.getAttribute("points").split(" ")[0].split(",").map((x) => Number(x)/78)))"""
NUMBER = r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?"


def numbers(text: str) -> list[float]:
    return [float(x) for x in re.findall(NUMBER, text.replace("−", "-"))]


def along_axes(engine: sb.Engine, order: int) -> dict[int, complex]:
    """Return c of each cylinder's force c e^(i n theta) + conjugate along its axis, by the FFT of y."""
    theta = 2 * np.pi * np.arange(256) / 256
    found = {}
    for cylinder in engine.cylinders:
        y = np.fft.fft(heights(engine, cylinder, theta))[order] / 256
        found[cylinder.number] = complex(order * order * y)
    return found


@pytest.mark.parametrize("name", ["r-985", "r-1820", "kharkiv-v2", "napier-lion"])
@pytest.mark.parametrize("order", [1, 2])
def test_unlike_stars_are_to_scale(name: str, order: int, browser: Any, tmp_path: Path) -> None:
    engine = sb.load(name)
    opened = Opened(browser, tmp_path, engine)
    opened.show(order=order)
    amplitudes = along_axes(engine, order)
    most = max(map(abs, amplitudes.values()))
    for star, way in zip(opened.page.evaluate(TIPS), (1, -1), strict=True):
        drawn = {complex(round(-y, 3), round(x, 3)) for x, y in star}
        for cylinder in engine.cylinders:
            c = amplitudes[cylinder.number] / most
            arrow = (c if way > 0 else c.conjugate()) * direction(cylinder.bank)
            assert min(abs(arrow - each) for each in drawn) < 3e-3


@pytest.mark.parametrize("name", ["v8-90", "inline-5", "vw-vr6", "r-985", "v2-90", "honda-nt650"])
def test_half_orders_are_those_of_the_firing(name: str, browser: Any, tmp_path: Path) -> None:
    engine = sb.load(name)
    opened = Opened(browser, tmp_path, engine)
    for order in (0.5, 1.5, 2.5):
        opened.show(order=order)
        verdict = opened.page.text_content("#star [data-verdict]")
        left = abs(sum(np.exp(-2j * np.pi * order * float(c.fires or 0) / 360) for c in engine.cylinders))
        if left < 1e-9:
            assert verdict == "closes: 0, proved"
        else:
            assert numbers(verdict)[0] == pytest.approx(left, rel=1e-3)
        (star,) = opened.page.evaluate(TIPS)
        drawn = [complex(-y, x) for x, y in star]
        for c in engine.cylinders:
            arrow = np.exp(-2j * np.pi * order * float(c.fires or 0) / 360)
            assert min(abs(arrow - each) for each in drawn) < 1e-3
        assert "no half orders" in opened.page.text_content("#phasors, #couple-phasors")


@pytest.mark.parametrize("name", ["vw-vr6", "r-985", "kharkiv-v2", "bugatti-w16"])
def test_dead_centres_and_strokes_are_the_mechanisms(name: str, browser: Any, tmp_path: Path) -> None:
    engine = sb.load(name)
    opened = Opened(browser, tmp_path, engine)
    radius = float(engine.first.radius or 1)
    for cylinder in engine.cylinders[:4]:
        opened.show(cylinder=cylinder.number)
        ends = dead_centres(cylinder.known_mechanism, 20)
        turned = -360 * float(cylinder.delay.turns)
        stroke, top, bottom = numbers(opened.page.inner_text("#piston .note"))[:3]
        own = float(cylinder.radius or radius)
        assert stroke == pytest.approx(float(ends.stroke) * own, rel=1e-5)
        for shown, angle in ((top, ends.top), (bottom, ends.bottom)):
            off = (shown - math.degrees(float(angle)) - turned) % 360
            assert min(off, 360 - off) < 0.051


@pytest.mark.parametrize("name", ["inline-3", "v8-90", "vw-vr6", "r-1820", "kharkiv-v2", "boxer-4"])
def test_turning_parts_are_the_library_s(name: str, browser: Any, tmp_path: Path) -> None:
    engine = sb.load(name)
    result = sb.balance(engine)
    opened = Opened(browser, tmp_path, engine)
    for figure, of in (("phasors", "force"), ("couple-phasors", "couple")):
        spectrum = getattr(result, of)
        for order in (1, 2):
            opened.show(order=order)
            note = opened.page.locator(f"#{figure} .note")
            if note.count() == 0:
                assert not spectrum.orders()
                continue
            if order not in spectrum.orders():
                assert note.inner_text() == "cancels, proved"
                continue
            share = abs(float(result.share(order)))
            parts = [spectrum.component(order, way).decimal(20) for way in ("forward", "backward")]
            expected = [share * math.hypot(float(c), float(s)) for c, s in parts]
            assert numbers(note.inner_text())[:2] == pytest.approx(expected, rel=1e-3, abs=1e-9)


@pytest.mark.parametrize("name", ["inline-3", "vw-vr6", "r-985"])
def test_shafts_of_an_order_end_what_they_turn_with(name: str, browser: Any, tmp_path: Path) -> None:
    opened = Opened(browser, tmp_path, sb.load(name))
    figure = "phasors" if opened.page.locator("#couple-phasors").count() == 0 else "couple-phasors"
    opened.show(order=1)
    forward, backward = numbers(opened.page.inner_text(f"#{figure} .note"))[:2]
    opened.show(order=1, ahead=1)
    words = opened.page.inner_text(f"#{figure} .note")
    if backward > 1e-9:
        assert numbers(words)[:2] == pytest.approx([0, backward], abs=1e-9)
    opened.show(order=1, ahead=0.5, back=0.25)
    assert numbers(opened.page.inner_text(f"#{figure} .note"))[:2] == pytest.approx(
        [forward / 2, 0.75 * backward], rel=1e-3, abs=1e-9
    )
    opened.show(order=1, ahead=1, back=1)
    words = opened.page.inner_text(f"#{figure} .note")
    assert words.startswith("cancels to rounding")
    assert numbers(words)[-2:] == pytest.approx([forward, backward], rel=1e-3, abs=1e-9)


def test_own_weights_are_shown_with_what_they_take_away(browser: Any, tmp_path: Path) -> None:
    engine = sb.load("two-stroke-37")
    bare = sb.balance(replace(engine, balancers=Balancers()))
    opened = Opened(browser, tmp_path, engine)
    opened.show(order=1)
    words = opened.page.inner_text("#phasors .note")
    assert "without weights" in words
    part = bare.force.component(1, "forward").decimal(20)
    assert numbers(words)[2] == pytest.approx(math.hypot(*map(float, part)), rel=1e-3)


@pytest.mark.parametrize("name", ["v8-90", "inline-1", "inline-5", "r-1820"])
def test_bars_are_the_library_s(name: str, browser: Any, tmp_path: Path) -> None:
    result = sb.balance(sb.load(name))
    opened = Opened(browser, tmp_path, result.engine)
    said = dict(re.findall(r"(\w+ \d+): ([^;]+)", opened.page.text_content("#orders desc")))
    for of in ("force", "couple"):
        spectrum = getattr(result, of)
        for order in (1, 2, *spectrum.orders()):
            words = said[f"{of} {order}"]
            if order not in spectrum.orders():
                assert words == "cancels, proved"
                continue
            parts = [spectrum.component(order, of_).decimal(20) for of_ in ("vertical", "lateral")]
            most = max(math.hypot(float(c), float(s)) for c, s in parts)
            # What is there, however small, does not cancel.
            size = abs(float(result.share(order))) * most
            assert numbers(words)[0] == pytest.approx(size, rel=1e-3, abs=1e-14)


@pytest.mark.parametrize("reading", ["crank", "firing"])
def test_firing_follows_the_bank_angle(reading: str, browser: Any, tmp_path: Path) -> None:
    engine = sb.load("v6-60")
    opened = Opened(browser, tmp_path, engine)
    opened.show(bank=75, reading=reading)
    cylinders = []
    for c in engine.cylinders:
        shift = 7.5 if c.bank.turns > 0 else -7.5
        bank = float(c.bank.in_degrees()) + shift
        throw = float(c.throw.in_degrees()) + (shift if reading == "firing" else 0)
        first = 7.5 if engine.first.bank.turns > 0 else -7.5
        fires = (float(c.fires or 0) + (shift - first if reading == "crank" else 0)) % 720
        cylinders.append(sb.Cylinder(c.number, str(throw), str(bank), c.station, fires=str(fires)))
    tops = firing_dead_centres(replace(engine, cylinders=tuple(cylinders)))
    order = "-".join(str(n) for n in sorted(tops, key=lambda n: tops[n]))
    said = opened.page.text_content("#firing desc")
    assert said.startswith(order)
    angles = sorted(float(t) for t in tops.values())
    gaps = [b - a for a, b in zip(angles, [*angles[1:], angles[0] + 720], strict=True)]
    assert numbers(said.partition(":")[2]) == pytest.approx(gaps, abs=1e-3)


@pytest.mark.parametrize("name", ["vq30de", "vw-vr6", "kharkiv-v2", "napier-lion"])
def test_each_direction_s_force_is_its_cylinders_(name: str, browser: Any, tmp_path: Path) -> None:
    engine = sb.load(name)
    opened = Opened(browser, tmp_path, engine)
    radius = float(engine.first.radius or 1)
    for order in (1, 2, 3, 6):
        opened.show(order=order, theta=25)
        amplitudes = along_axes(engine, order)
        banks = [
            2 * abs(sum(amplitudes[c.number] for c in group)) / radius
            for group in engine.grouped(lambda c: c.bank).values()
        ]
        words = opened.page.inner_text("#banks .note")
        if max(banks) < 1e-9:
            assert words == "each direction cancels"
            continue
        shown = [numbers(part.rpartition(":")[2])[0] for part in words.split(";")]
        shown *= len(banks) // len(shown)
        assert sorted(shown) == pytest.approx(sorted(banks), rel=1e-3, abs=1e-9)


def test_the_chosen_cylinder_stands_out(browser: Any, tmp_path: Path) -> None:
    opened = Opened(browser, tmp_path, sb.load("v8-90"))
    faded = (
        'n => document.querySelector(`#section [data-part="piston-${n}"]`).classList.contains("faded")'
    )
    assert opened.page.evaluate(faded, 5)
    opened.show(cylinder=5)
    assert not opened.page.evaluate(faded, 5)
    assert opened.page.evaluate(faded, 7)
    assert "piston 5" in opened.page.text_content("#piston desc")
