"""The document of counterweights against rotating weights: both, and a certificate of the residual."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from symbalance.design.balancing.rotating_balance import RotatingBalance
from symbalance.design.balancing.weight_cells import size_cell, station_cell
from symbalance.document.formula import Formula, Name, Upright
from symbalance.document.nodes import Cell, Column, Document, Facts, Table, Words
from symbalance.engine.balance_mass_facts import direction
from symbalance.exact.amplitude import Amplitude

_M, _R, _A, _THETA = Name("m"), Name("r"), Name("a"), Name("theta")
_AT = ("at ", _THETA, " = 0")


def rotating_document(balance: RotatingBalance) -> Document:
    """Return the counterweights, the force and couple before and after, the weights, how to read them."""
    unit = Upright("kg mm") if balance.in_kg_mm else _M * _R
    pairs = zip(("force", "couple"), balance.before, balance.remains, strict=True)
    certificate = tuple(
        (name, *_part(before, "none"), *_part(after, "proved 0")) for name, before, after in pairs
    )
    columns = (Column("of"), Column("before"), Column(_AT), Column("residual"), Column(_AT))
    weights = ((weight.station, weight.vector) for weight in balance.weights)
    return Document(
        balance.summary(),
        (
            _weights("Counterweights", unit, balance.vectors),
            Table(
                ("Certificate: all of it added up anew, forces in ", unit, ", couples in ", unit * _A),
                columns,
                certificate,
            ),
            _weights("Weights to balance", unit, weights),
            Facts(tuple(_reading(balance)), "How to read it"),
        ),
    )


def _weights(title: str, unit: Formula, vectors: Iterable[tuple[Fraction, Amplitude]]) -> Table:
    columns = (Column("station"), Column(("mass times radius, ", unit), "mass times radius"), Column(_AT))
    rows = tuple((station_cell(z), size_cell(vector), direction(vector)) for z, vector in vectors)
    return Table(title, columns, rows)


def _part(vector: Amplitude, none: str) -> tuple[Cell, Cell]:
    return (none, "") if vector.is_zero() else (size_cell(vector), direction(vector))


def _reading(balance: RotatingBalance) -> list[tuple[Words, Words]]:
    planes = ", ".join(str(z).replace("-", "−") for z in balance.stations)
    spread = f": {_SPREADS[balance.spread]}" if len(set(balance.stations)) > 1 else ""
    entries: list[tuple[Words, Words]] = [
        ("planes", f"stations {planes}{spread}"),
        ("station", ("place along the shaft, in pitches ", _A, ", + to the front")),
        (_AT, "where a weight points, from straight up, + to the right"),
    ]
    if not balance.in_kg_mm:
        entries.append(((_M, ", ", _R), "reciprocating mass and crank radius of the first cylinder"))
    entries.append(("couples", "about station 0"))
    return [*entries, ("proved 0", "exactly; where sizes are decimals, to their rounding")]


_SPREADS = {
    "ends": "the fewest that do, with the least total",
    "even": "all, with the least sum of squares",
}
