"""A pressure trace for whole arrays of crank angles."""

from __future__ import annotations

import numpy as np

from symbalance.crankshaft.rotor import Array
from symbalance.torque import PressureTrace


def pressures(trace: PressureTrace, angles: Array) -> Array:
    """Return the pressures in bar at angles (radians) after the firing top dead centre.

    Straight lines between the points; at a jump the value behind it, as `PressureTrace.at`.

    >>> trace = PressureTrace((0.0, 180.0, 360.0, 540.0), (3.0, 1.0, 1.0, 1.0))
    >>> pressures(trace, np.radians([90.0, 630.0, -90.0])).tolist()
    [2.0, 2.0, 2.0]
    """
    points, values = np.array(trace.radians), np.array(trace.closed)
    cycle = points[-1] - points[0]
    places = points[0] + np.mod(angles - points[0], cycle)
    i = np.clip(np.searchsorted(points, places, side="right") - 1, 0, len(points) - 2)
    width = points[i + 1] - points[i]
    share = np.where(width > 0, (places - points[i]) / np.where(width > 0, width, 1.0), 0.0)
    return values[i] + share * (values[i + 1] - values[i])
