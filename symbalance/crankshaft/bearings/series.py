"""Oil film and housing in series: equivalent coefficients as published, and the exact connection.

At one frequency W the dynamic stiffnesses Z = K + i W C and Z_B = K_B + i W C_B in series give

    Z* = Z (Z + Z_B)^-1 Z_B,     K* = Re Z*,     C* = Im Z*/W:

the paper's equivalent coefficients, taken at every crank angle as if it stood still. With the cross terms
of K they can exceed the film's own. Exact: the housing's displacement z is a state, K_B z + C_B z' = b.
What the film's change with the angle then does to z, the quasi-static way leaves out.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.system import Film, Housing, PeriodicSystem


def equivalent_coefficients(
    film: tuple[Array, Array], housing: Housing, frequency: float
) -> tuple[Array, Array]:
    """Return K* and C* (..., b, 2, 2) of a film's K and C, at `frequency` in rad/s; at 0 its limit.

    Two springs of 2 and 2 N/m in series:

    >>> two = 2 * np.eye(2)[None]
    >>> stiffness, damping = equivalent_coefficients((two, two), Housing(two, 0 * two), 0.0)
    >>> stiffness[0].round(12), damping[0].round(12)
    (array([[1., 0.],
           [0., 1.]]), array([[0.5, 0. ],
           [0. , 0.5]]))
    """
    stiffness, damping = film
    if frequency == 0:
        share = np.linalg.solve(stiffness + housing.stiffness, housing.stiffness)
        other = np.swapaxes(stiffness + housing.stiffness, -1, -2)
        rest = np.swapaxes(np.linalg.solve(other, np.swapaxes(stiffness, -1, -2)), -1, -2)
        return stiffness @ share, (np.eye(2) - rest) @ damping @ share + rest @ housing.damping @ (
            np.eye(2) - share
        )
    dynamic = stiffness + 1j * frequency * damping
    behind = housing.stiffness + 1j * frequency * housing.damping
    series = dynamic @ np.linalg.solve(dynamic + behind, behind + 0 * dynamic)
    return series.real, series.imag / frequency


def equivalent_system(system: PeriodicSystem, order: float = 0.0) -> PeriodicSystem:
    """Return the system with the paper's equivalent film in place of film and housing, at one order."""
    housing = system.housing
    if housing is None:
        return system
    film, frequency = system.film, order * system.omega

    def both(theta: Array) -> tuple[Array, Array]:
        return equivalent_coefficients((film.stiffness(theta), film.damping(theta)), housing, frequency)

    equivalent = Film(lambda theta: both(theta)[0], lambda theta: both(theta)[1])
    return replace(system, film=equivalent, housing=None)
