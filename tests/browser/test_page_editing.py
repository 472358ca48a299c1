"""The engine edited in its page: what is saved is an engine file, and the engine that the page shows."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

import symbalance as sb
from symbalance.cli import run
from tests.browser.opened import Opened, values_of

pytestmark = pytest.mark.rare
V8 = """name = "other"
[crank_train]
ratio = 4
[layout]
banks = [45, -45]
cylinders = [[1, 3, 5, 7], [2, 4, 6, 8]]
firing_order = [1, 5, 4, 8, 6, 3, 7, 2]
stagger = ["1/4", "-1/4"]
"""


def agrees(opened: Opened, engine: sb.Engine, tolerance: float = 1e-9) -> None:
    """Assert that the page's numbers are the library's of an engine, at four angles."""
    for degrees in (0, 33, 170, 251):
        assert opened.show(theta=degrees) == pytest.approx(
            values_of(engine, math.radians(degrees)), abs=tolerance
        )


@pytest.mark.parametrize(
    "name", ["v8-90", "vw-vr6", "honda-nt650", "r-985", "kharkiv-v2", "two-stroke-37", "innio-v16"]
)
def test_what_is_saved_unchanged_is_the_engine(name: str, browser: Any, tmp_path: Path) -> None:
    engine = sb.load(name)
    assert Opened(browser, tmp_path, engine).saved(tmp_path / "saved.toml") == engine


def test_a_firing_order_is_that_of_an_engine_file_with_it(browser: Any, tmp_path: Path) -> None:
    own = sb.load("v8-90")
    opened = Opened(browser, tmp_path, own)
    opened.fill("firing order", "1-5-4-8-6-3-7-2")
    saved = opened.saved(tmp_path / "saved.toml")
    text = V8.replace('stagger = ["1/4", "-1/4"]', f"stations = {stations(own)}")
    (tmp_path / "typed.toml").write_text(text, encoding="utf-8")
    typed = sb.load(str(tmp_path / "typed.toml"))
    assert {c.number: (c.throw, c.bank, c.fires) for c in saved.cylinders} == {
        c.number: (c.throw, c.bank, c.fires) for c in typed.cylinders
    }
    agrees(opened, saved)
    agrees(opened, typed)
    assert "1-5-4-8-6-3-7-2" in opened.page.text_content("#firing desc")
    assert run(["balance", str(tmp_path / "saved.toml"), "-o", str(tmp_path / "out.txt")]) == 0


def stations(engine: sb.Engine) -> list[list[str]]:
    """Return the stations of two banks as an engine file lists them."""
    banks = ([c for c in engine.cylinders if c.number % 2 == odd] for odd in (1, 0))
    return [[str(c.station) for c in sorted(bank, key=lambda c: c.number)] for bank in banks]


def test_uneven_intervals_are_taken(browser: Any, tmp_path: Path) -> None:
    opened = Opened(browser, tmp_path, sb.load("v2-90"))
    opened.fill("firing intervals, degrees: one, or one after each firing", "300 420")
    saved = opened.saved(tmp_path / "saved.toml")
    assert sorted(float(c.fires or 0) for c in saved.cylinders) == [0, 300]
    agrees(opened, saved)
    assert "300°, 420°" in opened.page.text_content("#firing desc")


@pytest.mark.parametrize(
    ("name", "label", "text"),
    [
        ("v8-90", "cylinder 3, pin at", "100"),
        ("v8-90", "cylinder 2, axis at", "-360/7"),
        ("inline-5", "cylinder 1, station", "2.5"),
        ("vw-vr6", "cylinder 4, fires at", "601"),
        ("vw-vr6", "cylinder 6, axis at", "9"),
        ("wartsila-10rta96c", "cylinder 2, fires at", "80"),
    ],
)
def test_a_cylinder_that_is_edited_is_that_of_the_saved_file(
    name: str, label: str, text: str, browser: Any, tmp_path: Path
) -> None:
    own = sb.load(name)
    opened = Opened(browser, tmp_path, own)
    opened.fill(label, text)
    saved = opened.saved(tmp_path / "saved.toml")
    assert saved.cylinders != own.cylinders
    agrees(opened, saved)
    assert "numeric" in opened.page.inner_text("#now")
    assert opened.messages == []
    # A link reproduces it, and the button takes it back.
    again = Opened(browser, tmp_path, own, hash="#" + opened.page.url.partition("#")[2])
    assert again.saved(tmp_path / "again.toml").cylinders == saved.cylinders
    again.page.click("#reset")
    assert again.saved(tmp_path / "own.toml") == own


@pytest.mark.parametrize(
    ("name", "state"),
    [
        ("v8-90", {"lambda": 3.3}),
        ("vq30de", {"lambda": 3.3}),
        ("v8-90", {"bank": 75}),
        ("v8-90", {"bank": 75, "reading": "firing"}),
        ("v8-90", {"share": 0.5}),
        ("vq30de", {"share": 0.25, "bank": 70}),
        ("two-stroke-37", {"share": 0.25}),
        ("two-stroke-37", {"weights": 0}),
    ],
)
def test_what_the_sliders_change_is_saved(
    name: str, state: dict[str, Any], browser: Any, tmp_path: Path
) -> None:
    opened = Opened(browser, tmp_path, sb.load(name))
    opened.show(**state)
    assert opened.page.text_content("#unsaved") == ""
    agrees(opened, opened.saved(tmp_path / "saved.toml"))


def test_what_is_not_saved_is_said(browser: Any, tmp_path: Path) -> None:
    opened = Opened(browser, tmp_path, sb.load("two-stroke-37"))
    opened.show(weights=0.5)
    assert "not saved" in opened.page.text_content("#unsaved")
    opened.show(weights=1, back=0.5)
    assert "not saved" in opened.page.text_content("#unsaved")


@pytest.mark.parametrize(
    ("label", "text", "said"),
    [
        ("firing order", "1-2-3", "each cylinder once: 1, 2, 3, 4, 5, 6, 7, 8"),
        ("firing order", "1-1-4-3-6-5-7-2", "each cylinder once"),
        ("firing order", "1-8-4-3-6-5-7-x", "each cylinder once"),
        (
            "firing intervals, degrees: one, or one after each firing",
            "100",
            "add up to 800; they must be 720",
        ),
        ("firing intervals, degrees: one, or one after each firing", "90 90", "give one, or 8"),
        (
            "firing intervals, degrees: one, or one after each firing",
            "-90",
            "must be a number of degrees",
        ),
        ("cylinder 3, pin at", "abc", "cylinder 3, pin at = abc: must be a number"),
        ("cylinder 3, axis at", "1/0", "must be a number"),
        ("cylinder 3, station", "1e9", "must be a number"),
        ("cylinder 3, station", "12345", "within 1000 pitches"),
        ("cylinder 3, fires at", "720", "from 0 up to 720"),
        ("cylinder 3, fires at", "0.1234567", "too fine"),
        ("cylinder 3, pin at", "", "must be a number"),
        ("cylinder 3, pin at", "<img src=x onerror=alert(1)>", "must be a number"),
    ],
)
def test_what_makes_no_engine_is_said_and_not_taken(
    label: str, text: str, said: str, browser: Any, tmp_path: Path
) -> None:
    own = sb.load("v8-90")
    opened = Opened(browser, tmp_path, own)
    opened.fill(label, text)
    assert said in opened.page.inner_text("#edit-error")
    assert opened.page.get_by_label(label, exact=True).get_attribute("aria-invalid") == "true"
    assert opened.page.is_disabled("#save")
    agrees(opened, own)
    opened.page.click("#reset")
    assert opened.page.inner_text("#edit-error") == ""
    assert opened.saved(tmp_path / "saved.toml") == own
    assert opened.messages == []


@pytest.mark.parametrize(
    "text", ["99_0_0_0_0", "1_x_0_0_0", "1_0_0", "1_0_0_0_720", "", "1_0_0_0_<b>", "_____~~~"]
)
def test_an_address_that_makes_no_engine_is_the_engine_s_own(
    text: str, browser: Any, tmp_path: Path
) -> None:
    own = sb.load("v8-90")
    opened = Opened(browser, tmp_path, own, hash=f"#theta=10&edit={text}")
    assert opened.saved(tmp_path / "saved.toml") == own
    assert opened.messages == []


@pytest.mark.parametrize("name", ["r-985", "kharkiv-v2", "two-stroke-37", "innio-v16"])
def test_link_rods_and_weights_are_not_edited_and_that_is_said(
    name: str, browser: Any, tmp_path: Path
) -> None:
    opened = Opened(browser, tmp_path, sb.load(name))
    opened.page.evaluate("document.getElementById('edit').open = true")
    assert opened.page.locator("#edit input:not([disabled])").count() == 0
    assert "link rods or weights" in opened.page.inner_text("#edit")
