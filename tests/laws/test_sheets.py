"""Sheets of every kind of engine: one page, no two labels in one place, hostile names as text."""

from __future__ import annotations

import itertools
import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from xml.etree import ElementTree

import pytest

import symbalance as sb
from symbalance.cli import run
from symbalance.document import nodes
from symbalance.document.fitting import plain_words
from symbalance.document.shapes import Drawing, Group, Label, Line, Shape, labels_of
from symbalance.engine.catalogue import preset_names
from symbalance.errors import MissingPartError, SymbalanceError
from symbalance.pages import sheet, sheet_files
from symbalance.pages.sheet_layout import HIGH, LEAST, MARGIN, WIDE, TextBlock, TextLine, set_text
from tests.laws.test_drawings import corners, overlaps

KINDS = ["inline-3", "vw-vr6", "v8-90", "boxer-4", "bugatti-w16", "r-1820", "wartsila-10rta96c"]


@pytest.mark.slow
@pytest.mark.parametrize("name", KINDS)
def test_a_sheet_stays_within_its_page_and_overlaps_no_labels(name: str) -> None:
    (drawing,) = sheet(sb.load(name)).pages
    stay_within(drawing)
    assert overlaps(drawing) == []


def stay_within(drawing: Drawing) -> None:
    for label in labels_of(drawing):
        left, bottom, right, top = label.box
        assert 0 <= left < right <= WIDE, label.text
        assert 0 <= bottom < top <= HIGH, label.text


@pytest.mark.slow
@pytest.mark.parametrize("count", [2, 3, 5, 12])
def test_a_comparison_is_one_sheet_of_all_its_engines(count: int) -> None:
    names = [*KINDS, "v12-60", "boxer-6", "honda-nt650", "kharkiv-v2", "inline-5"][:count]
    first, *more = sheet(*map(sb.load, names), compare=True, order=6).pages
    assert not more or count > 4
    for page in (first, *more):
        stay_within(page)
        assert overlaps(page) == []
    texts = [label.text for label in labels_of(first)]
    assert all(texts.count(name) >= 2 for name in names)  # above its section, and in the table


@pytest.mark.slow
def test_a_comparison_says_what_the_table_says() -> None:
    engines = [sb.load("v8-90"), sb.load("inline-4")]
    (page,) = sheet(*engines, compare=True, order=4).pages
    texts = [label.text for label in labels_of(page)]
    assert "√10 f" in texts or any("√10" in text for text in texts)
    assert any(text.startswith("inline-4: Free of forces up to order 1.") for text in texts)


def block(rows: int) -> TextBlock:
    lines = [TextLine(((0.0, f"row {k}"),)) for k in range(rows)]
    return TextBlock((TextLine(((0.0, "title"),)), TextLine(((0.0, "head"),), rule=True), *lines), 2)


def test_long_tables_go_on_under_their_head_and_lose_no_row() -> None:
    setting = set_text([block(5), block(300), block(5)], 400.0)
    assert len(setting.pages) > 1
    assert setting.size >= LEAST
    words = []
    for page in setting.pages:
        for column in page:
            lines = [line for line in column if line.words]
            assert not lines or not lines[-1].rule  # no head without a row below it
            assert not lines or lines[0].words[0][1] == "title"
            words += [line.words[0][1] for line in lines if line.words[0][1].startswith("row")]
    assert words == [f"row {k}" for n in (5, 300, 5) for k in range(n)]


def test_short_tables_share_a_page_in_letters_that_can_be_read() -> None:
    setting = set_text([block(10), block(20), block(8)], 400.0)
    assert len(setting.pages) == 1
    assert setting.size >= LEAST


@pytest.mark.slow
def test_a_sheet_holds_every_amplitude_of_the_balance() -> None:
    result = sb.balance(sb.load("v8-90"))
    texts = [label.text for label in labels_of(sheet(result).pages[0])]
    assert "4√2 ≈ 5.65685" in texts
    assert "√10 ≈ 3.16228" in texts
    assert sum(text in ("vertical", "lateral") for text in texts) == 4
    for cylinder in result.engine.cylinders:
        assert str(cylinder.number) in texts


