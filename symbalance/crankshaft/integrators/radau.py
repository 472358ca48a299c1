"""Radau IIA with a fixed step for linear periodic systems: order 2 s - 1, L-stable, no step rejected.

With A = T diag(poles) T^-1 the stages' accelerations come apart into one n x n system a pole,

    (M + h p D + h^2 p^2 S) a_p = (T^-1 r)_p,    r_i = f_i - B^T b_i - D v - S (x + h c_i v),

real or complex, factored once for the whole run. What the bearings add has rank 2 b a stage: their forces
at the s stages are the only unknowns that a step solves for, and the systems of all steps are solved
together beforehand. Housing states go along exactly; they are massless, so a stiffly accurate method is needed.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symbalance.crankshaft.integrators.coefficients import coefficients, gathered, units
from symbalance.crankshaft.integrators.films import stage_films
from symbalance.crankshaft.integrators.marching import LinearSteps
from symbalance.crankshaft.integrators.tableau import Complex, Tableau, radau_iia
from symbalance.crankshaft.rotor import Array
from symbalance.crankshaft.system import PeriodicSystem


def radau_steps(system: PeriodicSystem, steps: int, stages: int = 3) -> LinearSteps:
    """Return one cycle of `steps` equal steps of Radau IIA with `stages` stages."""
    tableau = radau_iia(stages)
    h = system.cycle / system.omega / steps
    theta = (system.cycle / steps) * (np.arange(steps)[:, None] + tableau.nodes)
    rotor = _Rotor.of(system, tableau, h, system.force(theta.ravel()).reshape(steps, stages, -1))
    films = stage_films(system, coefficients(system, theta.ravel()), tableau.matrix, h)
    small = np.eye(len(rotor.compliance)) + films.velocity @ rotor.compliance
    loads = films.velocity @ rotor.velocity_forced[..., None]
    known = np.concatenate([films.velocity, films.displacement, films.housing, loads], axis=2)
    gain = np.linalg.solve(small, known)
    points = gathered(system)
    free = np.vstack([rotor.free, rotor.velocity_seen, np.hstack([points, np.zeros_like(points)])])
    return LinearSteps(
        free,
        rotor.load,
        gain[..., :-1],
        gain[..., -1],
        rotor.forced,
        films.kept,
        films.moved,
        units(system),
    )


@dataclass(frozen=True)
class _Rotor:
    """One step of the rotor between its bearings: state to state, bearing forces to state, and loads.

    `velocity_seen` gives the journals' velocities at the stages (s 2b, 2n), `compliance` what the
    stages' bearing forces take from them (s 2b, s 2b).
    """

    free: Array
    load: Array
    forced: Array
    velocity_seen: Array
    compliance: Array
    velocity_forced: Array

    @classmethod
    def of(cls, system: PeriodicSystem, tableau: Tableau, h: float, force: Array) -> _Rotor:
        n, points, s = system.size, gathered(system), tableau.stages
        made = [_pole(system, tableau, h, k, force) for k in tableau.kept]
        modes = tableau.transform[:, tableau.kept] * tableau.counted
        poles = tableau.poles[list(tableau.kept)]
        velocity = _Sum(h * modes * poles, made)
        place = _Sum(h * h * modes[-1:] * poles**2, made)
        shift = np.hstack([np.eye(n), h * np.eye(n)])
        keep = np.hstack([np.zeros((n, n)), np.eye(n)])
        ends = (place.state(0), velocity.state(s - 1))
        seen = [points @ (keep + velocity.state(i)) for i in range(s)]
        return cls(
            np.vstack([shift + ends[0], keep + ends[1]]),
            -np.vstack([place.bearing(0), velocity.bearing(s - 1)]),
            np.hstack([place.forced(0), velocity.forced(s - 1)]),
            np.concatenate(seen) if s else np.zeros((0, 2 * n)),
            -np.concatenate([points @ velocity.bearing(i) for i in range(s)]),
            np.concatenate([velocity.forced(i) @ points.T for i in range(s)], axis=1),
        )


@dataclass(frozen=True)
class _Pole:
    """One pole's accelerations per state (n, 2n), per stages' bearing forces (n, s 2b), per step (N, n)."""

    state: Complex
    bearing: Complex
    forced: Complex


def _pole(system: PeriodicSystem, tableau: Tableau, h: float, k: int, force: Array) -> _Pole:
    n, points = system.size, gathered(system)
    pole, inverse = tableau.poles[k], tableau.inverse[k]
    if pole.imag == 0:
        pole, inverse = pole.real, inverse.real
    matrix = system.mass + h * pole * system.damping + (h * pole) ** 2 * system.stiffness
    loads = np.tensordot(inverse, force, axes=(0, 1)).T
    sides = np.hstack([system.stiffness, system.damping, points.T, loads])
    solved = np.linalg.solve(matrix, sides)
    stiff, damped = solved[:, :n], solved[:, n : 2 * n]
    ones, nodes = inverse.sum(), inverse @ tableau.nodes
    state = -np.hstack([ones * stiff, ones * damped + h * nodes * stiff])
    pushed = -np.kron(inverse, solved[:, 2 * n : 2 * n + len(points)])
    return _Pole(state, pushed, solved[:, 2 * n + len(points) :].T)


@dataclass(frozen=True)
class _Sum:
    """Real sums over the poles, weighted by row i of `weights`."""

    weights: Complex
    poles: list[_Pole]

    def state(self, i: int) -> Array:
        return sum((np.real(w * p.state) for w, p in self._with(i)), np.zeros(()))

    def bearing(self, i: int) -> Array:
        return sum((np.real(w * p.bearing) for w, p in self._with(i)), np.zeros(()))

    def forced(self, i: int) -> Array:
        return sum((np.real(w * p.forced) for w, p in self._with(i)), np.zeros(()))

    def _with(self, i: int) -> zip:
        return zip(self.weights[i], self.poles, strict=True)
