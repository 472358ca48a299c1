"""The crankshaft on its bearings: linear equations whose coefficients are periodic in the crank angle.

    M x'' + D x' + S x = f(theta) + sum over bearings of B_j^T b_j,     theta = omega t,

D = C + omega G and S = K + omega^2 dK (with the rigid-body rotation constrained). B_j x is the
displacement (u, v) of bearing j's journal in turning coordinates; its film and housing live in the
stationary ones, (vertical, lateral) = R(theta) (u, v).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symbalance.crankshaft.arguments import check_function, check_kind
from symbalance.crankshaft.arrays import Array
from symbalance.errors import SymbalanceError, brief

LEAST_STEPS, MOST_STEPS = 4, 200_000


class UnsolvedError(SymbalanceError):
    """Valid input whose equations have no solution: no periodic motion, or no closed journal orbit."""


@dataclass(frozen=True)
class Film:
    """Stiffness and damping (s, b, 2, 2) of all oil films at crank angles (s,), stationary axes.

    `stiffness` in N/m and `damping` in N s/m are tangents: force of the shaft on the film per journal
    displacement and velocity, rows vertical, lateral.
    """

    stiffness: Callable[[Array], Array]
    damping: Callable[[Array], Array]

    def __post_init__(self) -> None:
        for name in ("stiffness", "damping"):
            remedy = "a function of angles (s,) to (s, b, 2, 2); sb.crankshaft.film_from_tables makes one"
            check_function(getattr(self, name), f"film {name}", remedy)


@dataclass(frozen=True)
class Housing:
    """Stiffness and damping (b, 2, 2) of the structure behind each film, N/m, N s/m, stationary axes."""

    stiffness: Array
    damping: Array

    def __post_init__(self) -> None:
        shapes = [np.shape(self.stiffness), np.shape(self.damping)]
        for name, shape in zip(("stiffness", "damping"), shapes, strict=True):
            if len(shape) != 3 or shape[1:] != (2, 2) or shape != shapes[0]:
                remedy = "a 2 x 2 matrix for each bearing, N/m and N s/m"
                raise SymbalanceError(f"housing {name} of shape {shape}", "must be (b, 2, 2)", remedy)


@dataclass(frozen=True)
class PeriodicSystem:
    """A rotor on its bearings; `force` takes angles (s,), gives (s, n) in turning coordinates, N and N m.

    `cycle` is the crank angle after which everything repeats, in radians. `points` is (b, 2, n).
    Without a `housing` the films are fixed to the ground.
    """

    mass: Array
    damping: Array
    stiffness: Array
    points: Array
    film: Film
    housing: Housing | None
    force: Callable[[Array], Array]
    omega: float
    cycle: float = 4 * np.pi

    def __post_init__(self) -> None:
        check_kind(
            self.film,
            Film,
            "film",
            "sb.crankshaft.Film(stiffness, damping), or sb.crankshaft.film_from_tables(...)",
        )
        if self.housing is not None:
            check_kind(
                self.housing, Housing, "housing", "sb.crankshaft.Housing(stiffness, damping), or None"
            )
        check_function(self.force, "force", "a function of angles (s,) to (s, n)")

    @property
    def size(self) -> int:
        """The number of unknowns, without housing states."""
        return len(self.mass)


def check_system(value: object) -> None:
    """Refuse what is no `PeriodicSystem`: a rotor needs its supports first."""
    remedy = "sb.crankshaft.rotor.system_on_supports(rotor, supports, omega) makes one of a rotor"
    check_kind(value, PeriodicSystem, "system", remedy)


@dataclass(frozen=True)
class Trajectory:
    """A solution over one cycle: `theta` (s,), `position`, `velocity` (s, n), `bearing` (s, b, 2).

    Bearing forces are those on the shaft, stationary axes, N. `error` is what the method says of its own
    error, relative; `seconds` its run time.
    """

    theta: Array
    position: Array
    velocity: Array
    bearing: Array
    multipliers: NDArray[np.complexfloating[Any, Any]] | None = None
    error: float = float("nan")
    seconds: float = float("nan")


def check_steps(steps: int) -> None:
    """Refuse a number of steps a cycle that no run can have."""
    if not isinstance(steps, int | np.integer) or not LEAST_STEPS <= steps <= MOST_STEPS:
        rule = f"must be a whole number, at least {LEAST_STEPS} and at most {MOST_STEPS}"
        raise SymbalanceError(f"steps = {brief(steps)}", rule, "720 is usual")


def check_consistency(system: PeriodicSystem) -> None:
    """Refuse a speed or cycle that is not positive, shapes that do not fit, matrices that are not finite,
    a mass matrix or a housing that is not positive definite."""
    check_system(system)
    if not 0 < system.omega < np.inf:
        rule = "must be positive and finite"
        raise SymbalanceError(f"speed = {brief(system.omega)} rad/s", rule, "give rpm > 0")
    if not 0 < system.cycle < np.inf:
        rule = "must be positive and finite"
        raise SymbalanceError(f"cycle = {brief(system.cycle)} rad", rule, "4 pi, or 2 pi for one turn")
    _check_shapes(system)
    for name in ("mass", "damping", "stiffness", "points"):
        if not np.isfinite(getattr(system, name)).all():
            raise SymbalanceError(f"the crank's {name}", "must be finite", "look at its sizes")
    try:
        np.linalg.cholesky(system.mass)
    except np.linalg.LinAlgError:
        rule, remedy = "must be positive definite", "give every unknown a mass, or leave it out"
        raise SymbalanceError("the mass matrix", rule, remedy) from None
    if system.housing is not None:
        _check_housing(system.housing)


def _check_shapes(system: PeriodicSystem) -> None:
    """Refuse matrices, films and forces whose shapes are not those of n unknowns and b bearings."""
    n, count, angles = len(system.mass), len(system.points), np.zeros(1)
    film = (1, count, 2, 2)
    for name, array, shape in (
        ("mass", system.mass, (n, n)),
        ("damping", system.damping, (n, n)),
        ("stiffness", system.stiffness, (n, n)),
        ("points", system.points, (count, 2, n)),
        ("force at one angle", system.force(angles), (1, n)),
        ("film stiffness at one angle", system.film.stiffness(angles), film),
        ("film damping at one angle", system.film.damping(angles), film),
    ):
        if np.shape(array) != shape:
            what = f"{name} of shape {np.shape(array)}"
            raise SymbalanceError(what, f"must be {shape}", f"{n} unknowns, {count} bearings")


def _check_housing(housing: Housing) -> None:
    for name, table, unit in (
        ("stiffness", housing.stiffness, "N/m"),
        ("damping", housing.damping, "N s/m"),
    ):
        for j, each in enumerate(table):
            place = f"bearing {j + 1}"
            if not np.isfinite(each).all():
                remedy = "leave the housing out where it is rigid"
                raise SymbalanceError(f"housing {name}", "must be finite", remedy, place)
            least = _least(each)
            if least < 0 or (name == "stiffness" and least == 0):
                rule = (
                    f"must be {'positive' if name == 'stiffness' else 'zero or more'} in every direction"
                )
                what = f"housing {name} {brief(float(f'{least:.4g}'))} {unit}"
                raise SymbalanceError(what, rule, "leave the housing out where it is rigid", place)


def _least(matrix: Array) -> float:
    """Return the least eigenvalue of the symmetric part; rounding below 1e-12 of the largest is 0."""
    values = np.linalg.eigvalsh((matrix + matrix.T) / 2)
    return 0.0 if abs(values[0]) <= 1e-12 * np.abs(values).max() else float(values[0])
