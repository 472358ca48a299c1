"""The crankshaft on its bearings: linear equations whose coefficients are periodic in the crank angle.

    M x'' + D x' + S x = f(theta) + sum over bearings of B_j^T b_j,     theta = omega t,

D = C + omega G and S = K + omega^2 dK (less whatever holds the free spin). B_j x is the displacement
(u, v) of bearing j's journal in turning coordinates; its film and housing live in the stationary
ones, (vertical, lateral) = R(theta) (u, v).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symbalance.crankshaft.arguments import check_function, check_kind
from symbalance.crankshaft.rotor import Array
from symbalance.errors import SymbalanceError


class UnsolvedError(SymbalanceError):
    """Sound input whose equations gave no answer: no periodic motion, no orbit that closes."""


@dataclass(frozen=True)
class Film:
    """All bearings' oil films against the crank angle: angles (s,) in, (s, b, 2, 2) out; stationary axes.

    `stiffness` in N/m and `damping` in N s/m are tangents: force of the shaft on the film per journal
    displacement and velocity, rows vertical, lateral.
    """

    stiffness: Callable[[Array], Array]
    damping: Callable[[Array], Array]

    def __post_init__(self) -> None:
        for name in ("stiffness", "damping"):
            remedy = "a function of angles (s,) to (s, b, 2, 2); sb.film_from_tables makes one"
            check_function(getattr(self, name), f"film {name}", remedy)


@dataclass(frozen=True)
class Housing:
    """The structure behind each film: (b, 2, 2) `stiffness` and `damping`, N/m and N s/m, stationary."""

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
    """What is integrated; `force` takes angles (s,), gives (s, n) in turning coordinates, N and N m.

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
        check_kind(self.film, Film, "film", "sb.Film(stiffness, damping), or sb.film_from_tables(...)")
        if self.housing is not None:
            check_kind(self.housing, Housing, "housing", "sb.Housing(stiffness, damping), or None")
        check_function(self.force, "force", "a function of angles (s,) to (s, n)")

    @property
    def size(self) -> int:
        """The number of unknowns, without housing states."""
        return len(self.mass)


def check_system(value: object) -> None:
    """Refuse what is no periodic system: a rotor needs its supports first."""
    remedy = "sb.supported(rotor, supports, omega) makes one of a rotor"
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
