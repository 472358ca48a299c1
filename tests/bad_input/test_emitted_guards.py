"""Emitted sources where something goes wrong: compilers, constants, arrays and numbers not to take.

A source either computes what its head promises or says that it does not: by the compiler's #error, by a
self-test that fails, by an exception that names the argument.
"""

from __future__ import annotations

import math
import os
import pickle
import re
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from functools import cache
from importlib.resources import files
from pathlib import Path
from random import Random
from typing import Any

import numpy as np
import pytest

import symbalance as sb
from symbalance.cli import run as command
from symbalance.codegen import source_cache
from symbalance.codegen.evaluators import Evaluator

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


@pytest.mark.slow
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


@pytest.mark.slow
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


@pytest.mark.spread(2)
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


@pytest.mark.spread(2)
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


@pytest.mark.slow
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


@pytest.mark.slow
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


PERIODS = re.compile(r"^(PER_RADIAN\w*) = (\d[-.e\d]*)", re.MULTILINE)


@pytest.mark.slow
def test_a_self_test_sees_a_period_that_is_slightly_wrong() -> None:
    """By 5e-7 of itself: near 2^20 rad the count is off by one beside the middles between crests."""
    theta, harmful = np.random.default_rng(3).uniform(0.98 * 2**20, 2**20, 40_000), 0
    for engine, outputs in (("v8-90", "couple.vertical"), ("inline-1", OUTPUTS), ("inline-5", BOTH[0])):
        made = sb.to_function(sb.balance(sb.load(engine)), outputs=outputs.split(","))
        right = np.array(list(named(made(theta)).values()))
        for name, value in PERIODS.findall(made.source):
            for factor in (1 - 5e-7, 1 + 5e-7):
                text = made.source.replace(f"{name} = {value}", f"{name} = {float(value) * factor!r}")
                module: dict[str, Any] = {"__name__": "spoiled"}
                exec(text, module)
                wrong = np.array(list(named(module["evaluate"](theta)).values()))
                if np.abs(wrong - right).max() > 1e-14:
                    harmful += 1
                    with pytest.raises(AssertionError, match=" true "):
                        module["self_test"]()
    assert harmful > 8


def named(values: Any) -> dict[str, Any]:
    """Return one output's values as several outputs' are returned."""
    return values if isinstance(values, dict) else {"": values}


MISTAKES: dict[str, tuple[tuple[str, str], ...]] = {
    "numpy": (
        ("scales = (mass*radius*omega*omega*pitch,", "scales = (mass*radius*omega*pitch*pitch,"),
        ("range(0, theta.size, BLOCK)", "range(0, 1, BLOCK)"),
        ("range(0, theta.size, BLOCK)", "range(1, theta.size, BLOCK)"),
        ("range(0, size, BLOCK)", "range(0, 1, BLOCK)"),
        ("range(0, size, BLOCK)", "range(1, size, BLOCK)"),
        ("np.arange(start, stop,", "np.arange(stop - start,"),
        ("theta.dtype.itemsize == 4", "theta.dtype.itemsize == 3"),
    ),
    "array-api": (
        ("return (mass*radius*omega*omega*pitch,", "return (mass*radius*omega*pitch*pitch,"),
        ("_given([scale*value for scale, value in zip(scales, values)])", "_given(values)"),
    ),
    "c": (
        ("mass*radius*omega*omega*pitch", "mass*radius*omega*pitch*pitch"),
        ("start += BLOCK", "start += n"),
        ("theta + start", "theta"),
        ("if (near_double(size", "if (1 + near_double(size - 1"),
        ("< size) {", "< 1) {"),
        ("(float)value[0]", "(float)(1.0000003*value[0])"),
        ("i < size; i++", "i + 1 < size; i++"),
        ("out0[i] = value[0]", "out0[i + 1] = value[0]"),
    ),
    "javascript": (
        ("scale0 = mass*radius*omega*omega*pitch", "scale0 = mass*radius*omega*pitch*pitch"),
        ("fillGrid(period, points, mass,", "fillGrid(period, points, 1,"),
        ("instanceof Float32Array ? Float32Array", "instanceof Float32Array ? Float64Array"),
    ),
    "octave": (
        ("scale0 = mass*radius*omega*omega*pitch", "scale0 = mass*radius*omega*pitch*pitch"),
        (
            "numbers(mass, radius, omega, pitch);\n    count",
            "numbers(1, radius, omega, pitch);\n    count",
        ),
    ),
}
"""What a careless edit of an emitted source may do, of which every check with one angle knows nothing."""


