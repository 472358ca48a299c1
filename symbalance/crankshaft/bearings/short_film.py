"""The short-bearing film with its cavitated arc, in closed form: force, stiffness and damping.

Reynolds' equation without circumferential flow, on a film h = c - r.n, n = (cos psi, sin psi). With
V = r' - (omega/2) S r, the journal's velocity in axes that turn at half its speed, the film carries

    F = g integral over V.n > 0 of (V.n) n / (1 - r.n/c)^3 dpsi,      g = mu R L^3/c^3,

the arc of positive pressure. All moments over that arc are derivatives of one function: with p and q the
parts of r/c along V and a quarter turn ahead of it, kappa^2 = 1 - p^2 - q^2 and beta = atan2(kappa, -p),

    w = integral dpsi/(1 - p cos psi - q sin psi) = 2 beta/kappa,

F = g |V| (w_pp, w_pq)/2, and the tangents follow.
Source: F. W. Ocvirk, Short-bearing approximation for full journal bearings, NACA TN 2808 (1952).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from symbalance.crankshaft.arguments import check_kind, check_number
from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.frames import QUARTER_TURN
from symbalance.crankshaft.system import UnsolvedError
from symbalance.errors import SymbalanceError, brief

DENSEST = 1 - 1e-9
"""The largest eccentricity; the film's force has no bound towards 1."""
BORNE = 1e-3
"""How far the force at an equilibrium may be from the load, of the load."""
MAKE = "sb.crankshaft.Bearing(diameter, length, clearance, viscosity)"


@dataclass(frozen=True)
class Bearing:
    """A plain journal bearing: diameter, length, radial `clearance` in m, `viscosity` in Pa s.

    >>> Bearing(0.1, 0.03, 0.0, 0.1)
    Traceback (most recent call last):
    symbalance.errors.SymbalanceError: bearing clearance = 0.0: must be positive; ...
    """

    diameter: float
    length: float
    clearance: float
    viscosity: float

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            check_number(value, f"bearing {name}", "m; viscosity in Pa s", signed=True)
            if not 0 < value < np.inf:
                remedy = "radial clearance, diameter and length in m, viscosity in Pa s"
                raise SymbalanceError(f"bearing {name} = {brief(value)}", "must be positive", remedy)

    @property
    def strength(self) -> float:
        """g = mu R L^3/c^3, in N s/m."""
        return self.viscosity * self.diameter / 2 * (self.length / self.clearance) ** 3


@dataclass(frozen=True)
class FilmState:
    """An oil film's force (..., 2) in N, stiffness (N/m) and damping (N s/m), (..., 2, 2)."""

    force: Array
    stiffness: Array
    damping: Array


def film_state(bearing: Bearing, place: ArrayLike, velocity: ArrayLike, omega: float) -> FilmState:
    """Return the film's force, stiffness and damping for a journal at `place` (..., 2) m; `omega` rad/s.

    The force is the shaft's on the film; stiffness and damping are its derivatives by place and by
    velocity, stationary axes, rows vertical, lateral. Without any motion there is no pressure: force 0.

    >>> state = film_state(Bearing(0.1, 0.03, 1e-4, 0.1), [0.0, 2e-5], [0.0, 0.0], 157.0)
    >>> bool(np.allclose(state.damping, state.damping.T)), bool(state.force @ [0.0, 1.0] > 0)
    (True, True)
    """
    check_kind(bearing, Bearing, "bearing", MAKE)
    r, speed = np.asarray(place, dtype=float), np.asarray(velocity, dtype=float)
    return film_states(np.array(bearing.strength), np.array(bearing.clearance), r, speed, omega)


def film_states(strength: Array, clearance: Array, r: Array, speed: Array, omega: float) -> FilmState:
    """Return `film_state` of many bearings at once: g and c (...), places and velocities (..., 2)."""
    wind = speed - omega / 2 * r @ QUARTER_TURN.T
    size = np.linalg.norm(wind, axis=-1, keepdims=True)
    along = np.where(size > 0, wind / np.where(size > 0, size, 1.0), [1.0, 0.0])
    across = along @ QUARTER_TURN.T
    axes = np.stack([along, across], axis=-1)
    p, q = (r * along).sum(-1) / clearance, (r * across).sum(-1) / clearance
    if not (p * p + q * q < DENSEST**2).all():
        raise SymbalanceError("journal", "must lie within the clearance", "a larger clearance")
    second, third = _moments(p, q)
    back = np.swapaxes(axes, -1, -2)
    damping = strength[..., None, None] * (axes @ second @ back)
    slope = (strength / clearance)[..., None, None] * size[..., None] * (axes @ third @ back)
    stiffness = slope - omega / 2 * damping @ QUARTER_TURN
    return FilmState((damping @ wind[..., None])[..., 0], stiffness, damping)


