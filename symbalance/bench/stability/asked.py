"""One output of one engine as it is asked for: ours on every target, the truth, and the naive forms."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from importlib.util import find_spec
from math import gcd
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from symbalance.bench.stability.case import OF_AMPLITUDE, Case, measured
from symbalance.bench.stability.truth import (
    Points,
    Term,
    Truth,
    U,
    accelerations_at,
    coefficients,
    harmonics_at,
    piston_at,
    terms,
    weights,
)
from symbalance.codegen import Evaluator, plan_for, to_function
from symbalance.codegen.targets import IN_MEMORY, files
from symbalance.engine.engine import Engine
from symbalance.forces.free_forces import balance

Array = Any
Function = Callable[[Array], Array]
PARTS = {"numba": "numba"}
FLAGS = ("-std=gnu99", "-O3", "-march=native", "-fno-math-errno", "-shared", "-fPIC")
ALL_ORDERS = 64
"""The orders that stand for all in the forward and backward parts, at a real engine's rod ratio."""


@dataclass(frozen=True)
class Asked:
    """An output, its engine and rod ratio, and the orders: to `order`, or with a tolerance all."""

    layout: Engine
    name: str
    ratio: Fraction
    order: int = 12
    tolerance: float | None = None

    @cached_property
    def evaluator(self) -> Evaluator:
        """Ours, with NumPy."""
        return self.on("numpy")

    def on(self, target: str) -> Evaluator:
        """Return ours on a target in memory."""
        result = balance(self.layout, order=self.order)
        return to_function(result, self.ratio, self.name, target, tolerance=self.tolerance)

    @property
    def amplitude(self) -> float:
        """The output's largest size, as ours states it."""
        return self.evaluator.amplitude[self.name]

    @property
    def stated(self) -> float:
        """What ours says it may be off, in u of the amplitude, with what it leaves out."""
        left_out = self.evaluator.left_out[self.name] or 0.0
        return self.evaluator.rounding[self.name] + left_out / (U * self.amplitude)

    @property
    def step(self) -> int:
        """What the orders above the first are multiples of: far angles err as many times more."""
        return gcd(*(int(n) for n in self.evaluator.orders[self.name] if n != "1")) or 1

    @cached_property
    def terms(self) -> list[Term]:
        """The true harmonics."""
        order = self.order if self.tolerance is None else ALL_ORDERS
        return terms(self.layout, self.name, order, self.ratio)

    @property
    def _part(self) -> str:
        return self.name.partition(".")[2]

    def truth(self, points: Points) -> Truth:
        """Return the true values."""
        if self._part in ("displacement", "velocity"):
            return piston_at(points, self._part, self.layout, self.ratio)
        if self.tolerance is None or self._part in ("forward", "backward"):
            return harmonics_at(points, self.terms)
        return accelerations_at(points, weights(self.layout, self.name), self.ratio)

    def naive(self, theta: Array) -> dict[str, Array]:
        """Return what the obvious formulas give: the harmonics' cosines, and cylinder by cylinder."""
        if self._part in ("forward", "backward"):
            return {"cos n theta": self._by_cosines(theta)}
        if self.tolerance is None:
            return {"cos n theta": self._by_cosines(theta), "by cylinder": self._by_cylinder(theta)}
        return {"by cylinder": self._by_cylinder(theta)}

    def _by_cosines(self, theta: Array) -> Array:
        pairs = [
            (float(t.cos) * np.cos(t.order * theta), float(t.sin) * np.sin(t.order * theta))
            for t in self.terms
        ]
        return sum(c + s for c, s in pairs)

    def _by_cylinder(self, theta: Array) -> Array:
        lam = float(self.ratio)
        total = np.zeros_like(theta)
        for weight, turns in weights(self.layout, self.name):
            own = theta + 2 * np.pi * float(turns)
            total += float(weight) * (self._summed(own) if self.tolerance is None else textbook(own, lam))
        return total

    def _summed(self, angle: Array) -> Array:
        return sum(float(a) * np.cos(n * angle) for n, a in coefficients(self.order, self.ratio).items())

    def case(
        self, what: str, points: Points, bound: float, note: str = "", function: Function | None = None
    ) -> Case:
        """Return how far off ours is at the points, in u of its amplitude."""
        truth, size = self.truth(points), U * self.amplitude
        ours = truth.off((function or self.evaluator)(points.theta)) / size
        with np.errstate(all="ignore"):
            naive = {name: truth.off(v) / size for name, v in self.naive(points.theta).items()}
        return measured(what, points.theta, ours, bound, OF_AMPLITUDE, naive, note)


def textbook(angle: Array, lam: float) -> Array:
    """Return a piston's acceleration as textbooks write it."""
    c, s = np.cos(angle), np.sin(angle)
    root = np.sqrt(lam * lam - s * s)
    return c + (c * c - s * s) / root + (s * c) ** 2 / root**3


def targets() -> list[str]:
    """Return the targets that can be run here: those in memory, and C where there is a compiler."""
    known = [t for t in IN_MEMORY if t not in PARTS or find_spec(PARTS[t]) is not None]
    return [*known, "c"] if shutil.which("cc") else known


@lru_cache
def on_target(asked: Asked, target: str) -> Function:
    """Return ours on any target, as a function of an array of doubles."""
    if target != "c":
        function = asked.on(target)
        return lambda theta: np.asarray(function(theta))
    return _compiled(asked)


def _compiled(asked: Asked) -> Function:
    """Return the C source compiled into a library of its own."""
    result = balance(asked.layout, order=asked.order)
    planned = plan_for(result, asked.ratio, asked.name, "c", asked.tolerance)
    with TemporaryDirectory() as folder:
        for ending, text in files(planned, "c", "engine", "tried").items():
            Path(folder, "tried" + ending).write_text(text, encoding="utf-8")
        library = str(Path(folder, "tried.so"))
        command = ["cc", *FLAGS, "-o", library, str(Path(folder, "tried.c")), "-lm"]
        subprocess.run(command, check=True, capture_output=True)
        tried = ctypes.CDLL(library).tried
    pointer = np.ctypeslib.ndpointer(np.float64, flags="C")
    tried.argtypes = [ctypes.c_size_t, pointer, *[ctypes.c_double] * 4, pointer]
    tried.restype = None

    def function(theta: Array) -> Array:
        angles = np.ascontiguousarray(theta, np.float64)
        values = np.empty_like(angles)
        tried(angles.size, angles, 1.0, 1.0, 1.0, 1.0, values)
        return values

    return function
