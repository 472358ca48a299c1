"""Requests that cannot be drawn are refused in one line, and write nothing."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import pytest
import sympy

import symbalance as sb
from symbalance import draw
from symbalance.cli import run
from symbalance.document.shapes import Drawing, Label

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


HOSTILE = ["<script>alert(1)</script>", "]]>", r"\input{x}", "../../up", "a & b", "横置き", "n" * 60]


@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_name_is_text_in_every_file_and_none_is_written_elsewhere(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    here = tmp_path / "here"
    here.mkdir()
    monkeypatch.chdir(here)
    (here / "e.toml").write_text(
        f"name = '{name}'\n[crank_train]\nratio = 4\n[layout]\nbanks = [0]\n"
        "cylinders = [[1, 2, 3]]\nfiring_order = [1, 3, 2]\n",
        encoding="utf-8",
    )
    assert run(["draw", "e.toml", "-o", "d.svg"]) == 0
    assert run(["draw", "e.toml", "--what", "firing", "-o", "d.tex"]) == 0
    assert run(["page", "e.toml"]) == 0
    written = {path.name for path in here.iterdir()}
    (page,) = (name for name in written if name.endswith(".html"))
    assert not set(page) & set('<>\\/&"')
    assert {path.name for path in tmp_path.iterdir()} == {"here"}
    root = ElementTree.fromstring((here / "d.svg").read_text(encoding="utf-8"))
    assert name in "".join(root.itertext())
    assert "<script>alert" not in (here / page).read_text(encoding="utf-8")
    assert r"\input{x" not in (here / "d.tex").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", ["a\u202eb", "n" * 200, "two\nlines"])
def test_names_that_turn_or_fill_a_heading_are_refused(name: str) -> None:
    with pytest.raises(sb.SymbalanceError, match="must be one line of 1 to 60 characters"):
        sb.inline("1-3-2", ratio=4, name=name)


def test_marks_that_turn_writing_are_shown_by_their_codes() -> None:
    drawing = Drawing((Label((0, 0), "a\u202eb"),), 0, 0, 1, 1, "t\u202e", "s\u2066")
    svg = draw.to_svg(drawing)
    assert not {"\u202e", "\u2066"} & set(svg)
    assert "a\\u202eb" in svg
