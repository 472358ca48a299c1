"""Natural frequencies and shapes of a rotor at rest, free or on springs.

Source: K phi = (2 pi f)^2 M phi; the modal assurance criterion, R. J. Allemang and D. L. Brown, IMAC 1
(1982), 110-116.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.rotor.matrices import Rotor, check_rotor
from symbalance.document.result import Result
from symbalance.errors import SymbalanceError, brief

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

AnyShapes = Array | NDArray[np.complex128]
MOTIONS = ("bending U", "bending V", "axial", "torsion")


@dataclass(frozen=True, repr=False)
class Modes(Result):
    """Elastic modes in rising order: `frequencies` (k,) in Hz, `shapes` (n, k) with phi' M phi = 1.

    They are those of `rotor`, free or on a stiffness.
    """

    frequencies: Array
    shapes: Array
    rotor: Rotor
    is_free: bool

    kind: ClassVar[str] = "natural-modes"

    def summary(self) -> str:
        """Return the number of modes and the range of their frequencies, in one line."""
        low, high = self.frequencies[[0, -1]]
        return f"{len(self)} natural modes from {low:.5g} to {high:.5g} Hz, of {self.rotor.size} unknowns"

    def document(self) -> Document:
        """Return the frequencies, and what moves in each mode."""
        from symbalance.crankshaft.rotor.documents import modes_document

        return modes_document(self)

    def data(self) -> dict[str, Any]:
        """Return frequencies in Hz, shares of motion 0 to 1, and shapes (modes, nodes, 6)."""
        shapes = self.shapes.T.reshape(len(self), -1, DOF).tolist()
        return {
            "free": self.is_free,
            "points": self.rotor.points.tolist(),
            "modes": [{**row, "shape": shape} for row, shape in zip(self.records(), shapes, strict=True)],
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each mode: hertz, mostly, and the shares of each kind of motion."""
        names = [name.lower().replace(" ", "_") for name in MOTIONS]
        return [
            {
                "mode": i,
                "hertz": float(f),
                "mostly": kind,
                **dict(zip(names, map(float, row), strict=True)),
            }
            for i, (f, kind, row) in enumerate(
                zip(self.frequencies, self.kinds, self.shares, strict=True), 1
            )
        ]

    @property
    def shares(self) -> Array:
        """What `motion_shares` gives of them, (k, 4)."""
        return motion_shares(self.rotor, self)

    @property
    def kinds(self) -> list[str]:
        """The name of the largest share of each mode."""
        return dominant_motions(self.rotor, self)

    def __len__(self) -> int:
        return len(self.frequencies)


def natural_modes(rotor: Rotor, count: int = 20, support: Array | None = None) -> Modes:
    """Return the lowest `count` elastic modes; a rotor without `support` is free.

    `support` (n, n) is added to the stiffness. The zero eigenvalues of a free rotor's six rigid-body
    motions R are moved, K - s M R (R' M R)^-1 R' M, to the eigenvalue -s, so that a slow elastic mode is
    never lost among zeros.
    """
    check_rotor(rotor)
    available = rotor.size - (DOF if support is None else 0)
    if not isinstance(count, int | np.integer) or not 0 < count <= available:
        raise SymbalanceError(f"modes = {brief(count)}", f"must lie in 1..{available}", "elastic modes")
    stiffness = rotor.stiffness + (0 if support is None else check_support(rotor, support))
    first = 0
    if support is None:
        motions = rotor.mass @ rotor.rigid_motions()
        scale = np.trace(stiffness) / np.trace(rotor.mass)
        stiffness = stiffness - scale * motions @ np.linalg.solve(
            rotor.rigid_motions().T @ motions, motions.T
        )
        first = DOF
    squares, shapes = _eigen(stiffness, rotor.mass)
    elastic = slice(first, first + count)
    frequencies = np.sqrt(np.maximum(squares[elastic], 0.0)) / (2 * np.pi)
    return Modes(frequencies, shapes[:, elastic], rotor, support is None)


def check_support(rotor: Rotor, support: Array) -> Array:
    """Return the support; refuses what is not (n, n) and finite."""
    if np.shape(support) != rotor.stiffness.shape or not np.isfinite(support).all():
        rule = f"must be finite, of shape {rotor.stiffness.shape}"
        raise SymbalanceError(f"support of shape {np.shape(support)}", rule, "bearing_springs makes one")
    return support


def _eigen(stiffness: Array, mass: Array) -> tuple[Array, Array]:
    """Return eigenvalues and mass-normalised vectors of a symmetric pair, by M = L L'."""
    inverse = np.linalg.inv(np.linalg.cholesky(mass))
    squares, vectors = np.linalg.eigh(inverse @ stiffness @ inverse.T)
    return np.asarray(squares, dtype=float), np.asarray(inverse.T @ vectors, dtype=float)


def assurance(one: AnyShapes, other: AnyShapes) -> Array:
    """Return the modal assurance criterion of each shape of `one` (n, a) against `other` (n, b): (a, b).

    |p^H q|^2/(p^H p q^H q): 1 for the same shape, 0 for an orthogonal one.

    >>> assurance(np.array([[1.0], [0.0]]), np.array([[1.0, 2.0], [1.0, 0.0]])).round(12)
    array([[0.5, 1. ]])
    """
    cross = np.abs(one.conj().T @ other) ** 2
    return cross / np.outer(np.sum(np.abs(one) ** 2, 0), np.sum(np.abs(other) ** 2, 0))


def motion_shares(rotor: Rotor, modes: Modes) -> Array:
    """Return how the main journals move in each mode (k, 4): shares of bending U, V, axial, torsion.

    Each journal carries its part of the crank's mass and of its moment of inertia about W; the shares are
    of the kinetic energy of u, v, w and theta_w with them. A cranked shaft's modes are mixtures.
    """
    motions = rotor.rigid_motions()
    inertia = np.diag(motions.T @ rotor.mass @ motions)
    weights = np.array([inertia[0], inertia[1], inertia[2], inertia[5]])
    nodes = np.array(rotor.journals or range(len(rotor.points)))
    places = DOF * nodes[:, None] + np.array([0, 1, 2, 5])
    energy = np.sum(modes.shapes[places] ** 2, axis=0) * weights[:, None]
    return (energy / np.maximum(energy.sum(axis=0), 1e-300)).T


def dominant_motions(rotor: Rotor, modes: Modes) -> list[str]:
    """Return the name of the largest share of each mode."""
    return [MOTIONS[int(k)] for k in np.argmax(motion_shares(rotor, modes), axis=1)]
