"""Speeds and sizes that a command line gives: each refusal is a line that names key and option."""

from __future__ import annotations

import pytest

import symbalance as sb
from symbalance.cli import run

REFUSED = [
    (["balance", "inline-4", "--rpm", "6000"], "stroke and reciprocating_mass to [crank_train], or say"),
    (["balance", "v8-90", "--rpm", "6000", "--stroke", "80", "--mass", "0.5"], "or say --pitch MM"),
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
    (["tolerances", "inline-4", "--mass", "1%", "--rpm", "6000"], "--sizes stroke=MM,mass=KG"),
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
