"""Campbell diagram: natural frequencies over the speed, in turning and in stationary axes.

In turning axes M x'' + (C + omega G) x' + (K + omega^2 dK) x = 0 has solutions x = Re(a e^{st}). What
turns there as (u + iv) ~ e^{ipt} turns at p + omega in stationary axes: a shape's forward part
z+ = u + iv (of e^{ipt}) gives the line p + omega, its backward part the line p - omega; axial motion and
twist stay at p. Supports are given in turning axes, which holds where they are alike in all directions.

The false divergence of the rigid-body rotation is taken out of dK (see `rigid_body_mode`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.rotor.matrices import Rotor, check_rotor
from symbalance.crankshaft.rotor.modes import assurance, natural_modes
from symbalance.crankshaft.rotor.rigid_body_mode import deflated
from symbalance.document.result import Result
from symbalance.errors import SymbalanceError, brief

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

Shapes = NDArray[np.complex128]
RESTING, REAL = 1e-4, 1e-7
"""Below these a root counts as zero (per shift), or as real (per its size)."""
GROWS = 1e-7
"""A root's real part below this share of the largest frequency is rounding."""


@dataclass(frozen=True)
class _Parts:
    """The matrices on a basis orthonormal in M; `shift` in rad/s, well below the slowest elastic mode."""

    damping: Array
    gyroscopic: Array
    stiffness: Array
    centrifugal: Array
    shift: float


@dataclass(frozen=True)
class _Whirls:
    """At one speed: eigenvalues (k,), shapes (m, k) on the basis, and how the axis moves in them.

    `forward_part`, `backward_part`, `rest` (k,) are shares, 1 in sum: lateral motion that whirls with the
    signed frequency in turning axes, against it, and stretch and twist.
    """

    speed: float
    roots: Shapes
    shapes: Shapes
    forward_part: Array
    backward_part: Array
    rest: Array

    def selected(self, order: Sequence[int]) -> _Whirls:
        """Return some of them, in this order."""
        parts = (self.forward_part, self.backward_part, self.rest)
        return _Whirls(self.speed, self.roots[order], self.shapes[:, order], *(p[order] for p in parts))


