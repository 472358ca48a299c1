"""Numbers as programs write them, 17 digits and other types: read exactly, or refused with a reason."""

from __future__ import annotations

import random
import sys
from decimal import Decimal
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

import symbalance as sb
from symbalance.cli import run
from symbalance.design.balancing import rotating_weights
from symbalance.engine.engine_file import parse_engine
from symbalance.text.numbers import exact, short_text


@given(st.floats(1e-24, 1e9) | st.floats(-1e9, -1e-24))
def test_every_float_of_a_usual_size_is_read_as_it_prints(value):
    assert exact(value, "mass") == Fraction(repr(value)) == exact(repr(value), "mass")
    assert float(exact(value, "mass")) == value


@pytest.mark.parametrize(
    ("value", "number"),
    [
        (8.66190878660935, Fraction("8.66190878660935")),
        (0.1 + 0.2 - 0.3, Fraction("5.551115123125783e-17")),  # what is left of a sum
        (np.float64(8.66190878660935), Fraction("8.66190878660935")),
        (np.float32(0.1), Fraction(1, 10)),
        (np.float16(0.1), Fraction(1, 10)),
        (np.int64(3), 3),
        (Decimal("0." + "3" * 40), Fraction("0." + "3" * 40)),
        (Decimal("1E+3"), 1000),
        (Fraction(10**12 - 1, 10**12 - 11), Fraction(10**12 - 1, 10**12 - 11)),
        (Fraction(8.66190878660935), Fraction(8.66190878660935)),  # a double itself: halves of halves
        (sympy.Rational(1, 3), Fraction(1, 3)),
        (sympy.Float("0.1"), Fraction(1, 10)),
    ],
)
def test_numbers_of_other_types_are_read_as_they_print(value, number):
    assert exact(value, "mass") == number
    assert sb.Cylinder(1, offset=value).sizes.offset == number


@pytest.mark.parametrize(
    ("value", "rule"),
    [
        (5e-324, "with 40 decimals"),
        (1e300, "check the unit"),
        (sys.float_info.max, "check the unit"),
        (Decimal("0." + "3" * 41), "write fewer digits"),
        (Decimal("1E+999999999"), "must be a number"),
        (Decimal("sNaN"), "must be a number"),
        (Fraction(1, 3**30), "a denominator up to 10^12"),
        (Fraction(1, 3**30 * 10**5), "a denominator up to 10^12"),
        (sympy.Rational(1, 3**200), "a denominator up to 10^12"),
        (mpmath.mpf("0.1"), "working precision"),
        (mpmath.mpf(1) / 3, "working precision"),
        (np.float32("nan"), "must be a number"),
        (np.longdouble("inf"), "must be a number"),
        (np.bool_(True), "must be a number"),
        (np.array([0.5]), "must be a number"),
        (sympy.pi, "must be a number"),
    ],
    ids=lambda v: type(v).__name__,
)
def test_what_cannot_be_read_exactly_says_why(value, rule):
    with pytest.raises(sb.SymbalanceError, match=r"^mass = .*: ") as caught:
        exact(value, "mass")
    assert rule in str(caught.value)


def test_angles_keep_the_bound_that_their_field_needs():
    for value in (17.3333333, 17.333333333333332, 52 / 3, "0." + "3" * 20):
        with pytest.raises(sb.SymbalanceError, match="denominator must be at most 10000; write the frac"):
            sb.Cylinder(1, throw=value)
        with pytest.raises(sb.SymbalanceError, match="denominator must be at most 10000; write the frac"):
            sb.Cylinder(1, bank=value)
    assert sb.Cylinder(1, throw=np.float64(17.25)).throw == sb.Cylinder(1, throw="69/4").throw


def drawn(seed: int, low: float, high: float) -> str:
    return repr(random.Random(seed).uniform(low, high))


