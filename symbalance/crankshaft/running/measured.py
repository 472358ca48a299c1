"""Comparison of a computed stress with a measured curve from a CSV file: mean and peak error."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.files.operation import Overlay
from symbalance.crankshaft.running.outcome import SpeedOutcome
from symbalance.errors import SymbalanceError, brief
from symbalance.text.csv_rows import CsvRow, rows_of, without_headers
from symbalance.text.files import read_text

FEWEST = 8
"""Points of a measured curve."""
MEGA = 1e6


@dataclass(frozen=True)
class Comparison:
    """A measured curve (degrees, MPa) compared with the computed stress channel, at one speed.

    `rms` and `peak` are the errors computed - measured, MPa: root mean square, and largest value minus
    largest value; `span` is the measured curve's whole range.
    """

    rpm: float
    channel: str
    degrees: Array
    values: Array
    rms: float
    peak: float
    span: float


def compare_with_measured(overlay: Overlay, outcome: SpeedOutcome) -> Comparison | None:
    """Return the comparison at an outcome's speed, None where the curve belongs to another one."""
    if overlay.rpm is not None and abs(overlay.rpm - outcome.rpm) > 1e-9 * outcome.rpm:
        return None
    cycle = round(np.degrees(outcome.cycle))
    check_overlay(overlay, outcome.names, cycle)
    degrees, values = read_curve(overlay.path, cycle)
    theta = np.append(outcome.degrees, cycle)
    curve = outcome.channel(overlay.channel) / MEGA
    there = np.interp(degrees % cycle, theta, np.append(curve, curve[0]))
    off = there - values
    rms, peak = float(np.sqrt(np.mean(off**2))), float(curve.max() - values.max())
    return Comparison(outcome.rpm, overlay.channel, degrees, values, rms, peak, float(np.ptp(values)))


def check_overlay(overlay: Overlay, names: Sequence[str], cycle: int) -> None:
    """Refuse a curve that cannot be compared: an unknown channel, a file that does not read."""
    if overlay.channel not in names:
        near = get_close_matches(overlay.channel, names, 3, 0.4) or names[:3]
        what = f"channel = {brief(overlay.channel)}"
        raise SymbalanceError(what, "names no channel of this crank", f"one of {', '.join(near)}, ...")
    read_curve(overlay.path, cycle)


def read_curve(path: str | Path, cycle: int = 720) -> tuple[Array, Array]:
    """Return the crank angles in degrees at theta's zero and the values in MPa of a CSV file.

    One point a line, parted by a comma, a semicolon or a tab, decimals with a point; a header, empty
    lines and lines that begin with # are passed over.
    """
    place, text = str(path), read_text(path, what="a CSV file of measured curves", pipes=False)
    _, rows = without_headers(rows_of(text, place), None)
    points = [_point(row, cycle) for row in rows]
    if len(points) < FEWEST:
        rule = f"holds {len(points)} points, and a curve needs {FEWEST}"
        raise SymbalanceError(place, rule, "give crank angle in degrees and MPa, a point a line")
    curve = np.array(points)
    return curve[:, 0], curve[:, 1]


def _point(row: CsvRow, cycle: int) -> tuple[float, float]:
    row.check_width(2, "write crank angle, MPa")
    angle, value = row.number(0, "angle"), row.number(1, "value")
    if abs(angle) > cycle:
        what, rule = f"angle = {brief(angle)}", f"must lie in [{-cycle}, {cycle}] degrees"
        raise SymbalanceError(what, rule, "count from theta = 0", row.place)
    return angle, value
