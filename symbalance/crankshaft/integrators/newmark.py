"""Newmark's method with average acceleration (the trapezoidal rule) for linear periodic systems: order 2.

    x+ = x + h x' + h^2/4 (x'' + x''+),    x'+ = x' + h/2 (x'' + x''+),

with the equations of motion holding at both ends, so that the accelerations are no states. The rotor's
constant matrix M + h/2 D + h^2/4 S is factored once, the bearings are a correction of rank 2 b, as in
`radau`; the housings follow by the same rule. Neutral, not L-stable: what is stiff rings. Source: N. M.
Newmark, A method of computation for structural dynamics, J. Eng. Mech. Div. 85 (1959), 67-94.
"""

from __future__ import annotations

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.integrators.coefficients import (
    bearing_rows,
    block_matrix,
    film_laws,
    housing_size,
    state_units,
)
from symbalance.crankshaft.integrators.time_stepping import LinearSteps
from symbalance.crankshaft.system import PeriodicSystem


def newmark_steps(system: PeriodicSystem, steps: int) -> LinearSteps:
    """Return one cycle of `steps` equal steps of Newmark's method, beta = 1/4 and gamma = 1/2."""
    h = system.cycle / system.omega / steps
    theta = system.cycle / steps * np.arange(steps + 1)
    free, load, forcing = _rotor(system, h, system.force(theta))
    points = bearing_rows(system)
    count, n = len(points), system.size
    gain = _gains(system, theta, h, points @ load[n:])
    journals = np.vstack([points @ free[n:], np.kron(np.eye(2), points)])
    bias = gain[..., :count] @ (forcing[:, n:] @ points.T)[..., None]
    housing = housing_size(system)
    last = np.hstack([np.zeros((housing, 2 * count)), np.eye(housing)])
    loads = np.hstack([load, np.zeros((2 * n, housing))])
    housing_free, housing_load = np.zeros((housing, housing)), np.broadcast_to(last, (steps, *last.shape))
    return LinearSteps(
        np.vstack([free, journals]),
        loads,
        gain,
        bias[..., 0],
        forcing,
        housing_free,
        housing_load,
        state_units(system),
    )


def _rotor(system: PeriodicSystem, h: float, force: Array) -> tuple[Array, Array, Array]:
    """Return (2n, 2n) of the state, (2n, 4b) of both ends' bearing forces, (N, 2n) of the loads."""
    n, points = system.size, bearing_rows(system)
    zero = np.zeros_like(points.T)
    before = np.linalg.solve(
        system.mass, np.hstack([-system.stiffness, -system.damping, points.T, zero, force[:-1].T])
    )
    before[:, 2 * n : 2 * n + len(points)] *= -1
    state = np.hstack([np.eye(2 * n), np.zeros((2 * n, before.shape[1] - 2 * n))])
    place, speed = state[:n], state[n:]
    direct = np.hstack([np.zeros((n, 2 * n)), zero, -points.T, force[1:].T])
    matrix = system.mass + h / 2 * system.damping + h * h / 4 * system.stiffness
    right_side = direct - system.damping @ (speed + h / 2 * before)
    right_side -= system.stiffness @ (place + h * speed + h * h / 4 * before)
    both = before + np.linalg.solve(matrix, right_side)
    after = np.vstack([place + h * speed + h * h / 4 * both, speed + h / 2 * both])
    split = 2 * n + 2 * len(points)
    return after[:, : 2 * n], -after[:, 2 * n : split], after[:, split:].T


def _gains(system: PeriodicSystem, theta: Array, h: float, compliance: Array) -> Array:
    """Return (b, b+, z+) per (free v+, d, v, z) of each step: (N, 4b or 6b, 6b or 8b)."""
    laws, rates = (np.array([block_matrix(one) for one in each]) for each in film_laws(system, theta))
    count, housing, steps = 2 * len(system.points), housing_size(system), len(theta) - 1
    width, here = laws.shape[-1], np.zeros((steps, count, count + laws.shape[-1]))
    here[..., count:] = laws[:-1]
    # all in terms of (free v+, d, v, z): first the end's velocity, still without b+
    rows = np.eye(count + width)
    speed, start, first, rest = np.split(rows, [count, 2 * count, 3 * count])
    velocity = speed - compliance[:, :count] @ here
    to_place = (start + h / 2 * first, h / 2)
    drift = rest + h / 2 * rates[:-1] @ rows[count:]
    law = [laws[1:, :, i * count : (i + 1) * count] for i in range(3)]
    rate = [rates[1:, :, i * count : (i + 1) * count] for i in range(3)]
    slow = np.linalg.inv(np.eye(housing) - h / 2 * rate[2][..., :housing])
    per_place, per_speed = slow @ rate[0] * (h / 2), slow @ rate[1] * (h / 2)
    film = law[2][..., :housing]
    place_law, speed_law = law[0] + film @ per_place, law[1] + film @ per_speed
    total = speed_law + place_law * to_place[1]
    right_side = place_law @ to_place[0] + film @ slow @ drift + total @ velocity
    ends = np.linalg.solve(np.eye(count) + total @ compliance[:, count:], right_side)
    velocity = velocity - compliance[:, count:] @ ends
    z = slow @ drift + per_speed @ velocity + per_place @ (to_place[0] + to_place[1] * velocity)
    return np.concatenate([here, ends, z], axis=1)
