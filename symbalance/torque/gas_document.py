"""The documents of an engine's gas torque and firing stars: which orders survive, and why."""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.decimals import decimal
from symbalance.document.formula import Name, Subscript, number
from symbalance.document.nodes import Column, Document, Facts, Table, blocks
from symbalance.engine.engine_document import ORDER, angle_text, engine_words, origin_facts
from symbalance.exact.angles import Angle
from symbalance.forces.balance_document import component_table, order_cell
from symbalance.forces.rows import Row
from symbalance.torque.gas import GasTorque
from symbalance.torque.running_document import ORDER_COLUMNS, Entry, pressure_facts
from symbalance.torque.star_diagrams import FiringStars, Star

_A, _R, _J = Name("A"), Name("r"), Name("j")
_STAR_COLUMNS = (Column("order"), Column("star"), Column("direction: cylinders"))


def gas_document(gas: GasTorque) -> Document:
    """Return a gas torque as a document: its mean, its orders, what they are times, where it acts."""
    each = gas.cylinder.mean_effective_pressure
    facts: tuple[Entry, ...] = (
        ("mean", (decimal(gas.mean), " bar times ", _A * _R)),
        (
            "mean effective pressure",
            (decimal(each), " bar, of cylinder ", number(gas.engine.first.number)),
        ),
    )
    rows = tuple(
        (order_cell(o.order), *map(decimal, (o.number.real, o.number.imag, o.amplitude)))
        for o in gas.orders
    )
    title = ("Gas torque on the crank over ", _A * _R, ", bar")
    legend: tuple[Entry, ...] = (
        *origin_facts(gas.engine),
        ((_A, ", ", _R), f"area of a piston, crank radius of cylinder {gas.engine.first.number}"),
        *pressure_facts(gas.pressure.summary(), gas.ambient),
        ("signs", "a torque is + on the crank in the sense of rotation; the frame gets the opposite"),
        ORDER,
    )
    body = blocks(
        Facts(facts),
        Table(title, ORDER_COLUMNS, rows, empty=f"none, to order {gas.highest}"),
        Facts(legend, "How to read it"),
    )
    return Document(f"{gas.engine.name}: gas torque on the crank", body, engine_words(gas.engine))


def stars_document(stars: FiringStars) -> Document:
    """Return firing stars as a document: the sums that are left, then every star's vectors."""
    sums = [Row(star.order, "", star.resultant) for star in stars.open]
    vectors = tuple(
        (order_cell(star.order), "closed" if star.is_closed() else "open", _directions(star))
        for star in stars
    )
    theta = Subscript(Name("theta"), _J)
    legend: tuple[Entry, ...] = (
        *origin_facts(stars.engine),
        ("star", ("one unit vector a cylinder, at the angle ", Name("n") * theta)),
        (theta, ("crank angle at which the pin of cylinder ", _J, " passes its axis to fire")),
        ("closed", "the vectors cancel, and so does this order of the gas torque"),
        ORDER,
    )
    body = blocks(
        component_table("Sums of the stars that are open", sums, empty=f"none, to order {stars.highest}"),
        Table("Stars", _STAR_COLUMNS, vectors),
        Facts(legend, "How to read it"),
    )
    return Document(f"{stars.engine.name}: firing stars", body, engine_words(stars.engine))


def _directions(star: Star) -> str:
    """Return which cylinders point where, by angle: "0°: 1, 6; 120°: 2, 5"."""
    at: dict[Fraction, list[str]] = {}
    for cylinder, turns in sorted(star.vectors):
        at.setdefault(turns, []).append(str(cylinder))
    return "; ".join(f"{angle_text(Angle(turns))}:\u00a0{', '.join(at[turns])}" for turns in sorted(at))