@pytest.mark.slow
@pytest.mark.parametrize("target", MISTAKES)
def test_a_self_test_sees_keywords_blocks_and_single_precision(target: str, tmp_path: Path) -> None:
    path = emit(target, tmp_path / f"one{TARGETS[target]}", "inline-5", BOTH[0])
    text = path.read_text()
    assert run_self_test(target, path) == 0
    for right, wrong in MISTAKES[target]:
        assert right in text, right
        path.write_text(text.replace(right, wrong))
        assert run_self_test(target, path) != 0, (right, wrong)


@pytest.mark.slow
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


# Arguments ---------------------------------------------------------------------------------------------

THETA = np.linspace(-9.0, 9.0, 40_000)
BOTH = ("couple.vertical", "force.vertical")


@cache
def function(target: str, outputs: tuple[str, ...] = BOTH[:1]) -> Evaluator:
    """Return outputs of an in-line five."""
    return sb.to_function(sb.balance(sb.load("inline-5")), outputs=outputs, target=target)


@pytest.mark.slow
@pytest.mark.parametrize("target", ["numpy", "numba"])
@pytest.mark.parametrize("far", [0.0, 1e9], ids=["near", "far"])
@pytest.mark.parametrize("shift", [-20_000, -1, 0, 1, 20_000, 39_999])
def test_out_may_overlap_theta(target: str, far: float, shift: int) -> None:
    """A block with a far angle is read twice, and read after others are written."""
    start = max(0, -shift)
    room = np.empty(80_000)
    theta, out = room[start : start + 40_000], room[start + shift : start + shift + 40_000]
    theta[:] = THETA
    theta[5000] += far
    want = function(target)(theta.copy())
    assert function(target)(theta, out=out) is out
    assert (out == want).all()


@pytest.mark.slow
@pytest.mark.parametrize("target", ["numpy", "numba"])
def test_out_may_overlap_theta_in_any_order_and_type(target: str) -> None:
    room = np.arange(80_000.0)
    want = function(target)(room[::-2].copy())
    assert (function(target)(room[::-2], out=room[:40_000]) == want).all()
    whole = np.arange(40_000)
    want = function(target)(whole.copy())
    assert (function(target)(whole, out=whole.view(np.float64)) == want).all()
    both = {BOTH[0]: np.empty(40_000), BOTH[1]: THETA.copy()}
    right = function(target, BOTH)(THETA)
    values = function(target, BOTH)(both[BOTH[1]], out=both)
    assert all((values[name] == right[name]).all() for name in BOTH)


@pytest.mark.slow
@pytest.mark.parametrize("target", ["numpy", "numba"])
def test_outputs_that_share_memory_are_refused(target: str) -> None:
    room, other = np.zeros(9), np.zeros(5)
    for first, second in ((other, other), (room[:5], room[4:]), (room[2:7], room[:5])):
        with pytest.raises(ValueError, match="two outputs share memory"):
            function(target, BOTH)(np.ones(5), out={BOTH[0]: first, BOTH[1]: second})
    assert not room.any()
    function(target, BOTH)(np.ones(4), out={BOTH[0]: room[:4], BOTH[1]: room[4:8]})
    assert room[:8].all()


@pytest.mark.slow
@pytest.mark.parametrize("target", ["numpy", "numba"])
def test_an_out_that_does_not_fit_is_refused_before_anything_is_written(target: str) -> None:
    locked = np.zeros(4)
    locked.flags.writeable = False
    wrong = {
        "read-only": (locked, ValueError),
        "type": (np.zeros(4, np.float32), ValueError),
        "order of bytes": (np.zeros(4, ">f8"), ValueError),
        "steps": (np.zeros(8)[::2], ValueError),
        "shape": (np.zeros((4, 1)), ValueError),
        "mask": (np.ma.zeros(4), TypeError),
        "list": ([0.0] * 4, TypeError),
        "dict": ({BOTH[0]: np.zeros(4)}, TypeError),
    }
    for out, refusal in wrong.values():
        with pytest.raises(refusal, match="out "):
            function(target)(np.ones(4), out=out)
    first = np.zeros(4)
    for second in (locked, np.zeros(5)):
        with pytest.raises(ValueError, match="out must be"):
            function(target, BOTH)(np.ones(4), out={BOTH[0]: first, BOTH[1]: second})
    for names in (BOTH[:1], (*BOTH, "force.lateral")):
        with pytest.raises(ValueError, match="out must be a dict"):
            function(target, BOTH)(np.ones(4), out={name: np.zeros(4) for name in names})
    with pytest.raises(ValueError, match="out must be a dict"):
        function(target, BOTH)(np.ones(4), out=first)
    assert not first.any()
    matrix = np.zeros((2, 2)).view(np.matrix)
    assert function(target)(np.ones((2, 2)), out=matrix) is matrix
    assert (matrix == function(target)(1.0)).all()


