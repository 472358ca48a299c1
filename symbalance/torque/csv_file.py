"""Pressure traces as files: two columns, read strictly, refused with file, line and remedy."""

from __future__ import annotations

import re
from pathlib import Path

from symbalance.engine.engine import checked_strokes
from symbalance.errors import SymbalanceError, shown
from symbalance.text.files import read_text
from symbalance.text.measurements import reading
from symbalance.torque.pressure import PressureTrace, Row, from_rows

LARGEST_FILE = 20_000_000
"""Bytes: some hundred thousand points, whatever their digits."""
_SEPARATOR = re.compile(r"[,;\t]")
_OTHER_UNIT = re.compile(r"\b([kMh]?Pa|psia?|atm|rad|mbar)\b", re.IGNORECASE)


def read_pressure(path: str | Path, *, strokes: int = 4) -> PressureTrace:
    """Return the trace in a CSV file: crank angle in degrees after firing top dead centre, bar absolute.

    One point a line, the columns parted by a comma, a semicolon or a tab, decimals with a point; a
    header, empty lines and lines that begin with # are passed over. Every refusal names file and line.
    The rules for the points are those of `pressure_trace`.
    """
    cycle = 180 * checked_strokes(strokes)
    try:
        text = read_text(path, LARGEST_FILE)
    except SymbalanceError as problem:
        what, rule = problem.what, problem.rule
        raise SymbalanceError(what, rule, "name a CSV file of angles and pressures") from None
    return parse_pressure(text, str(path), cycle)


def parse_pressure(text: str, place: str, cycle: int = 720) -> PressureTrace:
    """Return the trace that the text of a CSV file holds; `place` is what errors call it.

    >>> text = "angle,bar" + "".join(f"{chr(10)}{a},1.5" for a in range(0, 720, 5))
    >>> parse_pressure(text, "trace.csv").at(2)
    1.5
    """
    lines = ((f"{place}:{i}", line.strip()) for i, line in enumerate(text.splitlines(), 1))
    told = [(where, line) for where, line in lines if line and not line.startswith("#")]
    if told and _is_header(told[0][1]):
        _check_header(*told.pop(0))
    return from_rows([_row(where, line) for where, line in told], cycle, place)


def _is_header(line: str) -> bool:
    return not re.search(r"\d", re.split(_SEPARATOR, line)[0])


def _check_header(where: str, line: str) -> None:
    other = _OTHER_UNIT.search(line)
    if other:
        what, rule = f"header {shown(line)!r}", f"names {other[0]}, and this reads degrees and bar"
        raise SymbalanceError(what, rule, "convert the column, and its name", where)


def _row(where: str, line: str) -> Row:
    cells = re.split(_SEPARATOR, line)
    if len(cells) != 2:
        what, rule = f"line {shown(line)!r}", f"has {len(cells)} columns, not 2"
        raise SymbalanceError(what, rule, "write angle, pressure, decimals with a point", where)
    try:
        return where, reading(cells[0].strip(), "angle"), reading(cells[1].strip(), "pressure")
    except SymbalanceError as problem:
        raise problem.within(where) from None
