"""Emitted code of an engine at a speed gives newtons with no argument but the angles, in every language.

Truth is each piston's acceleration, differentiated in 40 digits (`tests.kinematics`), times its mass,
the crank radius and the speed squared, summed over the cylinders and multiplied by their stations in m.
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from mpmath import mp

import symbalance as sb
from symbalance.cli import run
from symbalance.errors import SymbalanceError
from tests import kinematics
from tests.independent.test_targets import self_test
from tests.targets import ENDINGS

ENGINE = """
name = "five"
[crank_train]
stroke = 93.2
rod = 144
pitch = 88
reciprocating_mass = 0.61
[layout]
firing_order = [1, 2, 4, 5, 3]
"""
RPM = 5400
ANGLES = (0.0, 0.4, -2.5, 7.75)
OUTPUTS = ("couple.vertical", "piston.acceleration")


def truth(theta: float) -> tuple[float, float]:
    """Return the couple in N m and the first piston's acceleration in m/s^2."""
    with mp.workdps(40):
        lam = mp.mpf(2 * 144) / mp.mpf("93.2")
        radius, omega = mp.mpf("0.0466"), RPM * mp.pi / 30
        throws = {1: 0, 2: -144, 4: -288, 5: -432, 3: -576}
        pistons = {
            n: kinematics.acceleration(theta + kinematics.radians(angle), lam)
            for n, angle in throws.items()
        }
        couple = sum(value * (3 - n) for n, value in pistons.items())
        push = mp.mpf("0.61") * radius * omega**2 * mp.mpf("0.088")
        return float(couple * push), float(pistons[1] * radius * omega**2)


@pytest.fixture
def engine_file(tmp_path: Path) -> Path:
    path = tmp_path / "five.toml"
    path.write_text(ENGINE, encoding="utf-8")
    return path


C_MAIN = """#include <stdio.h>
#include "five.h"
int main(void) {{
    const double theta[] = {{ {angles} }};
    double couple[{count}], push[{count}];
    five_at_speed({count}, theta, couple, push);
    printf("[");
    for (int i = 0; i < {count}; i++) printf("%s[%.17g, %.17g]", i ? ", " : "", couple[i], push[i]);
    printf("]");
    return FIVE_MASS != 0.61 || FIVE_PITCH != 0.088;
}}
"""
JAVASCRIPT = """import {{ evaluate }} from "./five.mjs";
const values = evaluate([{angles}]);
const each = [{angles}].map((_, i) => [values["couple.vertical"][i], values["piston.acceleration"][i]]);
console.log(JSON.stringify(each));
"""
OCTAVE = """values = five([{angles}]);
fprintf('[');
for i = 1:{count}
    if i > 1, fprintf(', '); end
    fprintf('[%.17g, %.17g]', values.couple_vertical(i), values.piston_acceleration(i));
end
fprintf(']');
"""
PYTHON = """import json, numpy as np, five
values = five.evaluate(np.array([{angles}]))
print(json.dumps([[float(values[n][i]) for n in five.OUTPUTS] for i in range({count})]))
"""
DRIVERS = {
    "c": ("driver.c", C_MAIN, ["./driver"]),
    "javascript": ("driver.mjs", JAVASCRIPT, ["node", "driver.mjs"]),
    "octave": ("driver.m", OCTAVE, ["octave-cli", "--quiet", "--no-init-file", "driver.m"]),
}
BUILD = ["gcc", "-Wall", "-Wextra", "-pedantic", "-Werror", "-std=c99", "five.c", "driver.c", "-lm"]


def values_of(target: str, folder: Path) -> list[list[float]]:
    """Return what emitted code of a target makes of the angles, run in a process of its own."""
    name, text, command = DRIVERS.get(target, ("driver.py", PYTHON, [sys.executable, "driver.py"]))
    written = text.format(angles=", ".join(map(repr, ANGLES)), count=len(ANGLES))
    (folder / name).write_text(written, encoding="utf-8")
    if target == "c":
        subprocess.run([*BUILD, "-o", "driver"], cwd=folder, check=True, timeout=120)
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True, timeout=120)
    return json.loads(done.stdout)


