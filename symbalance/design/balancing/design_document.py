"""The document of a design: the weights proposed, their certificate, the orders that remain."""

from __future__ import annotations

from fractions import Fraction

from symbalance.design.balancing.design_facts import (
    PlacedWeight,
    achievement,
    by_order,
    design_weights,
    device_name,
    requirements,
    residual_ellipses,
    throw_counterweights,
)
from symbalance.design.balancing.designs import Design
from symbalance.design.balancing.ellipse_document import READING, ellipse_table
from symbalance.design.balancing.weight_cells import size_cell, station_cell
from symbalance.document.decimals import short_decimal
from symbalance.document.formula import Decimal, Formula, Name, Subscript, equal, number
from symbalance.document.nodes import (
    UNKNOWN,
    Block,
    Cell,
    Column,
    Details,
    Document,
    Facts,
    Heading,
    Paragraph,
    Table,
    Words,
    blocks,
)
from symbalance.engine.balance_mass_facts import direction, five_digits, with_minus
from symbalance.engine.engine_document import engine_words
from symbalance.forces.balance_document import conventions, resultant_blocks, turn_blocks
from symbalance.forces.free_forces import Balance, balance
from symbalance.text.numbers import short_text
from symbalance.text.reals import Real

VERDICTS = {
    "absent": "none before",
    "removed": "proved 0",
    "reduced": "changed",
    "unchanged": "unchanged",
    "added": "added",
}
_A_N = Subscript(Name("A"), Name("n"))
_U, _S, _N, _M, _R = Name("U"), Name("s"), Name("n"), Name("m"), Name("r")
_PLACES = (Column("speed"), Column("on the"))
_PROPOSED = (
    Column(("share ", _S), "share"),
    Column(("at ", Name("theta"), " = 0")),
    Column((_U, ", kg mm"), "U"),
)
_CERTIFICATE = (Column("order"), Column("of"), Column("with the crank"), Column("against it"))


def design_document(design: Design) -> Document:
    """Return a design as a document: what is proposed, the certificate, what remains, how to read it."""
    if not design.full:
        return _answer(design)
    ellipses = residual_ellipses(design)
    return Document(
        f"{design.engine.name}: {achievement(design)}",
        blocks(
            _proposal(design),
            _certificate(design),
            ellipse_table("Residual of the orders to remove", ellipses) if ellipses else None,
            Heading(f"What remains, to order {design.remains.highest}"),
            resultant_blocks(design.remains),
            turn_blocks(design.remains),
            Details(
                f"Before: {design.engine.name} unchanged, to order {design.remove[-1]}",
                resultant_blocks(_before(design)),
            ),
            conventions(design.before, _reading(design)),
        ),
        lead=_lead(design),
    )


def _answer(design: Design) -> Document:
    """Return what is to be built and what is proved of it, in a dozen lines."""
    remains = design.remains.summary().partition(": ")[2]
    left: Block = (
        Paragraph(f"Balanced anew with this built in, to order {design.remains.highest}: {remains}.")
        if design.is_complete
        else _certificate(design)
    )
    legend = tuple(_proposal_legend(design))
    return Document(
        f"{design.engine.name}: {achievement(design)}",
        blocks(_proposal(design), left, turn_blocks(design.remains), Facts(legend) if legend else None),
        lead=_lead(design),
    )


def _before(design: Design) -> Balance:
    """Return the engine's balance to the highest order to remove, at the design's operating point."""
    unchanged, point = balance(design.engine, design.remove[-1]), design.before.operating_point
    return unchanged if point is None else unchanged.at(rpm=point.rpm)


def _lead(design: Design) -> str:
    parts = (requirements(design), engine_words(design.engine))
    return " ".join(f"{part[0].upper()}{part[1:]}." for part in parts if part)


def _size(design: Design) -> Formula:
    """Return the mass times radius of a share s."""
    return (_S * _A_N * _M * _R if design.engine.has_common_harmonics else _S * _M * _R) / _N**2


def _proposal(design: Design) -> tuple[Block, ...]:
    pitch, is_cut = design.engine.pitch, design.ring is not None
    rows = tuple(_row(weight, pitch, cut=is_cut) for weight in design_weights(design))
    title: Words = (
        "Proposed weights: mass times radius ",
        equal(_U, _size(design)),
    )
    cut = (Column("cut, °", "segment"), Column("kg")) if design.ring else ()
    station = Column("station" if design.engine.pitch is None else "station, mm", "station")
    table = Table(title, (*_PLACES, station, *_PROPOSED, *cut), rows, keys=3) if rows else None
    counterweights, too_big = throw_counterweights(design), _too_big(design)
    if not counterweights:
        return blocks(table, too_big)
    share = max(c.overbalance or 0 for c in counterweights)
    also = f" and {share} of its reciprocating mass" if share else ""
    begin = "And on every throw" if rows else "On every throw"
    return blocks(table, too_big, Paragraph(f"{begin} a counterweight for its rotating mass{also}."))


