"""Radau IIA with a fixed step for linear periodic systems: order 2 s - 1, L-stable, no step rejected.

With A = T diag(poles) T^-1 the stages' accelerations come apart into one n x n system a pole,

    (M + h p D + h^2 p^2 S) a_p = (T^-1 r)_p,    r_i = f_i - B^T b_i - D v - S (x + h c_i v),

real or complex, factored once for the whole run. What the bearings add has rank 2 b a stage: their forces
at the s stages are the only unknowns that a step solves for, and the systems of all steps are solved
together beforehand. Housing states go along exactly; massless, they need a stiffly accurate method.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.integrators.coefficients import (
    BearingCoefficients,
    bearing_coefficients,
    bearing_count,
    bearing_rows,
    state_units,
)
from symbalance.crankshaft.integrators.tableau import Complex, Tableau, radau_iia
from symbalance.crankshaft.integrators.time_stepping import LinearSteps
from symbalance.crankshaft.system import Housing, PeriodicSystem


def radau_steps(system: PeriodicSystem, steps: int, stages: int = 3) -> LinearSteps:
    """Return one cycle of `steps` equal steps of Radau IIA with `stages` stages."""
    tableau = radau_iia(stages)
    h = system.cycle / system.omega / steps
    theta = (system.cycle / steps) * (np.arange(steps)[:, None] + tableau.nodes)
    rotor = _Rotor.of(system, tableau, h, system.force(theta.ravel()).reshape(steps, stages, -1))
    films = stage_films(system, bearing_coefficients(system, theta.ravel()), tableau.matrix, h)
    count = len(rotor.compliance)
    small = films.velocity.reshape(steps * count, count) @ rotor.compliance
    small = small.reshape(steps, count, count) + np.eye(count)
    loads = films.velocity @ rotor.velocity_forcing[..., None]
    right_side = np.concatenate([films.velocity, films.displacement, films.housing, loads], axis=2)
    gain = np.linalg.solve(small, right_side)
    points = bearing_rows(system)
    free = np.vstack([rotor.free, rotor.journal_velocity, np.hstack([points, np.zeros_like(points)])])
    return LinearSteps(
        free,
        rotor.load,
        gain[..., :-1],
        gain[..., -1],
        rotor.forcing,
        films.housing_free,
        films.housing_load,
        state_units(system),
    )


@dataclass(frozen=True)
class _Rotor:
    """One step of the rotor between its bearings: state to state, bearing forces to state, and loads.

    `journal_velocity` gives the journals' velocities at the stages (s 2b, 2n), `compliance` what the
    stages' bearing forces take from them (s 2b, s 2b), `velocity_forcing` what the loads add (N, s 2b).
    """

    free: Array
    load: Array
    forcing: Array
    journal_velocity: Array
    compliance: Array
    velocity_forcing: Array

    @classmethod
    def of(cls, system: PeriodicSystem, tableau: Tableau, h: float, force: Array) -> _Rotor:
        n, points, s = system.size, bearing_rows(system), tableau.stages
        shares, shapes = factor_loads(force.reshape(-1, n))
        poles = [_pole(system, tableau, h, k, shapes) for k in tableau.pole_indices]
        sums = _Sums(poles, tableau, shares.reshape(len(force), s, -1))
        modes = (
            h
            * tableau.transform[:, tableau.pole_indices]
            * tableau.pole_weights
            * tableau.poles[list(tableau.pole_indices)]
        )
        place, speed = h * modes[-1] * tableau.poles[list(tableau.pole_indices)], modes[-1]
        shift = np.hstack([np.eye(n), h * np.eye(n)])
        keep = np.hstack([np.zeros((n, n)), np.eye(n)])
        return cls(
            np.vstack([shift + sums.state(place), keep + sums.state(speed)]),
            -np.vstack([sums.bearing(place), sums.bearing(speed)]),
            np.hstack([sums.forcing(place), sums.forcing(speed)]),
            np.concatenate([points @ keep + sums.state(row, points) for row in modes]),
            -np.concatenate([sums.bearing(row, points) for row in modes]),
            np.hstack([sums.forcing(row, points) for row in modes]),
        )


@dataclass(frozen=True)
class _Pole:
    """One pole's accelerations per state (n, 2n), stages' bearing forces (n, s 2b), load shape (n, r)."""

    state: Complex
    bearing: Complex
    shapes: Complex
    inverse: Complex


def _pole(system: PeriodicSystem, tableau: Tableau, h: float, k: int, shapes: Array) -> _Pole:
    n, points = system.size, bearing_rows(system)
    pole, inverse = tableau.poles[k], tableau.inverse[k]
    if pole.imag == 0:
        pole, inverse = pole.real, inverse.real
    matrix = system.mass + h * pole * system.damping + (h * pole) ** 2 * system.stiffness
    answers = np.linalg.inv(matrix)
    sides = np.hstack([system.stiffness, system.damping, points.T, shapes.T])
    answers = answers.real @ sides + (1j * (answers.imag @ sides) if np.iscomplexobj(answers) else 0.0)
    by_place, by_velocity = answers[:, :n], answers[:, n : 2 * n]
    ones, nodes = inverse.sum(), inverse @ tableau.nodes
    state = -np.hstack([ones * by_place, ones * by_velocity + h * nodes * by_place])
    split = 2 * n + len(points)
    return _Pole(state, -np.kron(inverse, answers[:, 2 * n : split]), answers[:, split:], inverse)


@dataclass(frozen=True)
class _Sums:
    """Real sums over the poles, one weight each; `points` picks the journals' rows before the sum."""

    poles: list[_Pole]
    tableau: Tableau
    shares: Array

    def state(self, weights: Complex, points: Array | None = None) -> Array:
        return self._sum(weights, [p.state for p in self.poles], points)

    def bearing(self, weights: Complex, points: Array | None = None) -> Array:
        return self._sum(weights, [p.bearing for p in self.poles], points)

    def forcing(self, weights: Complex, points: Array | None = None) -> Array:
        each = [p.shapes if points is None else points @ p.shapes for p in self.poles]
        per_stage = [np.kron(p.inverse, shape) for p, shape in zip(self.poles, each, strict=True)]
        return self.shares.reshape(len(self.shares), -1) @ self._sum(weights, per_stage, None).T

    @staticmethod
    def _sum(weights: Complex, parts: list[Complex], points: Array | None) -> Array:
        if points is not None:
            parts = [points @ part for part in parts]
        total = np.zeros(parts[0].shape)
        for weight, part in zip(weights, parts, strict=True):
            total += weight.real * part.real - weight.imag * part.imag
        return total


