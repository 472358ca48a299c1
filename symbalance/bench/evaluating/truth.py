"""The truth: exact kinematics of every cylinder, in mpmath, and how far a function is from it.

Nothing of `symbalance.codegen` takes part: a cylinder's inertia force is the closed second derivative of
its piston's way, summed over the cylinders as the layout places them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from symbalance.bench.evaluating.alternatives import cylinders, per_cylinder
from symbalance.bench.evaluating.candidates import Floats
from symbalance.bench.evaluating.cases import Case
from symbalance.bench.judge import Number, mp

DIGITS = 40
FARTHEST = 1e6
TWO_TURNS = 4 * np.pi
UNIT = 2.0**-53


@dataclass(frozen=True)
class Error:
    """The largest |found - true| as a part of the amplitude: to a million radians, and to two turns."""

    largest: float
    near: float

    @property
    def in_u(self) -> float:
        """The largest in u = 2^-53 of the amplitude."""
        return self.largest / UNIT


@dataclass(frozen=True)
class Truth:
    """True values at some angles, all orders; `amplitude` is the largest over two turns."""

    angles: Floats
    values: tuple[Number, ...]
    amplitude: float

    def error(self, function: Callable[[Floats], Floats]) -> Error:
        """Return how far a function is off; NaN where it gives one."""
        with mp.workdps(DIGITS):
            pairs = zip(function(self.angles), self.values, strict=True)
            off = [float(abs(mp.mpf(float(found)) - true)) for found, true in pairs]
        relative = np.array(off) / self.amplitude
        within = np.abs(self.angles) <= TWO_TURNS
        return Error(float(relative.max()), float(relative[within].max()))


def truth(case: Case, count: int = 300) -> Truth:
    """Return the truth of a case, whatever its order, at about `count` angles."""
    angles = chosen(count)
    turns = np.linspace(0.0, TWO_TURNS, 14401)
    amplitude = float(np.abs(per_cylinder(case)(turns)).max())
    with mp.workdps(DIGITS):
        ratio = mp.mpf(case.known_ratio.numerator) / case.known_ratio.denominator
        rows = cylinders(case, mp.cos, mp.sin, mp.pi)
        values = tuple(_exact(mp.mpf(float(theta)), rows, ratio) for theta in angles)
    return Truth(angles, values, amplitude)


def _exact(theta: Number, rows: list[tuple[Number, Number]], ratio: Number) -> Number:
    return mp.fsum(weight * _force(theta + lead, ratio) for weight, lead in rows if weight)


def _force(p: Number, ratio: Number) -> Number:
    """Return minus the second derivative of cos p + sqrt(lambda^2 - sin^2 p)."""
    cosine, sine = mp.cos_sin(p)
    root = mp.sqrt(ratio**2 - sine**2)
    return cosine + (cosine**2 - sine**2) / root + (sine * cosine) ** 2 / root**3


def chosen(count: int) -> Floats:
    """Return angles: over two turns, on to a million radians, and close to dead centres."""
    random = np.random.default_rng(20)
    third = max(count // 3, 2)
    signs = random.choice((-1.0, 1.0), third)
    turns = random.uniform(-TWO_TURNS, TWO_TURNS, third)
    far = signs * 10 ** random.uniform(np.log10(TWO_TURNS), np.log10(FARTHEST), third)
    centres = random.integers(-7, 8, third) * (np.pi / 2)
    near = centres + signs * 10 ** random.uniform(-9.0, -1.0, third)
    return np.concatenate(([0.0, FARTHEST, -FARTHEST], turns, far, near))
