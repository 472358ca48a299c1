"""Every target language, run, and the truth by the slider-crank of `kinematics` in 40 digits.

Each target evaluates every case at angles to 1e6 rad, at far ones to 1e15, at some that are not finite,
at float32 angles, and on a grid; C, JavaScript and Octave each in one process, which reads the angles
from a file and writes what it found to one, as doubles. The truth is all orders of the exact motion, or
the sum of its harmonics by quadrature where the case is truncated. Every keyword is a power of two, so
that scaling rounds nothing and a keyword that went to the wrong place shows.
"""

from __future__ import annotations

import pickle
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from importlib import import_module
from math import tau
from pathlib import Path
from random import Random
from typing import Any

import numpy as np
from mpmath import mp

from symbalance.cli import run as command
from symbalance.codegen import plan_for, to_function
from symbalance.codegen.plans import Plan
from symbalance.engine.catalogue import load
from symbalance.forces.free_forces import balance
from tests import kinematics

U, U32 = 2.0**-53, 2.0**-24
KEYWORDS = {"mass": 2.0, "radius": 4.0, "omega": 8.0, "pitch": 16.0}
UNITS = {
    "force": 2 * 4 * 8**2,
    "couple": 2 * 4 * 8**2 * 16,
    "piston.displacement": 4,
    "piston.velocity": 4 * 8,
    "piston.acceleration": 4 * 8**2,
}
POINTS, TURNS = 36, 2
DIGITS = 40


@dataclass(frozen=True)
class Case:
    """Outputs of an engine: all orders unless `order` or `tolerance` says otherwise."""

    name: str
    engine: str
    outputs: tuple[str, ...]
    order: int | None = None
    tolerance: float = 0.0
    ratio: str = "4"

    def asked(self, target: str) -> Any:
        """Return what `plan_for` and `to_function` are asked for."""
        result = balance(load(self.engine), self.order or 1, ratio=self.ratio)
        return result, None, self.outputs, target

    def options(self, target: str) -> list[str]:
        """Return what the command line is asked for."""
        if self.order:
            orders = ["--order", str(self.order)]
        else:
            orders = ["--tolerance", str(self.tolerance)] if self.tolerance else []
        outputs = ["--outputs", ",".join(self.outputs), "--ratio", self.ratio]
        return ["emit", self.engine, "--target", target, "--uniform-grid", *orders, *outputs]

    def planned(self, target: str) -> Plan:
        """Return the plan of the outputs on a target."""
        return plan_for(*self.asked(target), None if self.order else self.tolerance)

    def function(self, target: str) -> Any:
        """Return the outputs as a function, which has been pickled and unpickled."""
        f = to_function(*self.asked(target), tolerance=None if self.order else self.tolerance)
        return pickle.loads(pickle.dumps(f))


CASES = (
    Case("v12", "v12-60", ("force.vertical", "force.lateral")),
    Case("i5", "inline-5", ("couple.vertical", "force.vertical")),
    Case("v8", "v8-90", ("couple.lateral", "couple.vertical"), order=4),
    Case(
        "i1",
        "inline-1",
        ("force.vertical", "piston.displacement", "piston.velocity", "piston.acceleration"),
    ),
    Case("v2", "v2-45", ("force.lateral",), tolerance=1e-3),
    Case("near_1", "inline-1", ("force.vertical",), ratio="1.3"),
    Case("nearer_1", "inline-3", ("couple.vertical",), ratio="1.1"),
)
BY_NAME = {case.name: case for case in CASES}
SOME = ("v12", "i5", "i1", "near_1")
SLOW = {"numba": ("v12", "i1"), "jax": SOME, "jax without float64": SOME}
"""What compiles for seconds has these cases alone."""


# The angles and the truth ---------------------------------------------------------------------------


def _near() -> list[float]:
    random = Random(7)
    spread = [random.uniform(-1e6, 1e6) for _ in range(900)]
    small = [random.uniform(-tau, tau) for _ in range(500)]
    sizes = [random.choice((-1, 1)) * 10 ** random.uniform(-8, 6) for _ in range(300)]
    zeros = [tau * k / 24 for k in (*range(-100, 100), *(random.randrange(10**6) for _ in range(100)))]
    return [0.0, *spread, *small, *sizes, *zeros]


