"""Speeds and sizes that a command line gives: each refusal is a line that names key and option."""

from __future__ import annotations

from pathlib import Path

import pytest

import symbalance as sb
from symbalance.cli import run
from symbalance.engine.doubtful_sizes import doubtful_size

REFUSED = [
    (
        ["balance", "inline-4", "--rpm", "6000"],
        "stroke and reciprocating_mass to [crank_train], or append your own",
    ),
    (
        ["balance", "v8-90", "--rpm", "6000", "--stroke", "80", "--mass", "0.5"],
        "or append your own figures like --pitch 100",
    ),
    (
        ["balance", "vq30de", "--rpm", "6000", "--mass", "0.7"],
        "is given by the engine already, as 673/1000",
    ),
    (["balance", "vq30de", "--rpm", "0"], "must lie in (0, 100000]"),
    (["balance", "vq30de", "--rpm", "7000:1000:500"], "must go upwards"),
    (["balance", "vq30de", "--rpm", "1:100000:1"], "asks for more than 1000 speeds"),
    (["balance", "vq30de", "--rpm", "1000:2000"], "must be a speed or from:to:step"),
    (["balance", "inline-4", "--mass", "0.5"], "--mass: plays a part at a speed only"),
    (["balance", "inline-4", "--rod", "140"], "makes a rod ratio with the stroke only"),
    (["balance", "inline-4", "--stroke", "80", "--rod", "140", "--ratio", "3"], "and so does --ratio"),
    (["torque", "inline-4", "--rpm", "6000"], "stroke and reciprocating_mass"),
    (["torque", "inline-4", "--stroke", "80"], "--stroke: plays a part at a speed only"),
    (["design", "inline-4", "--rpm", "6000"], "stroke and reciprocating_mass"),
    (["sensitivities", "inline-4", "--rpm", "6000"], "stroke and reciprocating_mass"),
    (["tolerances", "inline-4", "--mass", "1%", "--rpm", "6000"], "--sizes stroke=86,mass=0.5"),
    (["tolerances", "inline-4", "--mass", "1%", "--sizes", "bore=80"], "must name some of"),
    (["tolerances", "inline-4", "--mass", "1%", "--sizes", "mass=1,mass=2"], "must name some of"),
]


