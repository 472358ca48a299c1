"""Straight stepped shafts with discs and bearings as rotors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from symbalance.crankshaft.arguments import check_fields, check_kind, check_number
from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.rotor.assembly import assemble_rotor
from symbalance.crankshaft.rotor.beams import ALONG_W, Beam, circular
from symbalance.crankshaft.rotor.matrices import Member, Rotor, check_rotor
from symbalance.crankshaft.rotor.parts import Disc, Material
from symbalance.crankshaft.rotor.rigid_bodies import disc_body
from symbalance.errors import SymbalanceError, brief
from symbalance.text.numbers import as_list, whole

CLOSE = 1e-9
"""Places along a shaft nearer than this, in m, are one node."""


@dataclass(frozen=True)
class Tube:
    """A straight piece of shaft: length, diameter and bore in m, divided into `elements` at least.

    `bending` are factors on its second moments of area for bending along U and along V: of a slotted or
    flattened shaft, which is not round, they differ.
    """

    length: float
    diameter: float
    bore: float = 0.0
    elements: int = 4
    bending: tuple[float, float] = (1.0, 1.0)

    def __post_init__(self) -> None:
        check_fields(self, "tube", (("length", "m"), ("diameter", "m"), ("bore", "m")))
        factors = as_list(self.bending, "tube bending", "(1.0, 0.9): factors along U and V")
        for factor in factors:
            check_number(factor, "tube bending", "factors along U and V")
        sound = len(factors) == 2 and all(factor > 0 for factor in factors)
        sound = sound and self.length > 0 and self.bore < self.diameter
        if not sound or (whole(self.elements) or 0) < 1:
            what = ", ".join(f"{name} = {brief(value)}" for name, value in vars(self).items())
            rule = "must have length, a bore within its diameter, a whole number of elements, factors > 0"
            raise SymbalanceError(what, rule, "m", "tube")


def shaft(
    tubes: Sequence[Tube],
    discs: Mapping[float, Disc] | None = None,
    bearings: Sequence[float] = (),
    material: Material | None = None,
    *,
    shear: bool = True,
) -> Rotor:
    """Return a rotor of tubes joined along W from 0, with discs and bearings at given places (m).

    A disc's `distance` is not used. Bearings are nodes of `Rotor.journals`; `bearing_springs` makes
    springs, and `whirl` takes a `Support` for each. Beams are Timoshenko's, or without `shear`
    Rayleigh's, who has rotary inertia only: many published figures are his.

    >>> rotor = shaft([Tube(1.0, 0.05)], {0.5: Disc(10.0, 0.2, 0.1)}, bearings=(0.0, 1.0))
    >>> rotor.points[:, 2], rotor.journals
    (array([0.  , 0.25, 0.5 , 0.75, 1.  ]), (0, 4))
    """
    tubes, bearings = (
        as_list(tubes, "tubes", "[sb.crankshaft.rotor.Tube(1.0, 0.05)]"),
        as_list(bearings, "bearings", "[0, 1]"),
    )
    steel, weights = Material() if material is None else material, {} if discs is None else discs
    _check(tubes, steel, weights)
    for place in (*weights, *bearings):
        check_number(place, "place", "m along the shaft", signed=True)
    places = _places(tubes, [*weights, *bearings])
    points = np.array([[0.0, 0.0, w] for w in places])
    spans = [*_beams(tubes, places, steel, shear)]
    members = [Member(front, rear, beam.stiffness, "shaft", -1) for front, rear, beam in spans]
    bodies = [(_node(places, place), disc_body(disc)) for place, disc in weights.items()]
    rotor = assemble_rotor(points, members, spans, bodies)
    return replace(rotor, journals=tuple(_node(places, place) for place in bearings))


def _check(tubes: Sequence[Tube], steel: Material, discs: Mapping[float, Disc]) -> None:
    if not tubes:
        raise SymbalanceError("0 tubes", "must be one or more")
    for number, tube in enumerate(tubes, 1):
        check_kind(tube, Tube, f"tube {number}", "sb.crankshaft.rotor.Tube(length, diameter), in m")
    check_kind(steel, Material, "material", "sb.crankshaft.Material(young, poisson, density)")
    check_kind(discs, Mapping, "discs", "{place in m: sb.crankshaft.Disc(mass, polar, diametral)}")
    for place, disc in discs.items():
        name = f"disc at {brief(place)} m"
        check_kind(disc, Disc, name, "sb.crankshaft.Disc(mass, polar, diametral), in kg and kg m^2")
        if disc.polar > 2 * disc.diametral * (1 + 1e-9):
            rule = f"must be at most twice the diametral, {brief(disc.diametral)}"
            raise SymbalanceError(f"polar = {brief(disc.polar)}", rule, "as for any body", name)


def bearing_springs(
    rotor: Rotor, stiffness: float, across: float | None = None, axial: float = 0.0
) -> Array:
    """Return the stiffness matrix (n, n) of bearing springs: u, `across` in v, `axial` at the first, N/m.

    Springs alike in u and v are the same in turning and in stationary axes.
    """
    check_rotor(rotor)
    for value in (stiffness, across or 0.0, axial):
        if not np.isfinite(value):
            raise SymbalanceError(f"spring = {brief(value)} N/m", "must be finite")
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
    ends_and_extra = [*extra]
    for tube, start in zip(tubes, ends[:-1], strict=True):
        ends_and_extra += [*np.linspace(start, start + tube.length, tube.elements + 1)]
    for place in extra:
        if not -CLOSE <= place <= ends[-1] + CLOSE:
            rule = f"must lie on the shaft, 0 to {brief(float(ends[-1]))} m"
            raise SymbalanceError(f"place = {brief(place)}", rule)
    places: list[float] = []
    for place in sorted(ends_and_extra):
        if not places or place - places[-1] > CLOSE:
            places.append(float(place))
    return places


def _node(places: Sequence[float], place: float) -> int:
    return int(np.argmin(np.abs(np.array(places) - place)))


def _beams(
    tubes: Sequence[Tube], places: Sequence[float], material: Material, shear: bool
) -> list[tuple[int, int, Beam]]:
    ends = np.cumsum([tube.length for tube in tubes])
    spans = []
    for front in range(len(places) - 1):
        middle = (places[front] + places[front + 1]) / 2
        tube = tubes[min(int(np.searchsorted(ends, middle)), len(tubes) - 1)]
        section = circular(tube.diameter, tube.bore, material.poisson)
        along_u, along_v = tube.bending
        section = replace(section, bend_z=along_u * section.bend_z, bend_y=along_v * section.bend_y)
        if not shear:
            section = replace(section, shear_y=np.inf, shear_z=np.inf)
        beam = Beam(section, material, places[front + 1] - places[front], ALONG_W)
        spans.append((front, front + 1, beam))
    return spans
