"""The bearings of a periodic system at given angles, as every integrator needs them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symbalance.crankshaft.frames import QUARTER_TURN, rotation
from symbalance.crankshaft.rotor import Array
from symbalance.crankshaft.system import PeriodicSystem
from symbalance.errors import SymbalanceError


@dataclass(frozen=True)
class Coefficients:
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


def coefficients(system: PeriodicSystem, theta: Array) -> Coefficients:
    """Return the films' matrices at angles (s,); refuses what is not finite."""
    turn = rotation(theta)
    spread = turn[:, None]
    stiff, damped = system.film.stiffness(theta), system.film.damping(theta)
    if not (np.isfinite(stiff).all() and np.isfinite(damped).all()):
        raise SymbalanceError("a film coefficient", "must be finite", "look at the bearings' tables")
    velocity = damped @ spread
    return Coefficients(
        turn, stiff, damped, stiff @ spread + system.omega * velocity @ QUARTER_TURN, velocity
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


def gathered(system: PeriodicSystem) -> Array:
    """Return B (2 b, n), all bearings' rows in one matrix."""
    return system.points.reshape(2 * bearing_count(system), system.size)


def units(system: PeriodicSystem) -> Array:
    """Return what each part of a state is measured in: displacements 1, velocities 20 omega."""
    n, housing = system.size, housing_size(system)
    return np.concatenate([np.ones(n), np.full(n, 20 * system.omega), np.ones(housing)])