def factor_loads(loads: Array, most: int = 48) -> tuple[Array, Array]:
    """Return loads (s, n) as shares (s, r) times shapes (r, n), exact to rounding: r is small on a crank.

    A random projection finds the space that the loads span: pins, gravity, centrifugal forces. Where
    `most` shapes do not carry them the loads are returned as they are, with unit shapes.

    >>> shares, shapes = factor_loads(np.outer(np.arange(9.0), np.ones(60)), most=3)
    >>> shapes.shape[0] <= 3 and bool(np.allclose(shares @ shapes, np.outer(np.arange(9.0), np.ones(60))))
    True
    """
    width = loads.shape[1]
    if width > most:
        projections = np.random.default_rng(0).standard_normal((most, len(loads))) @ loads
        sizes, shapes = np.linalg.svd(projections, full_matrices=False)[1:]
        shapes = shapes[sizes > 1e-15 * sizes[0]]
        shares = loads @ shapes.T
        if np.abs(shares @ shapes - loads).max(initial=0.0) <= 1e-13 * np.abs(loads).max(initial=0.0):
            return shares, shapes
    return loads, np.eye(width)


@dataclass(frozen=True)
class StageFilms:
    """Film forces b in turning axes, stage by stage, for each of N steps; b acts on the film.

    b = velocity v + displacement d + housing z, with the journals' velocities v at the stages (s 2b),
    their displacements d at the step's start (2b) and the housings' z there (2b, or 0); z+ = kept z
    + moved b.
    """

    velocity: Array
    displacement: Array
    housing: Array
    housing_free: Array
    housing_load: Array


