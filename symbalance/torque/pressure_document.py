"""The documents of a pressure trace and an ideal cycle: peak, pressure by crank angle, work."""

from __future__ import annotations

from symbalance.document.decimals import decimal
from symbalance.document.formula import Name, Power, Product, Upright, equal
from symbalance.document.nodes import Column, Document, Facts, Table, Words
from symbalance.torque.ideal_cycles import IdealCycle
from symbalance.torque.pressure import PressureTrace

ROWS = 24
"""Even steps over a cycle that a trace is printed at."""
_STROKES = {2: "two-stroke", 4: "four-stroke"}


def trace_document(trace: PressureTrace) -> Document:
    """Return a trace as a document: its peak, the pressure at even steps, what angles count from."""
    facts: tuple[tuple[Words, Words], ...] = (
        ("peak", (decimal(trace.peak), " bar at ", decimal(trace.peak_degrees), "°")),
        ("lowest", (decimal(min(trace.bar)), " bar")),
    )
    step = trace.cycle // ROWS
    rows = tuple((decimal(a), decimal(trace.at(a))) for a in range(0, trace.cycle, step))
    count = len(trace.degrees)
    legend: tuple[tuple[Words, Words], ...] = (
        ("angle", "crank angle after the firing top dead centre"),
        ("pressure", "absolute"),
        ("trace", f"{count} point{'s' if count > 1 else ''}, straight lines between them"),
    )
    columns = (Column("angle, degrees"), Column("pressure, bar"))
    table = Table(f"Pressure every {step} degrees (after the jump where there is one)", columns, rows)
    title = f"Pressure trace of a {_STROKES[trace.strokes]} cycle"
    return Document(title, (Facts(facts), table, Facts(legend, "How to read it")))


def cycle_document(cycle: IdealCycle) -> Document:
    """Return an ideal cycle as a document: its pressures and its work, then what it is computed from."""
    mean = (decimal(cycle.mean_effective_pressure), " bar")
    facts: list[tuple[Words, Words]] = [
        ("mean effective pressure", mean),
        ("efficiency", decimal(cycle.efficiency)),
    ]
    rows: list[tuple[Words, Words]] = [
        ("intake", decimal(cycle.intake)),
        ("end of compression", decimal(cycle.compressed)),
        ("peak", decimal(cycle.peak)),
        ("end of expansion", decimal(cycle.expanded)),
        ("exhaust", decimal(cycle.exhaust)),
    ]
    heat = (decimal(cycle.heat), " bar: heat over the swept volume, 100 J per litre")
    legend: list[tuple[Words, Words]] = [
        ("compression ratio", decimal(cycle.compression_ratio)),
        ("heat", heat),
    ]
    if cycle.cutoff > 1:
        legend.append(("cutoff", (decimal(cycle.cutoff), " clearance volumes: end of constant pressure")))
    constant = Product((Name("p"), Power(Name("V"), Name("gamma"))))
    gamma = (decimal(cycle.gamma), ": ", equal(constant, Upright("constant")))
    legend += [(Name("gamma"), gamma), ("pressures", "absolute; the gas is an ideal one")]
    table = Table("Pressures, bar", (Column("state"), Column("pressure")), tuple(rows))
    title = f"Ideal {_STROKES[cycle.strokes]} cycle"
    return Document(title, (Facts(tuple(facts)), table, Facts(tuple(legend), "How to read it")))
