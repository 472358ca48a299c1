"""Finite-element model of a crank: beams for journals and pins, elements for webs, rigid end discs.

Journals and pins are Timoshenko beams from web face to web face, each in two halves with a node at its
middle; a web joins the nodes at its two faces, as an element whose stiffness is inverted from a
flexibility (`webs`) and whose mass is shared between them (of a solved web, heel and counterweight are
attached as a body with a node of its own); pulley and flywheel are rigid. All that has mass turns: M, G,
dK and F_M of every slice and body are those of `rotor.rigid_bodies`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from symbalance.crankshaft.arguments import check_kind
from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.crank import Crank, Journal, Pin, Web
from symbalance.crankshaft.rotor.assembly import assemble_rotor, damped
from symbalance.crankshaft.rotor.beams import ALONG_W, Beam, circular, element, flexibility
from symbalance.crankshaft.rotor.matrices import AttachedBody, Member, Rotor
from symbalance.crankshaft.rotor.parts import Disc
from symbalance.crankshaft.rotor.rigid_bodies import RigidBody, disc_body
from symbalance.crankshaft.solid.store import WebStore, open_store, solid_web
from symbalance.crankshaft.webs.arm import Arm, WebCompliance, arms, axis_of
from symbalance.crankshaft.webs.beam_webs import formula_flexibility, nominal_flexibility
from symbalance.crankshaft.webs.fitted import fitted_flexibility
from symbalance.crankshaft.webs.mass_lumping import far_bodies, near_bodies, near_fillet
from symbalance.errors import SymbalanceError, brief

Flexibility = Callable[[Arm], Array | WebCompliance]
WEBS = ("solid", "fitted", "formula", "nominal")
"""The models of a web's flexibility, most accurate first."""


@dataclass(frozen=True)
class Nodes:
    """The crank's nodes: `points` (n, 3), and (front, middle, rear) nodes of each journal and pin.

    `body_nodes` are those of the bodies attached to the near ends of webs, by the web's place.
    """

    points: Array
    ends: dict[int, tuple[int, int, int]]
    pulley: int | None
    flywheel: int | None
    body_nodes: dict[int, int]


def assemble(
    crank: Crank,
    *,
    webs: str | Flexibility = "nominal",
    store: WebStore | None = None,
    pin_masses: Sequence[float] = (),
    damping_ratio: float = 0.0,
    damping_time: float = 0.0,
) -> Rotor:
    """Return the free crankshaft as nodes and matrices.

    `webs`: "solid" (a whole-web element from the meshed half throw), "fitted" (the paper's six
    flexibilities, fitted to it), "formula" (Ker Wilson's lengths), "nominal" (plain beams), or a function
    from an `Arm` to its (6, 6) flexibility or `WebCompliance`. Solved webs come from `store`, by default
    the package's own (what it lacks is meshed, with gmsh and scikit-fem).
    `pin_masses` (kg, one per pin, front to rear) are big ends counted as part of the turning crank.
    Damping is `damping_ratio` of critical in every elastic mode, plus `damping_time` (s) times K.

    >>> from symbalance.crankshaft.crank import Crank, Journal, Pin, Web
    >>> web = Web(0.02, 0.08, 0.04, 0.04)
    >>> throw = (Journal(0.06, 0.03), web, Pin(0.05, 0.03, 0.04, 0.0, (1,)), web, Journal(0.06, 0.03))
    >>> rotor = assemble(Crank(throw))
    >>> rotor.size, rotor.journals, rotor.pins
    (54, (1, 7), (4,))
    """
    check_kind(crank, Crank, "crank", "sb.crankshaft.Crank(parts), journal, web, pin, web, journal, …")
    elastic = _elastic(crank, web_flexibility(webs, store))
    nodes = place_nodes(crank, elastic)
    members = [*_members(crank, nodes, elastic)]
    spans = [(front, rear, beam) for front, rear, beam, _, _ in beams(crank, nodes)]
    rotor = assemble_rotor(nodes.points, members, spans, [*_bodies(crank, nodes, pin_masses)])
    bearings = [i for i, part in enumerate(crank.parts) if isinstance(part, Journal) and part.bearing]
    rotor = replace(
        rotor,
        journals=tuple(nodes.ends[i][1] for i in bearings),
        pins=_middles(crank, nodes, Pin),
        pulley=nodes.pulley,
        flywheel=nodes.flywheel,
    )
    return damped(rotor, damping_ratio, damping_time)


def web_flexibility(webs: str | Flexibility, store: WebStore | None) -> Flexibility:
    """Return the model of a web's flexibility that `webs` names (see `assemble`), or refuse the name."""
    if not isinstance(webs, str):
        return webs
    if webs not in WEBS:
        raise SymbalanceError(f"webs = {brief(webs)}", f"must be one of {', '.join(WEBS)}")
    if webs in ("nominal", "formula"):
        return nominal_flexibility if webs == "nominal" else formula_flexibility
    solved_webs = open_store() if store is None else store
    if webs == "solid":
        return lambda arm: solid_web(arm, solved_webs)
    return lambda arm: fitted_flexibility(arm, solid_web(arm, solved_webs).face)


def _elastic(crank: Crank, flexibility: Flexibility) -> dict[int, WebCompliance]:
    flexibilities = {index: flexibility(arm) for index, arm in arms(crank)}
    return {
        index: web if isinstance(web, WebCompliance) else WebCompliance(web)
        for index, web in flexibilities.items()
    }


