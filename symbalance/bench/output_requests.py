"""Worst error of one output of an engine on every target, beside the naive formulas' errors."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache, partial
from importlib.util import find_spec
from math import gcd
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from symbalance.bench.bounded_cases import OF_AMPLITUDE, BoundedCase, attempt, worst_point
from symbalance.bench.timing import progress
from symbalance.bench.true_values import (
    Points,
    Term,
    TrueValues,
    U,
    accelerations_at,
    harmonics_at,
    piston_at,
    terms,
    true_coefficients,
    weights,
)
from symbalance.codegen import Evaluator, plan_for, to_function
from symbalance.codegen.targets import IN_MEMORY, files
from symbalance.engine.engine import Engine
from symbalance.forces.free_forces import balance

Array = Any
Function = Callable[[Array], Array]
PARTS = {"numba": "numba"}
"""The library a target needs."""
FLAGS = ("-std=gnu99", "-O3", "-march=native", "-fno-math-errno", "-shared", "-fPIC")
AIM = 4.0
"""The error aimed at for |theta| <= 1e6, in u of the amplitude; functions state a little more."""
ALL_ORDERS = 64
"""The orders that stand for all in the forward and backward parts, at a real engine's rod ratio."""


@dataclass(frozen=True)
class OutputRequest:
    """An output, its engine and rod ratio, and the orders: to `order`, or with a tolerance all."""

    engine: Engine
    name: str
    ratio: Fraction
    order: int = 12
    tolerance: float | None = None

    @cached_property
    def evaluator(self) -> Evaluator:
        """symbalance's function, with NumPy."""
        return self.on("numpy")

    def on(self, target: str) -> Evaluator:
        """Return symbalance's function on a target in memory."""
        result = balance(self.engine, order=self.order)
        return to_function(result, self.ratio, self.name, target, tolerance=self.tolerance)

    @property
    def amplitude(self) -> float:
        """The output's largest size, as its function states it."""
        return self.evaluator.amplitude[self.name]

    @property
    def stated_bound(self) -> float:
        """The error the function states, in u of the amplitude, with what it leaves out."""
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
        return terms(self.engine, self.name, order, self.ratio)

    @property
    def _part(self) -> str:
        return self.name.partition(".")[2]

    def true_values(self, points: Points) -> TrueValues:
        """Return the true values."""
        if self._part in ("displacement", "velocity"):
            return piston_at(points, self._part, self.engine, self.ratio)
        if self.tolerance is None or self._part in ("forward", "backward"):
            return harmonics_at(points, self.terms)
        return accelerations_at(points, weights(self.engine, self.name), self.ratio)

    def naive(self, theta: Array) -> dict[str, Array]:
        """Return the values of the obvious formulas: the harmonics' cosines, and cylinder by cylinder."""
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
        for weight, turns in weights(self.engine, self.name):
            angle = theta + 2 * np.pi * float(turns)
            force = self._series(angle) if self.tolerance is None else textbook(angle, lam)
            total += float(weight) * force
        return total

    def _series(self, angle: Array) -> Array:
        return sum(
            float(a) * np.cos(n * angle) for n, a in true_coefficients(self.order, self.ratio).items()
        )

    def case(
        self, name: str, points: Points, bound: float, note: str = "", function: Function | None = None
    ) -> BoundedCase:
        """Return how far off the function is at the points, in u of its amplitude."""
        truth, size = self.true_values(points), U * self.amplitude
        errors = truth.off((function or self.evaluator)(points.theta)) / size
        with np.errstate(all="ignore"):  # naive forms overflow, and that is their error
            naive = {way: truth.off(v) / size for way, v in self.naive(points.theta).items()}
        return worst_point(name, points.theta, errors, bound, OF_AMPLITUDE, naive, note)

    def stated_cases(self, points: Points, note: str = "") -> list[BoundedCase]:
        """Return the case held to the function's own stated bound; none where the output vanishes."""
        orders = f"orders to {self.order}" if self.tolerance is None else "all orders"
        name = f"{self.engine.name}, {self.name}, {orders}"
        progress(name)
        try:
            if not self.amplitude:
                return []
        except Exception as error:  # whatever the engine's plan stumbles over is a failure of the case
            return [BoundedCase(name, f"raised {type(error).__name__}: {error}"[:36], float("inf"), AIM)]
        note = note or f"amplitude {self.amplitude:.3g}: "
        make = partial(self.case, name, points, self.stated_bound, note)
        return [attempt(name, AIM, OF_AMPLITUDE, make)]


def textbook(angle: Array, lam: float) -> Array:
    """Return a piston's acceleration as textbooks write it."""
    c, s = np.cos(angle), np.sin(angle)
    root = np.sqrt(lam * lam - s * s)
    return c + (c * c - s * s) / root + (s * c) ** 2 / root**3


def targets() -> list[str]:
    """Return the targets that can be run here: those in memory, and C where there is a compiler."""
    in_memory = [t for t in IN_MEMORY if t not in PARTS or find_spec(PARTS[t]) is not None]
    return [*in_memory, "c"] if shutil.which("cc") else in_memory


@lru_cache
def on_target(request: OutputRequest, target: str) -> Function:
    """Return symbalance's function on any target, as one of an array of doubles."""
    if target != "c":
        function = request.on(target)
        return lambda theta: np.asarray(function(theta))
    return _compile_c(request)


def _compile_c(request: OutputRequest) -> Function:
    """Return the C source compiled into a library of its own."""
    result = balance(request.engine, order=request.order)
    plan = plan_for(result, request.ratio, request.name, "c", request.tolerance)
    with TemporaryDirectory() as folder:
        for ending, text in files(plan, "c", "engine", "output").items():
            Path(folder, "output" + ending).write_text(text, encoding="utf-8")
        library = str(Path(folder, "output.so"))
        command = ["cc", *FLAGS, "-o", library, str(Path(folder, "output.c")), "-lm"]
        subprocess.run(command, check=True, capture_output=True)
        evaluate = ctypes.CDLL(library).output
    pointer = np.ctypeslib.ndpointer(np.float64, flags="C")
    evaluate.argtypes = [ctypes.c_size_t, pointer, *[ctypes.c_double] * 4, pointer]
    evaluate.restype = None

    def function(theta: Array) -> Array:
        angles = np.ascontiguousarray(theta, np.float64)
        values = np.empty_like(angles)
        evaluate(angles.size, angles, 1.0, 1.0, 1.0, 1.0, values)
        return values

    return function