MASKED = np.ma.array([0.5, 1e300], mask=[False, True])
NO_ANGLES: dict[str, object] = {
    "nothing": None,
    "nothing among angles": [1.0, None],
    "mask": MASKED,
    "masked": np.ma.masked,
    "masks in a list": [MASKED],
    "masked in a tuple": (1.0, np.ma.masked),
    "masked in lists": [[1.0, 2.0], [3.0, np.ma.masked]],
    "word": "1.5",
    "bytes": b"1.5",
    "words": ["1.5"],
    "complex": 1.5 + 0j,
    "complexes": np.array([1.5 + 2j]),
    "date": np.datetime64("2026-01-01"),
    "time": np.array([1500], "m8[ms]"),
    "record": np.zeros(2, [("theta", "f8")]),
    "huge": 2**70,
}


@pytest.mark.spread(2)
@pytest.mark.parametrize("target", ["numpy", "numba", "array-api"])
@pytest.mark.parametrize("theta", NO_ANGLES.values(), ids=NO_ANGLES.keys())
def test_what_is_no_angle_is_refused(target: str, theta: object) -> None:
    more = {"xp": np} if target == "array-api" else {}
    with pytest.raises(TypeError, match=r"theta (is a masked array|holds)"):
        function(target)(theta, **more)


