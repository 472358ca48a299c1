"""Films and housings at a step's stages, per journal velocity, displacement and housing state."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symbalance.crankshaft.integrators.coefficients import Coefficients, bearing_count
from symbalance.crankshaft.rotor import Array
from symbalance.crankshaft.system import Housing, PeriodicSystem


@dataclass(frozen=True)
class StageFilms:
    """Film forces b in turning axes, stage by stage, for each of N steps; b acts on the film.

    b = velocity v + displacement d + housing z, with the journals' velocities v at the stages (s 2b),
    their displacements d at the step's start (2b) and the housings' z there (2b, or 0); z+ = kept z
    + moved b.
    """

    velocity: Array
    displacement: Array
    housing: Array
    kept: Array
    moved: Array


def stage_films(system: PeriodicSystem, at: Coefficients, matrix: Array, h: float) -> StageFilms:
    """Return the films at the stages of a collocation method with matrix A (s, s) and step h.

    Stage displacements are d + h A v, and z + h A z' for the housings, K_B z + C_B z' = b: exact, as
    the housings have no mass. K_B is not inverted, so that it may grow beyond all bounds.
    """
    s, count = len(matrix), bearing_count(system)
    steps = len(at.turn) // s
    inner, ones = h * np.kron(matrix, np.eye(2)), np.kron(np.ones((s, 1)), np.eye(2))
    turn = _staged(np.broadcast_to(at.turn[:, None], at.stiffness.shape), steps, s)
    stiff, damped = _staged(at.stiffness, steps, s), _staged(at.damping, steps, s)
    sides = np.concatenate([damped + stiff @ inner, stiff @ ones], axis=-1)
    kept, moved = np.zeros((0, 0)), np.zeros((steps, 0, 2 * s * count))
    if system.housing is not None:
        rate = _rates(system.housing, matrix, h)
        film = _staged(at.film_stiffness, steps, s)
        pull = (film @ inner + _staged(at.film_damping, steps, s)) @ rate
        at_rest = pull @ ones @ system.housing.stiffness - film @ ones
        sides = np.linalg.solve(np.eye(2 * s) + pull, np.concatenate([sides, at_rest], axis=-1))
        end = inner[-2:] @ rate
        kept = _spread((np.eye(2) - end @ ones @ system.housing.stiffness)[None], 1, 1)[0]
        moved = _spread(end @ turn, 1, s)
    sides = np.swapaxes(turn, -1, -2) @ sides
    velocity, displacement = sides[..., : 2 * s], sides[..., 2 * s : 2 * s + 2]
    housing = (
        _spread(sides[..., 2 * s + 2 :], s, 1) if system.housing else np.zeros((steps, 2 * s * count, 0))
    )
    return StageFilms(_spread(velocity, s, s), _spread(displacement, s, 1), housing, kept, moved)


def _rates(housing: Housing, matrix: Array, h: float) -> Array:
    """Return what the housings' velocities at the stages are per force beyond K_B z: (b, 2s, 2s)."""
    s, count = len(matrix), len(housing.stiffness)
    stages = np.einsum("ij,bcd->bicjd", h * matrix, housing.stiffness)
    stages += np.einsum("ij,bcd->bicjd", np.eye(s), housing.damping)
    return np.linalg.inv(stages.reshape(count, 2 * s, 2 * s))


def _staged(matrices: Array, steps: int, stages: int) -> Array:
    """Return (N s, b, 2, 2) as (N, b, 2s, 2s), the stages on the diagonal."""
    count = matrices.shape[1]
    full = np.zeros((steps, count, stages, 2, stages, 2))
    given = matrices.reshape(steps, stages, count, 2, 2)
    for i in range(stages):
        full[:, :, i, :, i, :] = given[:, i]
    return full.reshape(steps, count, 2 * stages, 2 * stages)


def _spread(blocks: Array, rows: int, columns: int) -> Array:
    """Return (N, b, 2 rows, 2 columns) as one matrix a step, in the order stage, bearing, direction."""
    steps, count = blocks.shape[:2]
    full = np.zeros((steps, rows, count, 2, columns, count, 2))
    given = blocks.reshape(steps, count, rows, 2, columns, 2)
    for j in range(count):
        full[:, :, j, :, :, j, :] = given[:, j]
    return full.reshape(steps, 2 * rows * count, 2 * columns * count)
