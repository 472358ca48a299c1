"""Ours, ready to be timed: the NumPy and the Numba target in memory, the C target through `cc`."""

from __future__ import annotations

import ctypes
import re
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from symbalance.bench.evaluating.cases import Case
from symbalance.codegen.plans import Plan
from symbalance.codegen.targets import files

Floats = NDArray[np.float64]
Call = Callable[[Floats, Floats], Floats]
Key = TypeVar("Key", bound=Hashable)
NUMPY, NUMBA, C = "numpy", "numba", "c"
TARGETS = (NUMPY, NUMBA, C)
COMPILED = (NUMBA, C)
FUNCTION = "evaluated"
FEW = np.linspace(-7.0, 7.0, 64)
FLAGS = re.compile(r"cc (-std=.*?) -c ")


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
        self(FEW)
        return self


@dataclass(frozen=True)
class Standing:
    """Which targets can run here, and for those that cannot, why, in one line each."""

    targets: tuple[str, ...]
    notes: tuple[str, ...]


def standing() -> Standing:
    """Return which of our targets this machine can run."""
    lacking: dict[str, str] = {}
    if find_spec("numba") is None:
        lacking[NUMBA] = "numba: not installed (pip install numba)"
    if compiler() is None:
        lacking[C] = "c: no C compiler found under the name cc"
    return Standing(tuple(t for t in TARGETS if t not in lacking), tuple(lacking.values()))


def compiler() -> str | None:
    """Return the path of `cc`."""
    return shutil.which("cc")


def ours(case: Case, target: str) -> Candidate:
    """Return our function for a case on a target, compiled."""
    if target == C:
        return from_plan(case.planned(C), C)
    return _filling(target, case.evaluator(target))


def from_plan(planned: Plan, target: str) -> Candidate:
    """Return a plan's one output on a target, compiled."""
    texts = files(planned, target, FUNCTION, FUNCTION, grid=False)
    if target == C:
        return Candidate(C, compiled(texts[".c"], texts[".h"])).warmed()
    return from_module(target, texts[".py"])


@cache
def from_module(target: str, source: str) -> Candidate:
    """Return the function that a generated Python module defines, compiled."""
    namespace: dict[str, Any] = {"__name__": FUNCTION}
    exec(compile(source, f"<{FUNCTION}>", "exec"), namespace)  # text of our own
    return _filling(target, namespace["evaluate"])


def _filling(target: str, function: Callable[..., Floats]) -> Candidate:
    return Candidate(target, lambda theta, out: function(theta, out=out)).warmed()


@cache
def compiled(source: str, header: str) -> Call:
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
