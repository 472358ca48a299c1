"""Pressure traces in CSV files: two columns, read strictly, refused with file, line and remedy."""

from __future__ import annotations

import re
from pathlib import Path

from symbalance.engine.engine import checked_strokes
from symbalance.text.csv_rows import CsvRow, check_units, rows_of, without_headers
from symbalance.text.files import file_name, read_text
from symbalance.torque.pressure import Point, PressureTrace, from_rows

LARGEST_FILE = 20_000_000
"""Bytes: some hundred thousand points, whatever their digits."""
_OTHER_UNIT = re.compile(r"\b([kMh]?Pa|psia?|atm|rad|mbar)\b", re.IGNORECASE)


def read_pressure(path: str | Path, *, strokes: int = 4) -> PressureTrace:
    """Return the pressure trace in a CSV file: degrees after firing top dead centre, bar absolute.

    One point a line, the columns parted by a comma, a semicolon or a tab, decimals with a point; a
    header, empty lines and lines that begin with # are passed over. Every refusal names file and line.
    The rules for the points are those of `pressure_trace`.
    """
    cycle = 180 * checked_strokes(strokes)
    text = read_text(path, LARGEST_FILE, "a CSV file of angles and pressures")
    return parse_pressure(text, file_name(path), cycle)


def parse_pressure(text: str, place: str, cycle: int = 720) -> PressureTrace:
    """Return the pressure trace in a CSV text; error messages call the text `place`.

    >>> text = "angle,bar" + "".join(f"{chr(10)}{a},1.5" for a in range(0, 720, 5))
    >>> parse_pressure(text, "trace.csv").at(2)
    1.5
    """
    headers, rows = without_headers(rows_of(text, place))
    for header in headers:
        check_units(header, _OTHER_UNIT, "degrees and bar")
    return from_rows([_point(row) for row in rows], cycle, place)


def _point(row: CsvRow) -> Point:
    row.check_width(2, "write angle, pressure, decimals with a point")
    return row.place, row.number(0, "angle"), row.number(1, "pressure")
