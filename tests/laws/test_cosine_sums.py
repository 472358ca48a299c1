"""Evidence: sums of cosines say the number they are written for, and nothing else is read as one."""

from __future__ import annotations

import math
import re
from fractions import Fraction

import hypothesis.strategies as st
import pytest
from hypothesis import given, settings

import symbalance as sb
from symbalance.engine.engine_file import parse_engine
from symbalance.engine.rotating_masses import share_sign
from symbalance.errors import SymbalanceError
from symbalance.exact.cosine_sums import PATTERN, cosine_text, read_cosines
from symbalance.exact.phasor import Phasor
from symbalance.kinematics.slider_crank import acceleration_values

TERMS = st.dictionaries(st.integers(0, 59), st.fractions(-5, 5, max_denominator=40), max_size=6)


@given(TERMS)
@settings(max_examples=60, deadline=None)
def test_what_is_written_is_read_back(terms):
    number = Phasor.of(60, terms).real()
    text = cosine_text(number)
    assert text is not None
    assert re.match(PATTERN, text)
    assert read_cosines(text, "share") == number
    value = sum(float(c) * math.cos(2 * math.pi * k / 60) for k, c in terms.items())
    assert math.isclose(float(number.evaluated().real), value, abs_tol=1e-12)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("cos 60", 0.5),
        ("-cos60", -0.5),
        ("1/2*cos 36 - 0.125", 0.5 * math.cos(math.pi / 5) - 0.125),
        (" + 2 cos 22.5 + 1", 2 * math.cos(math.pi / 8) + 1),
    ],
)
def test_what_a_person_writes_is_read(text, value):
    assert math.isclose(float(read_cosines(text, "share").evaluated().real), value, rel_tol=1e-14)


@pytest.mark.parametrize(
    "text",
    [
        "cos",
        "cos x",
        "cos 36 cos 36",
        "1 2 cos 36",
        "cos(36)",
        "cos 36 +",
        "+-cos 36",
        "1/0 cos 36",
        "cos 1/0",
        "cos 0.12345678901",
        "cos 36; import os",
        "__import__('os') cos 36",
        "2 ** 9 cos 36",
        "cos ٣٦",
        "+".join(["cos 36"] * 101),
        "9" * 5000 + " cos 36",
    ],
)
def test_what_is_no_sum_is_refused(text):
    with pytest.raises(SymbalanceError, match="share = "):
        read_cosines(text, "share")


def test_the_line_of_a_bad_sum_is_named():
    text = '[layout]\nfiring_order = [1, 2]\n[[counterweight]]\nangle = 3\nshare = "cos 36 cos 36"\n'
    with pytest.raises(SymbalanceError, match=r"bad\.toml:5: share"):
        parse_engine(text, "bad.toml")


@given(TERMS, st.fractions(0, 360, max_denominator=12))
@settings(max_examples=15, deadline=None)
def test_a_vector_of_any_direction_is_read_back_as_two_parts(terms, angle):
    number = Phasor.of(60, terms)
    up, right = (cosine_text(number.rotated(turns).real()) for turns in (Fraction(0), Fraction(-1, 4)))
    head = "[layout]\nfiring_order = [1, 2]\n[[balance_shaft]]\nspeed = 1\nphase = "
    text = f'{head}"{angle}"\nweights = [{{ share = ["{up}", "{right}"] }}]\n'
    (shaft,) = parse_engine(text, "parts.toml").balancers.shafts
    assert shaft.weights[0].vector == number
    by_hand = sb.engine.Weight(share=(number.real(), number.rotated(Fraction(-1, 4)).real()), phase=angle)
    assert by_hand.vector == number.rotated(angle / 360)


def test_designs_of_no_fine_direction_have_one_weight_each_and_leave_nothing():
    """Of a cross-plane V8 and a V6 the weights point by arctangents; four turns of A_4 point up."""
    written = {}
    for name, orders in (("v8-90", [1, 2]), ("v6-90", [1, 2]), ("inline-4", [2, 4])):
        design = sb.design_balance(sb.load(name), orders)
        written[name] = text = sb.engine.engine_text(design.balanced)
        count = sum(len(device.weights) for device in design.devices)
        assert text.count("share = ") == count
        assert sb.balance(parse_engine(text, "again.toml", name), 2).orders == ()
    assert written["v8-90"].count('share = ["') == 2
    assert "# 1.05409 m r at -116.565 degrees\n" in written["v8-90"]
    assert "share = 2, phase = 180" in written["inline-4"]
    assert "# station 0: -2 A4 m r/16 at 0 degrees" in written["inline-4"]
    assert "share = -2, phase = 0" in written["inline-4"]


def test_what_a_share_is_a_multiple_of_has_the_sign_that_the_writer_says():
    for ratio in (Fraction(101, 100), Fraction(3), Fraction(9)):
        values = acceleration_values(24, ratio, 30)
        engine = sb.inline("1", ratio=ratio)
        signs = [share_sign(engine, -n) for n in values if n == 1 or n % 2 == 0]
        assert signs == [1 if values[n] > 0 else -1 for n in values if n == 1 or n % 2 == 0]


@pytest.mark.parametrize(
    ("share", "says"),
    [
        ('["1"]', "must hold two parts"),
        ("[1, 2, 3]", "must hold two parts"),
        ("[]", "must hold two parts"),
        ('[1, "cos x"]', r"share\[2\] = cos x: must be a number"),
        ("[1, [2, 3]]", r"share\[2\] = "),
        ("[1, 2]\nunbalance = 3", "takes one of"),
    ],
)
def test_what_is_no_pair_of_parts_is_refused(share, says):
    text = f"[layout]\nfiring_order = [1, 2]\n[[counterweight]]\nangle = 3\nshare = {share}\n"
    with pytest.raises(SymbalanceError, match=rf"bad\.toml:[35].*{says}"):
        parse_engine(text, "bad.toml")


@pytest.mark.parametrize("name", ["inline-3", "inline-5", "v6-60", "v10-72"])
def test_a_design_is_written_as_its_table_has_it_and_balances_exactly(name):
    design = sb.design_balance(sb.load(name), [1, 2])
    text = sb.engine.engine_text(design.balanced)
    count = sum(len(device.weights) for device in design.devices)
    assert text.count("share = ") == count  # a weight each, exact
    again = parse_engine(text, "again.toml", name)
    left = sb.balance(again, 2)
    assert left.orders == sb.balance(design.balanced, 2).orders == ()
