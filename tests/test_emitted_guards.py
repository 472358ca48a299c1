"""Emitted sources where something goes wrong: compilers, constants, arrays and numbers not to take.

A source either computes what its head promises or says that it does not: by the compiler's #error, by a
self-test that fails, by an exception that names the argument.
"""

from __future__ import annotations

import re
import shutil
import signal
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import symbalance as sb
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


# Self-tests: what they catch ---------------------------------------------------------------------------

PYTHON = dict.fromkeys(("numpy", "numba", "array-api"), ".py")
TARGETS = {**PYTHON, "c": ".c", "javascript": ".mjs", "octave": ".m"}
CHECKS = {
    "checks": ("Angles, the true values", "0.1,"),
    "grid checks": ("The same at theta", "0.8975979010256552,"),
}
"""Comments above rows of true values, and the angle of a row."""
NUMBER = re.compile(r"-?\d+\.\d+(?:e[-+]?\d+)?")
CONSTANT = re.compile(r"^([A-Z]\w*) = (-?\d\S*)$|^([A-Z]\w*) = (-?\d\S*)  #", re.MULTILINE)


def spoil(text: str, what: str) -> str:
    """Return a source with one constant, or one true value of its checks, changed."""
    if what not in CHECKS:
        found = re.search(rf"\b{what} = ({NUMBER.pattern})", text)
        assert found
        return text[: found.start(1)] + repr(float(found[1]) * 1.001) + text[found.end(1) :]
    head, angle = CHECKS[what]
    start = text.index(angle, text.index(head)) + len(angle)
    value = NUMBER.search(text, start)
    assert value
    return text[: value.start()] + repr(float(value[0]) + 0.01) + text[value.end() :]


def run_self_test(target: str, path: Path) -> int:
    """Return the exit status of a source's own test, as optimised as its language knows."""
    lines = {
        "c": [
            ["gcc", "-std=gnu99", "-O3", "-DNDEBUG", "-DONE_SELF_TEST", path.name, "-lm", "-o", "one"],
            ["./one"],
        ],
        "javascript": [["node", path.name]],
        "octave": [["octave-cli", "--quiet", "--no-init-file", "--eval", "one('self-test')"]],
    }
    optimised = [[sys.executable, "-OO", "-B", path.name]]
    *build, run = lines.get(target, optimised)
    for line in build:
        done = call(line, path.parent)
        assert done.returncode == 0, done.stderr
    return call(run, path.parent).returncode


@pytest.mark.parametrize("target", TARGETS)
def test_a_self_test_fails_where_a_constant_or_a_true_value_is_spoiled(
    target: str, tmp_path: Path
) -> None:
    """S7 is every cosine's, PI the grid's alone; python -OO drops each `assert`."""
    path = emit(target, tmp_path / f"one{TARGETS[target]}")
    text = path.read_text()
    assert run_self_test(target, path) == 0
    for what in ("S7", "PI", *CHECKS) if target != "numba" else ("PI",):  # which compiles each time
        path.write_text(spoil(text, what))
        assert run_self_test(target, path) != 0, what


@pytest.mark.parametrize("target", ["numpy", "array-api"])
@pytest.mark.parametrize(
    ("engine", "outputs"),
    [
        ("inline-1", OUTPUTS),
        ("inline-5", "couple.vertical,force.vertical"),
        ("radial-7", "force.lateral"),
    ],
)
def test_a_self_test_sees_every_constant_that_matters(target: str, engine: str, outputs: str) -> None:
    """Each in turn a quarter larger: either the test fails, or no angle of a thousand shows it."""
    result = sb.balance(sb.load(engine))
    made = sb.to_function(result, outputs=outputs.split(","), target=target, tolerance=0)
    theta = np.concatenate([np.linspace(-7, 7, 701), np.random.default_rng(5).uniform(-1e6, 1e6, 400)])
    constants = [(a or c, b or d) for a, b, c, d in CONSTANT.findall(made.source)]
    assert len(constants) > 20
    for name, value in constants:
        text = made.source.replace(f"\n{name} = {value}", f"\n{name} = {float(value) * 1.25!r}")
        if name == "BLOCK" or text == made.source:
            continue
        module: dict[str, Any] = {"__name__": "spoiled"}
        exec(text, module)
        try:
            with np.errstate(all="ignore"):  # a spoiled reduction overflows
                module["self_test"]()
        except AssertionError:
            continue
        values, right = module["evaluate"](theta), made(theta)
        for output in made.outputs:
            gap = values[output] - right[output] if len(made.outputs) > 1 else values - right
            allowed = 2.0**-53 * made.rounding[output] * made.amplitude[output]
            assert np.abs(gap).max() <= 2.5 * allowed, name


def test_javascript_tests_itself_through_a_link_and_without_its_ending(tmp_path: Path) -> None:
    """A module that does not see that it was started says nothing, and ends as if all were well."""
    (tmp_path / "own").mkdir()
    (tmp_path / "own" / "package.json").write_text('{"type": "module"}')
    path = emit("javascript", tmp_path / "own" / "one.js")
    (tmp_path / "linked").symlink_to(tmp_path / "own", target_is_directory=True)
    (tmp_path / "other.mjs").symlink_to(path)
    names = ("own/one.js", "own/one", "linked/one.js", "other.mjs")
    for name in names:
        assert "self-test passed" in call(["node", name], tmp_path).stdout, name
    path.write_text(spoil(path.read_text(), "S7"))
    for name in names:
        assert call(["node", name], tmp_path).returncode != 0, name
    ask = 'import { evaluate } from "./own/one.js"; console.log(typeof evaluate);'
    (tmp_path / "ask.mjs").write_text(ask)
    assert call(["node", "ask.mjs"], tmp_path).stdout == "function\n"