def place_nodes(crank: Crank, elastic: dict[int, WebCompliance]) -> Nodes:
    """Return the nodes: front, middle and rear of each journal and pin, then discs, then webs' bodies."""
    points: list[Array] = []
    ends: dict[int, tuple[int, int, int]] = {}
    for index, (part, start, stop) in enumerate(crank.stations()):
        if isinstance(part, Web):
            continue
        at = len(points)
        points += [np.array([*axis_of(part), w]) for w in (start, (start + stop) / 2, stop)]
        ends[index] = (at, at + 1, at + 2)
    last = len(points) - 1
    pulley = _disc_node(points, 0, crank.pulley, -1)
    flywheel = _disc_node(points, last, crank.flywheel, 1)
    body_nodes: dict[int, int] = {}
    for index, arm in arms(crank):
        if (body := elastic[index].body) is not None:
            body_nodes[index] = len(points)
            points.append(arm.place_of(body, points[_faces(ends, index, arm)[0]]))
    return Nodes(np.array(points), ends, pulley, flywheel, body_nodes)


def _faces(ends: dict[int, tuple[int, int, int]], index: int, arm: Arm) -> tuple[int, int]:
    """Return the near and the far node of a web."""
    front, rear = ends[index - 1][2], ends[index + 1][0]
    return (rear, front) if arm.mirrored else (front, rear)


def _disc_node(points: list[Array], end: int, disc: Disc | None, side: int) -> int | None:
    if disc is None or disc.distance == 0:
        return None if disc is None else end
    points.append(points[end] + [0.0, 0.0, side * disc.distance])
    return len(points) - 1


def beams(crank: Crank, nodes: Nodes) -> Iterator[tuple[int, int, Beam, str, int]]:
    """Yield front node, rear node, beam, kind and part: halves of journals and pins, shafts."""
    material = crank.material
    for index, part in enumerate(crank.parts):
        if isinstance(part, Web):
            continue
        section = circular(part.diameter, part.bore, material.poisson)
        half = Beam(section, material, part.length / 2, ALONG_W)
        kind = "journal" if isinstance(part, Journal) else "pin"
        front, middle, rear = nodes.ends[index]
        yield front, middle, half, kind, index
        yield middle, rear, half, kind, index
    yield from _shafts(crank, nodes)


def _shafts(crank: Crank, nodes: Nodes) -> Iterator[tuple[int, int, Beam, str, int]]:
    first, last = 0, nodes.ends[len(crank.parts) - 1][2]
    for disc, node, end in ((crank.pulley, nodes.pulley, first), (crank.flywheel, nodes.flywheel, last)):
        if disc is None or node is None or node == end:
            continue
        carrier = crank.parts[0 if end == first else -1]
        assert isinstance(carrier, Journal)
        section = circular(disc.diameter or carrier.diameter, 0.0, crank.material.poisson)
        front, rear = (node, end) if end == first else (end, node)
        yield front, rear, Beam(section, crank.material, disc.distance, ALONG_W), "shaft", -1


def _members(crank: Crank, nodes: Nodes, elastic: dict[int, WebCompliance]) -> Iterator[Member]:
    for front, rear, beam, kind, index in beams(crank, nodes):
        yield Member(front, rear, beam.stiffness, kind, index)
    for index, arm in arms(crank):
        front, rear = nodes.ends[index - 1][2], nodes.ends[index + 1][0]
        web, body = elastic[index], None
        if index in nodes.body_nodes:
            body = AttachedBody(
                nodes.body_nodes[index], arm.web_stiffness(web), in_front=not arm.mirrored
            )
        yield Member(front, rear, arm.web_stiffness(WebCompliance(web.face)), "web", index, body)
    for index, (before, after) in enumerate(zip(crank.parts, crank.parts[1:], strict=False)):
        if isinstance(before, Pin) and isinstance(after, Pin):
            yield _joint(crank, nodes, index, before, after)


def _joint(crank: Crank, nodes: Nodes, index: int, before: Pin, after: Pin) -> Member:
    """Return the joint of two pins that meet without a web: a beam short enough to be all but rigid."""
    front, rear = nodes.ends[index][2], nodes.ends[index + 1][0]
    short = min(before.length, after.length) / 2000  # a thousandth of half a pin
    section = circular(min(before.diameter, after.diameter), 0.0, crank.material.poisson)
    lever = nodes.points[rear] - nodes.points[front]
    flexible = flexibility(section, crank.material, short)
    return Member(front, rear, element(flexible, lever), "pin", index)


def _bodies(crank: Crank, nodes: Nodes, pin_masses: Sequence[float]) -> Iterator[tuple[int, RigidBody]]:
    for index, arm in arms(crank):
        near, far = _faces(nodes.ends, index, arm)
        holder = nodes.body_nodes.get(index, near)
        away = nodes.points[near] - nodes.points[holder]
        yield from ((holder, body.shifted(away)) for body in near_bodies(arm))
        yield from ((near, body) for body in near_fillet(arm))
        yield from ((far, body) for body in far_bodies(arm))
    for disc, node in ((crank.pulley, nodes.pulley), (crank.flywheel, nodes.flywheel)):
        if disc is not None and node is not None:
            yield node, disc_body(disc)
    yield from _big_ends(crank, nodes, pin_masses)


def _big_ends(crank: Crank, nodes: Nodes, pin_masses: Sequence[float]) -> Iterator[tuple[int, RigidBody]]:
    places = _middles(crank, nodes, Pin)
    if pin_masses and len(pin_masses) != len(places):
        rule = f"must be one per pin, {len(places)}"
        raise SymbalanceError(f"{len(pin_masses)} pin masses", rule, "kg each, front to rear")
    for node, mass in zip(places, pin_masses, strict=False):
        yield node, RigidBody(float(mass), np.zeros(3), np.zeros((3, 3)))


def _middles(crank: Crank, nodes: Nodes, kind: type) -> tuple[int, ...]:
    return tuple(nodes.ends[i][1] for i, part in enumerate(crank.parts) if isinstance(part, kind))
