"""The figures of a crankshaft's run: speeds, extremes, durability; every report of a run prints them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import groupby
from math import isfinite
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from symbalance.crankshaft.files.operation import speed_text
from symbalance.crankshaft.rotor.modes import dominant_motions
from symbalance.crankshaft.running.configuration import RunConfiguration
from symbalance.crankshaft.running.measured import Comparison, compare_with_measured
from symbalance.crankshaft.running.outcome import SpeedOutcome
from symbalance.crankshaft.stress import Durability, durability
from symbalance.crankshaft.stress.concentration import FILLET_ASSUMPTION
from symbalance.crankshaft.webs.beam_webs import WEB_ASSUMPTION
from symbalance.document.result import Result

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

MEGA = 1e6
SHOWN_ORDERS = 4
MOST_NAMED = 4
"""Speeds that a line names."""
UNSTABLE = 1 + 1e-9
"""A Floquet multiplier above this grows."""
COARSE = 0.05
"""The step error, of the largest stress, beyond which a speed's stresses are not to be relied on."""


@dataclass(frozen=True)
class ChannelRange:
    """A channel's least and largest value over all speeds, MPa or degrees; where it is largest."""

    name: str
    unit: str
    least: float
    largest: float
    rpm: float
    orders: tuple[tuple[float, float], ...]
    """The largest orders at that speed, mean left out: (order, amplitude)."""


@dataclass(frozen=True)
class PlaceDurability:
    """Durability at a place, under its normal and shear stress together, at its worst speed."""

    name: str
    rpm: float
    durability: Durability
    hours: float


@dataclass(frozen=True)
class SpeedFigures:
    """Figures of one speed: journal displacement/clearance, departure from orbits, bearing load (N).

    Then the largest Floquet multiplier, the step error and seconds; the steps of a cycle. With a
    `reason` the speed has no stresses, and what is NaN here is not known.
    """

    rpm: float
    eccentricity: float
    departure: float
    bearing: float
    largest: float
    error: float
    seconds: float
    steps: int
    reason: str | None


