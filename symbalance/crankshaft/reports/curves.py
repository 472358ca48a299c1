"""Curves of a run over the crank angle as CSV, for other programs."""

from __future__ import annotations

import numpy as np

from symbalance.crankshaft.files.operation import speed_text
from symbalance.crankshaft.reports.summary import MEGA
from symbalance.crankshaft.running.configuration import RunConfiguration
from symbalance.crankshaft.running.outcome import SpeedOutcome


def curves_csv(outcome: SpeedOutcome) -> str:
    """Return a speed's channels, bearing loads (N) and orbits (mm) against the crank angle (degrees).

    Of a speed that is not to be relied on: a line that says why, the names, and no values.
    """
    scale = np.array([1 / MEGA if unit == "Pa" else 1.0 for unit in outcome.units])
    names = [
        f"{n} [{'MPa' if u == 'Pa' else u}]" for n, u in zip(outcome.names, outcome.units, strict=True)
    ]
    columns = [outcome.degrees, *(outcome.values * scale).T]
    for j in range(len(outcome.clearance)):
        for axis, direction in enumerate(("vertical", "lateral")):
            names += [f"bearing {j + 1} {direction} [N]", f"journal {j + 1} {direction} [mm]"]
            columns += [outcome.bearings[:, j, axis], outcome.orbits[:, j, axis] * 1000]
    head = ",".join(["crank angle [degrees]", *names])
    if outcome.reason:
        return f"# {speed_text(outcome.rpm)} rpm: {outcome.reason}\n{head}\n"
    lines = [head, *(",".join(f"{x:.7g}" for x in row) for row in zip(*columns, strict=True))]
    return "\n".join(lines) + "\n"


def loads_csv(outcome: SpeedOutcome, configuration: RunConfiguration) -> str:
    """Return the rods' forces on every pin (N) along U and V, turning axes, against the crank angle.

    Gas and inertia of piston and rod; the big ends turn with their pins and are no part of it.
    """
    loads = configuration.rotor_loads(outcome.rpm).pins.at(outcome.theta)
    count = loads.shape[1]
    names = [f"pin {k} {axis} [N]" for k in range(1, count + 1) for axis in "UV"]
    rows = np.column_stack([outcome.degrees, loads[:, :, :2].reshape(len(loads), -1)])
    lines = [",".join(["crank angle [degrees]", *names])]
    lines += [",".join(f"{x:.7g}" for x in row) for row in rows]
    return "\n".join(lines) + "\n"
