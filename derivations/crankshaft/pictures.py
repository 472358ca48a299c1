"""The pictures and the figures of the worked cranks, from their engine files.

    python derivations/crankshaft/pictures.py [OUT]      some minutes; OUT keeps finished speeds

Writes diesel-4-*.png and diesel-6-*.png into derivations/pictures and figures.json beside this file: what
crankshaft-running.md quotes of full resolution.
"""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from symbalance.crankshaft.files import read_running_engine
from symbalance.crankshaft.loads import firing_crank_angles
from symbalance.crankshaft.reports import summarise_run
from symbalance.crankshaft.reports.pictures import draw_pictures
from symbalance.crankshaft.running import RunConfiguration, SpeedOutcome, configure_run, run_speeds
from symbalance.jobs import LogProgress

HERE = Path(__file__).parent
SHOWN = ("pin-bending", "pin-torsion", "films", "orbits", "frequencies", "campbell", "waterfall")
SPEEDS = {
    "inline-4": [1000, 1400, 1800, 2200],
    "inline-6": [1000, 1400, 1900, 2400],
}
HIGH = 6
"""Orders above this count as high."""


def main(arguments: list[str]) -> None:
    """Run both engines and write pictures and figures."""
    kept = Path(arguments[0]) if arguments else None
    found = {name: _run(name, kept) for name in SPEEDS}
    text = json.dumps(found, indent=1) + "\n"
    (HERE / "figures.json").write_text(text, encoding="utf-8")


def _run(name: str, kept: Path | None) -> dict[str, Any]:
    engine = read_running_engine(HERE / f"{name}.toml").at_speeds(SPEEDS[name])
    made = configure_run(engine)
    folder = None if kept is None else kept / name
    outcomes = run_speeds(made, folder, LogProgress())
    if refused := [f"{name}, {o.rpm:g} rpm: {o.reason}" for o in outcomes if o.reason]:
        sys.exit("\n".join(refused))
    found = summarise_run(made, outcomes)
    for picture, data in draw_pictures(found).items():
        if picture.removesuffix(".png") in SHOWN:
            (HERE.parent / "pictures" / f"{engine.engine.name}-{picture}").write_bytes(data)
    last = outcomes[-1]
    centre = replace(made, about="centre", iterations=1, steps=last.steps)
    paper = run_speeds(centre.at_speeds((SPEEDS[name][-1],)), folder and folder / "centre")[0]
    return {
        "bending": {str(o.rpm): _peaks(made, o) for o in outcomes},
        "high": {str(o.rpm): _high(o) for o in outcomes},
        "worst": {"place": found.worst.name, "safety": found.worst.durability.safety},
        "clearance": {"orbit": max(map(_widest, outcomes)), "centre": _widest(paper)},
        "centre": float(np.abs(paper.values - last.values).max() / np.abs(last.values).max()),
        "departure": max(o.departure for o in outcomes),
        "multiplier": last.largest,
    }


def _widest(outcome: SpeedOutcome) -> float:
    """Return the largest share of its clearance that an orbit takes."""
    return float(outcome.eccentricity.max())


def _peaks(made: RunConfiguration, outcome: SpeedOutcome) -> dict[str, list[float]]:
    """Return each pin's bending in MPa: its largest, its least, its range away from its own firing."""
    return {
        str(k): [float(x) / 1e6 for x in (v.max(), v.min(), np.ptp(v[_away(made, outcome, k)]))]
        for k in range(1, len(made.engine.crank.pins) + 1)
        for v in [outcome.channel(f"pin {k} bending")]
    }


def _away(made: RunConfiguration, outcome: SpeedOutcome, pin: int) -> np.ndarray:
    """Return the angles further than 90 degrees from the firing of a pin's own cylinders."""
    tops = firing_crank_angles(made.engine.engine)
    own = [np.degrees(tops[n]) for n in made.engine.crank.pins[pin - 1].cylinders]
    cycle = np.degrees(outcome.cycle)
    off = [np.abs(np.mod(outcome.degrees - top + cycle / 2, cycle) - cycle / 2) for top in own]
    return np.min(off, axis=0) > 90


def _high(outcome: SpeedOutcome) -> dict[str, float]:
    """Return the root mean square of each pin's bending and torsion above order `HIGH`, MPa."""
    names = [n for n in outcome.names if n.startswith("pin ") and not n.endswith("sideways")]
    found = {}
    for name in names:
        orders, sizes = outcome.orders(name)
        found[name] = float(np.sqrt((sizes[orders > HIGH] ** 2).sum() / 2) / 1e6)
    return found


if __name__ == "__main__":
    main(sys.argv[1:])
