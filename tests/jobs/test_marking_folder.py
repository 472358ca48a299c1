"""A folder of homework: web pages are notes, reports are not, copies and what is no text are named."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from symbalance.cli import run

LINES = [
    r"\sin^2 x + \cos^2 x = 1",
    r"\sin 2x = 2\sin x\cos x",
    r"\cos 2x = 1 - 2\sin^2 x",
    r"\cos 2x = 2\cos^2 x - 1",
    r"(x+1)^2 = x^2 + 2x + 1",
]
WRONG = r"\sin^2 x = \frac{1 - \cos 2x}{4}"
OTHER = r"\cos^2 x = \frac{1 + \cos 2x}{4}"


@pytest.fixture
def homework(tmp_path: Path) -> Path:
    folder = tmp_path / "homework"
    folder.mkdir()
    page = "\n\n".join(f"$${line}$$" for line in [*LINES, WRONG])
    for name in ("ann.md", "bob.md"):
        (folder / name).write_text(page, encoding="utf-8")
    (folder / "cyd.md").write_text(page.replace(WRONG, OTHER), encoding="utf-8")
    (folder / "dee.html").write_text(f"<html><body><p>\\[{WRONG}\\]</p></body></html>", encoding="utf-8")
    (folder / "eve.pdf").write_bytes(b"%PDF")
    (folder / "ann.pdf").write_bytes(b"%PDF")
    return folder


def test_web_pages_are_notes_and_reports_are_not(
    homework: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    report = homework / "ann.md.html"
    assert run(["check", str(homework / "ann.md"), "-o", str(report)]) == 1
    capsys.readouterr()
    assert run(["check", str(homework), "--format", "json"]) == 1
    out, err = capsys.readouterr()
    names = [Path(each["document"]).name for each in json.loads(out)["documents"]]
    assert names == ["ann.md", "bob.md", "cyd.md", "dee.html"]
    assert "as they are no text: " in err
    assert "eve.pdf" in err
    assert "ann.pdf" not in err  # made from ann.md


def test_copies_are_named(homework: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["check", str(homework)]) == 1
    out, _ = capsys.readouterr()
    assert "The same relations on the same lines: ann.md, bob.md." in out
    assert "cyd.md." not in out


def test_one_number_wrong_in_two_formulas_is_two_errors(
    homework: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["check", str(homework), "--format", "csv"]) == 1
    capsys.readouterr()
    assert run(["check", str(homework), "--format", "markdown"]) == 1
    out, _ = capsys.readouterr()
    rows = [line for line in out.splitlines() if "put" in line]
    assert len(rows) == 2, rows
    assert sorted("cyd.md" in row for row in rows) == [False, True]
