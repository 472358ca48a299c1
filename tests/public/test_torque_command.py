"""`symbalance torque` as a user meets it."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

import symbalance as sb
from symbalance.cli import run

ENGINE = """
[crank_train]
stroke = 86
rod = 143
reciprocating_mass = 0.55
[layout]
firing_order = [1, 3, 4, 2]
"""


@pytest.fixture
def engine(tmp_path: Path) -> str:
    path = tmp_path / "four.toml"
    path.write_text(ENGINE, encoding="utf-8")
    return str(path)


def printed(capsys, *arguments: str) -> str:
    assert run(["torque", *arguments]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    return out


def test_inertia_alone_is_exact(capsys):
    text = printed(capsys, "inline-6", "--order", "12")
    assert [line.split()[0] for line in text.splitlines() if line[:7].strip().isdigit()] == 2 * [
        "3", "6", "9", "12"
    ]  # fmt: skip
    document = json.loads(printed(capsys, "inline-4", "--format", "json"))
    assert document["inertia"][0]["torque"]["amplitude"] == "4"
    assert document["inertia"][0]["coefficient"]["series"] == "-1/2 - 1/(32*lam**4)"
    assert document["running"] is None


@pytest.mark.slow
def test_a_running_engine_has_mean_swing_and_flywheel(engine, capsys):
    options = ("--compression", "10", "--heat", "18", "--bore", "86", "--rpm", "3000")
    found = json.loads(printed(capsys, engine, *options, "--format", "json"))["running"]
    assert found["mean"] == pytest.approx(found["power"] / (3000 * 3.141592653589793 / 30))
    assert found["flywheel"] == pytest.approx(found["energy"] / (0.02 * (100 * 3.141592653589793) ** 2))
    assert {"0.5", "1/2"}.isdisjoint(o["order"] for o in found["orders"])  # fires evenly: whole orders
    assert "flywheel" in printed(capsys, engine, *options)


@pytest.mark.slow
@pytest.mark.parametrize("ending", ["txt", "tex", "html", "md", "json"])
def test_the_running_engine_is_part_of_the_one_document(engine, ending, tmp_path, capsys):
    """In every medium: orders of inertia, then mean, extremes, energy and flywheel, to 6 digits."""
    target = tmp_path / f"four.{ending}"
    options = ("--compression", "10", "--bore", "86", "--rpm", "3000", "--order", "4", "--delta", "0.03")
    assert printed(capsys, engine, *options, "-o", str(target)) == ""
    text = target.read_text(encoding="utf-8")
    if ending == "json":
        document = json.loads(text)
        assert next(iter(document)) == "schema"
        assert [o["order"] for o in document["inertia"]] == ["2", "4"]
        assert [o["order"] for o in document["running"]["orders"]] == ["2", "4"]
        assert document["running"]["delta"] == 0.03
        return
    made = sb.running_torque(
        sb.load(engine), sb.torque.ideal_cycle(10, heat=18), bore=86, rpm=3000, order=4, delta="0.03"
    )
    swing, pi = made.fluctuation, 3.141592653589793
    flywheel = swing.energy / (0.03 * (100 * pi) ** 2)
    text = re.sub(r"\$ & \$\.", ".", text)  # LaTeX parts numbers at their points
    numbers = (
        made.mean,
        made.mean * 100 * pi / 1000,
        swing.largest,
        -swing.least,
        swing.energy,
        flywheel,
    )
    for value in (*numbers, *(abs(float(s)) for *_, s in made.terms(4))):
        assert f"{value:.6g}" in text
    assert text.index("Inertia torque on the crank") < text.index("Running at 3000 rpm")
    assert text.index("Running at 3000 rpm") < text.index("How to read it")


def test_a_pressure_trace_from_a_file(engine, capsys, tmp_path):
    """A constant pressure does no work over a turn."""
    trace = tmp_path / "trace.csv"
    trace.write_text("degrees,bar\n" + "".join(f"{a},3\n" for a in range(0, 721, 10)), encoding="utf-8")
    options = ("--pressure", str(trace), "--bore", "86", "--rpm", "600")
    found = json.loads(printed(capsys, engine, *options, "--format", "json"))["running"]
    assert abs(found["mean"]) < 1e-9
    assert found["highest"] > 1
    assert "no mean torque" in printed(capsys, engine, *options)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--bore", "86"), "is for a running engine"),
        (("--compression", "10", "--rpm", "3000"), "--bore: is missing"),
        (("--compression", "10", "--bore", "86"), "--rpm: is missing"),
        (("--pressure", "none.csv", "--bore", "86", "--rpm", "9"), "cannot be read"),
        (("--compression", "0.5", "--bore", "86", "--rpm", "9"), "compression_ratio"),
        (("--delta", "0"), "must lie between 0 and 1"),
        (("--delta", "0.01"), "is for a running engine"),
        (("--heat", "5"), "is for a running engine"),
        (("--pressure", "none.csv", "--heat", "5", "--bore", "86", "--rpm", "9"), "ideal cycle's"),
        (("--compression", "10", "--bore", "86", "--rpm", "1e400"), "rpm = 1e400: must lie within"),
        (("--compression", "10", "--bore", "86", "--rpm", "1e-200"), "rpm = 1e-200: must lie within"),
        (("--compression", "10", "--bore", "1e300", "--rpm", "9"), "bore = 1e300: must lie within"),
        (("--order", "0"), "from 1 to 1000"),
    ],
)
def test_refusals(engine, arguments, words, capsys):
    assert run(["torque", engine, *arguments]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert words in err
    assert err.count("\n") == 1


@pytest.mark.slow
def test_a_preset_runs_with_stroke_and_mass_said(capsys):
    """A radial's catalogue entry has no mass: it is said, and does what an engine file's would do."""
    options = ("--compression", "6.4", "--bore", "155.6", "--rpm", "2300", "--format", "json")
    said = json.loads(printed(capsys, "r-1820", *options, "--mass", "4"))["running"]
    layout, gas = sb.load("r-1820"), sb.torque.ideal_cycle("6.4", heat=18)
    made = sb.running_torque(layout, gas, bore="155.6", rpm=2300, reciprocating_mass=4)
    assert said["rpm"] == 2300
    assert said["highest"] == pytest.approx(made.fluctuation.largest, rel=1e-12)
    assert run(["torque", "inline-4", *options[:6], "--mass", "1"]) == 2
    assert "give --stroke" in capsys.readouterr().err