NEAR = _near()
FAR = [
    sign * size for sign in (-1.0, 1.0) for size in (1048577.0, 3e7 / 7, 1e9, 1e11 / 3, 1e13, 1e15 / 7)
]
FAR += [10 ** Random(k).uniform(9, 15) for k in range(40)]
LOST = [float("inf"), float("-inf"), float("nan")]
DOUBLE = np.array([*NEAR[:1000], *LOST, *NEAR[1000:], *FAR])
SINGLE = np.array(NEAR[::2], dtype=np.float32)
FINITE = np.isfinite(DOUBLE)
IS_FAR = FINITE & (np.abs(DOUBLE) > 2.0**20)


@cache
def motion(case: Case, output: str) -> Callable[[mp.mpf], mp.mpf]:
    """Return the exact function, or the sum of its harmonics the case asks for, by quadrature."""
    layout, lam, (kind, part) = load(case.engine), Fraction(case.ratio), output.split(".")
    if kind == "piston":
        first = layout.cylinders[0]
        lead = kinematics.radians(first.throw.in_degrees() - first.bank.in_degrees())
        function = getattr(kinematics, part)
        return lambda theta: function(theta + lead, kinematics.number(lam))
    cylinders = ((c.throw.in_degrees(), c.bank.in_degrees(), c.station) for c in layout.cylinders)
    vector = kinematics.planar([kinematics.Place(*place) for place in cylinders], lam, kind == "couple")
    onto = (lambda z: z.real) if part == "vertical" else (lambda z: z.imag)
    if not (case.order or case.tolerance):
        return lambda theta: onto(vector(theta))
    highest = case.order or max(
        int(t.order) for o in case.planned("numpy").outputs for t in o.harmonic_sum.terms
    )
    points = kinematics.points_for(lam, highest)
    orders = range(1, highest + 1)
    found = kinematics.harmonics(lambda theta: onto(vector(theta)), orders, points)
    return lambda theta: mp.fsum(
        found[n][0].real * mp.cos(n * theta) + found[n][1].real * mp.sin(n * theta) for n in orders
    )


@cache
def truth(case: Case, output: str, where: str) -> np.ndarray:
    """Return the true values in units, in two doubles each; NaN where an angle is not finite."""
    with mp.workdps(DIGITS):
        grid = [2 * mp.pi * (j % POINTS) / POINTS for j in range(POINTS * TURNS)]
        angles = {"double": DOUBLE.tolist(), "single": SINGLE.tolist(), "grid": grid}[where]
        unit = UNITS.get(output) or UNITS[output.partition(".")[0]]
        function, rows = motion(case, output), []
        for theta in angles:
            value = unit * function(mp.mpf(theta)) if mp.isfinite(theta) else mp.nan
            rows.append((float(value), float(value - float(value)) if mp.isfinite(value) else 0.0))
        return np.array(rows).T


def errors(case: Case, output: str, where: str, found: np.ndarray) -> np.ndarray:
    """Return how far values are off, as fractions of the amplitude over all angles."""
    high, low = truth(case, output, where)
    largest = np.nanmax(np.abs(truth(case, output, "double")[0]))
    assert found.shape == high.shape
    if largest < 1e-20:  # the cylinders' forces cancel altogether: nothing but 0 is right
        return np.abs(found) * 1e300
    return np.abs((found - high) - low) / largest


# The targets, run -----------------------------------------------------------------------------------

Found = dict[tuple[str, str, str], np.ndarray]
"""Values by case, output and where: double, single or grid."""


