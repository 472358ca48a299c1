"""The document of a run: its validity, speeds, durability, stresses, and how it was computed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from symbalance.crankshaft.files.operation import speed_text
from symbalance.document.decimals import decimal, fixed_cell
from symbalance.document.formula import Decimal, Name, Upright, absolute, number
from symbalance.document.nodes import (
    Block,
    Cell,
    Column,
    Document,
    Facts,
    Figure,
    Strong,
    Table,
    Words,
    blocks,
)
from symbalance.forces.balance_document import engine_title

if TYPE_CHECKING:
    from symbalance.crankshaft.reports.summary import SpeedFigures, Summary

MEGA = 1e6
OFF = "how far orbits lie from those of their films, over the clearance"
_PICTURES = {
    "pin-bending.png": ("Bending stress of the pins", "a curve over the crank angle for each pin"),
    "pin-torsion.png": ("Torsional stress of the pins", "a curve over the crank angle for each pin"),
    "orders.png": ("Orders of the pins' bending stress", "a bar for each order up to 24, for each pin"),
    "orbits.png": ("Orbits of the journals", "a closed curve in the clearance circle of each bearing"),
    "bearings.png": ("Loads of the main bearings", "a curve over the crank angle for each bearing"),
    "films.png": ("Stiffness of the middle bearing", "curves of film, housing and both in series"),
    "frequencies.png": ("Natural frequencies of the free crank", "a bar for each mode"),
    "campbell.png": (
        "Campbell diagram",
        "frequencies over the speed, in turning and stationary axes",
    ),
    "waterfall.png": ("Orders of the worst pin over the speed", "shades for each order and speed"),
    "order-cuts.png": (
        "The largest orders over the speed",
        "a curve over the speed for each order",
    ),
}
"""By file name: a picture's caption, and what it shows."""


def summary_document(run: Summary) -> Document:
    """Return a run as a document."""
    return Document(
        f"Running crankshaft of {engine_title(run.configuration.engine.engine)}",
        blocks(
            _speeds(run),
            _reasons(run),
            _places(run),
            _extremes(run),
            _comparisons(run),
            _frequencies(run),
            Facts(tuple((line, "") for line in run.assumptions), "Assumptions"),
            Facts(tuple((note, "") for note in run.notes), "Notes") if run.notes else None,
            _how_to_read(run),
            tuple(_figure(name, picture) for name, picture in run.pictures.items()),
        ),
        _verdict(run),
    )


def _verdict(run: Summary) -> Words:
    if not run.reliable:
        return Strong("No speed is to be relied on.")
    worst = run.worst
    safety = f"{worst.durability.safety:.2f}"
    least: Words = (
        "The least safety factor is ",
        Decimal(safety),
        f", of {worst.name} at {speed_text(worst.rpm)} rpm.",
    )
    warning = Strong("Not all is to be relied on, or not all is safe: see the notes.")
    return least if run.valid else (*least, " ", warning)


def _speeds(run: Summary) -> Table:
    columns = (
        Column("rpm"),
        Column((absolute(Name("x")) / Upright("clearance"),)),
        Column("off the orbit"),
        Column("bearing kN"),
        Column("multiplier"),
        Column("s"),
    )
    return Table("Speeds", columns, tuple(_speed(each, _is_about_centre(run)) for each in run.speeds))


def _is_about_centre(run: Summary) -> bool:
    """Tell whether films are linear about their bearings' centres: a table always is."""
    return run.configuration.about == "centre" or run.configuration.table is not None


def _speed(speed: SpeedFigures, about_centre: bool) -> tuple[Cell, ...]:
    return (
        _rpm(speed.rpm),
        fixed_cell(speed.eccentricity, 2),
        "" if about_centre else fixed_cell(speed.departure, 2),
        fixed_cell(speed.bearing / 1000, 1),
        fixed_cell(speed.largest, 4),
        fixed_cell(speed.seconds, 2),
    )


def _rpm(rpm: float) -> Cell:
    return Decimal(speed_text(rpm))


def _reasons(run: Summary) -> Facts | None:
    """Return why speeds have no stresses."""
    entries = tuple((f"{speed_text(s.rpm)} rpm", s.reason) for s in run.speeds if s.reason)
    return Facts(entries, "Speeds without stresses: not to be relied on") if entries else None


