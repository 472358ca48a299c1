"""Stiffness and mass of Timoshenko beams and other two-ended elastic pieces, from their flexibility.

A piece between a front and a rear end, clamped at its front, has the displacement S F of its rear end
under a load F there. With T the rigid transfer of a displacement from front to rear and K = S^-1, its
stiffness between the two ends is

    [ T' K T   -T' K ]
    [ -K T       K   ],

and pieces in a chain add their flexibilities, each transferred to the last end: S = sum T_k S_k T_k'.
Displacements inside follow from the same two facts, so that the mass matrix is the consistent one, with
rotary inertia.

Source: the flexibility of a straight beam with shear, S. Timoshenko, Phil. Mag. 41 (1921); shear
coefficients, G. R. Cowper, J. Appl. Mech. 33 (1966), 335-340.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import pi

import numpy as np

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.rotor.parts import Material

ALONG_W = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
"""A beam along W: its own axes x, y, z are W, U, V."""


@dataclass(frozen=True)
class CrossSection:
    """A cross-section in the beam's own axes (x along it), SI.

    `area`; `shear_y`, `shear_z` effective in shear; `torsion` constant; `bend_y`, `bend_z` second moments
    of area about y and z.
    """

    area: float
    shear_y: float
    shear_z: float
    torsion: float
    bend_y: float
    bend_z: float


def circular(diameter: float, bore: float, poisson: float) -> CrossSection:
    """Return the section of a round bar or tube.

    Shear coefficient 6 (1+nu) (1+m^2)^2 / ((7+6 nu) (1+m^2)^2 + (20+12 nu) m^2), m = bore/diameter:
    Cowper (1966), hollow circle.

    >>> round(circular(0.1, 0, 0.3).shear_y / circular(0.1, 0, 0.3).area, 4)
    0.8864
    """
    area = pi / 4 * (diameter**2 - bore**2)
    bend = pi / 64 * (diameter**4 - bore**4)
    ratio = (bore / diameter) ** 2
    whole = (1 + ratio) ** 2
    shear = 6 * (1 + poisson) * whole / ((7 + 6 * poisson) * whole + (20 + 12 * poisson) * ratio)
    return CrossSection(area, shear * area, shear * area, 2 * bend, bend, bend)


def rectangular(height: float, depth: float, poisson: float) -> CrossSection:
    """Return the section of a rectangle, `height` along y and `depth` along z.

    Shear coefficient 10 (1+nu)/(12+11 nu), Cowper (1966); torsion constant a b^3 (1/3 - 0.21 b/a (1 -
    b^4/(12 a^4))), a >= b, Roark's Formulas for Stress and Strain, table 10.1 (within 4 %).
    """
    area = height * depth
    shear = 10 * (1 + poisson) / (12 + 11 * poisson) * area
    long, short = max(height, depth), min(height, depth)
    torsion = long * short**3 * (1 / 3 - 0.21 * short / long * (1 - (short / long) ** 4 / 12))
    return CrossSection(area, shear, shear, torsion, height * depth**3 / 12, depth * height**3 / 12)


def transfer(lever: Array) -> Array:
    """Return the (6, 6) matrix that takes a rigid body's displacement to a point `lever` away.

    >>> transfer(np.array([0.0, 0.0, 2.0])) @ [0, 0, 0, 1, 0, 0]
    array([ 0., -2.,  0.,  1.,  0.,  0.])
    """
    x, y, z = lever
    matrix = np.eye(DOF)
    matrix[:3, 3:] = [[0, z, -y], [-z, 0, x], [y, -x, 0]]
    return matrix


def in_rotor_axes(matrix: Array, axes: Array) -> Array:
    """Return a (6, 6) matrix given in a piece's own `axes` (rows: x, y, z) in U, V, W instead."""
    turn = np.kron(np.eye(2), axes)
    return turn.T @ matrix @ turn


def flexibility(section: CrossSection, material: Material, length: float, axes: Array = ALONG_W) -> Array:
    """Return the flexibility (6, 6) of a straight beam's far end, clamped at the near one, in U, V, W.

    Along x: L/EA, torsion L/GJ, bending L^3/3EI + L/GA_s, L^2/2EI, L/EI; m/N, rad/N, rad/(N m).
    """
    e, g, s = material.young, material.shear, section
    own = np.zeros((DOF, DOF))
    own[0, 0], own[3, 3] = length / (e * s.area), length / (g * s.torsion)
    for across, about, area, bend, sign in (
        (1, 5, s.shear_y, s.bend_z, 1.0),
        (2, 4, s.shear_z, s.bend_y, -1.0),
    ):
        own[across, across] = length**3 / (3 * e * bend) + length / (g * area)
        own[about, about] = length / (e * bend)
        own[across, about] = own[about, across] = sign * length**2 / (2 * e * bend)
    return in_rotor_axes(own, axes)


def element(flexible: Array, *levers: Array) -> Array:
    """Return the stiffness of a piece between its near end and places of the flexibility `flexible`.

    `levers` lead to those places from the near end: one, and (12, 12), for a far end alone.
    """
    stiffness = np.linalg.inv((flexible + flexible.T) / 2)
    ends = np.hstack([-np.vstack([transfer(lever) for lever in levers]), np.eye(len(flexible))])
    return ends.T @ stiffness @ ends


@dataclass(frozen=True)
class Beam:
    """A straight beam: section, material, length, its `axes` as rows x (along), y, z in U, V, W."""

    section: CrossSection
    material: Material
    length: float
    axes: Array

    @property
    def lever(self) -> Array:
        """From the front end to the rear end."""
        return self.length * self.axes[0]

    @property
    def stiffness(self) -> Array:
        """The (12, 12) stiffness between its ends."""
        return element(flexibility(self.section, self.material, self.length, self.axes), self.lever)

    def interpolations(self) -> Iterator[tuple[float, Array, Array]]:
        """Yield weight (m), lever from the front and interpolation N (6, 12) at four Gauss points.

        The displacement inside is N x, x those of both ends: x(s) = T(s) x_0 + S(s) T(L - s)' K (x_1 -
        T(L) x_0), exact where no load acts between the ends. Four points are exact for N's cubics.
        """
        rear = self.stiffness[DOF:]
        places, weights = np.polynomial.legendre.leggauss(4)
        for place, weight in zip((places + 1) / 2, weights / 2 * self.length, strict=True):
            near = flexibility(self.section, self.material, place * self.length, self.axes)
            start = np.hstack([transfer(place * self.lever), np.zeros((DOF, DOF))])
            shape = start + near @ transfer((1 - place) * self.lever).T @ rear
            yield weight, place * self.lever, shape

    @property
    def inertia(self) -> Array:
        """The inertia tensor (3, 3) of a slice, per metre, about its centre, in U, V, W; kg m."""
        s = self.section
        own = self.material.density * np.diag([s.bend_y + s.bend_z, s.bend_y, s.bend_z])
        return self.axes.T @ own @ self.axes