def _too_big(design: Design) -> Paragraph | None:
    """Return which weights half of the ring is too small for, and what ring would do."""
    ring = design.ring
    weights = [(n, w) for n, w in enumerate(design_weights(design), 1) if w.segment is None]
    if ring is None or not weights:
        return None
    known = [w.unbalance for _, w in weights if w.unbalance is not None]
    needed = short_decimal(max(map(ring.thickness_for, known)), 4)
    rows = ", ".join(str(n) for n, _ in weights)
    which = f"The weight of row {rows} is" if len(weights) == 1 else f"Those of rows {rows} are"
    half = short_decimal(Real(ring.largest), 4)
    return Paragraph(
        f"{which} more than half of the ring has, {half} kg mm, and not cut: "
        f"take {needed} mm of thickness, or a larger radius."
    )


def _row(weight: PlacedWeight, pitch: Fraction | None, *, cut: bool) -> tuple[Cell, ...]:
    segment, station = weight.segment, weight.station
    sizes: tuple[Cell, ...] = (UNKNOWN, UNKNOWN)
    if segment is not None:
        sizes = (Decimal(five_digits(segment.angle)), Decimal(five_digits(segment.mass)))
    return (
        Decimal(f"{weight.device.speed:+d}"),
        device_name(weight.device),
        station_cell(station) if pitch is None else Decimal(f"{float(station * pitch):.8g}"),
        size_cell(weight.vector, below_zero=weight.is_opposite),
        direction(weight.pointing),
        "" if weight.unbalance is None else Decimal(five_digits(weight.unbalance)),
        *(sizes if cut else ()),
    )


def _certificate(design: Design) -> Table:
    rows = tuple(
        (number(n), kind, *(VERDICTS[claim.verdict] for claim in pair))
        for n, kind, pair in by_order(design)
    )
    return Table("Certificate: the engine with this built in, balanced anew", _CERTIFICATE, rows, keys=2)


def _reading(design: Design) -> list[tuple[Words, Words]]:
    """Return what the tables of a design mean, and the limits it keeps to."""
    entries: list[tuple[Words, Words]] = []
    if limits := _limits(design):
        entries.append(("limits", "; ".join(limits)))
    entries += _proposal_legend(design)
    entries.append(("proved 0", "exactly; where sizes are decimals, to their rounding"))
    return [*entries, *(READING if residual_ellipses(design) else ())]


def _proposal_legend(design: Design) -> list[tuple[Words, Words]]:
    """Return what the columns of the weights mean; empty where there are none."""
    if not design_weights(design):
        return []
    entries: list[tuple[Words, Words]] = []
    if design.engine.has_common_harmonics:
        first = equal(Subscript(Name("A"), number(1)), 1)
        entries.append((_A_N, ("coefficient of one cylinder at speed ", _N, "; ", first)))
    entries += [
        (("speed ", _N), "times that of the crank; below 0 against it"),
        ("station", f"place along the crank {_places(design.engine.pitch)}, + to the front"),
        (("at ", Name("theta"), " = 0"), "where a weight points, from straight up, + to the right"),
    ]
    if design.ring:
        ring = design.ring
        radii, thick = f"{short_text(ring.inner)} to {short_text(ring.outer)}", short_text(ring.thickness)
        steel = f"{short_text(ring.density)} kg/m³"
        cut = f"its whole angle, cut from a ring of {radii} mm, {thick} mm thick, {steel}"
        entries.append(("cut", f"{cut}; its middle where the weight points"))
    if any(w.is_opposite for w in design_weights(design)):
        entries.append((_S, "below 0 where its Aₙ is; U never is, and points as said"))
    return entries


def _places(pitch: Fraction | None) -> str:
    """Return in what stations are."""
    return "in cylinder pitches" if pitch is None else "in mm, counted as the cylinders' are"


def _limits(design: Design) -> list[str]:
    """Return the limits a design was given, and how it weighs what is left."""
    limits, weighting = design.limits, design.limits.weighting
    conditions = {
        f"at most {limits.shafts} shaft{'' if limits.shafts == 1 else 's'}": limits.shafts is not None,
        "no shaft against the crank": not limits.counter_rotation,
        "no counterweights on the crank": not limits.counterweights,
        f"weights at stations {', '.join(map(with_minus, limits.stations or ()))}": limits.stations,
        "a weight at every station": limits.spread == "even",
        "half the reciprocating mass on each throw": limits.per_throw,
        f"at most {limits.most} kg mm a weight": limits.most is not None,
        f"squares of the vertical weigh {weighting.vertical}, of the lateral {weighting.lateral}": (
            weighting.vertical != weighting.lateral
        ),
        f"couples count over {weighting.length} pitches": weighting.length != 1,
    }
    return [words for words, holds in conditions.items() if holds]
