"""The document of a running engine's torque: mean, swing, flywheel and orders, then the settings."""

from __future__ import annotations

from math import hypot

from symbalance.document.decimals import decimal
from symbalance.document.formula import Name, cos, sin
from symbalance.document.nodes import Block, Column, Document, Facts, Inline, Table, Words, blocks
from symbalance.engine.engine_document import ORDER, engine_words, origin_facts
from symbalance.forces.balance_document import order_cell
from symbalance.torque.running import MILLI, RunningTorque

NO_MEAN = 1e-9
"""A mean torque below this part of the largest is rounding."""
_ANGLE = Name("n") * Name("theta")
ORDER_COLUMNS = (
    Column("order"),
    Column(cos(_ANGLE), "cos"),
    Column(sin(_ANGLE), "sin"),
    Column("amplitude"),
)
Entry = tuple[Words, Words]


def running_document(torque: RunningTorque) -> Document:
    """Return a running engine's torque as a document."""
    title = f"{torque.engine.name}: torque on the crank at {torque.rpm:.6g} rpm"
    signs: Entry = ("signs", "a torque is + on the crank in the sense of rotation")
    entries = (*origin_facts(torque.engine), *running_facts(torque), signs, ORDER)
    body = blocks(running_blocks(torque), Facts(entries, "How to read it"))
    return Document(title, body, engine_words(torque.engine))


def running_title(torque: RunningTorque) -> str:
    """Return at what speed the engine runs."""
    return f"Running at {torque.rpm:.6g} rpm, with gas and inertia"


def running_blocks(torque: RunningTorque) -> tuple[Block, ...]:
    """Return the mean torque, its extremes, the energy fluctuation, the flywheel; the orders in N m."""
    swing = torque.fluctuation
    facts: tuple[Entry, ...] = (
        (
            "mean torque",
            (decimal(torque.mean), " N m (indicated; power ", decimal(torque.power / 1000), " kW)"),
        ),
        ("highest, lowest", (decimal(swing.largest), ", ", decimal(swing.least), " N m")),
        ("energy fluctuation", (decimal(swing.energy), " J", *_shares(torque))),
        (
            "flywheel",
            (decimal(torque.flywheel()), " kg m² for a speed fluctuation of ", decimal(torque.delta)),
        ),
    )
    rows = tuple(
        (order_cell(n), decimal(c), decimal(s), decimal(hypot(c, s))) for n, c, s in torque.terms()
    )
    empty = f"none, to order {torque.highest}"
    return (Facts(facts), Table("Orders of the whole torque, N m", ORDER_COLUMNS, rows, empty=empty))


def running_facts(torque: RunningTorque) -> list[Entry]:
    """Return what the engine runs with, and what its torque leaves out."""
    own = torque.first
    alike = len({(c.radius, c.mass) for c in torque.cylinders}) == 1
    sizes: Words = (
        *("bore ", decimal(torque.bore * MILLI), " mm, stroke ", decimal(2 * own.radius * MILLI)),
        *(" mm, reciprocating mass ", decimal(own.mass)),
        " kg a cylinder"
        if alike
        else f" kg: stroke and mass are those of cylinder {torque.engine.first.number}",
    )
    return [
        ("sizes", sizes),
        *pressure_facts(torque.pressure.summary(), torque.cylinder.ambient),
        ("running", "without friction; inertia at constant speed"),
    ]


def pressure_facts(pressure: str, ambient: float) -> list[Entry]:
    """Return what the pistons are pressed with from above and below."""
    below = (f"{pressure[0].lower()}{pressure[1:]}; ", decimal(ambient), " bar below the pistons")
    return [("pressure", below)]


def _shares(torque: RunningTorque) -> tuple[Inline, ...]:
    """Return the coefficients of fluctuation, of which there are none without a mean torque."""
    swing = torque.fluctuation
    if torque.mean <= NO_MEAN * swing.largest:
        return ("; no mean torque to compare with",)
    of_work, of_torque = decimal(swing.of_energy, 4), decimal(swing.of_torque, 4)
    return (", ", of_work, " of a cycle's work; the torque swings by ", of_torque, " times its mean")