@pytest.mark.slow
@pytest.mark.parametrize("target", ["numpy", "numba", "array-api", *ENDINGS])
def test_emitted_code_gives_newtons_with_no_argument(
    target: str, engine_file: Path, tmp_path: Path
) -> None:
    path = tmp_path / f"five{ENDINGS.get(target, '.py')}"
    options = ["--target", target, "--outputs", ",".join(OUTPUTS), "--rpm", str(RPM), "--uniform-grid"]
    assert run(["emit", str(engine_file), *options, "-o", str(path)]) == 0
    for row, theta in zip(values_of(target, tmp_path), ANGLES, strict=True):
        assert row == pytest.approx(truth(theta), rel=1e-11, abs=1e-8)
    for line in self_test(target, path):
        subprocess.run(line, cwd=tmp_path, check=True, capture_output=True, timeout=120)
    written = "".join(each.read_text(encoding="utf-8") for each in tmp_path.glob(f"{path.stem}.*"))
    assert "5400 rpm: mass 0.61 kg, radius 0.0466 m" in written.replace("\n", " ").replace("* ", "")


def test_a_function_of_a_result_at_a_speed_gives_newtons() -> None:
    engine = sb.inline("1-2-4-5-3").with_sizes(
        stroke="93.2", rod=144, pitch=88, reciprocating_mass="0.61"
    )
    result = sb.balance(engine, 1).at(rpm=RPM)
    values = sb.to_function(result, outputs=OUTPUTS, tolerance=0)
    for theta in ANGLES:
        actual = [float(values(theta)[name]) for name in OUTPUTS]
        assert actual == pytest.approx(truth(theta), rel=1e-12)
    per_unit = sb.to_function(sb.balance(engine, 1), outputs=OUTPUTS, tolerance=0)
    point = {"mass": 0.61, "radius": 0.0466, "omega": RPM * np.pi / 30, "pitch": 0.088}
    assert per_unit(0.4, **point)["couple.vertical"] == pytest.approx(truth(0.4)[0], rel=1e-12)
    values.self_test()


def test_a_torque_at_a_speed_is_in_newton_metres() -> None:
    engine = sb.inline("1-3-4-2").with_sizes(stroke=80, rod=160, reciprocating_mass="0.5")
    torque = sb.inertia_torque(engine, 2).at(rpm=6000)
    with mp.workdps(30):  # minus force times speed over the crank's: two pistons each way
        phases = [mp.mpf("0.3") + k * mp.pi for k in (0, 1)]
        moving = sum(kinematics.velocity(p, 4) * kinematics.acceleration(p, 4) for p in phases)
        newton_metres = -2 * moving * mp.mpf("0.5") * mp.mpf("0.04") ** 2 * (200 * mp.pi) ** 2
    assert sb.to_function(torque, tolerance=0)(0.3) == pytest.approx(float(newton_metres), rel=1e-12)


def test_without_a_speed_every_keyword_is_1(engine_file: Path, capsys) -> None:
    assert run(["emit", str(engine_file), "--target", "numpy"]) == 0
    text = capsys.readouterr().out
    assert "def evaluate(theta, *, mass=1.0, radius=1.0, omega=1.0, pitch=1.0, out=None):" in text
    assert "Each is 1 unless given: values" in " ".join(text.split())


def test_what_newtons_need_is_named(capsys, tmp_path: Path) -> None:
    """The sizes that the outputs depend on, and no others."""
    options = ["emit", "v8-90", "--target", "numpy", "--rpm", "6000"]
    assert run([*options, "--stroke", "90"]) == 2
    assert "needs the engine's reciprocating_mass for newtons" in capsys.readouterr().err
    sizes = ["--stroke", "90", "--mass", "0.5"]
    assert run([*options, *sizes]) == 0
    assert "gives no pitch, and no output takes it: it is 1" in capsys.readouterr().out.replace("\n", " ")
    assert run([*options, *sizes, "--outputs", "couple.vertical"]) == 2
    assert "needs the engine's pitch for newtons" in capsys.readouterr().err
    assert run([*options, *sizes, "--pitch", "100"]) == 2
    assert "--pitch: plays no part in the outputs asked for" in capsys.readouterr().err
    bare = tmp_path / "bare.toml"
    bare.write_text("[layout]\nfiring_order = [1, 2]\n", encoding="utf-8")
    assert run(["emit", str(bare), "--target", "numpy", "--rpm", "6000"]) == 2
    assert "needs the engine's stroke, reciprocating_mass and rod for newtons" in capsys.readouterr().err
    assert run(["emit", "v8-90", "--target", "numpy", "--mass", "1"]) == 2
    assert "--mass: makes newtons at a speed only" in capsys.readouterr().err


def test_a_mass_of_0_makes_no_newtons() -> None:
    engine = sb.inline("1").with_sizes(stroke=80, rod=160, reciprocating_mass=0)
    with pytest.raises(SymbalanceError, match="must be above 0"):
        sb.balance(engine).at(rpm=6000)
