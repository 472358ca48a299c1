"""Every result in every medium: what one says of a result, the others say too."""

from __future__ import annotations

import csv
import io
import json
import re
from html.parser import HTMLParser

import pytest

import symbalance as sb
from symbalance.document.result import (
    Result,
    to_csv,
    to_html,
    to_json,
    to_latex,
    to_markdown,
    to_text,
    to_xlsx,
)
from tests.results import EXAMPLES, example, result_classes

VOID = {"meta", "img", "br", "hr", "link"}


def test_every_kind_of_result_has_an_example_under_its_name() -> None:
    assert {cls.kind for cls in result_classes()} <= set(EXAMPLES)


@pytest.mark.slow
def test_every_class_of_result_has_an_example() -> None:
    assert {type(example(name)) for name in EXAMPLES} == result_classes()


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", EXAMPLES)
def test_text_fits_its_columns(name: str) -> None:
    for width in (80, 120):
        assert [
            line for line in to_text(example(name), width=width).splitlines() if len(line) > width
        ] == []


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", EXAMPLES)
def test_text_is_one_document(name: str) -> None:
    text = to_text(example(name))
    assert text.endswith("\n")
    assert not text.endswith("\n\n")
    assert not re.search(r"\n\n\n|[ \t]\n|<[a-z]", text)
    assert _commands(text) <= _commands(json.dumps(example(name).data()))


def _commands(text: str) -> set[str]:
    """Return the commands of LaTeX in a text: a result may quote somebody's, and writes none itself."""
    return set(re.findall(r"\\[a-z]+", text))


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", EXAMPLES)
def test_latex_is_balanced_and_a_fragment_says_what_it_needs(name: str) -> None:
    fragment = to_latex(example(name))
    assert fragment.startswith("% Needs \\usepackage{amsmath,booktabs")
    assert "\\documentclass" not in fragment
    for environment in set(re.findall(r"\\begin\{(\w+\*?)\}", fragment)):
        begun = fragment.count(rf"\begin{{{environment}}}")
        assert begun == fragment.count(rf"\end{{{environment}}}"), environment
    bare = re.sub(r"\\[{}\\]", "", fragment)
    assert bare.count("{") == bare.count("}")
    assert (
        fragment.isascii()
        or "lualatex" in fragment.splitlines()[0]
        or not re.search("[\u2000-\U0010ffff]", fragment)
    )


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", EXAMPLES)
def test_a_standalone_document_is_the_fragment_in_a_preamble(name: str) -> None:
    fragment = to_latex(example(name)).split("\n", 1)[1]
    alone = to_latex(example(name), standalone=True)
    assert alone.startswith("\\documentclass")
    assert alone.endswith("\\end{document}\n")
    # A page of its own is wider than an article's column: there no table is parted or set smaller.
    assert fragment in alone or heads(fragment) == heads(alone)


def heads(latex: str) -> list[str]:
    """Return the titles of a document's tables, each once."""
    titles = re.findall(r"\\textbf\{([^\n]*)\}", latex)
    return list(dict.fromkeys(title.removesuffix(" (continued)") for title in titles))


class _Nesting(HTMLParser):
    """Refuses tags that do not nest, and collects them and the text between them that is seen."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: list[str] = []
        self.words: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        if tag not in VOID:
            self.open.append("hidden" if ("aria-hidden", "true") in attrs else tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() in (tag, "hidden")

    def handle_data(self, data: str) -> None:
        if self.open[-1:] != ["hidden"]:
            self.words.append(data)


def _parsed(html: str) -> _Nesting:
    parser = _Nesting()
    parser.feed(html)
    parser.close()
    assert parser.open == []
    return parser


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", EXAMPLES)
def test_html_nests_and_says_what_things_are(name: str) -> None:
    page = _parsed(to_html(example(name), standalone=True))
    assert {"html", "title", "main", "article", "h1"} <= set(page.tags)
    assert "pre" not in page.tags
    assert page.tags.count("h1") == 1
    fragment = _parsed(to_html(example(name)))
    assert "html" not in fragment.tags
    assert "h1" not in fragment.tags
    assert fragment.tags.count("table") == page.tags.count("table")


def _digits(text: str) -> set[str]:
    """Return the numbers of four digits or more in a text: what a table is read for."""
    return {n for n in re.findall(r"\d[\d.]*\d", text) if len(n.replace(".", "")) >= 4}


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", EXAMPLES)
def test_the_media_agree_on_their_numbers(name: str) -> None:
    result = example(name)
    in_text = _digits(to_text(result, width=200))
    joined = "".join(_parsed(to_html(result)).words)
    assert in_text <= _digits(joined) | _digits(" ".join(_parsed(to_html(result)).words))
    points_in_line = re.sub(r"\$ & \$\.", ".", to_latex(result))
    assert in_text <= _digits(points_in_line)
    assert in_text <= _digits(to_markdown(result))


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", EXAMPLES)
def test_json_names_its_schema_and_reads_back(name: str) -> None:
    result = example(name)
    found = json.loads(to_json(result))
    assert next(iter(found)) == "schema"
    assert found["schema"] == {"result": result.kind, "version": result.schema_version}
    assert json.loads(json.dumps(result.data())) == {k: v for k, v in found.items() if k != "schema"}


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", EXAMPLES)
def test_a_result_is_shown_in_a_line_and_in_a_notebook(name: str) -> None:
    result = example(name)
    assert "\n" not in repr(result)
    assert 10 < len(repr(result)) < 200
    assert " object at " not in repr(result)
    assert result._repr_html_() == to_html(result)
    assert result._repr_latex_() == to_latex(result)
    assert result._repr_markdown_() == to_markdown(result)


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", EXAMPLES)
def test_records_are_rows_of_plain_values_with_one_set_of_keys(name: str) -> None:
    rows = example(name).records()
    assert rows
    assert all(list(row) == list(rows[0]) for row in rows)
    values = [value for row in rows for value in row.values()]
    assert all(value is None or isinstance(value, str | int | float | bool) for value in values)


def _read_back(cell: str) -> object:
    """Return what a program takes a cell of CSV for: as its reader of numbers, and texts, sees it."""
    if cell in ("", "true", "false"):
        return {"": None, "true": True, "false": False}[cell]
    if cell.startswith("'"):
        return cell[1:]
    try:
        return float(cell)
    except ValueError:
        return cell


def _comparable(value: object) -> object:
    """Return a record's value as `_read_back` gives it: texts that are numbers count as such."""
    if isinstance(value, bool) or value is None or value == "":
        return None if value == "" else value
    try:
        return float(value)  # type: ignore[arg-type]
    except ValueError:
        return value


