"""Assembly of a rotor's matrices from elastic elements, beams and rigid bodies; modal damping."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.rotor.beams import Beam
from symbalance.crankshaft.rotor.matrices import Member, Rotor
from symbalance.crankshaft.rotor.rigid_bodies import RigidBody, node_force, node_matrices


@dataclass(frozen=True)
class _Sums:
    """The matrices and the force that every piece is added to."""

    mass: Array
    gyroscopic: Array
    centrifugal: Array
    force: Array


def assemble_rotor(
    points: Array,
    members: Sequence[Member],
    spans: Iterable[tuple[int, int, Beam]],
    bodies: Iterable[tuple[int, RigidBody]],
) -> Rotor:
    """Return the undamped rotor of these nodes (n, 3).

    `members` carry its stiffness; the beams between nodes (front, rear, beam) and the bodies (node, body)
    its mass, and with it G, dK and F_M.
    """
    size = DOF * len(points)
    stiffness = np.zeros((size, size))
    for member in members:
        _add(stiffness, member.whole, *member.nodes)
    sums = _Sums(*np.zeros((3, size, size)), force=np.zeros(size))
    for front, rear, beam in spans:
        _add_beam(sums, points[front], (front, rear), beam)
    for node, body in bodies:
        _add_body(sums, points[node], node, body)
    return Rotor(
        points=points,
        mass=sums.mass,
        stiffness=stiffness,
        damping=np.zeros_like(stiffness),
        gyroscopic=sums.gyroscopic,
        centrifugal=sums.centrifugal,
        centrifugal_force=sums.force,
        journals=(),
        pins=(),
        members=tuple(members),
    )


def _add(total: Array, piece: Array, *nodes: int) -> None:
    unknowns = np.concatenate([np.arange(DOF * node, DOF * node + DOF) for node in nodes])
    total[np.ix_(unknowns, unknowns)] += piece


def _add_body(sums: _Sums, point: Array, node: int, body: RigidBody) -> None:
    matrices = node_matrices(body.mass, body.offset, body.inertia, point)
    for total, piece in zip((sums.mass, sums.gyroscopic, sums.centrifugal), matrices, strict=True):
        _add(total, piece, node)
    sums.force[DOF * node : DOF * node + DOF] += node_force(body.mass, point, body.offset, body.inertia)


def _add_beam(sums: _Sums, start: Array, ends: tuple[int, int], beam: Beam) -> None:
    """Add a beam's slices, each a thin rigid disc, by the beam's own interpolation."""
    mass, inertia, no_offset = beam.material.density * beam.section.area, beam.inertia, np.zeros(3)
    slices = np.array(node_matrices(mass, no_offset, inertia))
    totals, force = np.zeros((3, 2 * DOF, 2 * DOF)), np.zeros(2 * DOF)
    for weight, lever, shape in beam.interpolations():
        totals += weight * (shape.T @ slices @ shape)
        force += weight * (shape.T @ node_force(mass, start + lever, no_offset, inertia))
    for total, piece in zip((sums.mass, sums.gyroscopic, sums.centrifugal), totals, strict=True):
        _add(total, piece, *ends)
    for node, part in zip(ends, (force[:DOF], force[DOF:]), strict=True):
        sums.force[DOF * node : DOF * node + DOF] += part


def damped(rotor: Rotor, ratio: float, time: float) -> Rotor:
    """Return the rotor with `ratio` of critical damping in every elastic mode, and `time` (s) times K."""
    damping = time * rotor.stiffness
    return replace(rotor, damping=damping + modal_damping(rotor, ratio) if ratio else damping)


def modal_damping(rotor: Rotor, ratio: float) -> Array:
    """Return the C that gives every elastic mode this ratio of critical damping, rigid motions none.

    C = 2 ratio M^(1/2) (M^(-1/2) K M^(-1/2))^(1/2) M^(1/2): no mode needs to be named.
    """
    factor = np.linalg.cholesky(rotor.mass)
    inverse = np.linalg.inv(factor)
    squares, shapes = np.linalg.eigh(inverse @ rotor.stiffness @ inverse.T)
    roots = np.sqrt(np.maximum(squares, 0.0))
    motions = factor @ shapes
    return 2 * ratio * (motions * roots) @ motions.T
