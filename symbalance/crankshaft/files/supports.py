"""From [bearings]: the clearances, the oil, the structure behind the films, the thrust bearing."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from symbalance.crankshaft.crank import Crank, Journal
from symbalance.errors import SymbalanceError
from symbalance.text.sections import MILLI, Section

KEYS = (
    "clearance",
    "length",
    "viscosity",
    "housing_vertical",
    "housing_lateral",
    "housing_damping",
    "table",
    "thrust",
    "thrust_stiffness",
)
WIDEST = 0.01
"""The largest radial clearance, of the journal's diameter: beyond it is no bearing, or another unit."""
THRUST_STIFFNESS = 2e8
"""N/m of the thrust bearing where none is given: an estimate; it only holds the crank in place."""


@dataclass(frozen=True)
class Supports:
    """The main bearings front to rear, SI: a number each; `housing` None is a rigid structure.

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


def read_supports(section: Section, crank: Crank, folder: Path) -> Supports:
    """Return what [bearings] says of a crank's main bearings: clearance and length in mm, Pa s, N/m."""
    journals = [p for p in crank.parts if isinstance(p, Journal) and p.bearing]
    count = len(journals)
    if not count:
        rule = "leaves the crank no bearing"
        raise SymbalanceError("crankshaft.no_bearing", rule, "keep one or more", section.source.place)
    lengths = [j.length for j in journals]
    if "length" in section:
        lengths = section.numbers("length", count, None, MILLI)
        for given, journal in zip(lengths, journals, strict=True):
            if given > journal.length * (1 + 1e-12):
                rule = f"exceeds the journal's {journal.length / MILLI:.6g} mm"
                raise section.refusal("length", rule, "a bearing shell lies on its journal")
    table = section.text("table")
    clearance = section.numbers("clearance", count, None, MILLI)
    for given, journal in zip(clearance, journals, strict=True):
        if given > WIDEST * journal.diameter:
            rule = f"exceeds {WIDEST * journal.diameter / MILLI:.6g} mm, a hundredth of the journal"
            raise section.refusal("clearance", rule, "radial, in mm: about a thousandth of the radius")
    return Supports(
        tuple(clearance),
        tuple(lengths),
        tuple(j.diameter for j in journals),
        tuple(section.numbers("viscosity", count, 0.01 if table else None)),
        _housing(section, count),
        None if table is None else folder / table,
        (section.whole("thrust", 1, count) if "thrust" in section else count) - 1,
        section.number("thrust_stiffness", THRUST_STIFFNESS),
    )


def _housing(section: Section, count: int) -> tuple[tuple[float, float, float], ...] | None:
    if "housing_vertical" not in section and "housing_lateral" not in section:
        for key in ("housing_damping",):
            if key in section:
                raise section.missing("housing_vertical", "add housing_vertical = ..., in N/m")
        return None
    other = "housing_lateral" if "housing_vertical" in section else "housing_vertical"
    if other not in section:
        raise section.missing(other, f"add {other} = ..., in N/m")
    vertical = section.numbers("housing_vertical", count, None)
    lateral = section.numbers("housing_lateral", count, None)
    damping = section.numbers("housing_damping", count, 0.0, zero=True)
    return tuple(zip(vertical, lateral, damping, strict=True))
