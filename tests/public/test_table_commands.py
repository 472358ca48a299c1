"""`symbalance firing`, `overbalance` and `bounds`, and bank angles of any size: tables and refusals."""

from __future__ import annotations

import json
import math

import pytest
import sympy

import symbalance as sb
from symbalance.cli import run


def printed(capsys, *arguments: str) -> str:
    assert run(list(arguments)) == 0
    out, err = capsys.readouterr()
    assert err == ""
    return out


def data(capsys, *arguments: str):
    return json.loads(printed(capsys, *arguments, "--format", "json"))


def refused(capsys, *arguments: str) -> str:
    assert run(list(arguments)) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.count("\n") == 1
    return err


# firing ---------------------------------------------------------------------------------------------


def test_firing_orders_of_a_preset_hold_its_own(capsys):
    orders = data(capsys, "firing", "v8-90")["firing_orders"]
    assert [1, 8, 4, 3, 6, 5, 7, 2] in [one["order"] for one in orders]
    assert {tuple(one["intervals"]) for one in orders} == {("90",) * 8}


def test_a_crank_is_given_by_its_throws(capsys):
    text = printed(capsys, "firing", "--throws", "0,180,180,0")
    assert "1-3-4-2" in text
    assert "1-2-4-3" in text
    uneven = data(capsys, "firing", "--throws", "0,90", "--uneven")
    assert uneven["even_only"] is False
    gaps = [tuple(one["intervals"]) for one in uneven["firing_orders"]]
    assert sorted(gaps) == [("270", "450"), ("630", "90")]
    together = data(capsys, "firing", "--throws", "0,0", "--together")
    assert any("0" in one["intervals"] for one in together["firing_orders"])


def test_every_crank_of_a_row_of_cylinders(capsys):
    cranks = data(capsys, "firing", "--cylinders", "5")["cranks"]
    assert len(cranks) == 8
    assert sum(crank["stars"] for crank in cranks) == math.factorial(4)
    assert len(data(capsys, "firing", "--cylinders", "3", "--strokes", "2")["cranks"]) == 1


@pytest.mark.parametrize("angle", [60, 75, 90, 120])
def test_pin_offsets_make_a_vee_fire_evenly(capsys, angle):
    table = data(capsys, "firing", "--cylinders", "6", "--vee", str(angle))["bank_angles"]
    (row,) = [one for one in table if one["angle"] == str(angle)]
    assert row["natural"] == (angle == 120)
    for offset in row["offsets"]:  # by the definition: dead centres on some three pins are even
        evens = []
        for pins in ([0, 120, 240], [0, 240, 120]):
            engine = sb.vee(angle, pins=pins, splay=offset)
            evens.append(len(sb.engine.firing_orders(engine)))
        assert any(evens), offset


def test_natural_angles_of_one_crank(capsys):
    table = data(capsys, "firing", "--throws", "0,90,270,180", "--vee")
    assert [one["angle"] for one in table["bank_angles"] if one["natural"]] == ["90", "180"]
    assert table["pins"] == ["0", "90", "270", "180"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ((), "is given no crank"),
        (("v8-90", "--throws", "0,180"), "several cranks"),
        (("v8-90", "--vee"), "--vee"),
        (("v8-90", "--strokes", "2"), "--strokes"),
        (("--cylinders", "5", "--uneven"), "--uneven"),
        (("--cylinders", "5", "--vee"), "even number"),
        (("--cylinders", "x"), "whole number"),
        (("--throws", "0,x"), "--throws = x"),
        (("--cylinders", "6", "--vee", "200"), "200: must lie in [0, 180]"),
        (("--cylinders", "6", "--strokes", "3"), "strokes = 3"),
        (("v8-90", "--within", "90"), "within = 90"),
    ],
)
def test_what_is_no_crank_is_refused(capsys, arguments, words):
    assert words in refused(capsys, "firing", *arguments)


# overbalance ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["inline-1", "inline-3", "v2-45"])
def test_overbalance_is_the_balance_of_the_engine_with_those_weights(capsys, name):
    table = data(capsys, "overbalance", name, "--percent", "0,35,100")["shares"]
    for row in table:
        balance = sb.balance(sb.design.overbalanced(sb.load(name), row["share"]), 1)
        for kind in ("force", "couple"):
            for side in ("vertical", "lateral"):
                part = getattr(balance, kind).component(1, side)
                assert math.isclose(float(row[kind][side]), float(part.number.size()), abs_tol=1e-15)


