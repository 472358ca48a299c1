"""Oil films from tables of stiffness and damping over the crank angle: checks, splines, CSV files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.system import Film
from symbalance.errors import MissingPartError, SymbalanceError, brief
from symbalance.text.csv_rows import CsvRow, rows_of, without_headers
from symbalance.text.files import read_text

INSTALL = "pip install 'symbalance[crankshaft]'"
WHAT = "a CSV file of film coefficients"
LEAST_ANGLES = 4
COEFFICIENTS = ("kvv", "kvl", "klv", "kll", "cvv", "cvl", "clv", "cll")
MOST_ROWS = 100_000
LARGEST_FILE = 20_000_000
"""Bytes: a row for every tenth of a degree of a dozen bearings, whatever the digits."""


def film_from_tables(theta: Array, stiffness: Array, damping: Array, cycle: float) -> Film:
    """Return the film whose coefficients at angles (s,) are (s, b, 2, 2), by periodic cubic splines.

    Two derivatives are continuous: the error falls with the fourth power of the angles' spacing, and a
    fifth-order method keeps its order where its steps end on the table's angles. Refuses tables that no
    film has: see `check_table`.
    """
    check_table(theta, stiffness, damping, cycle)
    return Film(_spline(theta, stiffness, cycle), _spline(theta, damping, cycle))


def trigonometric_film(stiffness: Array, damping: Array, cycle: float) -> Film:
    """Return the film through tables (s, b, 2, 2) at s equal angles from 0, by trigonometric polynomials.

    Smooth without end, so that it limits no method's order; it rings where the table is too coarse.

    >>> table = np.cos(np.arange(8) * np.pi / 4)[:, None, None, None] * np.eye(2)
    >>> film = trigonometric_film(table, table, 2 * np.pi)
    >>> film.stiffness(np.array([0.3]))[0, 0].round(6)
    array([[0.955336, 0.      ],
           [0.      , 0.955336]])
    """
    return Film(_waves(stiffness, cycle), _waves(damping, cycle))


def check_table(theta: Array, stiffness: Array, damping: Array, cycle: float) -> None:
    """Refuse what no film's table can be; place, rule and remedy in the refusal.

    Angles rise from 0 or above to below the cycle; all is finite; the damping's symmetric part is
    positive definite at every angle, as a film that does not dissipate in some direction does not exist.
    """
    if len(theta) < LEAST_ANGLES or not (np.diff(theta) > 0).all() or theta[0] < 0 or theta[-1] >= cycle:
        degrees = f"{np.degrees(cycle):g}"
        rule = f"must be at least {LEAST_ANGLES}, rising, from 0 to below {degrees} degrees"
        raise SymbalanceError(
            f"{len(theta)} angles", rule, "the last angle of the cycle is its first again"
        )
    for name, table in (("stiffness", stiffness), ("damping", damping)):
        shape = np.shape(table)
        if len(shape) != 4 or shape[0] != len(theta) or shape[2:] != (2, 2):
            rule = f"must be ({len(theta)}, bearings, 2, 2)"
            raise SymbalanceError(
                f"{name} of shape {shape}", rule, "a 2 x 2 matrix an angle and a bearing"
            )
        if not np.isfinite(table).all():
            row, bearing = np.argwhere(~np.isfinite(table))[0][:2]
            raise SymbalanceError(name, "must be finite", "", _place(float(theta[row]), int(bearing)))
    symmetric = (damping + np.swapaxes(damping, -1, -2)) / 2
    least = np.linalg.eigvalsh(symmetric)[..., 0]
    if not (least > 0).all():
        row, bearing = np.argwhere(least <= 0)[0]
        what = f"damping with least eigenvalue {brief(float(f'{least[row, bearing]:.4g}'))} N s/m"
        rule = "must be positive definite in its symmetric part: a film takes energy out"
        remedy = "look for a sign, or for rows and columns in another order"
        raise SymbalanceError(what, rule, remedy, _place(float(theta[row]), int(bearing)))


def _place(theta: float, bearing: int) -> str:
    return f"bearing {bearing + 1} at {np.degrees(theta):g} degrees"


def _spline(theta: Array, table: Array, cycle: float) -> Callable[[Array], Array]:
    try:
        from scipy.interpolate import CubicSpline
    except ImportError:
        raise MissingPartError("bearing tables", "SciPy is not installed", INSTALL) from None
    around = np.concatenate([table, table[:1]])
    spline = CubicSpline(np.append(theta, theta[0] + cycle), around, bc_type="periodic")
    return lambda angles: spline(theta[0] + (angles - theta[0]) % cycle)


def _waves(table: Array, cycle: float) -> Callable[[Array], Array]:
    count = len(table)
    parts = np.fft.rfft(table.reshape(count, -1), axis=0) / count
    parts[1 : (count + 1) // 2] *= 2
    orders = 2 * np.pi / cycle * np.arange(len(parts))

    def at(angles: Array) -> Array:
        phase = np.multiply.outer(angles, orders)
        values = np.cos(phase) @ parts.real - np.sin(phase) @ parts.imag
        return values.reshape(len(angles), *table.shape[1:])

    return at


def read_film(path: str | Path, bearings: int, cycle: float) -> Film:
    """Return the film of a CSV file; `cycle` in radians.

    Columns: crank angle in degrees, then for each bearing, front to rear, kvv kvl klv kll in N/m and
    cvv cvl clv cll in N s/m, v vertical, l lateral, the force's direction first. Columns are parted by
    commas, semicolons or tabs; empty lines, lines that begin with # and one line of column names are
    passed over. An error names file, line, rule and remedy.
    """
    theta, stiffness, damping = _numbers(Path(path), bearings)
    try:
        return film_from_tables(theta, stiffness, damping, cycle)
    except SymbalanceError as problem:
        raise problem.within(str(path)) from None


def _numbers(path: Path, bearings: int) -> tuple[Array, Array, Array]:
    place, text = str(path), read_text(path, LARGEST_FILE, WHAT, pipes=False)
    _, rows = without_headers(rows_of(text, place))
    if not 0 < len(rows) <= MOST_ROWS:
        rule, remedy = f"must be 1 to {MOST_ROWS}", "write one row a crank angle"
        raise SymbalanceError(f"{len(rows)} rows", rule, remedy, place)
    names = ["angle", *(f"{name} of bearing {i + 1}" for i in range(bearings) for name in COEFFICIENTS)]
    values = np.array([_row(row, names) for row in rows])
    table = values[:, 1:].reshape(len(values), bearings, 2, 2, 2)
    return np.radians(values[:, 0]), table[:, :, 0], table[:, :, 1]


def _row(row: CsvRow, names: list[str]) -> list[float]:
    row.check_width(len(names), f"degrees, then for each bearing {', '.join(COEFFICIENTS)}")
    return [row.number(column, name) for column, name in enumerate(names)]
