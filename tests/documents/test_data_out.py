"""Results for spreadsheets and reports: what a stranger's words become there, and what is refused."""

from __future__ import annotations

import csv
import io
import re
import sys

import pytest

import symbalance as sb
from symbalance.cli import run
from symbalance.document.result import Result

HOSTILE = [
    "=1+1",
    '=HYPERLINK("http://x","y")',
    "+cmd|'/C calc'!A0",
    "-2+3",
    "@SUM(A1)",
    "\t=1",
    "＝1+1",
    "  =1",
    "'already",
    'two\nlines, and a "quote"',
    "_x0041_",
    "plain",
]


class Words(Result):
    """A result of somebody's words."""

    kind = "words"

    def records(self):
        return [{"name": text, "size": 1.5, "nested": {"a": 1, "b": [True, None]}} for text in HOSTILE]


class Nothing(Result):
    """A result that may have no rows."""

    kind = "nothing"

    def records(self):
        return []


def test_words_of_others_are_no_formulas_in_csv():
    head, *rows = csv.reader(io.StringIO(sb.to_csv(Words()), newline=""), strict=True)
    assert head == ["name", "size", "nested.a", "nested.b.1", "nested.b.2"]
    assert [row[1:] for row in rows] == [["1.5", "1", "true", ""]] * len(HOSTILE)
    names = [row[0] for row in rows]
    assert not any(name.lstrip().startswith(tuple("=+-@＝")) for name in names)
    assert [name.removeprefix("'") for name in names] == HOSTILE


@pytest.mark.slow
def test_words_of_others_are_no_formulas_in_a_workbook():
    from openpyxl import load_workbook
    from openpyxl.utils.escape import unescape

    sheet = load_workbook(io.BytesIO(sb.to_xlsx(Words()))).worksheets[0]
    cells = [row[0] for row in sheet.iter_rows(min_row=2)]
    assert [unescape(str(cell.value)) for cell in cells] == HOSTILE
    assert {cell.data_type for cell in cells} == {"s"}
    assert [cell.quotePrefix for cell in cells] == [i < 8 for i in range(len(HOSTILE))]


def test_a_table_of_no_rows_has_its_heads():
    free = sb.balance(sb.load("inline-6"), 2)
    assert free.records() == []
    assert sb.to_csv(free) == ",".join(sb.balance(sb.load("inline-4"), 2).records()[0]) + "\r\n"
    with pytest.raises(sb.SymbalanceError, match="has no rows"):
        sb.to_csv(Nothing())


def test_without_openpyxl_the_extra_is_named(monkeypatch, capsys, tmp_path):
    monkeypatch.setitem(sys.modules, "openpyxl", None)
    target = tmp_path / "out.xlsx"
    assert run(["balance", "inline-4", "-o", str(target)]) == 2
    assert capsys.readouterr().err == (
        "symbalance: openpyxl: is not installed; pip install 'symbalance[xlsx]'\n"
    )
    assert not target.exists()


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("balance inline-4 --format xlsx", "no terminal shows; name a file: -o FILE.xlsx"),
        ("balance inline-4 --label v4", "--label: is for LaTeX, and this is text"),
        ("balance inline-4 --format latex --label a_b", "label = a_b: must begin with"),
        ("check a.md b.md --format xlsx -o {out}", "--format xlsx: is for the report of one document"),
        ("check a.md b.md --label x --format latex -o {out}", "--label: is for the report of one"),
        ("balance inline-4 inline-5 --label a_b --format latex -o {out}", "label = a_b: must begin with"),
        ("engines --schema --label x", "--label: plays no part in --schema"),
    ],
)
def test_what_has_no_place_is_refused(line, says, capsys, tmp_path):
    out = tmp_path / "out"
    assert run(line.format(out=out).split()) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    assert says in shown.err
    assert shown.err.count("\n") == 1
    assert not out.exists()


@pytest.mark.slow
def test_several_engines_have_a_workbook_or_labels_each(tmp_path):
    """In a folder, from the store too: what is kept is what was written."""
    import openpyxl

    command = ["balance", "inline-4", "v8-90", "--order", "4", "-o", str(tmp_path / "each")]
    for _ in range(2):
        assert run([*command, "--format", "xlsx"]) == 0
        expected = sb.balance(sb.load("v8-90"), 4).records()
        (sheet,) = openpyxl.load_workbook(tmp_path / "each" / "v8-90.xlsx").worksheets
        assert [row[0].value for row in sheet.iter_rows(min_row=2)] == [row["order"] for row in expected]
    assert run([*command, "--format", "latex", "--label", "mine"]) == 0
    text = (tmp_path / "each" / "v8-90.tex").read_text(encoding="utf-8")
    assert r"\label{tab:mine-v8-90-force}" in text


def test_an_ending_asks_for_csv(tmp_path, capfdbinary):
    target = tmp_path / "out.csv"
    assert run(["balance", "inline-4", "-o", str(target)]) == 0
    assert run(["balance", "inline-4", "--format", "csv"]) == 0
    expected = sb.to_csv(sb.balance(sb.load("inline-4"))).encode()
    assert target.read_bytes() == expected == capfdbinary.readouterr().out


def test_a_labelled_table_says_what_it_is_of():
    text = sb.to_latex(sb.balance(sb.load("v8-90")), label="v8", full=True)
    heads = re.findall(r"\\caption\{(.*?)\s*[,(}].*\\label\{(.*?)\}", text)
    about = "Free couple about the mean of all stations"
    assert {label: head for head, label in heads}.items() >= {
        "tab:v8-force": "Free force",
        "tab:v8-couple": about,
        "tab:v8-couple-rotating": f"{about} as rotating parts",
        "tab:v8-coefficients": "Coefficients of one cylinder",
    }.items()


def test_where_nothing_takes_a_label_that_is_said():
    assert "% No table stands here" in sb.to_latex(sb.derive("force", 2), label="force")
    assert "% No table" not in sb.to_latex(sb.derive("force", 2))
    assert "% No table" not in sb.to_latex(sb.balance(sb.load("v8-90"), 1), label="v8")


@pytest.mark.slow
def test_an_article_refers_to_the_tables_of_two_engines(compile_latex, tmp_path):
    tables = "".join(sb.to_latex(sb.balance(sb.load(name)), label=name) for name in ("v8-90", "v12-60"))
    head = "\\documentclass{article}\n\\usepackage{amsmath,booktabs}\n\\begin{document}\n"
    compile_latex(head + tables + "\\end{document}\n")  # references are known to the second run
    labels = re.findall(r"\\label\{(.*?)\}", tables)
    text = "".join(f"See table~\\ref{{{label}}}.\n" for label in labels)
    compile_latex(head + text + tables + "\\end{document}\n")
    log = (tmp_path / "document.log").read_text(encoding="utf-8", errors="replace")
    assert "undefined" not in log
    assert "multiply defined" not in log
    numbers = re.findall(
        r"\\newlabel\{tab:(.*?)\}\{\{(\d+)\}", (tmp_path / "document.aux").read_text(encoding="utf-8")
    )
    assert dict(numbers)["v8-90-force"] == "1"
    assert [int(number) for _, number in numbers] == list(range(1, len(numbers) + 1))