@pytest.mark.slow
@pytest.mark.parametrize("target", ["numpy", "numba"])
@pytest.mark.parametrize("kind", [">f8", ">f4", "f2", "g", "i1", "u8", "?", "matrix"])
def test_real_numbers_of_every_type_are_angles(target: str, kind: str) -> None:
    theta = np.arange(4.0).view(np.matrix) if kind == "matrix" else np.arange(4).astype(kind)
    values = function(target)(theta)
    plain = np.asarray(theta, dtype=np.float64)
    assert type(values) is np.ndarray
    assert values.dtype == (np.float32 if kind == ">f4" else np.float64)
    assert values == pytest.approx(function(target)(plain), abs=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("target", ["numpy", "numba", "array-api"])
@pytest.mark.parametrize("keyword", ["mass", "radius", "omega", "pitch"])
def test_a_keyword_is_a_real_number(target: str, keyword: str) -> None:
    """Also where the output asked for does not take it: a force has no pitch."""
    f, theta = function(target, ("force.vertical",)), np.ones(3)
    grid = {"xp": np} if target == "array-api" else {}
    wrong = [None, "2", b"2", True, 2j, np.complex128(2), np.timedelta64(2, "s"), np.ma.masked, [2.0]]
    for value in wrong if target == "array-api" else [*wrong, np.ones(3), np.ones(1)]:
        for call_it in (lambda **k: f(theta, **k), lambda **k: f.on_grid(4, **grid, **k)):
            with pytest.raises(TypeError, match=f"{keyword} = .*must be"):
                call_it(**{keyword: value})
    want = f(theta, **{keyword: 2.0})
    for value in (2, np.float32(2), np.int8(2), np.array(2.0), Fraction(2)):
        assert (f(theta, **{keyword: value}) == want).all()
    assert np.isnan(f(theta, mass=math.nan)).all()
    for huge in (10**400, Fraction(10**5000, 3)):
        with pytest.raises(ValueError, match=f"{keyword} is beyond every double"):
            f(theta, **{keyword: huge})


@pytest.mark.slow
@pytest.mark.parametrize("target", ["numpy", "numba", "array-api"])
def test_a_grid_has_whole_numbers_of_points(target: str) -> None:
    f, more = function(target), {"xp": np} if target == "array-api" else {}
    for wrong in (7.5, "7", 0, -1, math.nan, math.inf, None, True, np.True_, [7], 7j):
        for points, turns, name in ((wrong, 1, "points"), (7, wrong, "turns")):
            with pytest.raises(ValueError, match=f"{name} = .*: must be a whole number, at least 1"):
                f.on_grid(points, turns, **more)
    assert (f.on_grid(7.0, **more) == f.on_grid(7, **more)).all()


def test_a_grid_of_the_array_module_takes_arrays_as_keywords_over_all_its_points() -> None:
    """They met the one period that is computed, and were repeated with it."""
    f = sb.to_function(sb.balance(sb.load("inline-4")), target="array-api")
    plain, masses = f.on_grid(4, 2, xp=np), np.arange(1.0, 9.0)
    assert np.array_equal(f.on_grid(4, 2, xp=np, mass=masses), masses * plain)
    column = masses[:3, None]
    assert np.array_equal(f.on_grid(4, 2, xp=np, mass=column), column * plain)
    with pytest.raises(ValueError, match="broadcast"):
        f.on_grid(4, 2, xp=np, mass=np.ones(2))


def test_javascript_refuses_what_is_no_number(tmp_path: Path) -> None:
    """null counted as 0, "1.5" as 1.5, undefined as NaN, and a keyword misspelled not at all."""
    emit("javascript", tmp_path / "one.mjs")
    (tmp_path / "ask.mjs").write_text("""
import { evaluate, onGrid } from "./one.mjs";
const wrong = [
  ...["1", null, undefined, true, [2], 1n].flatMap((x) => [[[1, x]], [[x]]]), [[1, , 2]],
  [new String("12")],
  ...["mass", "radius", "omega", "pitch"].flatMap((name) =>
    [null, "2", true, [2], 2n].map((x) => [1, { [name]: x }])),
  [1, { mas: 5 }], [1, { mass: 5, rpm: undefined }], [1, 5], [1, null], [1, "5"], [1, [5]],
];
for (const given of wrong) {
  let refused = false;
  try { evaluate(...given); } catch (problem) { refused = problem instanceof TypeError; }
  if (!refused) throw new Error(`taken: ${given}`);
}
let refused = false;
try { onGrid(7, 1, { mass: null }); } catch (problem) { refused = problem instanceof TypeError; }
try { onGrid(7, 1, { mas: 5 }); refused = false; } catch (problem) { refused &&= /mas:/.test(problem); }
const same = evaluate([1, NaN], { mass: undefined })["force.vertical"];
const one = evaluate(1)["force.vertical"];
if (!refused || same[0] !== one || !Number.isNaN(same[1])) throw new Error("no");
""")
    done = call(["node", "ask.mjs"], tmp_path)
    assert done.returncode == 0, done.stderr


def test_octave_takes_whole_number_types_as_numbers_and_refuses_the_rest(tmp_path: Path) -> None:
    """int32(2) as the mass rounded every force to a whole number; 'a' was its code, 97."""
    emit("octave", tmp_path / "one.m", outputs="force.vertical")
    (tmp_path / "ask.m").write_text("""1;
function check(given)
    taken = true;
    try, one(given{:}); catch problem, taken = isempty(strfind(problem.message, 'one real')); end
    assert(~taken);
end
theta = [0.1 0.2; 0.3 -4];
assert(isequal(one(theta, int32(2), int8(3)), one(theta, 2, 3)));
assert(isequal(class(one(theta, single(2))), 'double'));
assert(isequal(one('grid', int8(7), 2, uint8(2)), one('grid', 7, 2, 2)));
wrong = {'2', [], [1 2], 2i, true, {2}};
for i = 1:numel(wrong)
    for place = 1:4
        given = {1, 1, 1, 1};
        given{place} = wrong{i};
        for call = {{0.5, given{:}}, {'grid', 7, 1, given{:}}}
            check(call{1});
        end
    end
    for given = {{wrong{i}}, {7, wrong{i}}}
        check({'grid', given{1}{:}});
    end
end
""")
    done = call(["octave-cli", "--quiet", "--no-init-file", "ask.m"], tmp_path)
    assert done.returncode == 0, done.stderr


# Compiled code, kept for other processes ---------------------------------------------------------------

USE = """
import os, sys, importlib.util
if "MOST_BYTES" in os.environ:
    import resource
    resource.setrlimit(resource.RLIMIT_FSIZE, (int(os.environ["MOST_BYTES"]),) * 2)
how, path = sys.argv[1:]
if how == "memory":
    import symbalance as sb
    result = sb.balance(sb.load("v8-90"), 4, ratio=path)
    module = sb.to_function(result, outputs="couple.vertical", target="numba")._module
elif how == "run":
    import runpy
    module = runpy.run_path(path)
else:
    spec = importlib.util.spec_from_file_location(how, path)
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    module = vars(loaded)
value = module["evaluate"]([0.5])
grid = module["on_grid"](5)
loops = [module[name].stats for name in ("_fill", "_fill_grid")]
print(float(value[0]).hex(), float(grid[2]).hex(), *(sum(s.cache_hits.values()) for s in loops))
"""


def use(how: str, path: object, folder: Path, **environment: str) -> list[str]:
    """Return a value, one on a grid, and how many loops were found compiled, in a process of its own."""
    (folder / "use.py").write_text(USE)
    plain = {k: v for k, v in os.environ.items() if k not in ("NUMBA_CACHE_DIR", "XDG_CACHE_HOME")}
    line = [sys.executable, "use.py", how, str(path)]
    here = str(Path(sb.__file__).parents[1])
    known = {**plain, "HOME": str(folder), "PYTHONPATH": here, **environment}
    done = subprocess.run(
        line, cwd=folder, env=known, capture_output=True, text=True, timeout=300, check=False
    )
    assert (done.returncode, done.stderr) == (0, ""), done.stderr
    return done.stdout.split()


def numba_module(path: Path, ratio: str = "4") -> Path:
    """Write a small Numba module."""
    outputs = ["--outputs", "couple.vertical", "--order", "4", "--ratio", ratio]
    options = ["emit", "v8-90", "--target", "numba", "--uniform-grid", *outputs, "-o", str(path)]
    assert command(options) == 0
    return path


def right(ratio: str = "4") -> list[str]:
    """Return what NumPy's target gives, to 1e-14: Numba fuses multiplications and additions."""
    result = sb.balance(sb.load("v8-90"), 4, ratio=ratio)
    f = sb.to_function(result, outputs="couple.vertical")
    return [float(f([0.5])[0]).hex(), float(f.on_grid(5)[2]).hex()]


def agree(values: list[str], ratio: str = "4") -> bool:
    """Tell whether both values are the right ones."""
    pairs = zip(values[:2], right(ratio), strict=True)
    return all(float.fromhex(a) == pytest.approx(float.fromhex(b), rel=1e-13) for a, b in pairs)


@pytest.mark.slow
def test_a_module_is_compiled_once_whatever_it_is_called(tmp_path: Path) -> None:
    """Nor where nothing can import it by the name that it had when it was compiled."""
    (tmp_path / "own").mkdir()
    path = numba_module(tmp_path / "own" / "eight.py")
    first = use("eight", path, tmp_path)
    assert agree(first)
    assert first[2:] == ["0", "0"]
    assert use("run", path, tmp_path) == [*first[:2], "1", "1"]
    assert list((tmp_path / "own" / "__pycache__").glob("*.nbi"))


@pytest.mark.slow
def test_code_of_another_text_is_never_believed(tmp_path: Path) -> None:
    """The same name, size and time, as an installer may leave them: older Numbas know no more.

    Nor does Python of its own bytecode, which is therefore not written here.
    """
    plain = {"PYTHONDONTWRITEBYTECODE": "1"}
    path = numba_module(tmp_path / "eight.py", "3.5")
    at = path.stat()
    assert agree(use("eight", path, tmp_path, **plain), "3.5")
    numba_module(path, "4.5")
    os.utime(path, ns=(at.st_atime_ns, at.st_mtime_ns))
    assert path.stat().st_size == at.st_size
    second = use("eight", path, tmp_path, **plain)
    assert agree(second, "4.5")
    assert second[2:] == ["0", "0"]
    names = {file.name.partition("-")[0] for file in (tmp_path / "__pycache__").glob("*.nbi")}
    assert len(names) == 4


@pytest.mark.slow
@pytest.mark.parametrize("how", ["eight", "memory"])
def test_where_no_folder_can_be_written_it_compiles_each_time(how: str, tmp_path: Path) -> None:
    """A file in a folder's place stops any user, root too."""
    (tmp_path / "own").mkdir()
    path = numba_module(tmp_path / "own" / "eight.py")
    for blocked in ("own/__pycache__", "home"):
        (tmp_path / blocked).write_text("")
    environment = {"HOME": str(tmp_path / "home"), "XDG_CACHE_HOME": str(tmp_path / "home" / "x")}
    values = use(how, 4 if how == "memory" else path, tmp_path, **environment)
    assert agree(values)
    assert values[2:] == ["0", "0"]


@pytest.mark.slow
def test_a_function_in_memory_is_compiled_once(tmp_path: Path) -> None:
    first, again = (use("memory", "3.5", tmp_path) for _ in range(2))
    assert agree(first, "3.5")
    assert first[2:] == ["0", "0"]
    assert again == [*first[:2], "1", "1"]
    (kept,) = (tmp_path / ".cache" / "symbalance").glob("*.py")
    kept.write_text(kept.read_text().replace("couple", "COUPLE"))
    assert agree(use("memory", "3.5", tmp_path), "3.5")
    assert "COUPLE.vertical" not in kept.read_text()


DAMAGE: dict[str, tuple[str, Callable[[bytes], bytes]]] = {
    "index cut short": (".nbi", lambda data: data[:200]),
    "random index": (".nbi", lambda data: Random(1).randbytes(len(data))),
    "empty code": (".nbc", lambda data: b""),
    "other code": (".nbc", lambda data: pickle.dumps(["no", "code"])),
}


@pytest.mark.slow
@pytest.mark.parametrize("damage", DAMAGE)
def test_damaged_code_is_compiled_again_and_replaced(damage: str, tmp_path: Path) -> None:
    """Numba reads it at the first call, and raises what unpickling raises."""
    path = numba_module(tmp_path / "eight.py")
    first = use("eight", path, tmp_path)
    ending, spoiled = DAMAGE[damage]
    for file in (tmp_path / "__pycache__").glob(f"*{ending}"):
        file.write_bytes(spoiled(file.read_bytes()))
    assert use("eight", path, tmp_path) == [*first[:2], "0", "0"]
    assert use("eight", path, tmp_path) == [*first[:2], "1", "1"]


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "getuid"), reason="a limit on the size of files is POSIX's")
@pytest.mark.parametrize(("how", "most"), [("eight", 0), ("memory", 20_000)])
def test_a_disk_that_takes_no_code_costs_no_value(how: str, most: int, tmp_path: Path) -> None:
    """20 kB take the text and the index, not the code."""
    path = 4 if how == "memory" else numba_module(tmp_path / "eight.py")
    first = use(how, path, tmp_path, MOST_BYTES=str(most))
    assert agree(first)
    assert first[2:] == ["0", "0"]
    kept = {file.suffix for file in tmp_path.rglob("*.nb?")}
    assert kept == ({".nbi"} if most else set())
    assert use(how, path, tmp_path) == first
    assert use(how, path, tmp_path) == [*first[:2], "1", "1"]


