"""Angles of any number of turns: the same engine, to the last character of every answer."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy

import symbalance as sb
from symbalance.cli import run

ROW = """
[[cylinder]]
number = {number}
throw = {throw}
bank = {bank}
fires = {fires}
"""
LINK = """master = 1
link_angle = {angle}
link_radius = 82.55
rod = 266.7
"""


def vee(left: object, right: object, turns: int = 0) -> str:
    """Return a vee of four on a split crank as a file; `turns` whole turns are added to every throw."""
    rows = [(1, 0, left, 0), (2, 90, right, 390), (3, 180, left, 540), (4, 270, right, 210)]
    head = "name = 'vee'\n[crank_train]\nstroke = 80\nrod = 140\nreciprocating_mass = 0.5\npitch = 90\n"
    return head + "".join(
        ROW.format(number=n, throw=throw + 360 * turns, bank=bank, fires=fires) + f"station = {2 - n}\n"
        for n, throw, bank, fires in rows
    )


def nine(turns: int) -> str:
    """Return an R-1820 with banks from 0 to 360 and link angles some turns on."""
    text = "name = 'nine'\n[crank_train]\nstroke = 174.625\nrod = 349.25\n"
    for k in range(9):
        bank = 40 * k + 360 * turns
        fires = 40 * k + 360 * (k % 2)
        text += ROW.format(number=k + 1, throw=-720 * turns, bank=bank, fires=fires)
        text += LINK.format(angle=bank) if k else ""
    return text


def answers(capsys, tmp_path, text: str, *errors: str) -> list[str]:
    path = tmp_path / "engine.toml"
    path.write_text(text, encoding="utf-8")
    said = []
    for command in (
        ["balance", "--format", "json", "--order", "4"],
        ["balance", "--format", "latex", "--order", "4"],
        ["torque", "--format", "json", "--order", "4"],
        ["emit", "--target", "numpy", "--order", "4"],
        ["tolerances", *errors, "--order", "2"],
        ["sensitivities", "--order", "2"],
    ):
        assert run([command[0], str(path), *command[1:]]) == 0
        said.append(capsys.readouterr().out)
    return said


@pytest.mark.spread(1)
@pytest.mark.parametrize("turns", [1, -2])
def test_banks_beyond_half_a_turn_in_files_give_the_very_same_answers(capsys, tmp_path, turns):
    errors = "--bank", "0.1", "--throw", "0.1"
    usual = answers(capsys, tmp_path, vee(-90, 30), *errors)
    rotated = vee(270 + 360 * turns, 30 - 360 * turns, turns)
    assert answers(capsys, tmp_path, rotated, *errors) == usual


@pytest.mark.slow
@pytest.mark.parametrize("turns", [-1])  # a vee takes both ways above; nine link rods take long
def test_a_radial_may_be_numbered_from_0_to_360(capsys, tmp_path, turns):
    usual = answers(capsys, tmp_path, nine(0), "--mass", "1%")
    assert answers(capsys, tmp_path, nine(turns), "--mass", "1%") == usual
    force = sb.balance(sb.load(str(tmp_path / "engine.toml")), 2)[2].force
    preset = sb.balance(sb.load("r-1820"), 2)[2].force
    assert force.forward.cos == preset.forward.cos


@pytest.mark.spread(2)
@pytest.mark.parametrize(
    ("value", "same"),
    [(400, 40), (-270, 90), (720, 0), ("1087/3", "7/3"), (180, -180), (10**9, 280), (359.9, "-0.1")],
)
def test_builders_take_any_angle(value, same):
    assert sb.Cylinder(1, value, value) == sb.Cylinder(1, same, same)
    assert sb.Cylinder(1, bank=value).bank == sb.Cylinder(1, bank=same).bank
    assert sb.engine.Link(1, value, 30) == sb.engine.Link(1, same, 30)
    built = [sb.w([angle, 60, 0], "1-2-3", cylinders=[[1], [2], [3]], ratio=4) for angle in (value, same)]
    assert built[0] == built[1]
    assert sb.to_json(sb.balance(built[0])) == sb.to_json(sb.balance(built[1]))
    assert sb.engine.engine_text(built[0]) == sb.engine.engine_text(built[1])


def test_symbolic_angles_stay_as_they_are():
    alpha = sympy.Symbol("alpha", real=True)
    assert sb.Cylinder(1, bank=alpha + 3 * sympy.pi).bank.as_text() == "540 + alpha"
    assert sb.Cylinder(1, bank=5 * sympy.pi / 2).bank == sb.Cylinder(1, bank=90).bank


def test_the_angle_between_the_banks_of_a_vee_is_not_taken_modulo_a_turn():
    """Its half is the banks' angle: 400 degrees would hang the banks of a vee of 40."""
    with pytest.raises(sb.SymbalanceError, match=r"bank_angle = 400: must lie in \[0, 180\]"):
        sb.vee(400, "1-2")


def test_link_rods_of_both_rows_of_a_radial_are_alike():
    """The second row stands half a turn on: its banks less its master's pass half a turn."""
    rows = []
    for row, pin in enumerate((0, 180)):
        master = 9 * row + 1
        for k in range(9):
            own = {"link": sb.engine.Link(master, 40 * k, "82.55"), "rod": "266.7"} if k else {}
            rows.append(sb.Cylinder(master + k, pin, 40 * k + pin, -row, **own))
    train = sb.engine.CrankTrain(stroke=Fraction("174.625"), rod=Fraction("349.25"))
    double = sb.engine.from_cylinders(rows, crank_train=train)
    assert sorted(map(len, (g.cylinders for g in double.groups))) == [2] * 9
    assert sb.balance(double, 4).force.orders() == []  # the rows turned by half a turn: exactly nothing