@dataclass(frozen=True, repr=False)
class Campbell(Result):
    """A Campbell diagram: modes' frequencies and growth rates (s, k) over `speeds` (s,), all in rad/s.

    `rotating` frequencies and `growth` rates (positive: unstable) in turning axes; `stationary` the
    stronger line in stationary axes, negative where it whirls backward; `forward` the share, 0 to 1, of
    the lateral motion that turns with the signed frequency (a frequency that passed zero turns on);
    `lateral` whether a mode moves the axis sideways rather than along or about itself.
    """

    speeds: Array
    rotating: Array
    growth: Array
    stationary: Array
    forward: Array
    lateral: NDArray[np.bool_]
    rotor: Rotor
    is_free: bool
    """Whether the rotor has no support."""

    kind: ClassVar[str] = "campbell"

    @property
    def unstable(self) -> NDArray[np.bool_]:
        """Where a mode grows (s, k), by more than rounding does."""
        return self.growth > self.rounding

    @property
    def rounding(self) -> float:
        """A growth in 1/s below which there is none."""
        return GROWS * float(self.rotating.max(initial=1.0))

    def summary(self) -> str:
        """Return modes, speeds and whether something grows, in one line."""
        speeds = len(self.speeds)
        verdict = "unstable at some speed" if self.unstable.any() else "stable"
        return (
            f"Frequencies of {self.rotating.shape[1]} modes at {speeds} speed{'s' * (speeds > 1)} to "
            f"{self.speeds.max() * 30 / np.pi:.6g} rpm: {verdict}"
        )

    def document(self) -> Document:
        """Return whether something grows, each mode's course, and all frequencies by speed."""
        from symbalance.crankshaft.rotor.documents import campbell_document

        return campbell_document(self)

    def data(self) -> dict[str, Any]:
        """Return `speeds_rpm` and lists (speed, mode) in Hz; growth in 1/s, forward shares 0 to 1.

        A mode that moves along or about the axis has no forward share: None.
        """
        hertz = 1 / (2 * np.pi)
        # Of a mode that hardly moves sideways the share is a quotient of two roundings.
        forward = [
            [share if sideways else None for share, sideways in zip(*row, strict=True)]
            for row in zip(self.forward.tolist(), self.lateral.tolist(), strict=True)
        ]
        return {
            "free": self.is_free,
            "speeds_rpm": (self.speeds * 30 / np.pi).tolist(),
            "rotating_hertz": (self.rotating * hertz).tolist(),
            "stationary_hertz": (self.stationary * hertz).tolist(),
            "growth": self.growth.tolist(),
            "forward": forward,
            "lateral": self.lateral.tolist(),
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each mode at each speed."""
        data = self.data()
        names = ("rotating_hertz", "stationary_hertz", "growth", "forward", "lateral")
        return [
            {"rpm": rpm, "mode": k + 1, **{name: data[name][s][k] for name in names}}
            for s, rpm in enumerate(data["speeds_rpm"])
            for k in range(self.rotating.shape[1])
        ]


def campbell(
    rotor: Rotor,
    speeds: Sequence[float],
    support: Array | None = None,
    count: int = 12,
    basis_size: int = 40,
) -> Campbell:
    """Return the Campbell diagram of the lowest `count` modes over `speeds` (rad/s), tracked by shape.

    `support` (n, n) is a stiffness alike in all directions across the axis. Solved on the `basis_size`
    lowest modes at rest, the free rotor's rigid motions included.
    """
    check_rotor(rotor)
    for speed in speeds:
        if not np.isfinite(speed):
            raise SymbalanceError(f"speed = {brief(speed)} rad/s", "must be finite")
    basis = _basis(rotor, support, basis_size)
    stiffness = rotor.stiffness + (0 if support is None else support)
    spin = rotor.rigid_motions()[:, 5]
    centrifugal = deflated(rotor.centrifugal, rotor.mass, spin)
    matrices = (rotor.damping, rotor.gyroscopic, stiffness, centrifugal)
    damping, gyroscopic, stiffness, centrifugal = (basis.T @ m @ basis for m in matrices)
    stiffness = _without_rigid_rounding(stiffness, rotor, basis, support)
    squares = np.linalg.eigvalsh((stiffness + stiffness.T) / 2)
    shift = 0.1 * float(np.sqrt(squares[squares > 3e-15 * squares[-1]][0]))
    parts = _Parts(damping, gyroscopic, stiffness, centrifugal, shift)
    history: list[_Whirls] = []
    for speed in speeds:
        whirls = _whirls(parts, float(speed), rotor, basis)
        order = _match(history[-1], whirls) if history else _first(whirls, count)
        history.append(whirls.selected(order))
    return _lines(history, rotor, support is None)


def _basis(rotor: Rotor, support: Array | None, basis_size: int) -> Array:
    available = rotor.size - (DOF if support is None else 0)
    shapes = natural_modes(rotor, min(basis_size, available), support).shapes
    if support is not None:
        return shapes
    rigid = rotor.rigid_motions()
    factor = np.linalg.cholesky(rigid.T @ rotor.mass @ rigid)
    return np.hstack([rigid @ np.linalg.inv(factor).T, shapes])


def _without_rigid_rounding(stiffness: Array, rotor: Rotor, basis: Array, support: Array | None) -> Array:
    """Return the stiffness with the rounding taken out along rigid motions that no support stops."""
    motions = rotor.rigid_motions()
    free = [j for j in range(DOF) if support is None or not (support @ motions[:, j]).any()]
    rigid = np.linalg.qr(basis.T @ rotor.mass @ motions[:, free])[0]
    rest = np.eye(len(stiffness)) - rigid @ rigid.T
    return rest @ stiffness @ rest


def _whirls(parts: _Parts, speed: float, rotor: Rotor, basis: Array) -> _Whirls:
    """Return all oscillating motions, both signs of frequency, and divergent ones, slowest first.

    At rest a round shaft's modes are pairs, any mixture of which is a mode: their shapes are then those
    at a very slow speed, where each whirls its own way.
    """
    roots, shapes = _eigen(parts, speed)
    if speed == 0:
        slow = 1e-5 * float(np.min(np.abs(roots.imag), initial=1.0))
        shapes = _eigen(parts, slow)[1][:, : len(roots)]
    return _Whirls(speed, roots, shapes, *_motions(rotor, basis @ shapes))


def _eigen(parts: _Parts, speed: float) -> tuple[Shapes, Shapes]:
    """Return roots s and shapes, from the values 1/(s - shift): stiff springs then hide no slow mode."""
    size, shift = len(parts.damping), parts.shift
    damping = parts.damping + speed * parts.gyroscopic + shift * np.eye(size)
    stiffness = parts.stiffness + speed**2 * parts.centrifugal + shift * damping
    inverse = np.asarray(np.linalg.inv(stiffness))
    upper = -np.hstack([inverse @ damping, inverse])
    lower = shift * upper + np.eye(size, 2 * size)
    values, vectors = np.linalg.eig(np.vstack([upper, lower]))
    roots: Shapes = np.asarray(shift + 1 / values, dtype=np.complex128)
    moving = np.abs(roots) > RESTING * shift
    relevant = moving & (np.abs(roots.imag) > REAL * np.abs(roots))
    relevant[_divergent(roots, moving & ~relevant)] = True
    order = [k for k in np.lexsort((roots.imag < 0, np.abs(roots.imag).round(6))) if relevant[k]]
    return roots[order], np.asarray(vectors[:size, order], dtype=np.complex128)


def _divergent(roots: Shapes, real: NDArray[np.bool_]) -> NDArray[np.intp]:
    """Return the faster growing half of the real roots: a line that turns into -d + g and -d - g.

    So does a whirl of a shaft that is not round, between the two speeds at which it stands still in
    turning axes.
    """
    places = np.flatnonzero(real)
    return places[np.argsort(-roots[places].real, kind="stable")][: len(places) // 2]


def _motions(rotor: Rotor, shapes: Shapes) -> tuple[Array, Array, Array]:
    """Return the shares of forward whirl, backward whirl, stretch and twist in the axis' motion.

    Weighted with the crank's mass and moment of inertia about the axis; pins and webs do not count,
    as a twist moves them sideways.
    """
    motions = rotor.rigid_motions()
    inertia = np.diag(motions.T @ rotor.mass @ motions)
    axis = np.flatnonzero(np.hypot(*rotor.points[:, :2].T) < 1e-9) * DOF
    u, v, w, twist = (shapes[axis + place] for place in (0, 1, 2, 5))
    forward_part, backward_part = (
        inertia[0] * np.sum(np.abs(z) ** 2, axis=0) / 2 for z in (u + 1j * v, u - 1j * v)
    )
    rest = np.sum(inertia[0] * np.abs(w) ** 2 + inertia[5] * np.abs(twist) ** 2, axis=0)
    total = np.maximum(forward_part + backward_part + rest, 1e-300)
    return forward_part / total, backward_part / total, rest / total


def _first(whirls: _Whirls, count: int) -> list[int]:
    return [k for k in range(len(whirls.roots)) if whirls.roots[k].imag >= 0][:count]


def _match(before: _Whirls, now: _Whirls) -> list[int]:
    """Return which of `now` continues each of `before`: the best pairs first, each used once.

    Shapes are compared, and frequencies with what a whirl's would be (less the change of speed for
    forward whirl, more for backward): a forward whirl looks like the conjugate of a backward one. A
    frequency may pass through zero, so that both signs are compared; a motion and its conjugate are one.
    """
    step = now.speed - before.speed
    frequencies = before.roots.imag + (before.backward_part - before.forward_part) * step
    miss = (now.roots.imag[None, :] - frequencies[:, None]) / (
        abs(step) + 1e-3 * np.abs(frequencies[:, None]) + 1e-9
    )
    likeness = assurance(before.shapes, now.shapes) / (1 + miss**2)
    partners = _partners(now)
    matches, used, todo = [0] * len(before.roots), set(), set(range(len(before.roots)))
    for flat in np.argsort(likeness, axis=None)[::-1]:
        row, column = divmod(int(flat), likeness.shape[1])
        if row in todo and column not in used:
            matches[row] = column
            used |= {column, partners[column]}
            todo.discard(row)
    return matches


def _partners(whirls: _Whirls) -> list[int]:
    """Return the place of each motion's conjugate."""
    likeness = assurance(whirls.shapes.conj(), whirls.shapes)
    apart = np.abs(whirls.roots[:, None].conj() - whirls.roots) > 1e-6 * (1 + np.abs(whirls.roots))
    return [int(k) for k in np.argmax(np.where(apart, -1.0, likeness), axis=1)]


def _lines(history: Sequence[_Whirls], rotor: Rotor, is_free: bool) -> Campbell:
    speeds = np.array([whirls.speed for whirls in history])
    roots = np.array([whirls.roots for whirls in history])
    forward_part, backward_part, rest = (
        np.array([getattr(w, name) for w in history])
        for name in ("forward_part", "backward_part", "rest")
    )
    frequencies, turn = roots.imag, speeds[:, None]
    stationary = np.where(forward_part >= backward_part, turn + frequencies, turn - frequencies)
    stationary = np.where(rest > 0.5, np.abs(frequencies), stationary)
    forward = forward_part / np.maximum(forward_part + backward_part, 1e-300)
    return Campbell(
        speeds, np.abs(frequencies), roots.real, stationary, forward, rest <= 0.5, rotor, is_free
    )
