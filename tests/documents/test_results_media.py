"""Every result in every medium: what one says of a result, the others say too."""

from __future__ import annotations

import json
import re
from html.parser import HTMLParser

import pytest

import symbalance as sb
from symbalance.document.result import Result, to_html, to_json, to_latex, to_markdown, to_text
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
    assert fragment in alone


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


def test_kinds_are_named_once() -> None:
    kinds = [cls.kind for cls in result_classes()]
    assert all(kinds)
    assert len(set(kinds)) == len(kinds)


@pytest.mark.parametrize("writer", [to_text, to_latex, to_html, to_markdown, to_json])
def test_what_is_no_result_is_refused(writer) -> None:  # type: ignore[no-untyped-def]
    for value in (3, "text", Result, None):
        with pytest.raises(sb.SymbalanceError):
            writer(value)
