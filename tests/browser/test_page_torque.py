"""Torque on a page: gas and the whole torque are the running engine's, and the flywheel too."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

import symbalance as sb
from tests.browser.opened import Opened

pytestmark = pytest.mark.rare


@pytest.mark.parametrize(
    ("name", "sizes"),
    [
        ("vq30de", {}),
        ("r-1820", {"bore": 155.6, "mass": 5}),
        ("szechenyi-single", {"bore": 60}),
    ],
)
def test_gas_torque_and_flywheel_are_the_running_engine_s(
    name: str, sizes: dict[str, Any], browser: Any, tmp_path: Path
) -> None:
    from symbalance.cli.options import engine_of
    from symbalance.cli.parser import build_parser
    from symbalance.cli.torque import running_engine

    words = ["page", name, "--rpm", "2500", "--compression", "9", "--heat", "15"]
    words += [part for key, value in sizes.items() for part in (f"--{key}", str(value))]
    options = build_parser().parse_args(words)
    engine = engine_of(options)
    running = running_engine(options, engine)
    opened = Opened(browser, tmp_path, engine, of={"running": running})
    largest = max(abs(running.gas(math.radians(d))) for d in range(0, 720, 5))
    for degrees in (1, 20, 37, 150, 333, 400, 690):
        theta = math.radians(degrees)
        shown = opened.page.evaluate("t => symbalance.gas(t)", theta)
        assert shown == pytest.approx(running.gas(theta), abs=2e-4 * largest)
    opened.show(theta=20)
    assert opened.page.evaluate("symbalance.now.mean") == pytest.approx(running.mean, rel=2e-3)
    assert opened.page.evaluate("symbalance.now.wheel") == pytest.approx(running.flywheel(), rel=0.01)
    assert "kg m²" in opened.page.inner_text("#torque .note")
    assert opened.messages == []


def test_a_flywheel_is_that_of_the_fluctuation(browser: Any, tmp_path: Path) -> None:
    opened = Opened(browser, tmp_path, sb.load("inline-4"))
    opened.show(delta=0.02)
    one = opened.page.evaluate("symbalance.now.wheel")
    opened.show(delta=0.01)
    assert opened.page.evaluate("symbalance.now.wheel") == pytest.approx(2 * one)
    assert "m r²" in opened.page.inner_text("#torque .note")
