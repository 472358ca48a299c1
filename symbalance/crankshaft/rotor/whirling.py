"""Whirl of a round rotor on any supports: roots, directions, critical speeds.

x = Re(a e^{st}) in stationary axes, (s^2 M + s D + K) a = 0. At a node a = (vertical, lateral, …); the
part a_v + i a_l turns with the shaft, a_v - i a_l against it. Solved for 1/(s - shift), whose largest
values are the lowest roots: stiff supports then cost no digits.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.rotor.documents import HERTZ, RPM, complex_data, supports_data, whirl_word
from symbalance.crankshaft.rotor.matrices import Rotor
from symbalance.crankshaft.rotor.modes import natural_modes
from symbalance.crankshaft.rotor.stationary import (
    ROUND,
    StationaryRotor,
    Support,
    Supports,
    checked_rotor_speed,
    number_of,
    stationary_rotor,
    supports_at,
)
from symbalance.document.result import Result
from symbalance.errors import SymbalanceError, brief

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

Complex = NDArray[np.complex128]
SINGULAR = 1e13
"""The condition (scaled by its diagonal) beyond which a stiffness leaves some rigid motion free."""
OSCILLATES, MOVES = 1e-7, 1e-5
"""Below these a root counts as real (imaginary part per its size), or as zero (size per shift)."""
GRID, NARROWINGS, CLOSE = 96, 60, 1e-12
"""Of the search for crossings: speeds of the grid, steps of a zero's search, its relative width."""


