"""Periodic steady state of a rotor on its bearings by harmonic balance: a reference for time stepping.

The rotor between its bearings has constant coefficients in turning axes, the housings in stationary ones.
Each answers a harmonic by itself, so that the bearing forces at N equal angles are the only unknowns,
2 b N of them whatever the rotor's size: one dense linear system. Turning moves a harmonic by one turn's,

    R(theta) = 2 Re e^{i theta} P,    P = [1, i; -i, 1]/2,

so a stationary quantity of a turning harmonic W_k has the frequency W_k + omega. The error falls faster
than any power of N for smooth films, else as the film table's smoothness has it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.integrators.coefficients import bearing_count, bearing_rows
from symbalance.crankshaft.system import PeriodicSystem, check_consistency
from symbalance.errors import SymbalanceError, shown

Complex = NDArray[np.complexfloating[Any, Any]]
MOST = 2000
"""Harmonics at most: the dense system grows with their square, its solution with their cube."""
SUPPORT, DAMPER = 1e8, 1e5
"""Springs (N/m) and dampers (N s/m) added at the bearings where the rotor's answers are taken, and taken
off in the balance: a rotor without any has no answer to a force that stands still."""
FORWARD: Complex = np.array([[0.5, 0.5j], [-0.5j, 0.5]])
"""P, the part of a vector that turns forward."""


@dataclass(frozen=True)
class HarmonicState:
    """The steady state: coefficients of e^{i k 2 pi theta/cycle} for k = 0 to h (h + 1, n).

    `housing` (2h + 1, 2b), k = -h to h, are those of the housings, times e^{i theta}, to be taken twice
    the real part of; None without housings.
    """

    system: PeriodicSystem
    position: Complex
    housing: Complex | None

    def states(self, theta: Array) -> Array:
        """Return the states (x, x', z) at angles (s,), as the integrators have them."""
        base, top = 2 * np.pi / self.system.cycle, len(self.position) - 1
        wave = np.exp(1j * base * np.multiply.outer(theta, np.arange(top + 1)))
        rate = 1j * base * self.system.omega * np.arange(top + 1)
        weights = np.where(np.arange(top + 1) > 0, 2.0, 1.0)[:, None]
        parts = [(wave @ (weights * self.position)).real]
        parts.append((wave @ (weights * rate[:, None] * self.position)).real)
        if self.housing is not None:
            both = np.exp(1j * np.multiply.outer(theta, base * np.arange(-top, top + 1) + 1))
            parts.append(2 * (both @ self.housing).real)
        return np.hstack(parts)


def harmonic_state(system: PeriodicSystem, harmonics: int = 120) -> HarmonicState:
    """Return the periodic steady state with harmonics of the cycle up to `harmonics`.

    One equation of N = 2 harmonics + 1 angles times 2 b unknowns is solved, in N^3 operations.
    """
    if not isinstance(harmonics, int | np.integer) or not 1 <= harmonics <= MOST:
        rule = f"must be a whole number, 1 to {MOST}"
        raise SymbalanceError(f"harmonics = {shown(harmonics)}", rule, "120 is usual")
    check_consistency(system)
    count, top = 2 * harmonics + 1, harmonics
    theta, orders = system.cycle / count * np.arange(count), np.fft.fftfreq(count, 1 / count)
    frequency = 2 * np.pi / system.cycle * system.omega * orders
    force = np.fft.fft(system.force(theta), axis=0) / count
    answer, free = _answers(system, frequency[: top + 1], force[: top + 1])
    flexible = _both_sides(np.stack([a[:, 1:] for a in answer]))
    loose = _both_sides(np.stack([a[:, 0] for a in answer]))
    balance = _Balance.of(system, frequency, flexible, loose)
    excess = balance.solve(system, theta)
    spectrum = np.fft.fft(excess, axis=0) / count
    position = free[:, :, 0] - np.einsum("knb,kb->kn", free[:, :, 1:], spectrum[: top + 1])
    total = np.einsum("kab,kb->ka", balance.whole, spectrum) + balance.loose_force
    housing = None
    if system.housing is not None:
        housing = np.fft.fftshift(np.einsum("kab,kb->ka", balance.behind, total), axes=0)
    return HarmonicState(system, position, housing)


def _answers(system: PeriodicSystem, frequency: Array, force: Complex) -> tuple[list[Complex], Complex]:
    """Return, per harmonic, what loads and unit bearing forces do: at the journals, and everywhere."""
    points = bearing_rows(system)
    spring, damper = SUPPORT * points.T @ points, DAMPER * points.T @ points
    everywhere = []
    for w, load in zip(frequency, force, strict=True):
        dynamic = system.stiffness + spring + 1j * w * (system.damping + damper) - w * w * system.mass
        everywhere.append(np.linalg.solve(dynamic, np.column_stack([load, points.T])))
    return [points @ each for each in everywhere], np.array(everywhere)


def _both_sides(positive: Complex) -> Complex:
    """Return coefficients 0 to h as 0 to h, then -h to -1: those of something real."""
    return np.concatenate([positive, positive[:0:-1].conj()])


@dataclass(frozen=True)
class _Balance:
    """Per harmonic (N, ...): excess force to whole film force, to the film's squeeze, to the housing.

    The excess is the film's force less that of the added springs and dampers.
    """

    whole: Complex
    squeeze: Complex
    behind: Complex
    rate: Complex
    loose_force: Complex
    loose_squeeze: Complex

    @classmethod
    def of(cls, system: PeriodicSystem, frequency: Array, answer: Complex, loose: Complex) -> _Balance:
        """Return the balance of flexibilities (N, 2b, 2b) and load displacements (N, 2b)."""
        count = bearing_count(system)
        support = SUPPORT + 1j * frequency * DAMPER
        whole = np.eye(2 * count) - support[:, None, None] * answer
        loose_force = support[:, None] * loose
        forward = np.kron(np.eye(count), FORWARD)
        behind = _housing_answers(system, frequency + system.omega) @ forward
        squeeze = forward @ answer + behind @ whole
        loose_squeeze = loose @ forward.T - np.einsum("kab,kb->ka", behind, loose_force)
        rate = 1j * (frequency + system.omega)
        return cls(whole, squeeze, behind, rate, loose_force, loose_squeeze)

    def solve(self, system: PeriodicSystem, theta: Array) -> Array:
        """Return the excess forces (N, 2b) at the angles, turning axes."""
        count, b = len(theta), 2 * bearing_count(system)
        forward, turn = np.kron(np.eye(b // 2), FORWARD), 2 * np.exp(1j * theta)
        kernels = [np.fft.ifft(part, axis=0) for part in self._parts(forward)]
        sides = [count * np.fft.ifft(part, axis=0) for part in self._loose(forward)]
        stiffness, damping = (_whole(f(theta)) for f in (system.film.stiffness, system.film.damping))
        matrix, side = np.empty((count, b, count, b)), np.empty((count, b))
        for i in range(count):
            back = (i - np.arange(count)) % count
            load, squeeze, speed = (kernel[back] for kernel in kernels)
            row = turn[i] * (load + stiffness[i] @ squeeze + damping[i] @ speed)
            matrix[i] = row.real.transpose(1, 0, 2)
            constant = stiffness[i] @ sides[1][i] + damping[i] @ sides[2][i] - sides[0][i]
            side[i] = (turn[i] * constant).real
        return np.linalg.solve(matrix.reshape(count * b, -1), side.ravel()).reshape(count, b)

    def _parts(self, forward: Complex) -> tuple[Complex, Complex, Complex]:
        return forward @ self.whole, self.squeeze, self.rate[:, None, None] * self.squeeze

    def _loose(self, forward: Complex) -> tuple[Complex, Complex, Complex]:
        return (
            self.loose_force @ forward.T,
            self.loose_squeeze,
            self.rate[:, None] * self.loose_squeeze,
        )


def _housing_answers(system: PeriodicSystem, frequency: Array) -> Complex:
    """Return the housings' flexibilities (N, 2b, 2b), zero without housings."""
    b = 2 * bearing_count(system)
    if system.housing is None:
        return np.zeros((len(frequency), b, b), dtype=complex)
    speed = 1j * frequency[:, None, None, None] * system.housing.damping
    return _whole(np.linalg.inv(system.housing.stiffness + speed))


def _whole(blocks: NDArray[Any]) -> NDArray[Any]:
    """Return (s, b, 2, 2) as (s, 2b, 2b), the bearings on the diagonal."""
    count, b = blocks.shape[:2]
    full = np.zeros((count, b, 2, b, 2), dtype=blocks.dtype)
    for j in range(b):
        full[:, j, :, j, :] = blocks[:, j]
    return full.reshape(count, 2 * b, 2 * b)