LIKE = f"""
[crank_train]
stroke = {drawn(1, 79, 81)}
rod = {drawn(2, 139, 141)}
pitch = {drawn(3, 90, 99)}
reciprocating_mass = 8.66190878660935
rotating_mass = {drawn(4, 3, 4)}
[layout]
banks = [-45, 45]
cylinders = [[1, 3, 5, 7], [2, 4, 6, 8]]
firing_order = [1, 8, 4, 3, 6, 5, 7, 2]
stagger = [{drawn(5, 0.1, 0.3)}, {drawn(6, -0.3, -0.1)}]
"""
TWELVE = f"[crank_train]\npitch = {drawn(7, 90, 99)}\n" + "".join(
    f"[[cylinder]]\nnumber = {i + 1}\nthrow = {(0, 120, 240, 240, 120, 0)[i % 6]}\n"
    f"bank = {-30 if i < 6 else 30}\nstation = {2.5 - i % 6 + random.Random(i).uniform(-0.01, 0.01)!r}\n"
    + "".join(
        f"{key} = {drawn(100 * i + k, low, high)}\n"
        for k, (key, low, high) in enumerate(
            [
                ("reciprocating_mass", 8, 9),
                ("rotating_mass", 3, 4),
                ("stroke", 79, 81),
                ("rod", 139, 141),
                ("offset", -1, 1),
                ("rod_mass", 0.5, 0.6),
                ("rod_centre", 40, 45),
                ("rod_inertia", 2000, 2500),
            ]
        )
    )
    for i in range(12)
)
BALANCERS = f"""
[[counterweight]]
throw = 1
overbalance = {drawn(8, 0.4, 0.6)}
[[balance_shaft]]
speed = -1
station = {drawn(9, 1, 2)}
unbalance = {drawn(10, 1, 2)}
x = {drawn(11, 10, 20)}
"""
COMMANDS = [
    ["balance", "--order", "4"],
    ["balance", "--order", "4", "--format", "latex"],
    ["balance", "--order", "4", "--format", "json"],
    ["torque", "--order", "4"],
    ["torque", "--order", "4", "--format", "latex"],
    ["tolerances", "--mass", "0.00234567890123456", "--rotating", drawn(12, 0, 0.1), "--order", "2"],
    ["sensitivities", "--order", "2"],
    ["emit", "--target", "numpy", "--order", "4"],
    ["design", "--remove", "1"],
]


@pytest.mark.spread(1)
@pytest.mark.parametrize("text", [LIKE, LIKE + BALANCERS, TWELVE, TWELVE + BALANCERS], ids="abcd")
def test_engines_of_17_digits_go_through_every_command(capsys, tmp_path, text):
    path = tmp_path / "engine.toml"
    path.write_text(text, encoding="utf-8")
    for command in COMMANDS:
        assert run([command[0], str(path), *command[1:]]) == 0, command
        out, err = capsys.readouterr()
        assert err == ""
        if "--format" not in command and command[0] != "emit":
            assert max(map(len, out.splitlines())) < 120, command
    made = sb.load(str(path))
    again = parse_engine(sb.engine.engine_text(made), "again.toml", made.name)
    assert again.cylinders == made.cylinders
    assert again.pitch == made.pitch
    assert again.balancers == made.balancers
    assert len(rotating_weights(made)) == len(made.cylinders)


def test_a_long_ratio_is_printed_as_decimals_and_kept_exactly(capsys, tmp_path):
    path = tmp_path / "engine.toml"
    path.write_text(LIKE, encoding="utf-8")
    ratio = 2 * Fraction(drawn(2, 139, 141)) / Fraction(drawn(1, 79, 81))
    assert run(["balance", str(path), "--order", "4"]) == 0
    assert f"connecting rod over crank radius, here {float(ratio):.12g}"[:-3] in capsys.readouterr().out
    assert run(["balance", str(path), "--order", "4", "--format", "json"]) == 0
    assert f'"ratio": "{ratio}"' in capsys.readouterr().out
    assert run(["balance", str(path), "--order", "4", "--format", "latex"]) == 0
    assert f"{float(ratio):.12g}"[:-3] in capsys.readouterr().out


@pytest.mark.parametrize(
    ("number", "said"),
    [
        (Fraction(7, 2), "7/2"),
        (Fraction(-(10**7) - 1, 10**7), "-1.000000100…"),
        (Fraction(123456789012 * 10**3 + 1, 10**7), "12345678.90…"),
        (Fraction(10**16 + 1, 10**7), "1000000000…"),
        (Fraction(1, 10**7 + 1), "0.000000099…"),
    ],
)
def test_short_text_cuts_and_never_rounds(number, said):
    assert short_text(number) == said
