"""Newton's method on all time steps of journals' periodic orbits together, much faster than stepping.

All steps' stage equations F = load are linearised together; each step then turns a change of its
start into a change of its end, 2 x 2 a bearing, and the cycle closes by one 2 x 2 system a bearing.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.bearings.short_film import FilmState

MOST, SETTLED, SMALLEST = 40, 1e-10, 1e-3
"""Newton steps; the change over the clearance that ends them; the least share of a step."""
Films = Callable[[Array, Array], FilmState]


def periodic_places(
    at: Films, loads: Array, inner: Array, limits: Array, start: tuple[Array, Array]
) -> Array | None:
    """Return the places (N, b, 2) at the steps' starts of the periodic orbit; None without convergence.

    `loads` (N, s, b, 2) are the loads at the stages, `inner` (s, s) is h A of a stiffly accurate
    method, `limits` (b, 1) the distance that no journal passes, `start` a guess: places (N, b, 2) and
    stage velocities (N, s, b, 2).
    """
    place, rate = start
    for _ in range(MOST):
        film = at(_stages(place, rate, inner), rate)
        place_change, rate_change = _newton_step(film, loads - film.force, inner, place, rate)
        share = np.ones((1, place.shape[1], 1))
        while True:
            new = place + share * place_change, rate + share[:, None] * rate_change
            within = np.linalg.norm(_stages(*new, inner), axis=-1).max(axis=(0, 1))[:, None] < limits
            if within.all():
                break
            share = share * np.where(within, 1.0, 0.5)
            if share.min() < SMALLEST:
                return None
        place, rate = new
        if share.min() == 1 and (np.abs(place_change) / limits).max() <= SETTLED:
            return place
    return None


def _stages(place: Array, rate: Array, inner: Array) -> Array:
    """Return the places at the stages (N, s, b, 2)."""
    return place[:, None] + np.einsum("ij,njbc->nibc", inner, rate)


def _newton_step(
    film: FilmState, missing: Array, inner: Array, place: Array, rate: Array
) -> tuple[Array, Array]:
    """Return Newton's changes of places (N, b, 2) and of stage velocities (N, s, b, 2)."""
    steps, s, count = missing.shape[:3]
    matrix = np.einsum("ij,nibcd->nbicjd", inner, film.stiffness)
    for i in range(s):
        matrix[:, :, i, :, i] += film.damping[:, i]
    by_place = film.stiffness.transpose(0, 2, 1, 3, 4).reshape(steps, count, 2 * s, 2)
    side = missing.transpose(0, 2, 1, 3).reshape(steps, count, 2 * s, 1)
    solution = np.linalg.solve(
        matrix.reshape(steps, count, 2 * s, 2 * s), np.concatenate([by_place, side], axis=-1)
    )
    end = np.kron(inner[-1], np.eye(2)) @ solution
    gap = _stages(place, rate, inner)[:, -1] - np.roll(place, -1, axis=0)
    place_change = _solve_cyclic(np.eye(2) - end[..., :2], end[..., 2] + gap)
    rate_change = (solution[..., 2:] - solution[..., :2] @ place_change[..., None])[..., 0]
    return place_change, rate_change.reshape(steps, count, s, 2).transpose(0, 2, 1, 3)


def _solve_cyclic(factor: Array, offset: Array) -> Array:
    """Return x (N, b, 2) with x_{k+1} = factor_k x_k + added_k, where x_N is x_0 again."""
    whole, sum_ = np.broadcast_to(np.eye(2), factor.shape[1:]), np.zeros(offset.shape[1:])
    for each, one in zip(factor, offset, strict=True):
        whole, sum_ = each @ whole, (each @ sum_[..., None])[..., 0] + one
    values = np.empty_like(offset)
    values[0] = np.linalg.solve(np.eye(2) - whole, sum_[..., None])[..., 0]
    for k in range(len(offset) - 1):
        values[k + 1] = (factor[k] @ values[k][..., None])[..., 0] + offset[k]
    return values
