"""Evidence: sums of cosines say the number they are written for, and nothing else is read as one."""

from __future__ import annotations

import math
import re

import hypothesis.strategies as st
import pytest
from hypothesis import given, settings

import symbalance as sb
from symbalance.engine.engine_file import parse_engine
from symbalance.errors import SymbalanceError
from symbalance.exact.cosine_sums import PATTERN, cosine_text, read_cosines
from symbalance.exact.phasor import Phasor

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


@pytest.mark.parametrize("name", ["inline-3", "inline-5", "v6-60", "v10-72"])
def test_a_design_is_written_as_its_table_has_it_and_balances_exactly(name):
    design = sb.design_balance(sb.load(name), [1, 2])
    text = sb.engine.engine_text(design.balanced)
    count = sum(len(device.weights) for device in design.devices)
    assert text.count("share = ") == count  # a weight each, exact
    again = parse_engine(text, "again.toml", name)
    left = sb.balance(again, 2)
    assert left.orders == sb.balance(design.balanced, 2).orders == ()
