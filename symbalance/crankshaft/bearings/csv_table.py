"""Film coefficients from a CSV file: degrees, then eight columns a bearing."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np

from symbalance.crankshaft.bearings.periodic import film_from_tables
from symbalance.crankshaft.rotor import Array
from symbalance.crankshaft.system import Film
from symbalance.errors import SymbalanceError, shown

COEFFICIENTS = ("kvv", "kvl", "klv", "kll", "cvv", "cvl", "clv", "cll")
MOST_ROWS = 100_000


def read_film(path: str | Path, bearings: int, cycle: float) -> Film:
    """Return the film of a CSV file; `cycle` in radians.

    Columns: crank angle in degrees, then for each bearing, front to rear, kvv kvl klv kll in N/m and
    cvv cvl clv cll in N s/m, v vertical, l lateral, the force's direction first. Lines that begin with #
    and one line of column names are passed over. An error names file, line, rule and remedy.
    """
    theta, stiffness, damping = _numbers(Path(path), bearings)
    try:
        return film_from_tables(theta, stiffness, damping, cycle)
    except SymbalanceError as problem:
        raise problem.within(str(path)) from None


def _numbers(path: Path, bearings: int) -> tuple[Array, Array, Array]:
    try:
        with path.open(encoding="utf-8-sig", newline="") as stream:
            rows = [(n, row) for n, row in enumerate(csv.reader(stream), 1) if row]
    except (OSError, UnicodeError, csv.Error) as problem:
        reason = getattr(problem, "strerror", None) or "it is no CSV text"
        raise SymbalanceError(str(path), f"cannot be read ({reason})", "name a CSV file") from None
    rows = [(n, row) for n, row in rows if not row[0].lstrip().startswith("#")]
    if rows and not _is_number(rows[0][1][0]):
        rows = rows[1:]
    if not 0 < len(rows) <= MOST_ROWS:
        raise SymbalanceError(f"{len(rows)} rows", f"must be 1 to {MOST_ROWS}", "", str(path))
    values = np.array([_row(path, n, row, 1 + 8 * bearings) for n, row in rows])
    table = values[:, 1:].reshape(len(values), bearings, 2, 2, 2)
    return np.radians(values[:, 0]), table[:, :, 0], table[:, :, 1]


def _row(path: Path, line: int, row: list[str], width: int) -> list[float]:
    place = f"{path}:{line}"
    if len(row) != width:
        rule = f"must have {width} columns"
        raise SymbalanceError(
            f"{len(row)} columns", rule, f"degrees, then {', '.join(COEFFICIENTS)}", place
        )
    for text in row:
        if not _is_number(text):
            raise SymbalanceError(shown(repr(text)), "must be a number", "write 1.2e8 or -3400", place)
    return [float(text) for text in row]


def _is_number(text: str) -> bool:
    try:
        return bool(np.isfinite(float(text)))
    except ValueError:
        return False