@pytest.mark.slow
def test_processes_at_once_do_not_disturb_one_another(tmp_path: Path) -> None:
    with ThreadPoolExecutor(2) as pool:
        found = list(pool.map(lambda _: use("memory", "3.5", tmp_path), range(2)))
    assert all(agree(values, "3.5") for values in found)
    assert use("memory", "3.5", tmp_path)[2:] == ["1", "1"]
    assert len(list((tmp_path / ".cache" / "symbalance").iterdir())) == 2  # the text, and __pycache__


@pytest.mark.slow
def test_the_oldest_sources_are_forgotten(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    for i in range(source_cache.MOST_SOURCES + 3):
        path = source_cache.source_file(f"x = {i}\n")
        assert path is not None
        os.utime(path, (i, i))
        for folder in ("symbalance/__pycache__", "symbalance_0123"):
            (tmp_path / folder).mkdir(exist_ok=True)
            (tmp_path / folder / f"{path.stem}._fill.nbi").write_text("")
    left = sorted((tmp_path / "symbalance").glob("*.py"), key=lambda path: path.stat().st_mtime)
    assert [path.read_text() for path in left] == [
        f"x = {i}\n" for i in range(3, source_cache.MOST_SOURCES + 3)
    ]
    for folder in ("symbalance/__pycache__", "symbalance_0123"):
        assert {p.name.partition(".")[0] for p in (tmp_path / folder).iterdir()} == {p.stem for p in left}


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="Windows keeps permissions elsewhere")
def test_a_folder_that_others_can_write_is_not_used(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What is kept there is loaded as code."""
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    (tmp_path / "symbalance").mkdir()
    (tmp_path / "symbalance").chmod(0o777)
    assert source_cache.source_file("x = 1\n") is None
    (tmp_path / "symbalance").chmod(0o755)
    assert source_cache.source_file("x = 1\n") is not None


def test_the_types_travel_with_the_package() -> None:
    assert files("symbalance").joinpath("py.typed").is_file()
