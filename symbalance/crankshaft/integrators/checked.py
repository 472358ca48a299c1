"""What a periodic system must be before anything is integrated."""

from __future__ import annotations

import numpy as np

from symbalance.crankshaft.rotor import Array
from symbalance.crankshaft.system import Housing, PeriodicSystem, check_system
from symbalance.errors import SymbalanceError, shown

LEAST_STEPS, MOST_STEPS = 4, 200_000


def checked_steps(steps: int) -> None:
    """Refuse a number of steps a cycle that no run can have."""
    if not isinstance(steps, int | np.integer) or not LEAST_STEPS <= steps <= MOST_STEPS:
        rule = f"must be a whole number, at least {LEAST_STEPS} and at most {MOST_STEPS}"
        raise SymbalanceError(f"steps = {shown(steps)}", rule, "720 is usual")


def checked_system(system: PeriodicSystem) -> None:
    """Refuse speeds that are none, shapes that do not fit, matrices that are not finite or no mass,
    housings that push themselves away."""
    check_system(system)
    if not 0 < system.omega < np.inf:
        rule = "must be positive and finite"
        raise SymbalanceError(f"speed = {shown(system.omega)} rad/s", rule, "give rpm > 0")
    if not 0 < system.cycle < np.inf:
        rule = "must be positive and finite"
        raise SymbalanceError(f"cycle = {shown(system.cycle)} rad", rule, "4 pi, or 2 pi for one turn")
    _checked_shapes(system)
    for name in ("mass", "damping", "stiffness", "points"):
        if not np.isfinite(getattr(system, name)).all():
            raise SymbalanceError(f"the crank's {name}", "must be finite", "look at its sizes")
    try:
        np.linalg.cholesky(system.mass)
    except np.linalg.LinAlgError:
        rule, remedy = "must be positive definite", "give every unknown a mass, or leave it out"
        raise SymbalanceError("the mass matrix", rule, remedy) from None
    if system.housing is not None:
        _checked_housing(system.housing)


def _checked_shapes(system: PeriodicSystem) -> None:
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


def _checked_housing(housing: Housing) -> None:
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
                what = f"housing {name} {shown(float(f'{least:.4g}'))} {unit}"
                raise SymbalanceError(what, rule, "leave the housing out where it is rigid", place)


def _least(matrix: Array) -> float:
    """Return the least eigenvalue of the symmetric part; rounding below 1e-12 of the largest is 0."""
    values = np.linalg.eigvalsh((matrix + matrix.T) / 2)
    return 0.0 if abs(values[0]) <= 1e-12 * np.abs(values).max() else float(values[0])
