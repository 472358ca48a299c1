"""Evidence: the rows that are read from a CSV file are those that were written into it.

Files are written cell by cell in the ways that people and spreadsheets use, and read back; a damaged cell
is refused with its own line.
"""

from __future__ import annotations

import io
import math
from fractions import Fraction
from pathlib import Path

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given

from symbalance.crankshaft.bearings.film_tables import read_film
from symbalance.crankshaft.running.measured import read_curve
from symbalance.design.variations.part_sets import parse_parts
from symbalance.errors import SymbalanceError
from symbalance.text.csv_rows import rows_of, without_headers
from symbalance.text.files import read_text
from symbalance.torque import parse_pressure

separators = st.sampled_from([",", ";", "\t", " , ", "; "])
fillers = st.lists(st.sampled_from(["", "# said before", "  ", "\t", " # 1,2"]), max_size=3)
numbers = st.decimals(-(10**6), 10**6, places=4) | st.integers(-(10**6), 10**6)
ends = st.sampled_from(["\n", "\r\n"])


@st.composite
def files(draw: st.DrawFn) -> tuple[str, list[int], list[list[str]]]:
    """Return a CSV text, the lines its rows stand on and their cells, quoted now and then."""
    width = draw(st.integers(1, 4))
    lines: list[str] = []
    at, rows = [], []
    for row in draw(st.lists(st.lists(numbers, min_size=width, max_size=width), max_size=6)):
        lines += draw(fillers)
        cells = [str(number) for number in row]
        written = [f'"{cell}"' if draw(st.booleans()) else cell for cell in cells]
        lines.append(draw(separators).strip(" ").join(written) + draw(st.sampled_from(["", " "])))
        at.append(len(lines))
        rows.append(cells)
    return draw(ends).join(lines), at, rows


@given(files())
def test_rows_are_those_written_on_the_lines_they_were_written_on(
    file: tuple[str, list[int], list[list[str]]],
) -> None:
    text, lines, cells = file
    rows = rows_of(text, "a.csv")
    assert [row.place for row in rows] == [f"a.csv:{line}" for line in lines]
    assert [list(row.cells) for row in rows] == cells
    for row, written in zip(rows, cells, strict=True):
        for column, cell in enumerate(written):
            assert row.exact(column, "x") == Fraction(cell)
            assert row.number(column, "x") == float(cell)


@pytest.mark.parametrize(
    ("text", "most", "headers"),
    [
        ("angle,bar\n0,1", 1, 1),
        ("theta_1,p_1\n0,1", 1, 1),  # digits in names, and no number
        ("angle,1,2\n0,1,2", 1, 1),  # columns that are counted
        ("angle,bar\ndeg,bar\n0,1", 1, 1),
        ("angle,bar\ndeg,bar\n0,1", None, 2),
        ("0,1\nangle,bar", None, 0),
        ("0°,1\n1,1", 1, 0),  # a damaged number beside a sound one is no header
        ("", 1, 0),
    ],
)
def test_headers_are_told_from_numbers(text: str, most: int | None, headers: int) -> None:
    first, rest = without_headers(rows_of(text, "a.csv"), most)
    assert (len(first), len(rest)) == (headers, len(text.splitlines()) - headers)


@pytest.mark.parametrize(
    ("cell", "words"),
    [
        ("1,5", "a.csv:3: x = 1,5: must be a number or a fraction; write decimals with a point"),
        ("1e999", "a.csv:3: x = 1e999: is beyond all bounds"),
        ("1_000", "a.csv:3: x = 1_000: must be a number"),
        ("nan", "a.csv:3: x = nan: must be a number"),
        ("", "a.csv:3: x = : must be a number"),
    ],
)
def test_a_cell_that_is_no_number_is_refused_where_it_stands(cell: str, words: str) -> None:
    row = rows_of(f"name;x\n\nA;{cell}\n", "a.csv")[1]
    with pytest.raises(SymbalanceError) as refusal:
        row.number(1, "x")
    assert str(refusal.value).startswith(words)


def test_a_quote_that_csv_cannot_read_is_refused() -> None:
    with pytest.raises(SymbalanceError, match=r"^a\.csv:2: the line: is no line of CSV"):
        rows_of('name,x\n"' + "A" * 200_000 + '",1', "a.csv")


def test_a_measured_value_beyond_the_doubles_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "gauge.csv"
    path.write_text("degrees,MPa\n" + "".join(f"{a},1\n" for a in range(0, 720, 60)) + "719,1e999\n")
    with pytest.raises(SymbalanceError, match=r"gauge\.csv:14: value = 1e999: is beyond all bounds"):
        read_curve(path)


@pytest.mark.parametrize("separator", [",", ";", "\t"])
@pytest.mark.parametrize("mark", ["", "\ufeff"])
def test_one_spelling_does_for_every_file(separator: str, mark: str, tmp_path: Path) -> None:
    """A byte order mark, a comment, an empty line, a header, quotes: as spreadsheets export them."""

    def written(header: str, rows: list[list[object]]) -> Path:
        path = tmp_path / "file.csv"
        lines = ["# exported", "", header.replace(",", separator)]
        lines += [separator.join(f'"{cell}"' for cell in row) for row in rows]
        path.write_text(mark + "\r\n".join(lines), encoding="utf-8", newline="")
        return path

    angles = range(0, 720, 10)
    trace = written("angle,bar", [[a, 1.5] for a in angles])
    assert parse_pressure(read_text(trace), "p").at(33) == 1.5
    curve = written("angle,MPa", [[a, math.sin(a)] for a in angles])
    assert np.array_equal(read_curve(curve)[1], [math.sin(a) for a in angles])
    film = written("deg,kvv", [[a, 1e8, 0, 0, 1e8, 1e5, 0, 0, 1e5] for a in angles])
    assert np.allclose(read_film(film, 1, 4 * math.pi).stiffness(np.array([1.0]))[0, 0, 0], [1e8, 0])
    parts = written("name,piston", [["left", 0.4], ["right", "1/3"]])
    (pistons,) = parse_parts(read_text(parts), "p")
    assert [(p.name, p.reciprocating) for p in pistons.parts] == [
        ("left", Fraction(2, 5)),
        ("right", Fraction(1, 3)),
    ]


def test_a_table_that_numpy_writes_is_a_film(tmp_path: Path) -> None:
    rows = [[a, 1e8, 0, 0, 1e8, 1e5, 0, 0, 1e5] for a in range(0, 720, 90)]
    for fmt in ("%.18e", "%g", "%d"):
        stream = io.StringIO()
        np.savetxt(stream, rows, fmt=fmt, delimiter=",", header="deg,k,c")
        (tmp_path / "film.csv").write_text(stream.getvalue(), encoding="utf-8")
        assert (
            read_film(tmp_path / "film.csv", 1, 4 * math.pi).damping(np.array([0.0]))[0, 0, 0, 0] == 1e5
        )
