"""Reading of [bearings] in an engine file: clearances, oil, housing stiffness, thrust bearing."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from symbalance.crankshaft.crank import Crank, Journal
from symbalance.errors import SymbalanceError
from symbalance.text.named_paths import NamingFolder
from symbalance.text.sections import Section

MILLI = 1e-3
WIDEST = 0.01
"""The largest radial clearance, of the journal's diameter: beyond it is no bearing, or another unit."""


@dataclass(frozen=True)
class MainBearings:
    """Main bearings, SI units, one number each, front to rear; without `housing` the structure is rigid.

    `clearance` is radial; `housing` holds (vertical, lateral, damping); `table` names a file of film
    coefficients. `thrust` is the place among the journals of the one with the thrust bearing.
    """

    clearance: tuple[float, ...]
    length: tuple[float, ...]
    diameter: tuple[float, ...]
    viscosity: tuple[float, ...]
    housing: tuple[tuple[float, float, float], ...] | None
    table: Path | None
    thrust: int
    thrust_stiffness: float


def read_bearings(section: Section, crank: Crank, folder: NamingFolder) -> MainBearings:
    """Return what [bearings] says of a crank's main bearings: clearance and length in mm, Pa s, N/m."""
    journals = [p for p in crank.parts if isinstance(p, Journal) and p.bearing]
    count = len(journals)
    if not count:
        rule = "leaves the crank no bearing"
        raise SymbalanceError("crankshaft.no_bearing", rule, "keep one or more", section.source.place)
    lengths = [j.length for j in journals]
    if "length" in section:
        lengths = section.numbers("length", count)
        for value, journal in zip(lengths, journals, strict=True):
            if value > journal.length * (1 + 1e-12):
                rule = f"exceeds the journal's {journal.length / MILLI:.6g} mm"
                raise section.refusal("length", rule, "a bearing shell lies on its journal")
    table = section.value("table")
    clearance = section.numbers("clearance", count)
    for value, journal in zip(clearance, journals, strict=True):
        if value > WIDEST * journal.diameter:
            rule = f"exceeds {WIDEST * journal.diameter / MILLI:.6g} mm, a hundredth of the journal"
            raise section.refusal("clearance", rule, "radial, in mm: about a thousandth of the radius")
    return MainBearings(
        tuple(clearance),
        tuple(lengths),
        tuple(j.diameter for j in journals),
        tuple(section.numbers("viscosity", count)),
        _housing(section, count),
        None if table is None else section.guarded(lambda: folder.file(table), "table"),
        _thrust(section, count) - 1,
        section.number("thrust_stiffness"),
    )


def _thrust(section: Section, count: int) -> int:
    (place,) = section.places("thrust", count) or (count,)
    return place


def _housing(section: Section, count: int) -> tuple[tuple[float, float, float], ...] | None:
    if "housing_vertical" not in section:
        return None
    vertical, lateral = (
        section.numbers(f"housing_{direction}", count) for direction in ("vertical", "lateral")
    )
    return tuple(zip(vertical, lateral, section.numbers("housing_damping", count), strict=True))
