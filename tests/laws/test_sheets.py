"""Sheets of every kind of engine: one page, no two labels in one place, hostile names as text."""

from __future__ import annotations

import shutil
from xml.etree import ElementTree

import pytest

import symbalance as sb
from symbalance import draw
from symbalance.cli import run
from symbalance.document.shapes import labels_of
from symbalance.engine.catalogue import presets
from symbalance.errors import MissingPartError, SymbalanceError
from symbalance.pages import sheet_files
from symbalance.pages.sheet import HIGH, WIDE, sheet
from tests.laws.test_drawings import overlaps

KINDS = ["inline-3", "vw-vr6", "v8-90", "boxer-4", "bugatti-w16", "r-1820", "wartsila-10rta96c"]


@pytest.mark.slow
@pytest.mark.parametrize("name", KINDS)
def test_a_sheet_stays_within_its_page_and_overlaps_no_labels(name: str) -> None:
    drawing = sheet(sb.load(name))
    for label in labels_of(drawing):
        left, bottom, right, top = label.box
        assert 0 <= left < right <= WIDE, label.text
        assert 0 <= bottom < top <= HIGH, label.text
    assert overlaps(drawing) == []


@pytest.mark.slow
def test_a_sheet_holds_every_amplitude_of_the_balance() -> None:
    result = sb.balance(sb.load("v8-90"))
    texts = [label.text for label in labels_of(sheet(result))]
    assert "4√2 ≈ 5.65685" in texts
    assert "√10 ≈ 3.16228" in texts
    assert sum(text in ("vertical", "lateral") for text in texts) == 4
    for cylinder in result.engine.cylinders:
        assert str(cylinder.number) in texts


@pytest.mark.slow
@pytest.mark.parametrize("text", ["<script>", "]]>", "\\input{x}", "n" * 60, "横置き", "$^&%#_{}~"])
def test_a_hostile_name_is_text_on_a_sheet(text: str) -> None:
    engine = sb.inline("1-3-2", ratio=4, name=text)
    svg = ElementTree.fromstring(draw.to_svg(sheet(engine), standalone=True))
    shown = "".join(svg.itertext())
    assert text in shown
    assert "\\input{x" not in sheet_files.sheets_latex([sheet(engine)])


@pytest.mark.rare
@pytest.mark.parametrize("program", ["pdflatex", "lualatex"])
def test_sheets_of_all_presets_are_a_page_each(program: str, monkeypatch: pytest.MonkeyPatch) -> None:
    if shutil.which(program) is None:
        pytest.skip(f"no {program} on this machine")
    monkeypatch.setattr(sheet_files, "which", lambda name: shutil.which(program))
    names = [str(name) for name in presets()]
    pdf = sheet_files.sheets_pdf([sheet(sb.load(name)) for name in names if sb.load(name).ratio])
    assert pdf.startswith(b"%PDF")


@pytest.mark.slow
@pytest.mark.parametrize("name", ["v8-90", "横置き"])
def test_a_pdf_has_one_page(name: str) -> None:
    if not (shutil.which("pdflatex") and shutil.which("lualatex") and shutil.which("pdfinfo")):
        pytest.skip("needs both TeX engines and pdfinfo")
    import subprocess

    engine = sb.inline("1-3-2", ratio=4, name=name)
    pdf = sheet_files.sheets_pdf([sheet(engine), sheet(engine)])
    said = subprocess.run(["pdfinfo", "-"], input=pdf, capture_output=True, check=True).stdout.decode()
    assert "Pages:           2" in said
    words = subprocess.run(["pdftotext", "-", "-"], input=pdf, capture_output=True, check=True).stdout
    assert name in words.decode()


def test_without_tex_a_pdf_is_refused_in_a_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sheet_files, "which", lambda name: None)
    with pytest.raises(MissingPartError, match=r"pdflatex or lualatex is not installed"):
        sheet_files.sheets_pdf([sheet(sb.load("inline-3"))])


def test_what_a_sheet_cannot_show_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["sheet", "inline-3", "-o", "x.png"]) == 2
    assert run(["sheet", "inline-3", "v8-90", "-o", "x.svg"]) == 2
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 2
    assert "must end in .pdf, .tex, .svg" in lines[0]
    assert "one page" in lines[1]
    with pytest.raises(SymbalanceError, match="a sheet shows 64 at most"):
        sheet(sb.inline("-".join(map(str, range(1, 71))), ratio=4))
