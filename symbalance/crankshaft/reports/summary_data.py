"""A run's numbers for other programs: in MPa, Hz, rpm, N and hours; None where infinite or not known."""

from __future__ import annotations

from math import isfinite
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from symbalance.crankshaft.reports.summary import Summary

MEGA = 1e6


def summary_data(run: Summary) -> dict[str, Any]:
    """Return what `to_json` writes of a run.

    A speed with a `reason` is not to be relied on: channels, places and measured curves leave it out.
    """
    return {
        "engine": run.setting.engine.layout.name,
        "webs": run.setting.webs,
        "modes": run.setting.modes,
        "connection": run.setting.connection,
        "natural_frequencies": [{"hertz": f, "mostly": kind} for f, kind in run.frequencies],
        "speeds": [_finite(vars(s)) for s in run.speeds],
        "channels": [_finite(vars(e)) for e in run.extremes],
        "places": [
            {
                "name": p.name,
                "rpm": p.rpm,
                "amplitude": p.found.amplitude / MEGA,
                "mean": p.found.mean / MEGA,
                **_finite({"safety": p.found.safety, "damage": p.found.damage, "hours": p.hours}),
            }
            for p in run.places
        ],
        "measured": [
            {"rpm": c.rpm, "channel": c.channel, "rms": c.rms, "peak": c.peak, "span": c.span}
            for c in run.comparisons
        ],
        "notes": list(run.notes),
    }


def summary_records(run: Summary) -> list[dict[str, Any]]:
    """Return a row for each channel at each speed that is to be relied on.

    Keys: rpm, channel, unit (MPa or degrees), least and largest value of the cycle.
    """
    rows = []
    for outcome in run.reliable:
        for name, unit, values in zip(outcome.names, outcome.units, outcome.values.T, strict=True):
            shown, scale = ("MPa", MEGA) if unit == "Pa" else (unit, 1.0)
            least, largest = float(values.min()) / scale, float(values.max()) / scale
            row = {"rpm": float(outcome.rpm), "channel": name, "unit": shown}
            rows.append({**row, "least": least, "largest": largest})
    return rows


def _finite(values: dict[str, Any]) -> dict[str, Any]:
    return {k: None if isinstance(v, float) and not isfinite(v) else _plain(v) for k, v in values.items()}


def _plain(value: Any) -> Any:
    """Return tuples as lists, as JSON has them."""
    return [_plain(each) for each in value] if isinstance(value, tuple) else value
