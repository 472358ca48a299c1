"""Evidence: the derivations hang together. pytest runs their formulas itself, as doctests.

Checked here: the index names every document, each document computes something, and the table of errors
says what the documents say. A line found wrong stands in bold in its document, as in **000:55**.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple

import pytest

from tests import ROOT

FOLDER = ROOT / "derivations"
INDEX = FOLDER / "README.md"
DOCUMENTS = sorted(path for path in FOLDER.glob("*.md") if path != INDEX)

MARK = r"\d{3}:\d+(?:–\d+)?"
ROW = re.compile(rf"\| ({MARK}) \| `([^`]+)` \| (.+) \| (\w+) \| \[.+\]\((.+)\) \|")
KINDS = {"value", "follows", "notation", "condition", "convention"}


class Listed(NamedTuple):
    """One row of the table of errors."""

    mark: str
    wrong: str
    right: str
    kind: str
    document: str


def errors_listed() -> list[Listed]:
    rows = [line for line in INDEX.read_text("utf-8").splitlines() if re.match(rf"\| {MARK} ", line)]
    found = [ROW.fullmatch(row) for row in rows]
    unread = [row for row, match in zip(rows, found, strict=True) if match is None]
    assert not unread, unread
    return [Listed(*match.groups()) for match in found if match is not None]


@pytest.mark.parametrize("document", [INDEX, *DOCUMENTS], ids=lambda path: path.name)
def test_a_document_computes_something(document: Path) -> None:
    assert re.search(r"^>>> ", document.read_text("utf-8"), re.MULTILINE)


def test_the_index_names_every_document_and_no_other() -> None:
    named = set(re.findall(r"^\| \[.+?\]\((.+?\.md)\) \|", INDEX.read_text("utf-8"), re.MULTILINE))
    assert named == {path.name for path in DOCUMENTS}


def test_every_listed_error_stands_in_its_document() -> None:
    texts = {path.name: path.read_text("utf-8") for path in DOCUMENTS}
    listed = errors_listed()
    assert len(listed) == len(set(listed)) > 60
    for error in listed:
        assert error.kind in KINDS, error
        assert f"**{error.mark}**" in texts[error.document], error
        assert error.wrong in texts[error.document], error


def test_every_error_of_a_document_is_listed() -> None:
    listed = {(error.document, error.mark) for error in errors_listed()}
    for path in DOCUMENTS:
        for mark in re.findall(rf"\*\*({MARK})\*\*", path.read_text("utf-8")):
            assert (path.name, mark) in listed


def test_what_a_row_calls_wrong_is_quoted_from_that_line() -> None:
    """Lines quoted in blocks hold the wrong formula under the same mark."""
    for error in errors_listed():
        text = (FOLDER / error.document).read_text("utf-8")
        first, _, last = error.mark.partition("–")
        source, number = first.split(":")
        marks = [f"{source}:{n}" for n in range(int(number), int(last or number) + 1)]
        quoted = [line for mark in marks for line in re.findall(rf"^{mark}  (.+)$", text, re.MULTILINE)]
        if quoted:
            assert any(error.wrong in line for line in quoted), error
