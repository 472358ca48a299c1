"""Formulas whose meaning stands in words: an engine's name, an order's, a letter that is small."""

from __future__ import annotations

import tomllib
from fractions import Fraction
from math import cos, pi, sin, sqrt

import pytest

from symbalance.checking import LibraryEngines, check
from symbalance.notes.checking.meant.named_orders import torque_terms
from symbalance.notes.checking.verdicts import FAILING, PROVED_WORDS, REFUTED
from tests import TESTS

GROUPS = tomllib.loads((TESTS / "laws" / "formulas_in_words.toml").read_text(encoding="utf-8"))["group"]
PAGES = [
    pytest.param(page, group["symbols"], key, id=f"{key}: {page.strip()[:60]}")
    for group in GROUPS
    for key in ("right", "wrong", "open")
    for page in group.get(key, ())
]


@pytest.mark.parametrize(("page", "symbols", "key"), PAGES)
def test_words_are_read_as_they_are_meant_or_left_open(page, symbols, key):
    checked = check(page.lstrip() + "\n", symbols)
    assert not checked.faults
    verdicts = sorted(checked.verdicts, key=lambda v: (v.line, v.span))
    last = verdicts[-1].verdict
    if key == "wrong":
        assert last == REFUTED
    elif key == "right":
        assert [v.verdict for v in verdicts if v.verdict in FAILING] == []
        assert last in (*PROVED_WORDS, "conditional")
    else:
        assert last != REFUTED
        assert last not in PROVED_WORDS


def test_what_an_engines_name_says_stands_in_the_verdict():
    right, wrong = (
        check(f"In the in-line four $\\sum \\cos 2\\alpha_i = {value}$.\n", {}).verdicts[0]
        for value in (4, 2)
    )
    said = "the cranks are at 0°, 180°, 180°, 0°, as is usual for the engine that line 1 names"
    assert right.assumption == said
    assert wrong.reason == f"if {said}"


@pytest.mark.parametrize("order", [1, 2, 3, 4])
def test_the_torques_orders_are_those_of_the_motion(order):
    ratio, count = 0.25, 4000
    total = 0.0
    for k in range(count):
        theta = 2 * pi * k / count
        root = sqrt(1 - ratio**2 * sin(theta) ** 2)
        rate = sin(theta) + ratio * sin(theta) * cos(theta) / root
        above = ratio * cos(2 * theta) / root + ratio**3 * sin(2 * theta) ** 2 / (4 * root**3)
        total -= (cos(theta) + above) * rate * sin(order * theta)
    terms = torque_terms(LibraryEngines(), order, 15)
    series = sum(float(c) * ratio**p for p, c in terms.items())
    assert series == pytest.approx(-2 * total / count, abs=1e-8)
    leading = {1: Fraction(-1, 4), 2: Fraction(1, 2), 3: Fraction(3, 4), 4: Fraction(1, 4)}
    assert terms[min(terms)] == leading[order]