def in_python(target: str) -> Found:
    """Return what a target of `to_function` makes of NumPy's arrays, after a journey through pickle."""
    found: Found = {}
    for case in CASES:
        if case.name in SLOW.get(target, BY_NAME):
            f = case.function(target)
            more = {"xp": np} if target == "array-api" else {}
            found |= _named(case, "double", f(DOUBLE, **KEYWORDS), "float64")
            found |= _named(case, "single", f(SINGLE, **KEYWORDS), "float32")
            found |= _named(case, "grid", f.on_grid(POINTS, TURNS, **more, **KEYWORDS), "float64")
    return found


def in_library(name: str, double: bool = True, compiled: Callable[..., Any] = lambda f: f) -> Found:
    """Return what the array-api target makes of another library's arrays."""
    xp, found = import_module(name), {}
    for case in (BY_NAME[known] for known in SLOW.get(name.partition(".")[0], BY_NAME)):
        f = case.function("array-api")
        call, own = compiled(f), xp.float64 if double else xp.float32
        kinds = {"double": (DOUBLE, xp.float64), "single": (SINGLE, xp.float32)}
        for where, (angles, kind) in kinds.items():
            if double or where == "single":
                values = call(xp.asarray(angles.tolist(), dtype=kind), **KEYWORDS)
                found |= _named(case, where, values, "float64" if where == "double" else "float32")
        values = f.on_grid(POINTS, TURNS, xp=xp, dtype=own, **KEYWORDS)
        found |= _named(case, "grid", values, "float64" if double else "float32")
    return found


def in_jax(double: bool) -> Found:
    """Return what jax.jit makes of the array-api target, with or without its float64."""
    jax = import_module("jax")
    before = jax.config.jax_enable_x64
    jax.config.update("jax_enable_x64", double)
    try:
        return in_library("jax.numpy", double, jax.jit)
    finally:
        jax.config.update("jax_enable_x64", before)


def _named(case: Case, where: str, values: Any, kind: str) -> Found:
    named = values if isinstance(values, dict) else {case.outputs[0]: values}
    assert set(named) == set(case.outputs)  # jax.jit sorts them
    assert all(str(v.dtype).endswith(kind) for v in named.values())
    return {(case.name, n, where): np.array([float(x) for x in v]) for n, v in named.items()}


C_CALLS = """
    {{
        double *d = room(n, {count}), *g = room(points * turns, {count});
        float *s = room(m, {count});
        {name}(n, doubles, 2, 4, 8, 16, {doubles});
        {name}_float(m, singles, 2, 4, 8, 16, {singles});
        {name}_on_grid(points, turns, 2, 4, 8, 16, {grids});
        fwrite(d, sizeof *d, n * {count}, out);
        for (size_t i = 0; i < m * {count}; i++) {{
            const double value = s[i];
            fwrite(&value, sizeof value, 1, out);
        }}
        fwrite(g, sizeof *g, points * turns * {count}, out);
    }}
"""
C_MAIN = """#include <stdio.h>
#include <stdlib.h>
{includes}
static void *room(size_t n, size_t count) {{ return malloc(n * count * sizeof(double)); }}

int main(void) {{
    const size_t n = {n}, m = {m}, points = {points}, turns = {turns};
    double *doubles = room(n, 1);
    float *singles = room(m, 1);
    FILE *in = fopen("doubles", "rb"), *more = fopen("singles", "rb"), *out = fopen("found", "wb");
    if (fread(doubles, sizeof *doubles, n, in) + fread(singles, sizeof *singles, m, more) != n + m) {{
        return 1;
    }}
{calls}
    return fclose(out);
}}
"""
JAVASCRIPT = """
import {{ readFileSync, writeFileSync }} from "node:fs";
const read = (name, Kind) => new Kind(new Uint8Array(readFileSync(name)).buffer);
const doubles = read("doubles", Float64Array), singles = read("singles", Float32Array);
const engine = {{ pitch: 16, omega: 8, radius: 4, mass: 2 }};
const found = [];
for (const name of {names}) {{
  const {{ OUTPUTS, evaluate, onGrid }} = await import(`./${{name}}.mjs`);
  for (const values of [
    evaluate(doubles, engine), evaluate(singles, engine), onGrid({points}, {turns}, engine),
  ]) {{
    for (const output of OUTPUTS) {{
      const kind = OUTPUTS.length === 1 ? values : values[output];
      if (kind.length === singles.length && !(kind instanceof Float32Array)) throw new Error(output);
      found.push(...kind);
    }}
  }}
}}
writeFileSync("found", new Uint8Array(new Float64Array(found).buffer));
"""
OCTAVE = """1;
function show(out, values, kind)
    if isstruct(values), values = struct2cell(values); else, values = {{values}}; end
    for i = 1:numel(values)
        if ~isa(values{{i}}, kind), error('%s, not %s', class(values{{i}}), kind); end
        fwrite(out, double(values{{i}}), 'double');
    end
end
in = fopen('doubles'); doubles = fread(in, Inf, 'double'); fclose(in);
in = fopen('singles'); singles = single(fread(in, Inf, 'single')); fclose(in);
out = fopen('found', 'w');
names = {names};
for i = 1:numel(names)
    show(out, feval(names{{i}}, reshape(doubles, 1, []), 2, 4, 8, 16), 'double');
    show(out, feval(names{{i}}, singles, 2, 4, 8, 16), 'single');
    show(out, feval(names{{i}}, 'grid', {points}, {turns}, 2, 4, 8, 16), 'double');
end
fclose(out);
"""
RUN = {
    "c": ["./driver"],
    "javascript": ["node", "driver.mjs"],
    "octave": ["octave-cli", "--quiet", "--no-init-file", "driver.m"],
}
ENDINGS = {"c": ".c", "javascript": ".mjs", "octave": ".m"}
STRICT = ["gcc", "-Wall", "-Wextra", "-pedantic", "-Werror"]


