"""Fatigue under a stress over the crank angle: Goodman's safety factor and rainflow damage.

Amplitudes and means of a normal stress sigma and a shear stress tau at one place combine to
sqrt(sigma^2 + 3 tau^2) (von Mises). Goodman's line: sigma_a/sigma_e + sigma_m/sigma_u = 1/n, a mean below
zero counted as zero. Cycles are those of the equivalent stress with the largest damage, of

    sign(sigma) sqrt(sigma^2 + 3 tau^2)   and   sigma cos phi + sqrt(3) tau sin phi,  |phi| <= 90 degrees:

the first folds a torsion that swings about zero into half its swing, the others miss what bending and
torsion do at different angles. Damage (Palmgren, Miner): every rainflow cycle of amplitude a and
mean m, put on the line to zero mean by Goodman, a_0 = a/(1 - m/sigma_u), takes 1/N of the life,
N = N_e (sigma_e/a_0)^k, amplitudes below sigma_e too (Miner's elementary form: on the safe side).
Sources: Goodman (1899) and Miner (1945) as in Shigley, Mechanical Engineering Design, ch. 6; rainflow by
ASTM E1049 as the library `rainflow` counts it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.files.operation import Strength
from symbalance.errors import MissingPartError

DIRECTIONS = 24
"""The combinations of the two stresses whose cycles are counted."""


@dataclass(frozen=True)
class Durability:
    """Fatigue figures: equivalent amplitude and mean in Pa, Goodman's safety factor, damage per cycle."""

    amplitude: float
    mean: float
    safety: float
    damage: float

    def hours(self, cycle_time: float) -> float:
        """Return the life in hours at a cycle of `cycle_time` seconds; infinite without damage."""
        return cycle_time / self.damage / 3600 if self.damage else float("inf")


def durability(normal: Array, shear: Array, strength: Strength) -> Durability:
    """Return the durability under a normal and a shear stress (s,) over one cycle, Pa.

    >>> wave = 1e8 * np.cos(np.arange(360) * np.pi / 180)
    >>> result = durability(wave, 0 * wave, Strength(9e8, 4e8, 8.0, 2e6))
    >>> round(result.safety, 9), bool(abs(result.damage * 2e6 * 4**8 - 1) < 1e-9)
    (4.0, True)
    """
    amplitude = _equivalent(float(np.ptp(normal)) / 2, float(np.ptp(shear)) / 2)
    middle = (normal.max() + normal.min()) / 2, (shear.max() + shear.min()) / 2
    mean = _equivalent(*middle) if middle[0] > 0 else 0.0
    utilisation = amplitude / strength.endurance + mean / strength.tensile
    worst = max(damage(wave, strength) for wave in combinations(normal, shear))
    return Durability(amplitude, mean, 1 / utilisation if utilisation else float("inf"), worst)


def combinations(normal: Array, shear: Array) -> Iterator[Array]:
    """Yield the signed root (s,), then sigma cos phi + sqrt(3) tau sin phi at `DIRECTIONS` angles.

    Not beyond 90 degrees, where the sign of sigma would turn. A swing between two angles is missed by
    less than 0.3 %.
    """
    yield np.where(normal < 0, -1.0, 1.0) * np.sqrt(normal**2 + 3 * shear**2)
    if not shear.any():
        return
    for k in range(1, DIRECTIONS + 1):
        phi = np.pi * (k / DIRECTIONS - 0.5)
        yield normal * np.cos(phi) + np.sqrt(3) * shear * np.sin(phi)
    yield -np.sqrt(3) * shear


def _equivalent(normal: float, shear: float) -> float:
    return float(np.sqrt(normal**2 + 3 * shear**2))


def damage(stress: Array, strength: Strength) -> float:
    """Return the share of the life that a cycle of a stress (s,) takes; infinite at the strength."""
    start = int(np.argmax(np.abs(stress)))
    cycle = np.concatenate([stress[start:], stress[: start + 1]])  # from its largest value round to it
    total = 0.0
    for span, mean, count, *_ in rainflow().extract_cycles(cycle):
        margin = 1 - max(mean, 0.0) / strength.tensile
        if margin <= 0:
            return float("inf")
        ratio = span / 2 / margin / strength.endurance
        total += count * ratio**strength.slope / strength.cycles
    return float(total)


def rainflow() -> Any:
    """Return the library that counts cycles, or refuse with the command that installs it."""
    try:
        return import_module("rainflow")
    except ImportError:
        rule = "rainflow is not installed"
        raise MissingPartError("durability", rule, "pip install 'symbalance[crankshaft]'") from None
