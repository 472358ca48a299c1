"""Torsional vibration of a shaft as discs and springs, and that chain for a given crankshaft.

J_i phi_i'' = c_i (phi_{i+1} - phi_i) - c_{i-1} (phi_i - phi_{i-1})
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.rotor.matrices import Rotor, check_rotor
from symbalance.document.result import Result
from symbalance.errors import SymbalanceError, brief

if TYPE_CHECKING:
    from symbalance.document.nodes import Document


@dataclass(frozen=True, repr=False)
class TorsionalChain(Result):
    """A torsional model: moments of inertia of discs (kg m^2), stiffnesses between them (N m/rad)."""

    inertias: Array
    stiffnesses: Array

    kind: ClassVar[str] = "torsional-chain"

    def summary(self) -> str:
        """Return the discs and the lowest frequency, in one line."""
        return f"Torsional chain of {len(self.inertias)} discs: {self.frequencies()[0]:.5g} Hz and up"

    def document(self) -> Document:
        """Return natural frequencies, shapes, discs and springs."""
        from symbalance.crankshaft.rotor.documents import torsion_document

        return torsion_document(self)

    def data(self) -> dict[str, Any]:
        """Return discs in kg m^2, springs in N m/rad, modes in Hz with shapes, sum of J phi^2 = 1."""
        hertz, shapes = self.modes()
        modes = [
            {"hertz": float(f), "shape": row} for f, row in zip(hertz, shapes.T.tolist(), strict=True)
        ]
        return {
            "inertias": self.inertias.tolist(),
            "stiffnesses": self.stiffnesses.tolist(),
            "modes": modes,
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each natural frequency."""
        return [{"mode": k, "hertz": float(f)} for k, f in enumerate(self.frequencies(), 1)]

    @property
    def matrices(self) -> tuple[Array, Array]:
        """Mass and stiffness matrix."""
        size = len(self.inertias)
        twist = np.diff(np.eye(size), axis=0)
        return np.diag(self.inertias), twist.T @ (self.stiffnesses[:, None] * twist)

    def frequencies(self) -> Array:
        """Return the elastic natural frequencies in Hz, rising; the rigid-body rotation is left out."""
        return self.modes()[0]

    def modes(self) -> tuple[Array, Array]:
        """Return frequencies (k,) in Hz and shapes (n, k), sum of J phi^2 = 1.

        The eigenvalues of the twists' own matrix D J^-1 D' (D the differences), where the rigid-body
        rotation does not appear: no low frequency loses digits to a zero.
        """
        root = np.sqrt(self.stiffnesses)
        twist = np.diff(np.eye(len(self.inertias)), axis=0) * root[:, None] / np.sqrt(self.inertias)
        squares, vectors = np.linalg.eigh(twist @ twist.T)
        shapes = (twist.T @ vectors) / np.sqrt(squares) / np.sqrt(self.inertias)[:, None]
        return np.sqrt(squares) / (2 * np.pi), shapes


def torsional_chain(inertias: Sequence[float], stiffnesses: Sequence[float]) -> TorsionalChain:
    """Return the torsional model of discs (kg m^2) joined by springs (N m/rad).

    >>> torsional_chain([2.0, 2.0], [1.0]).frequencies() * 2 * np.pi
    array([1.])
    """
    try:
        discs, springs = (np.array([*map(float, values)]) for values in (inertias, stiffnesses))
    except (TypeError, ValueError):
        rule = "must be two lists of numbers"
        raise SymbalanceError("inertias and stiffnesses", rule, "kg m^2, N m/rad") from None
    if len(discs) < 2 or len(springs) != len(discs) - 1:
        what = f"{len(discs)} discs, {len(springs)} springs"
        raise SymbalanceError(what, "must be two discs or more and a spring between neighbours")
    for name, values in (("moment of inertia", discs), ("stiffness", springs)):
        for value in values[~((values > 0) & np.isfinite(values))]:
            raise SymbalanceError(f"{name} = {brief(value)}", "must be positive and finite", "SI units")
    return TorsionalChain(discs, springs)


def crank_torsional_chain(rotor: Rotor) -> TorsionalChain:
    """Return a crankshaft's torsional model: discs at its journals' middles and at its ends.

    A spring is 1 over the turn between two journals under a unit torque on the free crank; a node's
    inertia about W goes to the journals before and behind it in proportion to its place. Bearings that
    stop the journals sideways stiffen the throws: this chain is the free shaft's.
    """
    check_rotor(rotor)
    stations = sorted({*rotor.journals, *(n for n in (rotor.pulley, rotor.flywheel) if n is not None)})
    stations.sort(key=lambda node: rotor.points[node, 2])
    if len(stations) < 2:
        raise SymbalanceError(f"{len(stations)} stations", "must be two journals or discs or more")
    springs = [_spring(rotor, a, b) for a, b in pairwise(stations)]
    return torsional_chain([*_tributary(rotor, stations)], springs)


def _spring(rotor: Rotor, front: int, rear: int) -> float:
    torque = np.zeros(rotor.size)
    torque[DOF * front + 5], torque[DOF * rear + 5] = -1.0, 1.0
    turn = torque @ np.linalg.lstsq(rotor.stiffness, torque, rcond=1e-13)[0]
    return float(1 / turn)


def _tributary(rotor: Rotor, stations: Sequence[int]) -> Array:
    """Return the stations' moments of inertia about the axis: phi' M phi of hat-shaped turns."""
    places = rotor.points[stations, 2]
    spin = rotor.rigid_motions()[:, 5].reshape(-1, DOF)
    hats = np.array([np.interp(rotor.points[:, 2], places, row) for row in np.eye(len(stations))])
    turns = (hats[:, :, None] * spin).reshape(len(stations), -1)
    return turns @ rotor.mass @ spin.ravel()