@pytest.mark.slow
@pytest.mark.parametrize(
    "text",
    [
        "<script>",
        "]]>",
        "\\input{x}",
        "n" * 60,
        "Großer Motor",
        "横置き",
        "$^&%#_{}~",
        "あ" * 40,
        "w" * 60,
    ],
)
def test_a_hostile_name_is_text_on_a_sheet(text: str) -> None:
    engine = sb.inline("1-3-2", ratio=4, name=text)
    svg = ElementTree.fromstring(sheet(engine).svg())
    shown = "".join(each.text or "" for each in svg.iter("{http://www.w3.org/2000/svg}text"))
    assert text in shown
    assert not list(svg.iter("{http://www.w3.org/2000/svg}script"))
    assert "\\input{x" not in sheet(engine).latex()


@pytest.mark.rare
@pytest.mark.parametrize("program", ["pdflatex", "lualatex"])
def test_sheets_of_all_presets_are_a_page_each(program: str, tmp_path: Path) -> None:
    if shutil.which(program) is None:
        pytest.skip(f"no {program} on this machine")
    pages = []
    for name in preset_names():
        sheets = sheet(sb.load(name))
        assert len(sheets.pages) == 1, name
        stay_within(sheets.pages[0])
        assert overlaps(sheets.pages[0]) == [], name
        pages += sheets.pages
    (tmp_path / "all.tex").write_text(sheet_files.sheets_latex(pages), encoding="utf-8")
    command = [program, "-interaction=nonstopmode", "-halt-on-error", "all.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, check=False, timeout=1500)
    log = (tmp_path / "all.log").read_text(encoding="utf-8", errors="replace")
    assert done.returncode == 0, log[-2000:]
    assert "Overfull" not in log
    assert "Missing character" not in log
    assert f"({len(pages)} pages" in " ".join(log.split())


def has_japanese() -> bool:
    """Return whether TeX has luatexja here: Debian's LuaTeX comes without it."""
    return bool(subprocess.run(["kpsewhich", "luatexja.sty"], capture_output=True, check=False).stdout)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["v8-90", "横置き"])
def test_a_pdf_has_one_page(name: str) -> None:
    if not (shutil.which("pdflatex") and shutil.which("lualatex") and shutil.which("pdfinfo")):
        pytest.skip("needs both TeX engines and pdfinfo")
    engine = sb.inline("1-3-2", ratio=4, name=name)
    if not name.isascii() and not has_japanese():
        with pytest.raises(MissingPartError, match="texlive-lang-japanese"):
            sheet(engine, engine).pdf()
        return
    pdf = sheet(engine, engine).pdf()
    said = subprocess.run(["pdfinfo", "-"], input=pdf, capture_output=True, check=True).stdout.decode()
    assert "Pages:           2" in said
    words = subprocess.run(["pdftotext", "-", "-"], input=pdf, capture_output=True, check=True).stdout
    assert name in words.decode()


def test_without_tex_a_pdf_is_refused_in_a_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sheet_files, "which", lambda name: None)
    with pytest.raises(MissingPartError, match=r"pdflatex or lualatex is not installed"):
        sheet(sb.load("inline-3")).pdf()


def test_a_missing_tikz_is_said_with_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    log = b"! LaTeX Error: File `tikz.sty' not found.\n"
    stopped = subprocess.CompletedProcess(["pdflatex"], 1, stdout=log)
    monkeypatch.setattr(sheet_files, "which", lambda name: name)
    monkeypatch.setattr(sheet_files.subprocess, "run", lambda *given, **also: stopped)
    with pytest.raises(MissingPartError, match="apt-get install texlive-pictures, or write"):
        sheet(sb.load("inline-3")).pdf()


@pytest.mark.slow
def test_japanese_names_are_whole_or_refused() -> None:
    engine = sb.inline("1-3-2", ratio=4, name="横置き")
    source = sheet(engine).latex()
    if shutil.which("pdflatex") is None:
        pytest.skip("needs pdflatex")
    command = ["pdflatex", "-interaction=nonstopmode", "x.tex"]
    with TemporaryDirectory() as folder:
        (Path(folder) / "x.tex").write_text(source, encoding="utf-8")
        done = subprocess.run(command, cwd=folder, capture_output=True, check=False)
        assert done.returncode == 1
        assert b"! Package symbalance Error: East Asian characters need lualatex" in done.stdout
        assert not (Path(folder) / "x.pdf").exists()


