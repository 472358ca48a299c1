"""Requests that cannot be drawn are refused in one line, and write nothing."""

from __future__ import annotations

from pathlib import Path

import pytest
import sympy

import symbalance as sb
from symbalance import draw
from symbalance.cli import run

REFUSED = [
    (["v8-90", "-o", "x.gif"], "must end in .svg, .tex, .png, .pdf"),
    (["v8-90", "--what", "star", "--angle", "3"], "--angle"),
    (["v8-90", "--what", "star", "--order", "1/3"], "order = 1/3"),
    (["v8-90", "--what", "star", "--order", "0"], "order = 0"),
    (["v8-90", "--order", "2"], "--order"),
    (["v8-90", "--angle", "x"], "--angle = x"),
    (["v8-90", "--what", "forces", "--rpm", "6000"], "rpm = 6000"),
    (["v12-60", "--what", "couple-path"], "has no free couple"),
    (["v12-60", "--what", "forces", "--order", "4"], "has no free force and no couple"),
]


@pytest.mark.parametrize(("arguments", "said"), REFUSED)
def test_refused_in_one_line(
    arguments: list[str],
    said: str,
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(["draw", *arguments]) == 2
    streams = capsys.readouterr()
    assert streams.out == ""
    assert said in streams.err
    assert streams.err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_forces_without_a_rod_ratio_are_refused() -> None:
    for drawing in (draw.path, draw.forces, draw.orders):
        with pytest.raises(sb.SymbalanceError, match="no rod ratio"):
            drawing(sb.inline("1-3-4-2"))


def test_symbols_for_angles_are_refused() -> None:
    vee = sb.vee(sympy.Symbol("alpha"), "1-2")
    for drawing in (draw.section, draw.star, draw.orders):
        with pytest.raises(sb.SymbalanceError, match="symbols for angles"):
            drawing(vee)