@dataclass(frozen=True, repr=False)
class Summary(Result):
    """All figures of a run; extremes, places and comparisons come from the `reliable` speeds only.

    `draw_pictures` are PNG by file name, none before `with_pictures`.
    """

    configuration: RunConfiguration
    outcomes: tuple[SpeedOutcome, ...]
    frequencies: tuple[tuple[float, str], ...]
    """The free crank's natural frequencies in Hz, and what mostly moves."""
    speeds: tuple[SpeedFigures, ...]
    extremes: tuple[ChannelRange, ...]
    places: tuple[PlaceDurability, ...]
    comparisons: tuple[Comparison, ...]
    notes: tuple[str, ...]
    pictures: Mapping[str, bytes] = field(default_factory=dict)

    kind: ClassVar[str] = "crankshaft"

    def summary(self) -> str:
        """Return the speeds and the least safety factor, in one line."""
        speeds = ", ".join(speed_text(s.rpm) for s in self.speeds[:MOST_NAMED])
        more = f", … ({len(self.speeds)} speeds)" if len(self.speeds) > MOST_NAMED else ""
        if not self.reliable:
            verdict = "no speed is to be relied on"
        else:
            worst = self.worst
            verdict = f"least safety factor {worst.durability.safety:.2f}, of {worst.name}"
        return f"Crankshaft of {self.configuration.engine.engine.name} at {speeds}{more} rpm: {verdict}"

    def document(self) -> Document:
        """Return speeds, durability, stresses, frequencies, notes, how it was computed, and pictures."""
        from symbalance.crankshaft.reports.summary_document import summary_document

        return summary_document(self)

    def data(self) -> dict[str, Any]:
        """Return the figures in MPa, Hz, rpm, N and hours; None where infinite or not known."""

        return summary_data(self)

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each channel at each speed that is to be relied on."""

        return summary_records(self)

    def with_pictures(self) -> Summary:
        """Return the run with its pictures drawn; refused without matplotlib."""
        from symbalance.crankshaft.reports.pictures import draw_pictures

        return replace(self, pictures=draw_pictures(self))

    @property
    def reliable(self) -> tuple[SpeedOutcome, ...]:
        """The speeds whose values are to be relied on."""
        return tuple(o for o in self.outcomes if not o.reason)

    @property
    def assumptions(self) -> tuple[str, ...]:
        """What the figures rest on that was not compared with its source."""
        return (FILLET_ASSUMPTION, *((WEB_ASSUMPTION,) if self.configuration.webs == "formula" else ()))

    @property
    def worst(self) -> PlaceDurability:
        """The place of the least safety factor; there is one where a speed is reliable."""
        return min(self.places, key=lambda place: place.durability.safety)

    @property
    def valid(self) -> bool:
        """Whether all is to be relied on, in its clearance, stable, of fine steps and safe."""
        calm = all(
            o.within_clearance and not o.largest > UNSTABLE and o.error <= COARSE for o in self.reliable
        )
        every = len(self.reliable) == len(self.outcomes)
        return every and calm and self.worst.durability.safety >= 1


def summarise_run(configuration: RunConfiguration, outcomes: Sequence[SpeedOutcome]) -> Summary:
    """Return the figures of a run."""
    motions = dominant_motions(configuration.rotor, configuration.modes_at_rest)
    overlay = configuration.engine.operation.overlay
    reliable = [o for o in outcomes if not o.reason]
    comparisons = [c for o in reliable if overlay and (c := compare_with_measured(overlay, o))]
    return Summary(
        configuration,
        tuple(outcomes),
        tuple(zip(map(float, configuration.modes_at_rest.frequencies), motions, strict=True)),
        tuple(_speed(outcome) for outcome in outcomes),
        tuple(_extreme(name, reliable) for name in outcomes[0].names if reliable),
        tuple(_places(configuration, reliable) if reliable else ()),
        tuple(comparisons),
        tuple(_notes(configuration, outcomes)),
    )


def _speed(outcome: SpeedOutcome) -> SpeedFigures:
    loads = np.hypot(outcome.bearings[..., 0], outcome.bearings[..., 1])
    return SpeedFigures(
        outcome.rpm,
        float(outcome.eccentricity.max()),
        outcome.departure,
        float("nan") if outcome.reason else float(loads.max()),
        float("nan") if outcome.reason else outcome.largest,
        outcome.error,
        outcome.seconds,
        outcome.steps,
        outcome.reason or None,
    )


def _extreme(name: str, outcomes: Sequence[SpeedOutcome]) -> ChannelRange:
    unit = outcomes[0].units[outcomes[0].names.index(name)]
    scale = 1 / MEGA if unit == "Pa" else 1.0
    curves = [outcome.channel(name) * scale for outcome in outcomes]
    worst = max(range(len(curves)), key=lambda i: np.abs(curves[i]).max())
    orders, sizes = outcomes[worst].orders(name)
    strongest = sorted(range(1, len(orders)), key=lambda k: -sizes[k])[:SHOWN_ORDERS]
    return ChannelRange(
        name,
        "MPa" if unit == "Pa" else unit,
        float(min(c.min() for c in curves)),
        float(max(c.max() for c in curves)),
        outcomes[worst].rpm,
        tuple((float(orders[k]), float(sizes[k] * scale)) for k in strongest),
    )


def _places(configuration: RunConfiguration, outcomes: Sequence[SpeedOutcome]) -> list[PlaceDurability]:
    """Return the durability of every place that has a bending and a torsion channel."""
    stresses = [
        c.name for c in configuration.channels if c.unit == "Pa" and not c.name.endswith("sideways")
    ]
    places = []
    for name, pair in groupby(stresses, lambda n: n.rsplit(" ", 1)[0]):
        bending, torsion = pair
        strength = configuration.engine.operation.strength
        rows = [(o, durability(o.channel(bending), o.channel(torsion), strength)) for o in outcomes]
        outcome, worst = min(rows, key=lambda row: row[1].safety)
        places.append(PlaceDurability(name, outcome.rpm, worst, worst.hours(outcome.cycle_time)))
    return places


def _notes(configuration: RunConfiguration, outcomes: Sequence[SpeedOutcome]) -> list[str]:
    """Return what a reader must know before relying on the figures."""
    notes = []
    about = configuration.about == "orbit" and configuration.table is None
    for outcome in outcomes:
        speed = f"{speed_text(outcome.rpm)} rpm"
        if outcome.reason:
            continue  # stands beside the speeds
        if outcome.steps != configuration.steps:
            notes.append(
                f"{speed}: {outcome.steps} steps a cycle: at {configuration.steps} the films do not "
                "settle"
            )
        if not outcome.error <= COARSE:
            much = f"{100 * outcome.error:.2g} %" if outcome.error >= 0 else "an unknown share"
            notes.append(f"{speed}: halved steps change a stress by {much} of the largest: raise --steps")
        if not outcome.within_clearance:
            most = outcome.eccentricity.max()
            notes.append(
                f"{speed}: an orbit reaches {most:.2f} of its clearance: the films, linear "
                f"about {'their orbits' if about else 'the centre'}, are taken beyond their validity"
            )
        if outcome.largest > UNSTABLE:
            notes.append(f"{speed}: unstable, largest Floquet multiplier {outcome.largest:.4g}")
    overlay = configuration.engine.operation.overlay
    if overlay and not any(compare_with_measured(overlay, o) for o in outcomes if not o.reason):
        where = "every speed" if overlay.rpm is None else f"{speed_text(overlay.rpm)} rpm"
        there = overlay.rpm is None or any(o.rpm == overlay.rpm for o in outcomes)
        why = "whose films do not settle" if there else "which is no speed of this run"
        notes.append(f"the measured curve belongs to {where}, {why}")
    balancers = configuration.engine.engine.balancers
    if balancers:
        notes.append(
            "[[counterweight]] and [[balance_shaft]] take no part here: a running crank's weights are "
            "its [[crankshaft.counterweight]] tables"
        )
    for number, outside in _outside(configuration):
        notes.append(f"{number}: outside the fillet formulas' range: {', '.join(outside)}")
    if configuration.engine.operation.strength == type(configuration.engine.operation.strength)():
        notes.append("strength: default values, estimates for a forged and hardened steel crank")
    return notes


def _outside(configuration: RunConfiguration) -> list[tuple[str, tuple[str, ...]]]:
    webs_by_range: dict[tuple[str, ...], list[str]] = {}
    for channel in configuration.channels:
        if channel.outside:
            web = " ".join(channel.name.split()[:2])
            names = webs_by_range.setdefault(channel.outside, [])
            if web not in names:
                names.append(web)
    return [(", ".join(webs), outside) for outside, webs in webs_by_range.items()]


def summary_data(run: Summary) -> dict[str, Any]:
    """Return what `to_json` writes of a run.

    A speed with a `reason` is not to be relied on: channels, places and measured curves leave it out.
    """
    return {
        "engine": run.configuration.engine.engine.name,
        "webs": run.configuration.webs,
        "modes": run.configuration.modes,
        "connection": run.configuration.connection,
        "natural_frequencies": [{"hertz": f, "mostly": kind} for f, kind in run.frequencies],
        "speeds": [_finite(vars(s)) for s in run.speeds],
        "channels": [_finite(vars(e)) for e in run.extremes],
        "places": [
            {
                "name": p.name,
                "rpm": p.rpm,
                "amplitude": p.durability.amplitude / MEGA,
                "mean": p.durability.mean / MEGA,
                **_finite(
                    {"safety": p.durability.safety, "damage": p.durability.damage, "hours": p.hours}
                ),
            }
            for p in run.places
        ],
        "measured": [
            {"rpm": c.rpm, "channel": c.channel, "rms": c.rms, "peak": c.peak, "span": c.span}
            for c in run.comparisons
        ],
        "assumptions": list(run.assumptions),
        "notes": list(run.notes),
    }


def summary_records(run: Summary) -> list[dict[str, Any]]:
    """Return a row for each channel at each speed that is to be relied on.

    Keys: rpm, channel, unit (MPa or degrees), least and largest value of the cycle.
    """
    rows = []
    for outcome in run.reliable:
        for name, unit, values in zip(outcome.names, outcome.units, outcome.values.T, strict=True):
            unit_name, scale = ("MPa", MEGA) if unit == "Pa" else (unit, 1.0)
            least, largest = float(values.min()) / scale, float(values.max()) / scale
            row = {"rpm": float(outcome.rpm), "channel": name, "unit": unit_name}
            rows.append({**row, "least": least, "largest": largest})
    return rows


def _finite(values: dict[str, Any]) -> dict[str, Any]:
    return {k: None if isinstance(v, float) and not isfinite(v) else _plain(v) for k, v in values.items()}


def _plain(value: Any) -> Any:
    """Return tuples as lists, as JSON has them."""
    return [_plain(each) for each in value] if isinstance(value, tuple) else value
