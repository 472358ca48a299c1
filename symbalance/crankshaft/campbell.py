"""Natural frequencies against speed, in axes that turn with the crank and in stationary ones.

In turning axes M x'' + (C + omega G) x' + (K + omega^2 dK) x = 0 has solutions x = Re(a e^{st}). What
turns there as (u + iv) ~ e^{ipt} turns at p + omega in stationary axes: a shape's forward part
z+ = u + iv (of e^{ipt}) gives the line p + omega, its backward part the line p - omega; axial motion and
twist stay at p. Supports are given in turning axes, which holds where they are alike in all directions.

The false divergence of the free spin is taken out of dK (see `spin`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from symbalance.crankshaft.modes import assurance, natural_modes
from symbalance.crankshaft.rotor import DOF, Array, Rotor
from symbalance.crankshaft.spin import deflated

Shapes = NDArray[np.complex128]


@dataclass(frozen=True)
class Campbell:
    """Lines over speed: `speeds` (s,) in rad/s; the others (s, k), in rad/s, one column per mode.

    `rotating` frequencies and `growth` rates (positive: unstable) in turning axes; `stationary` the
    stronger line in stationary axes, negative where it whirls backward; `forward` the share, 0 to 1, of
    the lateral motion that whirls forward in turning axes.
    """

    speeds: Array
    rotating: Array
    growth: Array
    stationary: Array
    forward: Array


def campbell(
    rotor: Rotor, speeds: Sequence[float], support: Array | None = None, count: int = 12, kept: int = 40
) -> Campbell:
    """Return the lowest `count` modes' frequencies over `speeds` (rad/s), tracked by their shapes.

    `support` (n, n) is a stiffness alike in all directions across the axis. Solved on the `kept` lowest
    modes at rest, the free rotor's rigid motions included.
    """
    basis = _basis(rotor, support, kept)
    stiffness = rotor.stiffness + (0 if support is None else support)
    spin = rotor.rigid_motions()[:, 5]
    centrifugal = deflated(rotor.centrifugal, rotor.mass, spin)
    parts = [basis.T @ m @ basis for m in (rotor.damping, rotor.gyroscopic, stiffness, centrifugal)]
    values, shapes = [], []
    before: Shapes | None = None
    for speed in speeds:
        roots, vectors = _whirls(parts, float(speed))
        picked = [*range(min(count, len(roots)))] if before is None else _matched(before, vectors)
        before = vectors[:, picked]
        values.append(roots[picked])
        shapes.append(basis @ before[: basis.shape[1]])
    return _lines(np.array(speeds, dtype=float), np.array(values), np.array(shapes))


def _basis(rotor: Rotor, support: Array | None, kept: int) -> Array:
    available = rotor.size - (DOF if support is None else 0)
    shapes = natural_modes(rotor, min(kept, available), support).shapes
    if support is not None:
        return shapes
    rigid = rotor.rigid_motions()
    factor = np.linalg.cholesky(rigid.T @ rotor.mass @ rigid)
    return np.hstack([rigid @ np.linalg.inv(factor).T, shapes])


def _whirls(parts: Sequence[Array], speed: float) -> tuple[Shapes, Shapes]:
    """Return eigenvalues of non-negative frequency, rising, and their (position, velocity) vectors."""
    damping, gyroscopic, stiffness, centrifugal = parts
    size = len(damping)
    turning = np.zeros((2 * size, 2 * size))
    turning[:size, size:] = np.eye(size)
    turning[size:, :size] = -(stiffness + speed**2 * centrifugal)
    turning[size:, size:] = -(damping + speed * gyroscopic)
    roots, vectors = np.linalg.eig(turning)
    order = [k for k in np.argsort(np.abs(roots.imag)) if roots[k].imag > 1e-6 * np.abs(roots).max()]
    return roots[order], vectors[:, order]


def _matched(before: Shapes, now: Shapes) -> list[int]:
    """Return which of `now` continues each of `before`: the best pairs first, each used once."""
    likeness = assurance(before, now)
    picked = [-1] * before.shape[1]
    for flat in np.argsort(likeness, axis=None)[::-1]:
        row, column = divmod(int(flat), likeness.shape[1])
        if picked[row] < 0 and column not in picked:
            picked[row] = column
    return picked


def _lines(speeds: Array, values: Shapes, shapes: Shapes) -> Campbell:
    u, v = shapes[:, 0::DOF], shapes[:, 1::DOF]
    onward, back = (np.sum(np.abs(z) ** 2, axis=1) for z in (u + 1j * v, u - 1j * v))
    rest = np.sum(np.abs(shapes[:, 2::DOF]) ** 2, axis=1) * 2
    forward = onward / np.maximum(onward + back, 1e-300)
    frequencies, turn = values.imag, speeds[:, None]
    stationary = np.where(onward >= back, frequencies + turn, turn - frequencies)
    stationary = np.where(rest > onward + back, frequencies, stationary)
    return Campbell(speeds, frequencies, values.real, stationary, forward)
