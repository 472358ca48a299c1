"""Emitted sources where something goes wrong: compilers, constants, arrays and numbers not to take.

A source either computes what its head promises or says that it does not: by the compiler's #error, by a
self-test that fails, by an exception that names the argument.
"""

from __future__ import annotations

import shutil
import signal
import subprocess
from functools import cache
from pathlib import Path

import pytest

from symbalance.cli import run as command

OUTPUTS = "force.vertical,piston.displacement,piston.velocity"
GCC = shutil.which("gcc")


def emit(target: str, path: Path, engine: str = "inline-1", outputs: str = OUTPUTS) -> Path:
    """Write an engine's outputs with their grid to a file, and return its path."""
    options = ["--target", target, "--outputs", outputs, "--uniform-grid", "-o", str(path)]
    assert command(["emit", engine, *options]) == 0
    return path


def call(line: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    """Run a program in a folder."""
    return subprocess.run(line, cwd=folder, capture_output=True, text=True, timeout=300, check=False)


# C: what the compiler is told --------------------------------------------------------------------------

MACHINES = ("x86-64", "haswell", "skylake-avx512", "sapphirerapids", "native")
STANDARDS = ("c99", "gnu99", "c11", "gnu17", "c2x", "gnu2x")
WARNINGS = ("-Wall", "-Wextra", "-Werror")


@cache
def is_known(*options: str) -> bool:
    """Tell whether this machine's gcc takes options."""
    if GCC is None:
        return False
    line = [GCC, *options, "-E", "-x", "c", "-"]
    return not subprocess.run(line, input=b"", capture_output=True, check=False).returncode


@pytest.fixture(scope="module")
def source(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a C source with forces, pistons and grid."""
    if GCC is None:
        pytest.skip("gcc is not installed")
    return emit("c", tmp_path_factory.mktemp("c") / "one.c")


@pytest.mark.parametrize("standard", STANDARDS)
@pytest.mark.parametrize("machine", MACHINES)
def test_c_compiles_for_every_machine_and_standard(source: Path, machine: str, standard: str) -> None:
    """The command that the source documents; where AVX512-FP16 is, FLT_EVAL_METHOD is 16 with gnu99."""
    options = [f"-march={machine}", f"-std={standard}"]
    if not is_known(*options):
        pytest.skip(f"gcc does not know {options}")
    flags = [*WARNINGS, *options, "-O2", "-fno-math-errno"]
    done = call(["gcc", *flags, "-c", source.name, "-o", f"{machine}-{standard}.o"], source.parent)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("machine", MACHINES)
def test_c_tests_itself_on_the_machines_that_this_one_is(source: Path, machine: str) -> None:
    """A processor that lacks the instructions ends the program by a signal, never with a wrong value."""
    if not is_known(f"-march={machine}"):
        pytest.skip(f"gcc does not know -march={machine}")
    flags = ["-std=gnu99", "-O3", f"-march={machine}", "-fno-math-errno", "-DONE_SELF_TEST"]
    built = call(["gcc", *WARNINGS, *flags, source.name, "-lm", "-o", machine], source.parent)
    assert built.returncode == 0, built.stderr
    done = call([f"./{machine}"], source.parent)
    lacking = machine not in ("x86-64", "native") and done.returncode == -signal.SIGILL
    assert done.returncode == 0 or lacking, done.stdout


@pytest.mark.parametrize(
    "options",
    [
        "-ffast-math",
        "-Ofast",
        "-funsafe-math-optimizations",
        "-fassociative-math -fno-signed-zeros -fno-trapping-math",
        "-ffinite-math-only",
        "-fsingle-precision-constant",
        "-mfpmath=387",
        "-mfpmath=387 -march=sapphirerapids",
        "-mfpmath=sse+387",
    ],
)
def test_c_refuses_arithmetic_that_would_be_wrong(source: Path, options: str) -> None:
    if not is_known(*options.split()):
        pytest.skip(f"gcc does not know {options}")
    for standard in ("c99", "gnu99"):
        flags = [f"-std={standard}", "-O2", *options.split()]
        done = call(["gcc", *flags, "-c", source.name, "-o", "refused.o"], source.parent)
        assert done.returncode != 0
        assert "#error" in done.stderr or "constants_are_doubles" in done.stderr


@pytest.mark.parametrize("method", [-1, 0, 1, 2, 16, 32, 33, 64, 65, 128])
def test_c_takes_the_evaluation_methods_that_leave_doubles_alone(source: Path, method: int) -> None:
    """C23, 5.2.5.3.3: widened are types no wider than float (1: to double), _Float16, 32 or 64."""
    flags = ["-std=c99", "-U__FLT_EVAL_METHOD__", f"-D__FLT_EVAL_METHOD__={method}"]
    done = call(["gcc", *flags, "-fsyntax-only", source.name], source.parent)
    assert (done.returncode == 0) == (method in (0, 1, 16, 32, 64)), done.stderr