def test_overbalance_at_a_speed_is_the_balance_in_newtons(capsys):
    sizes = ("--stroke", "80", "--mass", "0.5", "--pitch", "100")
    table = data(capsys, "overbalance", "v2-60", "--percent", "0,35", "--rpm", "6000", *sizes)
    for row in table["shares"]:
        balance = sb.balance(sb.design.overbalanced(sb.load("v2-60"), row["share"]), 1)
        at_speed = balance.at(rpm=6000, stroke=80, mass="0.5", pitch=100)
        for of, key in (("force", "newtons"), ("couple", "newton_metres")):
            for name in ("vertical", "lateral"):
                values = at_speed.in_newtons(1, f"{of}.{name}")
                size = math.hypot(*map(float, values))
                assert math.isclose(float(row[key][name]), size, rel_tol=1e-12, abs_tol=1e-9)
    text = printed(capsys, "overbalance", "v2-60", "--rpm", "6000", *sizes)
    assert "Amplitudes of order 1 at 6000 rpm, forces in N, couples in N m" in text


def test_overbalance_goes_from_0_to_100_per_cent(capsys):
    table = data(capsys, "overbalance", "inline-1")
    assert [row["share"] for row in table["shares"]][::5] == ["0", "1/2", "1"]
    assert table["best"] == {"force": "1/2", "couple": None}
    assert "50" in printed(capsys, "overbalance", "inline-1", "--percent", "45:55:2.5")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("inline-1", "--percent", "0:100"), "A:B:STEP"),
        (("inline-1", "--percent", "0:100:0"), "A:B:STEP"),
        (("inline-1", "--percent", "9:1:1"), "A:B:STEP"),
        (("inline-1", "--percent", "0:100:0.001"), "larger step"),
        (("inline-1", "--percent", ""), "must be a number"),
    ],
)
def test_shares_that_are_none_are_refused(capsys, arguments, words):
    assert words in refused(capsys, "overbalance", *arguments)


def test_counterweights_there_are_no_part_of_an_overbalance(capsys, tmp_path):
    path = tmp_path / "engine.toml"
    text = "[layout]\nfiring_order = [1, 2]\n[[counterweight]]\nthrow = 1\noverbalance = 1\n"
    path.write_text(text, encoding="utf-8")
    assert "counterweights already" in refused(capsys, "overbalance", str(path))


# bounds ---------------------------------------------------------------------------------------------


def test_bounds_are_the_largest_error_over_a_turn(capsys):
    bounds = data(capsys, "bounds", "--quantity", "displacement", "--ratio", "7/2", "--order", "2")
    lam = 3.5
    angles = [math.pi * i / 2000 for i in range(2001)]

    def height(p: float) -> float:
        return math.cos(p) + math.sqrt(lam**2 - math.sin(p) ** 2)

    for row in bounds["bounds"]:
        order, points = int(row["order"]), 256
        turn = [2 * math.pi * i / points for i in range(points)]
        means = [sum(height(p) * math.cos(n * p) for p in turn) / points for n in range(order + 1)]
        kept = [m * (1 if n == 0 else 2) for n, m in enumerate(means)]
        # from top dead centre, as displacement counts: the constant is fixed there
        error = [height(p) - sum(k * math.cos(n * p) for n, k in enumerate(kept)) for p in angles]
        seen = max(abs(e) for e in error)
        assert float(row["bound"]) >= seen * (1 - 1e-9)
        assert float(row["bound"]) <= 2.001 * seen


@pytest.mark.parametrize("option", [("--quantity", "jerk"), ("--ratio", "1"), ("--order", "0")])
def test_bounds_of_nothing_are_refused(capsys, option):
    refused(capsys, "bounds", *option)


# a bank angle that is a letter ----------------------------------------------------------------------