@pytest.mark.parametrize(("arguments", "words"), REFUSED, ids=[" ".join(a) for a, _ in REFUSED])
def test_refusals(arguments: list[str], words: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(arguments) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert words in err
    assert err.count("\n") == 1


def test_what_is_known_already_may_be_said_again() -> None:
    engine = sb.load("vq30de")
    assert engine.with_sizes(stroke="73.3", pitch=108) == engine


def test_a_rod_takes_the_place_of_a_ratio_that_is_given_alone() -> None:
    assert sb.load("inline-4").with_sizes(stroke=86, rod=129).ratio == 3


def test_sizes_given_late_are_those_given_early() -> None:
    """What holds the kinematics is computed anew, not rescaled."""
    engine = sb.load("vw-vr6")
    late = sb.balance(engine, 3).at(rpm=3000, mass="0.5")
    early = sb.balance(engine.with_sizes(reciprocating_mass="0.5"), 3).at(rpm=3000)
    assert late == early


def test_orders_out_of_range_and_other_outputs_are_refused() -> None:
    balance = sb.balance(sb.load("vq30de"), 6).at(rpm=6000)
    assert [float(x) for x in balance.in_newtons(3, "force.vertical")] == [0, 0]
    for order, output in ((7, "force.vertical"), (0, "force.vertical"), (1, "force.up"), (1, "torque")):
        with pytest.raises(sb.SymbalanceError):
            balance.in_newtons(order, output)
    with pytest.raises(sb.SymbalanceError, match="no operating point"):
        sb.balance(sb.load("vq30de"), 6).in_newtons(1, "force.vertical")


UNLIKE = """
[[cylinder]]
number = 1
throw = 0
rod = 140
[[cylinder]]
number = 2
throw = 180
station = -1
rod = 160
[crank_train]
stroke = 80
pitch = 100
"""


def _unlike(tmp_path: Path) -> sb.Engine:
    path = tmp_path / "unlike.toml"
    path.write_text(UNLIKE, encoding="utf-8")
    return sb.load(path)


TORQUES = {
    "inertia": sb.inertia_torque,
    "rod": sb.torque.rod_torque,
    "couple": sb.torque.rod_couple,
    "roll": sb.torque.roll_moment,
    "beside": sb.torque.offset_moment,
}


@pytest.mark.parametrize("name", TORQUES)
def test_sizes_given_late_to_a_torque_are_those_given_early(name: str) -> None:
    """In-line with offset axes and a rod's inertia: every part of the torque holds the kinematics."""
    engine = sb.inline("1-3-2", ratio=4).with_sizes(stroke=80)
    sizes = {"mass": "0.5", "rod": 140, "pitch": 100, "bore": 82}
    function = TORQUES[name]
    late = function(engine, 4).at(rpm=3000, **sizes)
    early = function(engine.with_sizes(reciprocating_mass="0.5", rod=140, pitch=100, bore=82), 4)
    assert sb.to_json(late) == sb.to_json(early.at(rpm=3000))
    opposite = function(engine, 4).reaction().at(rpm=3000, **sizes)
    assert sb.to_json(opposite) == sb.to_json(early.reaction().at(rpm=3000))


def test_a_torque_that_holds_the_kinematics_takes_sizes_late(tmp_path: Path) -> None:
    engine = _unlike(tmp_path)
    late = sb.inertia_torque(engine, 4).at(rpm=3000, mass="0.5")
    early = sb.inertia_torque(engine.with_sizes(reciprocating_mass="0.5"), 4)
    assert late.kinematics is None
    assert sb.to_json(late) == sb.to_json(early.at(rpm=3000))


def test_a_design_takes_sizes_late() -> None:
    """They are those given early; which orders get a shaft may depend on them."""
    engine = sb.load("inline-4")
    late = sb.design_balance(engine, [2, 4], shafts=2).at(rpm=3000, mass="0.5", stroke=80, rod=150)
    sized = engine.with_sizes(reciprocating_mass="0.5", stroke=80, rod=150)
    early = sb.design_balance(sized, [2, 4], shafts=2).at(rpm=3000)
    assert late == early
    with pytest.raises(sb.SymbalanceError, match="needs the engine's reciprocating_mass for newtons"):
        sb.design_balance(engine, [2]).at(rpm=3000, stroke=80)


def test_all_that_is_missing_is_named_at_once() -> None:
    engine = sb.vee(90, "1-8-4-3-6-5-7-2")
    with pytest.raises(sb.SymbalanceError) as refusal:
        sb.balance(engine, 4).at(rpm=6000)
    keys = "stroke, reciprocating_mass, pitch and rod"
    assert f"needs the engine's {keys} for newtons" in str(refusal.value)
    assert "--stroke 86 --mass 0.5 --pitch 100 --rod 145" in str(refusal.value)
    sb.balance(engine, 4).at(rpm=6000, stroke=86, mass="0.5", pitch=100, rod=145)


DOUBTFUL = {
    "stroke = 0.09\nrod = 0.148": "stroke = 0.09 mm: is below 1 mm",
    "stroke = 90\nrod = 148\nreciprocating_mass = 520": "520 g are 0.52 kg",
    "stroke = 90\nrod = 148\nreciprocating_mass = 0.0005": "far less than pistons",
    "stroke = 90\nrod = 14800": "is more than 25 strokes",
    "stroke = 90000\nrod = 148000": "is above 5000 mm",
    "stroke = 90\nrod = 148\nbore = 0.08": "bore = 0.08 mm: is below 1 mm",
    "stroke = 90\nrod = 148\npitch = 0.1": "pitch = 0.1 mm: is below 1 mm",
}


@pytest.mark.parametrize("sizes", DOUBTFUL)
def test_sizes_in_other_units_are_said_and_counted_with(
    sizes: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "mine.toml"
    file.write_text(f"[crank_train]\n{sizes}\n[layout]\nfiring_order = [1, 3, 4, 2]\n", encoding="utf-8")
    for command in (["balance", str(file)], ["design", str(file)], ["balance", str(file), "v8-90"]):
        assert run(command) == 0
        printed = capsys.readouterr()
        (line,) = printed.err.splitlines()
        assert line.startswith("symbalance: mine: ")
        assert DOUBTFUL[sizes] in line
        assert "doubt" not in printed.out


def test_no_preset_and_no_ship_or_model_engine_has_doubtful_sizes() -> None:
    """Beside the presets: a model engine, a ship's of 2.5 m stroke, a racing engine's of 40 mm."""
    for preset in sb.presets():
        assert not doubtful_size(sb.load(preset.name)), preset.name
    for stroke, mass in ((6, "0.0004"), (2500, 12_000), ("39.7", "0.33")):
        four = sb.inline("1-3-4-2").with_sizes(stroke=stroke, reciprocating_mass=mass)
        assert not doubtful_size(four)