def _moments(p: Array, q: Array) -> tuple[Array, Array]:
    """Return w's second derivatives over 2, (..., 2, 2), and those of w_pp/2, w_pq/2 by p and q."""
    k2, m = 1 - p * p - q * q, 1 - q * q
    beta = np.arctan2(np.sqrt(k2), -p)
    f, k4, k6 = beta / np.sqrt(k2), k2 * k2, k2**3
    pp = 3 * p / k4 + f * (k2 + 3 * p * p) / k4
    pq = 2 * q / k4 + p * p * q / (k4 * m) + 3 * f * p * q / k4
    qq = (
        p / (k2 * m) + 3 * p * q * q / (k4 * m) + 2 * p * q * q / (k2 * m * m) + f * (k2 + 3 * q * q) / k4
    )
    ppp = 4 / k4 + 15 * p * p / k6 + 3 * f * p * (3 * k2 + 5 * p * p) / k6
    ppq = 12 * p * q / k6 + p * q * (k2 + 3 * p * p) / (k6 * m) + 3 * f * q * (k2 + 5 * p * p) / k6
    pqq = 2 / k4 + 8 * q * q / k6 + p * p / (k4 * m) + 4 * (p * q) ** 2 / (k6 * m)
    pqq += (
        2 * (p * q) ** 2 / (k4 * m * m) + 3 * (p * q) ** 2 / (k6 * m) + 3 * f * p * (k2 + 5 * q * q) / k6
    )
    return _square(pp, pq, pq, qq), _square(ppp, ppq, ppq, pqq)


def _square(a: Array, b: Array, c: Array, d: Array) -> Array:
    return np.stack([np.stack([a, b], axis=-1), np.stack([c, d], axis=-1)], axis=-2)


def equilibrium(bearing: Bearing, load: ArrayLike, omega: float) -> Array:
    """Return the position (2,) in m of a journal at `omega` rad/s under a steady load (2,) in N.

    Newton's method on the eccentricity in log(load), which is nearly straight; without load at the
    centre.

    >>> place = equilibrium(Bearing(0.1, 0.03, 1e-4, 0.1), [-525.0, 0.0], 50 * np.pi)
    >>> round(float(np.linalg.norm(place)) / 1e-4, 4)
    0.2663
    """
    check_kind(bearing, Bearing, "bearing", MAKE)
    force = np.asarray(load, dtype=float)
    size, clear = float(np.linalg.norm(force)), bearing.clearance
    if not np.isfinite(size) or not 0 < abs(omega) < np.inf:
        what = f"load = {brief(size)} N at {brief(omega)} rad/s"
        raise SymbalanceError(what, "must be finite, on a journal that turns", "N, rad/s")
    if size == 0:
        return np.zeros(2)
    low, high, still = 0.0, DENSEST * (1 - 1e-9), np.zeros(2)
    eccentricity = 0.5
    for _ in range(200):
        state = film_state(bearing, [eccentricity * clear, 0.0], still, omega)
        capacity = float(np.linalg.norm(state.force))
        low, high = (eccentricity, high) if capacity < size else (low, eccentricity)
        slope = float(state.force @ state.stiffness[:, 0]) / capacity * clear
        step = np.log(size / capacity) * capacity / slope
        candidate = eccentricity + step
        is_settled = abs(step) <= 1e-14 * eccentricity or high - low <= 1e-16
        if low < candidate < high:
            eccentricity = candidate
        elif not is_settled:  # a step of a rounding unit may end on a bound: no reason to halve
            eccentricity = (low + high) / 2
        if is_settled:
            break
    state = film_state(bearing, [eccentricity * clear, 0.0], still, omega)
    capacity = float(np.linalg.norm(state.force))
    if not abs(capacity - size) <= BORNE * size:
        rule = f"is more than the film bears within the clearance, {capacity:.3g} N"
        raise UnsolvedError(f"load = {size:.3g} N", rule, "a wider bearing or a smaller load")
    turn = np.array([state.force, QUARTER_TURN @ state.force]).T / np.linalg.norm(state.force)
    aim = np.array([force, QUARTER_TURN @ force]).T / size
    return eccentricity * clear * aim @ turn.T @ np.array([1.0, 0.0])