def elsewhere(target: str, folder: Path) -> Found:
    """Return what C, JavaScript or Octave finds: every case emitted to `folder`, run in one process."""
    DOUBLE.tofile(folder / "doubles")
    SINGLE.tofile(folder / "singles")
    for case in CASES:
        assert command([*case.options(target), "-o", str(folder / (case.name + ENDINGS[target]))]) == 0
    if target == "c":
        (folder / "driver.c").write_text(_c_driver())
        sources = [*(f"{case.name}.c" for case in CASES), "driver.c"]
        execute([*STRICT, "-std=c99", "-O1", *sources, "-lm", "-o", "driver"], folder)
    else:
        names = [case.name for case in CASES]
        listed = str(names) if target == "javascript" else "{" + str(names)[1:-1] + "}"
        text = {"javascript": JAVASCRIPT, "octave": OCTAVE}[target]
        driver = text.format(names=listed, points=POINTS, turns=TURNS)
        (folder / f"driver{ENDINGS[target]}").write_text(driver)
    execute(RUN[target], folder)
    return _split(np.fromfile(folder / "found"))


def _c_driver() -> str:
    calls = []
    for case in CASES:
        outputs = range(len(case.outputs))
        calls.append(
            C_CALLS.format(
                name=case.name,
                count=len(outputs),
                doubles=", ".join(f"d + {i} * n" for i in outputs),
                singles=", ".join(f"s + {i} * m" for i in outputs),
                grids=", ".join(f"g + {i} * points * turns" for i in outputs),
            )
        )
    includes = "".join(f'#include "{case.name}.h"\n' for case in CASES)
    sizes = {"n": len(DOUBLE), "m": len(SINGLE), "points": POINTS, "turns": TURNS}
    return C_MAIN.format(includes=includes, calls="".join(calls), **sizes)


def _split(values: np.ndarray) -> Found:
    found, start = {}, 0
    for case in CASES:
        for where, size in (("double", len(DOUBLE)), ("single", len(SINGLE)), ("grid", POINTS * TURNS)):
            for output in case.outputs:
                found[case.name, output, where] = values[start : start + size]
                start += size
    assert start == len(values)
    return found


def execute(line: list[str], folder: Path) -> None:
    """Run a program in a folder; show what it said if it fails."""
    done = subprocess.run(line, cwd=folder, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, f"{' '.join(line)}: {done.stdout[-2000:]}{done.stderr[-2000:]}"