def _table(result: Result) -> tuple[list[str], list[list[object]]]:
    """Return a result's records as heads and rows; what is within a value has a head of its own."""
    records = result.records()
    inner: dict[str, dict[str, None]] = {key: {} for record in records for key in record}
    for record in records:
        for key, value in record.items():
            inner[key] |= dict.fromkeys(value) if isinstance(value, dict) else {"": None}
    heads = [f"{key}.{part}" if part else key for key, parts in inner.items() for part in parts]
    places = [(key, part) for key, parts in inner.items() for part in parts]
    return heads, [[r[k].get(part) if part else r[k] for k, part in places] for r in records]


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", EXAMPLES)
def test_csv_is_the_records(name: str) -> None:
    result = example(name)
    text = to_csv(result)
    assert text.count("\n") >= text.count("\r\n") == len(result.records()) + 1
    head, *rows = csv.reader(io.StringIO(text, newline=""), strict=True)
    expected = _table(result)
    assert head == expected[0]
    # An operating point adds its columns to those that are always there.
    assert set(result.record_keys) <= set(head)
    cells = [[_read_back(cell) for cell in row] for row in rows]
    assert cells == [[_comparable(value) for value in row] for row in expected[1]]
    risky = [
        c for row in rows for c in row if c[:1] in tuple("=+-@") and not re.fullmatch(r"[-+\d.e]+", c)
    ]
    assert risky == []


@pytest.mark.slow
@pytest.mark.parametrize("name", EXAMPLES)
def test_a_workbook_is_the_records(name: str) -> None:
    from openpyxl import load_workbook

    result = example(name)
    book = load_workbook(io.BytesIO(to_xlsx(result)))
    (sheet,) = book.worksheets
    assert sheet.title == result.kind
    assert sheet.freeze_panes == "A2"
    head, *rows = sheet.iter_rows()
    heads, expected = _table(result)
    assert [cell.value for cell in head] == heads
    assert all(cell.font.b for cell in head)
    assert len(rows) == len(expected)
    for row, values in zip(rows, expected, strict=True):
        for cell, value in zip(row, values, strict=True):
            if isinstance(value, float):  # openpyxl writes 16 digits
                assert cell.value == pytest.approx(value, rel=1e-15, abs=0)
            else:
                assert cell.value == (None if value == "" else value)
    assert {cell.data_type for row in rows for cell in row} <= {"n", "s", "b", "inlineStr"}


@pytest.mark.spread(2)
@pytest.mark.parametrize("name", EXAMPLES)
def test_labelled_tables_have_captions_and_labels_of_their_own(name: str) -> None:
    plain, labelled = to_latex(example(name)), to_latex(example(name), label="here")
    assert "\\caption" not in plain
    assert "\\label" not in plain
    labels = re.findall(r"\\caption\{(?=\S).*\}\\label\{(tab:here-[a-z0-9-]+)\}", labelled)
    assert len(set(labels)) == len(labels) == labelled.count(r"\begin{table}")
    assert plain.count(r"\begin{tabular}") == labelled.count(r"\begin{tabular}") == len(labels)


def test_kinds_are_named_once() -> None:
    kinds = [cls.kind for cls in result_classes()]
    assert all(kinds)
    assert len(set(kinds)) == len(kinds)


@pytest.mark.parametrize("writer", [to_text, to_latex, to_html, to_markdown, to_json, to_csv, to_xlsx])
def test_what_is_no_result_is_refused(writer) -> None:  # type: ignore[no-untyped-def]
    for value in (3, "text", Result, None):
        with pytest.raises(sb.SymbalanceError):
            writer(value)
