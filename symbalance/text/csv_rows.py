"""Reading of CSV files with any usual separator: rows of cells, each with its line number.

Cells are parted by semicolons, else by tabs, else by commas: a line's own separator counts, so that a
name in a file of semicolons may hold a comma. A cell may stand in double quotes. Empty lines and lines
that begin with # are passed over; decimals have a point. A refusal names file, line, value and rule.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Sequence
from fractions import Fraction
from math import isfinite
from typing import NamedTuple

from symbalance.errors import SymbalanceError, brief
from symbalance.text.measurements import as_float
from symbalance.text.numbers import exact

_DIGIT = re.compile(r"\d")


class CsvRow(NamedTuple):
    """One line's cells, without the spaces around them; `place` is its file and line number."""

    place: str
    text: str
    cells: tuple[str, ...]

    def check_width(self, count: int, remedy: str) -> None:
        """Refuse a row of more or fewer than `count` cells."""
        if len(self.cells) != count:
            # The line itself is not quoted: it may be of a file that is no table, and nobody's business.
            rule = f"has {len(self.cells)} columns, not {count}"
            raise SymbalanceError("the line", rule, remedy, self.place)

    def number(self, column: int, name: str) -> float:
        """Return a cell's number as a double; `name` is what a refusal calls it.

        >>> rows_of("angle;bar\\n0;1.5e1", "trace.csv")[1].number(1, "bar")
        15.0
        """
        try:
            number = as_float(self.cells[column], name)
        except SymbalanceError as problem:
            raise self._refusal(problem, column) from None
        if not isfinite(number):
            what = f"{name} = {brief(self.cells[column])}"
            raise SymbalanceError(what, "is beyond all bounds", "check the unit", self.place)
        return number

    def exact(self, column: int, name: str) -> Fraction:
        """Return a cell's number as the fraction it says; `name` is what a refusal calls it."""
        try:
            return exact(self.cells[column], name)
        except SymbalanceError as problem:
            raise self._refusal(problem, column) from None

    def _refusal(self, problem: SymbalanceError, column: int) -> SymbalanceError:
        if "," in self.cells[column]:
            problem = SymbalanceError(problem.what, problem.rule, "write decimals with a point")
        return problem.within(self.place)


def rows_of(text: str, place: str) -> list[CsvRow]:
    """Return a CSV text's rows, headers among them; `place` is what errors call the file.

    >>> [row.cells for row in rows_of('# weighed\\nname,kg\\n\\n"left, front",0.4', "p.csv")]
    [('name', 'kg'), ('left, front', '0.4')]
    """
    lines = ((f"{place}:{number}", line.strip()) for number, line in enumerate(text.splitlines(), 1))
    return [CsvRow(at, line, _cells(line, at)) for at, line in lines if line and not line.startswith("#")]


def _cells(line: str, place: str) -> tuple[str, ...]:
    separator = ";" if ";" in line else "\t" if "\t" in line else ","
    cells = line.split(separator)
    if '"' in line:
        try:
            cells = next(csv.reader([line], delimiter=separator))
        except csv.Error:
            rule, remedy = "is no line of CSV", "shorten the text in quotes"
            raise SymbalanceError("the line", rule, remedy, place) from None
    return tuple([cell.strip() for cell in cells])


def without_headers(rows: Sequence[CsvRow], most: int | None = 1) -> tuple[list[CsvRow], list[CsvRow]]:
    """Return the headers a file of numbers begins with, `most` at most (None: any number), and the rest.

    A header is a row whose first cell holds no digit, or none of whose cells is a number.

    >>> headers, rest = without_headers(rows_of("theta_1,p_1\\n0,1", "trace.csv"))
    >>> [row.text for row in headers], [row.text for row in rest]
    (['theta_1,p_1'], ['0,1'])
    """
    count = 0
    while count < len(rows) and count != most and _is_header(rows[count]):
        count += 1
    return list(rows[:count]), list(rows[count:])


def _is_header(row: CsvRow) -> bool:
    return not _DIGIT.search(row.cells[0]) or not any(map(_is_number, row.cells))


def _is_number(cell: str) -> bool:
    try:
        as_float(cell, "")
    except SymbalanceError:
        return False
    return True


def check_units(header: CsvRow, foreign: re.Pattern[str], expected: str) -> None:
    """Refuse a header that names a unit among `foreign`, where the file is taken to hold `expected`."""
    unit = foreign.search(header.text)
    if unit:
        rule = f"names {unit[0]}, and this reads {expected}"
        raise SymbalanceError("the header", rule, "convert the column, and its name", header.place)