@pytest.mark.slow
def test_a_missing_luatexja_is_said_with_what_to_install(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    if shutil.which("lualatex") is None:
        pytest.skip("needs lualatex")
    changed = sheet_files.EAST_ASIAN.replace("luatexja.sty}{", "no-such.sty}{")
    monkeypatch.setattr(sheet_files, "EAST_ASIAN", changed)
    with pytest.raises(MissingPartError, match="texlive-lang-japanese"):
        sheet(sb.inline("1-3-2", ratio=4, name="横置き")).pdf()


def test_what_a_sheet_cannot_show_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["sheet", "inline-3", "-o", "x.png"]) == 2
    assert run(["sheet", "inline-3", "v8-90", "-o", "x.svg"]) == 2
    assert run(["sheet", "inline-3", "--compare", "-o", "x.svg"]) == 2
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 3
    assert "must end in .pdf, .tex, .svg" in lines[0]
    assert "one page" in lines[1]
    assert "--compare: compares several engines" in lines[2]
    with pytest.raises(SymbalanceError, match="a sheet shows 64 at most"):
        sheet(sb.inline("-".join(map(str, range(1, 71))), ratio=4))


def bounds(shapes: Sequence[Shape]) -> tuple[float, float, float, float]:
    """Return left, bottom, right and top of shapes and their labels."""
    drawing = Drawing(tuple(shapes), 0, 0, 1, 1, "", "")
    xs, ys = zip(*corners(drawing), strict=True)
    boxes = [label.box for label in labels_of(drawing)]
    return (
        min([*xs, *(b[0] for b in boxes)]),
        min([*ys, *(b[1] for b in boxes)]),
        max([*xs, *(b[2] for b in boxes)]),
        max([*ys, *(b[3] for b in boxes)]),
    )


@pytest.mark.slow
@pytest.mark.parametrize("name", [*KINDS, "comparison"])
def test_pictures_and_columns_of_a_sheet_stand_apart(name: str) -> None:
    if name == "comparison":
        page = sheet(*map(sb.load, KINDS[:5]), compare=True, order=6).pages[0]
    else:
        page = sheet(sb.load(name)).pages[0]
    pictures = [bounds([s]) for s in page.shapes if isinstance(s, Group)]
    assert len(pictures) > 2
    for place, one in enumerate(pictures):
        for other in pictures[place + 1 :]:
            across = min(one[2], other[2]) - max(one[0], other[0])
            along = min(one[3], other[3]) - max(one[1], other[1])
            assert min(across, along) < 3, (one, other)
    low = min(picture[1] for picture in pictures)
    rules = [s for s in page.shapes if isinstance(s, Line)]
    assert rules
    assert all(rule.points[0][1] < low + 3 for rule in rules)
    ends = sorted({(rule.points[0][0], rule.points[1][0]) for rule in rules})
    assert ends[0][0] == MARGIN
    assert ends[-1][1] == pytest.approx(WIDE - MARGIN)
    assert all(a[1] + 5 < b[0] for a, b in itertools.pairwise(ends))
    # What stands in the left column ends before the right one begins.
    for label in (s for s in page.shapes if isinstance(s, Label) and s.at[1] < low - 5):
        column = next(end for end in ends if end[0] - 1 <= label.at[0] <= end[1])
        assert label.box[2] <= column[1] + 1, label.text


@pytest.mark.slow
@pytest.mark.parametrize("name", ["inline-3", "vw-vr6", "r-985", "v8-90", "honda-rc211v"])
def test_a_sheet_says_all_that_the_short_document_says(name: str) -> None:
    result = sb.balance(sb.load(name))
    labels = [s for s in sheet(result).pages[0].shapes if isinstance(s, Label)]
    texts = [label.text for label in labels]
    strong = " ".join(label.text for label in labels if label.strong)
    joined = " ".join(text.strip() for text in texts)
    document = result.document().unfolded(full=False)
    assert plain_words(document.title) in strong
    paragraphs = [b for b in document.blocks if isinstance(b, nodes.Paragraph)]
    for block in document.blocks:
        if isinstance(block, nodes.Table):
            title = plain_words(block.title)
            assert title in (strong if block.rows else joined)
            for row in block.rows:
                assert plain_words(row[0]) in texts  # type: ignore[arg-type]
        elif isinstance(block, nodes.Facts):
            assert plain_words(block.title) in strong
            for entry, said in block.entries:
                beginning = f"{plain_words(entry)}: {plain_words(said)}"[:24].strip()
                assert any(text.startswith(beginning) for text in texts), beginning
        elif isinstance(block, nodes.Paragraph) and block is not paragraphs[-1]:
            assert plain_words(block.words) in joined
    last = plain_words(paragraphs[-1].words) if paragraphs else ""
    if "--full" in last:
        assert "in full also" not in joined
        assert "symbalance balance --full" in joined
    elif last:
        assert last in joined