def stage_films(system: PeriodicSystem, at: BearingCoefficients, matrix: Array, h: float) -> StageFilms:
    """Return the films at the stages of a collocation method with matrix A (s, s) and step h.

    Stage displacements are d + h A v, and z + h A z' for the housings, K_B z + C_B z' = b: exact, as
    the housings have no mass. K_B is not inverted, so that it may grow beyond all bounds.
    """
    s, count = len(matrix), bearing_count(system)
    steps = len(at.turn) // s
    inner, ones = h * np.kron(matrix, np.eye(2)), np.kron(np.ones((s, 1)), np.eye(2))
    turn = _stage_diagonal(np.broadcast_to(at.turn[:, None], at.stiffness.shape), steps, s)
    spring, damper = _stage_diagonal(at.stiffness, steps, s), _stage_diagonal(at.damping, steps, s)
    sides = np.concatenate([damper + spring @ inner, spring @ ones], axis=-1)
    housing_free, housing_load = np.zeros((0, 0)), np.zeros((steps, 0, 2 * s * count))
    if system.housing is not None:
        rate = _rates(system.housing, matrix, h)
        film = _stage_diagonal(at.film_stiffness, steps, s)
        pull = (film @ inner + _stage_diagonal(at.film_damping, steps, s)) @ rate
        at_rest = pull @ ones @ system.housing.stiffness - film @ ones
        sides = np.linalg.solve(np.eye(2 * s) + pull, np.concatenate([sides, at_rest], axis=-1))
        end = inner[-2:] @ rate
        housing_free = _step_matrices((np.eye(2) - end @ ones @ system.housing.stiffness)[None], 1, 1)[0]
        housing_load = _step_matrices(end @ turn, 1, s)
    sides = np.swapaxes(turn, -1, -2) @ sides
    velocity, displacement = sides[..., : 2 * s], sides[..., 2 * s : 2 * s + 2]
    housing = (
        _step_matrices(sides[..., 2 * s + 2 :], s, 1)
        if system.housing
        else np.zeros((steps, 2 * s * count, 0))
    )
    return StageFilms(
        _step_matrices(velocity, s, s),
        _step_matrices(displacement, s, 1),
        housing,
        housing_free,
        housing_load,
    )


def _rates(housing: Housing, matrix: Array, h: float) -> Array:
    """Return what the housings' velocities at the stages are per force beyond K_B z: (b, 2s, 2s)."""
    s, count = len(matrix), len(housing.stiffness)
    stages = np.einsum("ij,bcd->bicjd", h * matrix, housing.stiffness)
    stages += np.einsum("ij,bcd->bicjd", np.eye(s), housing.damping)
    return np.linalg.inv(stages.reshape(count, 2 * s, 2 * s))


def _stage_diagonal(matrices: Array, steps: int, stages: int) -> Array:
    """Return (N s, b, 2, 2) as (N, b, 2s, 2s), the stages on the diagonal."""
    count = matrices.shape[1]
    full = np.zeros((steps, count, stages, 2, stages, 2))
    blocks = matrices.reshape(steps, stages, count, 2, 2)
    for i in range(stages):
        full[:, :, i, :, i, :] = blocks[:, i]
    return full.reshape(steps, count, 2 * stages, 2 * stages)


def _step_matrices(blocks: Array, rows: int, columns: int) -> Array:
    """Return (N, b, 2 rows, 2 columns) as one matrix a step, in the order stage, bearing, direction."""
    steps, count = blocks.shape[:2]
    full = np.zeros((steps, rows, count, 2, columns, count, 2))
    parts = blocks.reshape(steps, count, rows, 2, columns, 2)
    for j in range(count):
        full[:, :, j, :, :, j, :] = parts[:, j]
    return full.reshape(steps, 2 * rows * count, 2 * columns * count)
