"""An engine as pistons on cranks, without symbalance: harmonics by FFT of exact kinematics.

Each piston sits at r cos p + sqrt(l^2 - (r sin p - e)^2) along its axis, p = theta + throw - bank, and
pushes with minus its mass times the second derivative of that by theta (omega = 1).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

POINTS = 512


@dataclass(frozen=True)
class Piston:
    """One cylinder: mass, crank radius, rod, offset, and throw, bank (radians) and station."""

    mass: float
    radius: float
    rod: float
    offset: float
    throw: float
    bank: float
    station: float

    def changed(self, **sizes: float) -> Piston:
        return replace(self, **{k: getattr(self, k) + v for k, v in sizes.items()})

    def push(self, theta: np.ndarray) -> np.ndarray:
        p = theta + self.throw - self.bank
        side = self.radius * np.sin(p) - self.offset
        along = self.radius * np.cos(p)
        reach = np.sqrt(self.rod**2 - side**2)
        rod = -(along**2 - side * self.radius * np.sin(p)) / reach - (side * along) ** 2 / reach**3
        return self.mass * (along - rod)


def pistons(layout, mass: float = 1.0, ratio: float = 4.0) -> list[Piston]:
    """Return a layout's pistons, all alike, of crank radius 1; stations from their mean."""
    mean = sum(c.station for c in layout.cylinders) / len(layout.cylinders)
    turn = 2 * np.pi
    return [
        Piston(
            mass, 1.0, ratio, 0.0, turn * float(c.throw.turns), turn * float(c.bank.turns),
            float(c.station - mean),
        )
        for c in layout.cylinders
    ]  # fmt: skip


def harmonics(engine: Sequence[Piston], arms: bool = False) -> np.ndarray:
    """Return c_n of the planar force (or couple), n modulo POINTS: index n and, for -n, POINTS - n."""
    theta = 2 * np.pi * np.arange(POINTS) / POINTS
    total = np.zeros(POINTS, complex)
    for piston in engine:
        arm = piston.station if arms else 1.0
        total += arm * piston.push(theta) * np.exp(1j * piston.bank)
    return np.fft.fft(total) / POINTS


def largest(engine: Sequence[Piston], n: int, arms: bool = False) -> float:
    """Return the largest modulus of one order over a turn."""
    found = harmonics(engine, arms)
    return abs(found[n]) + abs(found[-n])
