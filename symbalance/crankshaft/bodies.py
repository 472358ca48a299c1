"""Rigid bodies that sit at a node: mass, where its centre is, its inertia there. SI units."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symbalance.crankshaft.crank import Disc
from symbalance.crankshaft.rotor import Array


@dataclass(frozen=True)
class Body:
    """A rigid body: mass, `offset` (3,) from node to mass centre, `inertia` (3, 3) about that centre."""

    mass: float
    offset: Array
    inertia: Array

    def turned(self, angle: float) -> Body:
        """Return the body turned by `angle` about W."""
        turn = turn_about_w(angle)
        return Body(self.mass, turn @ self.offset, turn @ self.inertia @ turn.T)

    def mirrored(self) -> Body:
        """Return the body reflected front to rear."""
        flip = np.diag([1.0, 1.0, -1.0])
        return Body(self.mass, flip @ self.offset, flip @ self.inertia @ flip)

    def shifted(self, lever: Array) -> Body:
        """Return the same body seen from a node `lever` before the old one."""
        return Body(self.mass, self.offset + lever, self.inertia)


def turn_about_w(angle: float) -> Array:
    """Return the rotation (3, 3) by `angle` radians about W.

    >>> turn_about_w(np.pi / 2).round(12) @ [1.0, 0.0, 0.0]
    array([0., 1., 0.])
    """
    cos, sin = np.cos(angle), np.sin(angle)
    return np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])


def disc_body(disc: Disc) -> Body:
    """Return a disc as a body centred on its node.

    >>> disc_body(Disc(2.0, 3.0, 4.0)).inertia.diagonal()
    array([4., 4., 3.])
    """
    return Body(disc.mass, np.zeros(3), np.diag([disc.diametral, disc.diametral, disc.polar]))


def ring(area: float, radius: float, place: float, density: float) -> Body:
    """Return a thin ring about W of cross-section `area` and mean `radius`, `place` along W."""
    mass = 2 * np.pi * radius * area * density
    about = mass * radius**2
    return Body(mass, np.array([0.0, 0.0, place]), np.diag([about / 2, about / 2, about]))
