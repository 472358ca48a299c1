"""Film matrices of a rotor's bearings at given crank angles, and the bearing forces of a state."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.frames import QUARTER_TURN, rotation
from symbalance.crankshaft.system import PeriodicSystem
from symbalance.errors import SymbalanceError


@dataclass(frozen=True)
class BearingCoefficients:
    """Films at angles (s,): what a turning displacement (`stiffness`) and velocity (`damping`) give.

    A film carries `stiffness` d + `damping` d' in stationary axes, d and d' in turning ones: its
    matrices are K R + omega C R S and C R, (s, b, 2, 2). `film_stiffness` K and `film_damping` C are
    the stationary ones themselves, `turn` is R (s, 2, 2).
    """

    turn: Array
    film_stiffness: Array
    film_damping: Array
    stiffness: Array
    damping: Array


def bearing_coefficients(system: PeriodicSystem, theta: Array) -> BearingCoefficients:
    """Return the films' matrices at angles (s,); refuses what is not finite."""
    turn = rotation(theta)
    turns = turn[:, None]
    spring, damper = system.film.stiffness(theta), system.film.damping(theta)
    if not (np.isfinite(spring).all() and np.isfinite(damper).all()):
        raise SymbalanceError("a film coefficient", "must be finite", "look at the bearings' tables")
    velocity = damper @ turns
    return BearingCoefficients(
        turn, spring, damper, spring @ turns + system.omega * velocity @ QUARTER_TURN, velocity
    )


def bearing_count(system: PeriodicSystem) -> int:
    """Return the number of bearings."""
    return len(system.points)


def housing_size(system: PeriodicSystem) -> int:
    """Return the number of housing states: two a bearing, none without a housing."""
    return 0 if system.housing is None else 2 * bearing_count(system)


def state_size(system: PeriodicSystem) -> int:
    """Return the length of a state: displacements, velocities, housing displacements."""
    return 2 * system.size + housing_size(system)


def bearing_rows(system: PeriodicSystem) -> Array:
    """Return B (2 b, n): the displacements u, v at all bearings."""
    return system.points.reshape(2 * bearing_count(system), system.size)


def state_units(system: PeriodicSystem) -> Array:
    """Return the unit in which each part of a state is compared: displacements 1, velocities 20 omega."""
    n, housing = system.size, housing_size(system)
    return np.concatenate([np.ones(n), np.full(n, 20 * system.omega), np.ones(housing)])


def film_laws(system: PeriodicSystem, theta: Array) -> tuple[Array, Array]:
    """Return, per angle and bearing, the film's force in turning axes and z' per (d, d', z).

    Shapes (s, b, 2, 6) and (s, b, 2, 6); without a housing (s, b, 2, 4) and (s, b, 0, 4). Where neither
    film nor housing damps a direction, its z follows without delay and this form does not exist: the
    least-squares rate is taken, right for z' = 0.
    """
    at = bearing_coefficients(system, theta)
    back = np.swapaxes(at.turn, -1, -2)[:, None]
    direct = np.concatenate([at.stiffness, at.damping], axis=-1)
    if system.housing is None:
        return back @ direct, np.zeros((*direct.shape[:2], 0, 4))
    stiffness = np.broadcast_to(system.housing.stiffness, at.film_stiffness.shape)
    inverse = np.linalg.pinv(at.film_damping + system.housing.damping)
    rate = inverse @ np.concatenate([direct, -at.film_stiffness - stiffness], axis=-1)
    film = np.concatenate([direct, -at.film_stiffness], axis=-1) - at.film_damping @ rate
    return back @ film, rate


def film_forces(system: PeriodicSystem, theta: Array, states: Array) -> Array:
    """Return the bearings' forces on the shaft, stationary axes, (s, b, 2), of states (s, size)."""
    n, count = system.size, len(system.points)
    laws, _ = film_laws(system, theta)
    place = np.einsum("bcn,sn->sbc", system.points, states[:, :n])
    speed = np.einsum("bcn,sn->sbc", system.points, states[:, n : 2 * n])
    rest = states[:, 2 * n :].reshape(len(theta), count, 0 if system.housing is None else 2)
    turning = laws @ np.concatenate([place, speed, rest], axis=-1)[..., None]
    return -(bearing_coefficients(system, theta).turn[:, None] @ turning)[..., 0]


def block_matrix(laws: Array) -> Array:
    """Return one angle's (b, r, 2 k) as one matrix (b r, k 2b), columns by kind, then bearing."""
    count, rows, columns = laws.shape
    full = np.zeros((count, rows, columns // 2, count, 2))
    for j in range(count):
        full[j, :, :, j, :] = laws[j].reshape(rows, columns // 2, 2)
    return full.reshape(count * rows, columns * count)
