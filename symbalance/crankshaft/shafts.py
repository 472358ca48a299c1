"""Straight stepped shafts with discs and bearings: rotors as handbooks draw them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from symbalance.crankshaft.beams import ALONG_W, Beam, circular
from symbalance.crankshaft.bodies import disc_body
from symbalance.crankshaft.crank import Disc, Material
from symbalance.crankshaft.gathering import gathered
from symbalance.crankshaft.rotor import DOF, Array, Member, Rotor
from symbalance.errors import SymbalanceError, shown

CLOSE = 1e-9


@dataclass(frozen=True)
class Tube:
    """A straight piece of shaft: length, diameter and bore in m, divided into `elements` at least."""

    length: float
    diameter: float
    bore: float = 0.0
    elements: int = 4


def shaft(
    tubes: Sequence[Tube],
    discs: Mapping[float, Disc] | None = None,
    bearings: Sequence[float] = (),
    material: Material | None = None,
) -> Rotor:
    """Return the rotor of tubes in a row along W from 0, discs and bearings at the places given (m).

    A disc's `distance` is not used. Bearings are nodes of `Rotor.journals`; `held_at` makes springs.

    >>> rotor = shaft([Tube(1.0, 0.05)], {0.5: Disc(10.0, 0.2, 0.1)}, bearings=(0.0, 1.0))
    >>> rotor.points[:, 2], rotor.journals
    (array([0.  , 0.25, 0.5 , 0.75, 1.  ]), (0, 4))
    """
    if not tubes or not all(t.length > 0 and t.diameter > t.bore >= 0 and t.elements > 0 for t in tubes):
        raise SymbalanceError(f"{len(tubes)} tubes", "must have length, and a bore within their diameter")
    steel, weights = material or Material(), dict(discs or {})
    places = _places(tubes, [*weights, *bearings])
    points = np.array([[0.0, 0.0, w] for w in places])
    spans = [*_spans(tubes, places, steel)]
    members = [Member(front, rear, beam.stiffness, "shaft", -1) for front, rear, beam in spans]
    bodies = [(_node(places, place), disc_body(disc)) for place, disc in weights.items()]
    rotor = gathered(points, members, spans, bodies)
    return replace(rotor, journals=tuple(_node(places, place) for place in bearings))


def held_at(rotor: Rotor, stiffness: float, across: float | None = None, axial: float = 0.0) -> Array:
    """Return (n, n): springs (N/m) at all bearings along u, `across` along v, `axial` at the first.

    Springs alike in u and v are the same in turning and in stationary axes.
    """
    support = np.zeros((rotor.size, rotor.size))
    for node in rotor.journals:
        support[DOF * node, DOF * node] += stiffness
        support[DOF * node + 1, DOF * node + 1] += stiffness if across is None else across
    if rotor.journals:
        place = DOF * rotor.journals[0] + 2
        support[place, place] += axial
    return support


def _places(tubes: Sequence[Tube], extra: Sequence[float]) -> list[float]:
    ends = [0.0, *np.cumsum([tube.length for tube in tubes])]
    wanted = [*extra]
    for tube, start in zip(tubes, ends[:-1], strict=True):
        wanted += [*np.linspace(start, start + tube.length, tube.elements + 1)]
    for place in extra:
        if not -CLOSE <= place <= ends[-1] + CLOSE:
            rule = f"must lie on the shaft, 0 to {shown(float(ends[-1]))} m"
            raise SymbalanceError(f"place = {shown(place)}", rule)
    places: list[float] = []
    for place in sorted(wanted):
        if not places or place - places[-1] > CLOSE:
            places.append(float(place))
    return places


def _node(places: Sequence[float], place: float) -> int:
    return int(np.argmin(np.abs(np.array(places) - place)))


def _spans(
    tubes: Sequence[Tube], places: Sequence[float], material: Material
) -> list[tuple[int, int, Beam]]:
    ends = np.cumsum([tube.length for tube in tubes])
    spans = []
    for front in range(len(places) - 1):
        middle = (places[front] + places[front + 1]) / 2
        tube = tubes[min(int(np.searchsorted(ends, middle)), len(tubes) - 1)]
        section = circular(tube.diameter, tube.bore, material.poisson)
        beam = Beam(section, material, places[front + 1] - places[front], ALONG_W)
        spans.append((front, front + 1, beam))
    return spans