def test_a_letter_is_every_bank_angle(capsys):
    orders = data(capsys, "balance", "v2-90", "--bank", "alpha", "--order", "2")["orders"]
    alpha = sympy.Symbol("alpha")
    for degrees in (45, 60, 90):
        numbers = data(capsys, "balance", "v2-90", "--bank", str(degrees), "--order", "2")["orders"]
        by_order = {one["order"]: one for one in numbers}
        for one in orders:
            for side in ("vertical", "lateral"):
                expression = sympy.sympify(one["force"][side]["cos"]).subs(alpha, sympy.rad(degrees))
                other = by_order[one["order"]]["force"][side]["cos"] if one["order"] in by_order else "0"
                assert math.isclose(float(expression), float(sympy.sympify(other)), abs_tol=1e-12)
    assert orders[0]["force"]["vertical"]["amplitude"] == "cos(alpha) + 1"


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("inline-4", "--bank", "alpha"), "1 bank"),
        (("v2-90", "--bank", "lam"), "results use themselves"),
        (("v2-90", "--bank", "__import__('os')"), "must be a number"),
        (("v2-90", "v8-90", "--bank", "alpha"), "is for one engine"),
        (("vw-vr6", "--bank", "alpha"), "rods or offsets differ"),
    ],
)
def test_bank_angles_that_are_none_are_refused(capsys, arguments, words):
    assert words in refused(capsys, "balance", *arguments)


@pytest.mark.parametrize("name", ["v2-45", "v6-90", "v8-90", "v12-60"])
def test_its_own_bank_angle_changes_nothing_but_where_theta_counts_from(name):
    engine = sb.load(name)
    banks = {c.bank.in_degrees() for c in engine.cylinders}
    again = sb.engine.with_bank_angle(engine, max(banks) - min(banks))
    assert [c.bank for c in again.cylinders] == [c.bank for c in engine.cylinders]
    ours, theirs = sb.balance(again, 4), sb.balance(engine, 4)
    for kind in ("force", "couple"):
        one, other = (getattr(b, kind).terms for b in (ours, theirs))
        assert one.keys() == other.keys()
        for n in one:
            assert math.isclose(float(one[n].size()), float(other[n].size()), rel_tol=1e-15)


def test_banks_that_hang_keep_hanging():
    hanging = sb.engine.from_firing_order("1-2", banks=[-150, 150], cylinders=[[1], [2]])
    changed = sb.engine.with_bank_angle(hanging, 90)
    left, right = (float(c.bank.in_degrees()) for c in changed.cylinders)
    assert (left % 360, right % 360) == (225, 135)


# letters --------------------------------------------------------------------------------------------


def test_any_number_of_cylinders_is_that_number_of_them(capsys):
    theta, count = sympy.Symbol("theta", real=True), sympy.Symbol("N")
    for row in data(capsys, "formulas", "--order", "4")["orders"]:
        n = int(row["order"])
        for cylinders in (3, 4, 5):
            angles = [4 * math.pi * j / cylinders for j in range(cylinders)]
            kind = "force" if 2 * n % cylinders == 0 else "couple"
            names = {"theta": theta, "N": count}
            expression = sympy.sympify(row[kind], locals=names).subs(count, cylinders)
            for at in (0.3, 1.7):
                arms = (
                    [1.0] * cylinders
                    if kind == "force"
                    else [(cylinders - 1) / 2 - j for j in range(cylinders)]
                )
                total = sum(a * math.cos(n * (at - h)) for a, h in zip(arms, angles, strict=True))
                assert math.isclose(float(expression.subs(theta, at)), total, abs_tol=1e-12)


def test_masses_and_a_bank_angle_may_be_letters(capsys):
    text = data(capsys, "formulas", "v2-90", "--bank", "alpha", "--masses", "m")
    vertical = sympy.sympify(text["force"]["vertical"]["cos"])
    alpha, one, two = sympy.symbols("alpha m_1 m_2")
    assert sympy.simplify(vertical - (one + two) * sympy.cos(alpha / 2) ** 2) == 0


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--masses", "m"), "is for one engine"),
        (("v2-90", "--strokes", "2"), "leave it out"),
        (("v2-90", "--masses", "m n"), "must be a letter"),
        (("--order", "0"), "order = 0"),
        (("--strokes", "3"), "strokes = 3"),
    ],
)
def test_letters_that_are_none_are_refused(capsys, arguments, words):
    assert words in refused(capsys, "formulas", *arguments)
