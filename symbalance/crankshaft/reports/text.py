"""A run's report as plain text."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import isnan

from symbalance.crankshaft.files.operation import speed_text
from symbalance.crankshaft.reports.summary import Summary

UNKNOWN = "-"
UNRELIABLE = "Speeds without stresses: not to be relied on"
SPEED_HEAD = ("rpm", "|x|/clearance", "off the orbit", "bearing kN", "multiplier", "s")
MODE_HEAD = ("mode", "Hz", "mostly")
EXTREME_HEAD = ("channel", "least", "largest", "unit", "rpm", "largest orders: amplitude")
PLACE_HEAD = ("place", "rpm", "amplitude MPa", "mean MPa", "safety", "life h")


def summary_text(found: Summary) -> str:
    """Return the report as text: what was run, speeds, stresses, durability, notes."""
    parts = [_head(found), _table("Speeds", SPEED_HEAD, speed_rows(found))]
    if lines := reason_lines(found):
        parts.append(f"{UNRELIABLE}\n" + "".join(f"  {line}\n" for line in lines))
    parts.append(_table("Natural frequencies of the free crank", MODE_HEAD, mode_rows(found)))
    if found.reliable:
        parts.append(_table("Stresses and twists", EXTREME_HEAD, extreme_rows(found)))
        parts.append(_table("Durability, the worst speed of each place", PLACE_HEAD, place_rows(found)))
    if found.comparisons:
        parts.append("Measured curves\n" + "".join(f"  {line}\n" for line in comparison_lines(found)))
    if found.notes:
        parts.append("Notes\n" + "".join(f"  {note}\n" for note in found.notes))
    return "\n".join(parts)


def mode_rows(found: Summary) -> list[tuple[str, ...]]:
    """Return the cells of the modes' table."""
    return [(str(i), f"{f:.1f}", kind) for i, (f, kind) in enumerate(found.frequencies, 1)]


def speed_rows(found: Summary) -> list[tuple[str, ...]]:
    """Return the cells of the speeds' table."""
    return [
        (
            speed_text(s.rpm),
            _known(s.eccentricity, ".2f"),
            _known(s.departure, ".2f"),
            _known(s.bearing / 1000, ".1f"),
            _known(s.largest, ".4f"),
            f"{s.seconds:.2f}",
        )
        for s in found.speeds
    ]


def _known(value: float, form: str) -> str:
    return UNKNOWN if isnan(value) else format(value, form)


def reason_lines(found: Summary) -> list[str]:
    """Return a line for each speed without stresses: why."""
    return [f"{speed_text(s.rpm)} rpm: {s.reason}" for s in found.speeds if s.reason]


def extreme_rows(found: Summary) -> list[tuple[str, ...]]:
    """Return the cells of the channels' table."""
    return [
        (
            e.name,
            f"{e.least:.4g}",
            f"{e.largest:.4g}",
            e.unit,
            speed_text(e.rpm),
            ", ".join(f"{order:g}: {size:.3g}" for order, size in e.orders),
        )
        for e in found.extremes
    ]


def place_rows(found: Summary) -> list[tuple[str, ...]]:
    """Return the cells of the durability table."""
    return [
        (
            p.name,
            speed_text(p.rpm),
            f"{p.found.amplitude / 1e6:.1f}",
            f"{p.found.mean / 1e6:.1f}",
            f"{p.found.safety:.2f}",
            f"{p.hours:.3g}",
        )
        for p in found.places
    ]


def comparison_lines(found: Summary) -> list[str]:
    """Return a line for each measured curve."""
    return [
        f"{speed_text(c.rpm)} rpm, {c.channel}: error {c.rms:.3g} MPa rms, "
        f"{c.peak:+.3g} MPa at the peak, of a range of {c.span:.4g} MPa"
        for c in found.comparisons
    ]


def head_lines(found: Summary) -> list[str]:
    """Return what was run, a line each."""
    made, run = found.setting, found.setting.engine.operation
    layout = made.engine.layout
    fires = layout.firing_order()
    kept = f"{made.modes} modes and the static shapes" if made.modes else "every unknown kept"
    films = {
        "orbit": f"linear about their orbits, at most {made.passes} passes",
        "centre": "as springs about the centre",
    }["centre" if made.table else made.about]
    return [
        f"{layout.name}: {len(layout.cylinders)} cylinders, {layout.strokes}-stroke"
        + (f", fires {'-'.join(map(str, fires))}" if fires else ""),
        f"peak pressure {max(run.trace.bar):.4g} bar, bore {run.bore * 1000:g} mm",
        f"{made.rotor.size} unknowns, {kept}; webs: {made.webs}; housing: {made.connection}; "
        f"{made.steps} steps a cycle",
        *(["a reduction: hold its stresses to a run without --modes at one speed"] if made.modes else []),
        f"films: {films}; damping {run.damping:g} of critical",
        f"strength: tensile {run.strength.tensile / 1e6:g} MPa, "
        f"endurance {run.strength.endurance / 1e6:g} MPa",
        "bending + opens the throw, torsion + where the front drives the rear",
    ]


def _head(found: Summary) -> str:
    return "".join(f"{line}\n" for line in head_lines(found))


def _table(title: str, head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    rows = [head, *rows]
    widths = [max(len(row[i]) for row in rows) for i in range(len(head))]
    left = {0} | ({len(head) - 1} if head in (EXTREME_HEAD, MODE_HEAD) else set())
    lines = [
        "  ".join(
            c.ljust(w) if i in left else c.rjust(w)
            for i, (c, w) in enumerate(zip(r, widths, strict=True))
        )
        for r in rows
    ]
    ruled = [lines[0], "─" * len(lines[0]), *lines[1:]]
    return title + "\n" + "".join(f"  {line.rstrip()}\n" for line in ruled)