def _places(run: Summary) -> Table | None:
    columns = ("place", "rpm", "amplitude MPa", "mean MPa", "safety", "life h")
    rows = tuple(
        (
            place.name,
            _rpm(place.rpm),
            fixed_cell(place.durability.amplitude / MEGA, 1),
            fixed_cell(place.durability.mean / MEGA, 1),
            fixed_cell(place.durability.safety, 2),
            decimal(place.hours, 3),
        )
        for place in run.places
    )
    title = "Durability, the worst speed of each place"
    return Table(title, tuple(map(Column, columns)), rows) if rows else None


def _extremes(run: Summary) -> tuple[Block, ...]:
    """Return every channel's range over all speeds, and its largest orders."""
    ranges = tuple(
        (e.name, e.unit, decimal(e.least, 4), decimal(e.largest, 4), _rpm(e.rpm)) for e in run.extremes
    )
    orders = tuple(
        (e.name, ", ".join(f"{order:g}: {size:.3g}" for order, size in e.orders)) for e in run.extremes
    )
    columns = ("channel", "unit", "least", "largest", "largest at rpm")
    pair = (Column("channel"), Column("order: amplitude"))
    if not ranges:
        return ()
    return (
        Table("Stresses and twists", tuple(map(Column, columns)), ranges),
        Table("Their largest orders at that speed", pair, orders),
    )


def _comparisons(run: Summary) -> Table | None:
    columns = ("channel", "rpm", "rms error MPa", "error at the peak MPa", "measured range MPa")
    rows = tuple(
        (c.channel, _rpm(c.rpm), decimal(c.rms, 3), decimal(c.peak, 3), decimal(c.span, 4))
        for c in run.comparisons
    )
    return Table("Measured curves", tuple(map(Column, columns)), rows) if rows else None


def _frequencies(run: Summary) -> Table:
    rows = tuple(
        (number(i), fixed_cell(hertz, 1), kind) for i, (hertz, kind) in enumerate(run.frequencies, 1)
    )
    head = (Column("mode"), Column("Hz"), Column("mostly"))
    return Table("Natural frequencies of the free crank", head, rows)


def _how_to_read(run: Summary) -> Facts:
    """Return what was run, and what the columns are."""
    configuration, operation = run.configuration, run.configuration.engine.operation
    fires = configuration.engine.engine.firing_order()
    about = f"linear about their orbits, at most {configuration.iterations} passes"
    if _is_about_centre(run):
        about = "as springs about the centre"
    entries: list[tuple[Words, Words]] = [("fires", "-".join(map(str, fires)))] if fires else []
    entries += [
        ("peak pressure", f"{max(operation.trace.bar):.4g} bar, bore {operation.bore * 1000:g} mm"),
        ("model", f"{configuration.rotor.size} unknowns, {_model_size(configuration.modes)}"),
        ("steps", f"{configuration.steps} a cycle"),
        ("webs, housing", f"{configuration.webs}, {configuration.connection}"),
        ("films", about),
        ("damping", f"{operation.damping:g} of critical"),
        (
            "strength",
            f"tensile {operation.strength.tensile / MEGA:g} MPa, "
            f"endurance {operation.strength.endurance / MEGA:g} MPa",
        ),
        (absolute(Name("x")) / Upright("clearance"), "a journal's largest displacement; valid below 1"),
        *([] if _is_about_centre(run) else [("off the orbit", OFF)]),
        ("multiplier", "largest Floquet multiplier; stable up to 1"),
        ("bearing, s", "largest load of a main bearing; seconds of computing"),
        ("signs", "bending + opens the throw, torsion + where the front drives the rear"),
        ("safety", "Goodman, on the equivalent stress; the life counts rainflow cycles"),
    ]
    return Facts(tuple(entries), "How it was computed, and how to read it")


def _model_size(modes: int) -> str:
    if not modes:
        return "all kept"
    return f"{modes} modes and the static shapes kept: check one speed without --modes"


def _figure(name: str, picture: bytes) -> Figure:
    caption, shows = _PICTURES.get(name, (name.removesuffix(".png"), "a diagram"))
    return Figure(name, picture, caption, shows)
