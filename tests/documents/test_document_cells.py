"""What a document's cells and formulas come to in print: numbers not known, matrices."""

from __future__ import annotations

import re

import pytest

from symbalance.document.decimals import fixed, rounded
from symbalance.document.formula import INFINITY, Decimal, Equation, Matrix, Name, Subscript, number
from symbalance.document.html_document import document_html
from symbalance.document.latex_document import document_latex
from symbalance.document.markdown_document import document_markdown
from symbalance.document.nodes import UNKNOWN, Column, Document, Exact, Facts, Formulas, Table
from symbalance.document.text_document import document_text

TABLE = Table(
    "Speeds",
    (Column("rpm"), Column("load, kN"), Column("steps")),
    (
        (number(900), Decimal("12.75"), number(1440)),
        (number(2200), UNKNOWN, UNKNOWN),
        (number(3000), Decimal("-101.5"), number(90)),
    ),
)
MATRIX = Matrix(((Name("a"), -Name("b")), (Name("b"), number(0) * Name("c"))))


def columns_of(line: str) -> list[str]:
    return line.split()


def test_an_unknown_number_leaves_points_and_units_in_line() -> None:
    lines = document_text(Document("", (TABLE,))).splitlines()
    body = lines[-3:]
    assert [columns_of(line)[1:] for line in body] == [["12.75", "1440"], ["–", "–"], ["−101.5", "90"]]
    unit = body[0].index(".") - 1
    assert body[1][unit] == "–"
    assert body[2].index(".") - 1 == unit
    last = [line.rstrip() for line in body]
    assert len({len(line) for line in last}) == 1


@pytest.mark.parametrize("write", [document_html, document_latex, document_markdown])
def test_an_unknown_number_keeps_its_column_one_of_numbers(write) -> None:  # type: ignore[no-untyped-def]
    known = Table(TABLE.title, TABLE.columns, (TABLE.rows[0], TABLE.rows[2]))
    shape = {
        document_html: r'class="number">(?:<|–|\d|−)',
        document_latex: r"\\begin\{tabular\}.*",
        document_markdown: r"---:",
    }[write]
    with_unknown, without = (re.findall(shape, write(Document("", (t,)))) for t in (TABLE, known))
    assert without
    assert set(without) <= set(with_unknown)
    assert len(with_unknown) == len(without) + (3 if write is document_html else 0)


def test_a_matrix_is_drawn_row_by_row_where_it_fits() -> None:
    matrices = (Equation(Name(name), (("=", MATRIX),)) for name in "XZ")
    block = Formulas((*matrices, Equation(Name("Ym"), (("=", Name("a")),))))
    drawn = document_text(Document("", (block,))).splitlines()
    rows = ["   X = [ a  −b ]", "       [ b  0c ]"]
    assert drawn[-6:] == [*rows, "", rows[0].replace("X", "Z"), rows[1], "  Ym = a"]


def test_a_matrix_that_does_not_fit_stands_in_one_line() -> None:
    wide = Matrix(((Name("a" * 40), Name("b" * 40)), (Name("c"), Name("d"))))
    text = document_text(Document("", (Formulas((Equation(Name("X"), (("=", wide),)),)),)))
    assert "; c, d]" in text


def test_lists_in_text_are_wrapped_and_names_stand_apart() -> None:
    long = "word " * 30
    entries = ((long, ""), ("name", "said"), ("n", "x"))
    lines = document_text(Document("", (Facts(entries),))).splitlines()
    assert max(map(len, lines)) < 80
    assert lines[-2:] == ["  name  said", "  n     x"]


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (1234.567, 4, "1235"),
        (99999.9, 3, "100000"),
        (0.00123456, 3, "0.00123"),
        (1e9, 5, "1e9"),
        (-0.0, 5, "0"),
        (9999999.9, 2, "1e7"),
    ],
)
def test_floats_are_rounded_to_significant_digits(value: float, digits: int, text: str) -> None:
    assert rounded(value, digits) == Decimal(text)


def test_what_is_not_finite_is_no_decimal() -> None:
    assert rounded(float("nan")) == fixed(float("nan"), 2) == UNKNOWN
    assert rounded(float("inf")) == fixed(float("inf"), 2) == INFINITY
    assert fixed(-0.001, 2) == Decimal("0.00")


def test_an_index_of_an_indexed_letter_compiles(compile_latex) -> None:  # type: ignore[no-untyped-def]
    entry = Subscript(Name("F_M"), number(1))
    block = Formulas((Equation(entry, (("=", Name("m")),)),))
    compile_latex(document_latex(Document("", (block,)), standalone=True))


@pytest.mark.parametrize("write", [document_html, document_latex, document_markdown, document_text])
def test_a_row_below_a_table_is_named_by_the_key_columns_that_are_left(write) -> None:  # type: ignore[no-untyped-def]
    """A key column without a cell is left out; the value beside it does not become a name."""
    wide = Exact(
        sum((Name(letter) for letter in "bcdefghijklmnopqrstuvwxyz" * 4), Name("a")), Decimal("0.25")
    )
    columns = (Column("order"), Column("component"), Column("size"))
    for name in ("", "vertical"):
        printed = write(Document("", (Table("", columns, ((number(3), name, wide),), keys=2),)))
        (below,) = [line for line in re.split(r"\n|<dt>|</dt>", printed) if "order 3" in line]
        assert re.search(r"order 3 (vertical )?size", below)
        assert ("vertical" in below) == bool(name)
