"""Outputs of preset engines as NumPy, Numba and compiled C functions, ready to be timed."""

from __future__ import annotations

import ctypes
import re
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from importlib.util import find_spec
from math import atan2, hypot
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from symbalance.codegen import Evaluator, plan_for, to_function
from symbalance.codegen.harmonic_sum import HarmonicSum
from symbalance.codegen.plans import Plan
from symbalance.codegen.targets import files
from symbalance.engine.catalogue import load
from symbalance.engine.engine import Engine
from symbalance.forces.free_forces import Balance, balance

Floats = NDArray[np.float64]
Call = Callable[[Floats, Floats], Floats]
Key = TypeVar("Key", bound=Hashable)
ALL = "all"
NUMPY, NUMBA, C = "numpy", "numba", "c"
TARGETS = (NUMPY, NUMBA, C)
COMPILED = (NUMBA, C)
FUNCTION = "evaluated"
WARM_UP = np.linspace(-7.0, 7.0, 64)
"""Angles of the first call, at which Numba compiles."""
FLAGS = re.compile(r"cc (-std=.*?) -c ")


@dataclass(frozen=True)
class Harmonic:
    """amplitude * cos(order * theta - phase), in doubles: what the alternatives start from."""

    order: float
    amplitude: float
    phase: float


@dataclass(frozen=True)
class EvaluatedOutput:
    """An output of an engine; `order` None: all that shows in a double; `ratio` None: its own."""

    engine: str
    output: str
    order: int | None = 12
    ratio: Fraction | None = None

    @cached_property
    def preset_engine(self) -> Engine:
        """The preset."""
        return load(self.engine)

    @cached_property
    def balance(self) -> Balance:
        """The engine's balance to the order, to 12 where none is set."""
        return balance(self.preset_engine, self.order or 12, ratio=self.ratio)

    @property
    def rod_ratio(self) -> Fraction:
        """lambda = l/r: `ratio`, or the engine's own."""
        ratio = self.balance.ratio
        if ratio is None:
            raise ValueError(f"{self.engine} has no rod ratio")
        return ratio

    @property
    def tolerance(self) -> float | None:
        """0, for every order that shows in a double, where there is no order."""
        return 0.0 if self.order is None else None

    @property
    def reach(self) -> str:
        """The order, or "all"."""
        return ALL if self.order is None else str(self.order)

    def evaluator(self, target: str) -> Evaluator:
        """Return the function of the crank angle, as a user gets it."""
        return to_function(self.balance, None, self.output, target, tolerance=self.tolerance)

    def plan(self, target: str) -> Plan:
        """Return what a target is written from."""
        return plan_for(self.balance, None, self.output, target, self.tolerance)

    @cached_property
    def harmonic_sum(self) -> HarmonicSum:
        """The output's surviving harmonics, exact in lambda."""
        return self.plan("numpy").outputs[0].harmonic_sum

    @cached_property
    def harmonics(self) -> tuple[Harmonic, ...]:
        """The cancelled sum, each harmonic one cosine."""
        return tuple(
            _harmonic(float(term.order), float(term.cos), float(term.sin))
            for term in self.harmonic_sum.terms
        )


def _harmonic(order: float, cos: float, sin: float) -> Harmonic:
    """Return one harmonic; what is rounding of a phase 0 or 180 degrees is taken for it.

    >>> _harmonic(2.0, -3.0, 1e-30), _harmonic(1.0, 0.0, 2.0).amplitude
    (Harmonic(order=2.0, amplitude=-3.0, phase=0.0), 2.0)
    """
    if abs(sin) < 1e-20 * abs(cos):
        return Harmonic(order, cos, 0.0)
    return Harmonic(order, hypot(cos, sin), atan2(sin, cos))


@dataclass(frozen=True)
class Candidate:
    """A name, and a call that gives the values at theta: in the second array, or in a new one."""

    name: str
    call: Call

    def __call__(self, theta: Floats) -> Floats:
        """Return the values in a new array."""
        return self.call(theta, np.empty_like(theta))

    def warmed(self) -> Candidate:
        """Return the candidate, compiled by a first call."""
        self(WARM_UP)
        return self


@dataclass(frozen=True)
class AvailableTargets:
    """Which targets can run here, and for those that cannot, why, in one line each."""

    targets: tuple[str, ...]
    notes: tuple[str, ...]


def available_targets() -> AvailableTargets:
    """Return which of symbalance's targets this machine can run."""
    lacking: dict[str, str] = {}
    if find_spec("numba") is None:
        lacking[NUMBA] = "numba: not installed (pip install numba)"
    if compiler() is None:
        lacking[C] = "c: no C compiler under the name cc"
    return AvailableTargets(tuple(t for t in TARGETS if t not in lacking), tuple(lacking.values()))


def compiler() -> str | None:
    """Return the path of `cc`."""
    return shutil.which("cc")


def candidate(case: EvaluatedOutput, target: str) -> Candidate:
    """Return symbalance's function for a case on a target, compiled."""
    if target == C:
        return from_plan(case.plan(C), C)
    return _filling(target, case.evaluator(target))


def from_plan(plan: Plan, target: str) -> Candidate:
    """Return a plan's one output on a target, compiled."""
    texts = files(plan, target, FUNCTION, FUNCTION, grid=False)
    if target == C:
        return Candidate(C, compile_c(texts[".c"], texts[".h"])).warmed()
    return from_module(target, texts[".py"])


@cache
def from_module(target: str, source: str) -> Candidate:
    """Return the function that a generated Python module defines, compiled."""
    namespace: dict[str, Any] = {"__name__": FUNCTION}
    exec(compile(source, f"<{FUNCTION}>", "exec"), namespace)  # text that symbalance wrote
    return _filling(target, namespace["evaluate"])


def _filling(target: str, function: Callable[..., Floats]) -> Candidate:
    return Candidate(target, lambda theta, out: function(theta, out=out)).warmed()


@cache
def compile_c(source: str, header: str) -> Call:
    """Return the function of a generated C source, built by `cc` with the flags the source names."""
    flags = FLAGS.search(source)
    if flags is None:
        raise ValueError("the C source names no flags")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"{FUNCTION}.c"
        path.write_text(source, encoding="utf-8")
        path.with_suffix(".h").write_text(header, encoding="utf-8")
        library = path.with_suffix(".so")
        command = [str(compiler()), *flags[1].split(), "-shared", "-fPIC", str(path)]
        subprocess.run([*command, "-o", str(library), "-lm"], check=True)
        function = ctypes.CDLL(str(library))[FUNCTION]  # stays loaded when the file goes
    function.argtypes = [ctypes.c_size_t, ctypes.c_void_p, *4 * [ctypes.c_double], ctypes.c_void_p]
    function.restype = None

    def call(theta: Floats, out: Floats) -> Floats:
        function(theta.size, theta.ctypes.data, 1.0, 1.0, 1.0, 1.0, out.ctypes.data)
        return out

    return call


def calls(
    candidates: Mapping[Key, Candidate], theta: Floats, out: Floats
) -> dict[Key, Callable[[], object]]:
    """Return the candidates as calls without arguments, on one pair of arrays."""
    return {name: (lambda one=one: one.call(theta, out)) for name, one in candidates.items()}