@dataclass(frozen=True, repr=False)
class Whirl(Result):
    """Whirl modes at one `speed` (rad/s), slowest first: `roots` (k,) in rad/s, imaginary parts positive.

    `shapes` (n, 2, k): vertical and lateral at each node; `forward` (k,): the share, 0 to 1, of the
    motion that turns with the shaft. `overdamped`: the real roots, whose motions do not oscillate.
    """

    speed: float
    roots: Complex
    shapes: Complex
    forward: Array
    overdamped: Array
    rotor: Rotor
    supports: tuple[Support, ...]
    """What is under each bearing at this speed."""

    kind: ClassVar[str] = "whirl"

    def summary(self) -> str:
        """Return the slowest motion and whether all are stable, in one line."""
        verdict = "stable" if self.is_stable else "unstable"
        slowest = f", the slowest at {self.natural[0] * HERTZ:.5g} Hz" if len(self.roots) else ""
        return f"Whirl at {self.speed * RPM:.6g} rpm: {len(self.roots)} motions{slowest}; {verdict}"

    def document(self) -> Document:
        """Return the motions, whether they are stable, and the supports."""
        from symbalance.crankshaft.rotor.documents import whirl_document

        return whirl_document(self)

    def data(self) -> dict[str, Any]:
        """Return every motion: Hz, root in 1/s, shape (node, direction) as [real, imaginary] pairs."""
        roots = complex_data(self.roots)
        shapes = complex_data(np.moveaxis(self.shapes, -1, 0))
        return {
            "rpm": self.speed * RPM,
            "stable": self.is_stable,
            "supports": supports_data(self.supports),
            "places": self.rotor.points[:, 2].tolist(),
            "overdamped": self.overdamped.tolist(),
            "motions": [
                {**row, "root": root, "shape": shape}
                for row, root, shape in zip(self.records(), roots, shapes, strict=True)
            ],
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each motion, the slowest first; hertz is negative where it is backward."""
        columns = {
            "hertz": self.frequencies * HERTZ,
            "natural_hertz": self.natural * HERTZ,
            "damping_ratio": self.damping_ratios,
            "log_decrement": self.log_decrements,
            "forward": self.forward,
        }
        return [
            {"mode": k + 1, **{name: float(column[k]) for name, column in columns.items()}}
            for k in range(len(self.roots))
        ]

    @property
    def frequencies(self) -> Array:
        """Damped frequencies in rad/s, negative where the whirl is backward rather than forward."""
        return np.where(self.forward < 0.5, -1.0, 1.0) * self.roots.imag

    @property
    def natural(self) -> Array:
        """|s| in rad/s."""
        return np.abs(self.roots)

    @property
    def damping_ratios(self) -> Array:
        """-Re s/|s|; negative: unstable."""
        return -self.roots.real / self.natural

    @property
    def log_decrements(self) -> Array:
        """-2 pi Re s/Im s."""
        return -2 * np.pi * self.roots.real / self.roots.imag

    @property
    def is_stable(self) -> bool:
        """Whether nothing grows."""
        return bool(max(*self.roots.real, *self.overdamped) <= OSCILLATES * self.natural.min(initial=1.0))


@dataclass(frozen=True, repr=False)
class CriticalSpeeds(Result):
    """Critical speeds (k,) in rad/s, rising, and the `forward` share (k,) of each: 0 is a backward whirl.

    On supports alike in all directions an unbalance excites those that are forward only. `supports` is
    None where they were given as a function of the speed, `most` where no speed was too large.
    """

    speeds: Array
    forward: Array
    rotor: Rotor
    supports: tuple[Support, ...] | None
    most: float | None = None

    kind: ClassVar[str] = "critical-speeds"

    def __len__(self) -> int:
        return len(self.speeds)

    def summary(self) -> str:
        """Return how many there are, and the lowest, in one line."""
        limit = "" if self.most is None else f" up to {self.most * RPM:.6g} rpm"
        first = f", from {self.speeds[0] * RPM:.5g} rpm on" if len(self) else ""
        return f"{len(self)} critical speed{'s' * (len(self) != 1)}{limit}{first}"

    def document(self) -> Document:
        """Return the speeds with the way each whirls, and the supports."""
        from symbalance.crankshaft.rotor.documents import critical_document

        return critical_document(self)

    def data(self) -> dict[str, Any]:
        """Return every critical speed in rpm, its forward share and the supports."""
        limit = None if self.most is None else self.most * RPM
        supports = supports_data(self.supports)
        return {"most_rpm": limit, "critical_speeds": self.records(), "supports": supports}

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each critical speed, rising."""
        return [
            {"rpm": float(speed) * RPM, "forward": float(share), "whirl": whirl_word(float(share))}
            for speed, share in zip(self.speeds, self.forward, strict=True)
        ]


def whirl(rotor: Rotor, supports: Supports, speed: float) -> Whirl:
    """Return the whirl modes of an axisymmetric rotor at `speed` (rad/s), one support for each bearing.

    A disc of 20 kg in the middle of a light shaft, one support softer sideways:

    >>> from symbalance.crankshaft.rotor.parts import Disc, Material
    >>> from symbalance.crankshaft.rotor.shafts import Tube, shaft
    >>> from symbalance.crankshaft.rotor.stationary import Support
    >>> light = Material(density=1e-3)
    >>> rotor = shaft([Tube(1.0, 0.09)], {0.5: Disc(20.0, 0.4, 0.2)}, (0.0, 1.0), light)
    >>> motions = whirl(rotor, [Support((1e8, 5e7)), Support(1e8)], 300.0)
    >>> motions.frequencies[:2].round(0)
    array([-1126.,  1163.])
    """
    return _whirl(stationary_rotor(rotor), supports, checked_rotor_speed(speed))


def _whirl(matrices: StationaryRotor, supports: Supports, speed: float) -> Whirl:
    below = tuple(supports_at(matrices.rotor, supports, speed))
    damping, stiffness = matrices.at(below, speed)
    roots, vectors, shift = _roots(matrices, damping, stiffness)
    real = np.abs(roots.imag) <= OSCILLATES * np.abs(roots)
    moving = np.abs(roots) > MOVES * shift
    whirling = np.flatnonzero(moving & ~real & (roots.imag > 0))
    whirling = whirling[np.argsort(np.abs(roots[whirling]), kind="stable")]
    shapes = vectors[:, whirling].reshape(len(matrices.rotor.points), 4, -1)[:, :2]
    overdamped = np.sort(roots[moving & real].real)[::-1]
    forward = forward_share(shapes)
    return Whirl(speed, roots[whirling], shapes, forward, overdamped, matrices.rotor, below)


def _roots(matrices: StationaryRotor, damping: Array, stiffness: Array) -> tuple[Complex, Complex, float]:
    """Return all roots, shapes (n, 2n), and the shift (0 where the supports hold the rotor)."""
    mass, n = matrices.mass, len(damping)
    scale = 1 / np.sqrt(np.abs(np.diag(stiffness)))
    is_constrained = (
        np.isfinite(scale).all() and np.linalg.cond(scale[:, None] * stiffness * scale) < SINGULAR
    )
    shift = (
        0.0 if is_constrained else 0.2 * np.pi * float(natural_modes(matrices.rotor, 1).frequencies[0])
    )
    stiffness_at_shift = stiffness + shift * damping + shift**2 * mass
    inverse = np.linalg.solve(stiffness_at_shift, np.hstack([damping + shift * mass, mass]))
    # (1/mu) (x, s x) of s x = shift x + x/mu, (shifted) x = -(damping + shift mass)(x/mu) - mass s (x/mu)
    upper = -inverse
    lower = shift * upper
    lower[:, :n] += np.eye(n)
    values, vectors = np.linalg.eig(np.vstack([upper, lower]))
    finite = np.abs(values) > 1e-15 * np.abs(values).max()
    roots: Complex = np.asarray(shift + 1 / values[finite], dtype=np.complex128)
    return roots, np.asarray(vectors[:n, finite], dtype=np.complex128), shift


def forward_share(shapes: Complex) -> Array:
    """Return the share of the forward part in shapes (n, 2, k)."""
    forward, backward = (np.sum(np.abs(shapes[:, 0] + i * shapes[:, 1]) ** 2, axis=0) for i in (1j, -1j))
    return forward / np.maximum(forward + backward, 1e-300)


def critical_speeds(rotor: Rotor, supports: Supports, most: float | None = None) -> CriticalSpeeds:
    """Return the speeds (rad/s) up to `most` at which a whirl's frequency equals the speed itself.

    Without damping, on constant supports, all at once: K a = w^2 (M - i G) a. Otherwise the crossings of
    the damped frequencies with the speed, for which `most` is needed.

    >>> from symbalance.crankshaft.rotor.parts import Disc, Material
    >>> from symbalance.crankshaft.rotor.shafts import Tube, shaft
    >>> from symbalance.crankshaft.rotor.stationary import Support
    >>> rotor = shaft([Tube(1.0, 0.09)], {0.5: Disc(20.0, 0.4, 0.2)}, (0.0, 1.0), Material(density=1e-3))
    >>> critical_speeds(rotor, [Support(1e8), Support(1e8)]).speeds[:2].round(0)
    array([1163., 1163.])
    """
    matrices = stationary_rotor(rotor)
    if most is not None and not 0 < number_of(most, "most") < np.inf:
        raise SymbalanceError(f"most = {brief(most)} rad/s", "must be positive and finite")
    if not callable(supports):
        damping, stiffness = matrices.at(supports, 0.0)
        uneven = np.abs(stiffness - stiffness.T).max() / np.abs(stiffness).max()
        if not damping.any() and uneven < ROUND:
            speeds, forward = _solve_undamped(
                matrices, (stiffness + stiffness.T) / 2, np.inf if most is None else most
            )
            return CriticalSpeeds(speeds, forward, rotor, tuple(supports), most)
    if most is None:
        rule = "must be given where supports damp, differ with speed or are not symmetric"
        raise SymbalanceError("most", rule, "the largest speed to look at, rad/s")
    below = None if callable(supports) else tuple(supports)
    return CriticalSpeeds(*_crossings(matrices, supports, most), rotor, below, most)


def _solve_undamped(matrices: StationaryRotor, stiffness: Array, most: float) -> tuple[Array, Array]:
    gyric = matrices.mass - 1j * matrices.gyroscopic
    try:
        inverse = np.linalg.inv(np.linalg.cholesky(stiffness))
    except np.linalg.LinAlgError:
        rule = "must hold the rotor against every rigid motion"
        raise SymbalanceError("the supports", rule, "two springs, or a tilt stiffness") from None
    values, vectors = np.linalg.eigh(inverse @ gyric @ inverse.T)
    positive = np.flatnonzero(values > 1e-14 * np.abs(values).max())[::-1]
    speeds = 1 / np.sqrt(values[positive])
    shapes = (inverse.T @ vectors[:, positive]).reshape(len(matrices.rotor.points), 4, -1)[:, :2]
    inside = speeds <= most
    return speeds[inside], forward_share(np.asarray(shapes[..., inside], dtype=np.complex128))


def _crossings(matrices: StationaryRotor, supports: Supports, most: float) -> tuple[Array, Array]:
    """Return where the k-th of the rising frequencies passes the speed, for every k."""
    grid = np.linspace(most / GRID / 64, most, GRID)
    count = len(matrices.mass)

    def lead(speed: float) -> Array:
        frequencies = _whirl(matrices, supports, speed).roots.imag
        return np.pad(np.sort(frequencies), (count - len(frequencies), 0)) - speed

    leads = [lead(float(speed)) for speed in grid]
    crossings = []
    for ends, values in zip(pairwise(grid), pairwise(leads), strict=True):
        for k in np.flatnonzero(values[0] * values[1] < 0):
            at_ends = (float(values[0][k]), float(values[1][k]))
            crossings.append(_find_zero(lambda speed, k=k: float(lead(speed)[k]), ends, at_ends))
    speeds = np.sort(crossings)
    shares = [_share_at(_whirl(matrices, supports, float(speed))) for speed in speeds]
    return speeds, np.array(shares)


def _share_at(motions: Whirl) -> float:
    return float(motions.forward[np.argmin(np.abs(motions.roots.imag - motions.speed))])


def _find_zero(
    function: Callable[[float], float], ends: tuple[float, float], values: tuple[float, float]
) -> float:
    """Return the zero between two ends by the Illinois method."""
    (low, high), (a, b) = ends, values
    for _ in range(NARROWINGS):
        middle = (low * b - high * a) / (b - a)
        value = function(middle)
        if value == 0 or abs(high - low) <= CLOSE * high:
            return middle
        if value * b < 0:
            low, a = high, b
        else:
            a /= 2
        if abs(middle - high) <= CLOSE * high:
            return middle
        high, b = middle, value
    return high
