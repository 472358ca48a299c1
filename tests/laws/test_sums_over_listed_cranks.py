"""Sums over cylinders, Σ cos n θ_i, whose cranks a sentence lists in any language."""

from __future__ import annotations

import pytest

import symbalance as sb
from symbalance.notes.checking.verdicts import CONDITIONAL, REFUTED, UNDECIDED

PAIRS = "The crank pins are at 0°, 180°, 180°, 0°.\n\n"
ANGLE_ELSEWHERE = r"The acceleration is zero at $\theta_0 \approx 75^\circ$." + "\n\n" + PAIRS
QUARTERS = [
    "The pins are at 0°, 90°, 270°, 180°.",
    "Die Zapfen stehen bei 0°, 90°, 270°, 180°.",
    "Manivelles à 0°, 90°, 270°, 180°.",
    "Manovelle a 0°, 90°, 270°, 180°.",
    "Las muñequillas están a 0°, 90°, 270°, 180°.",
    "ピンは 0°, 90°, 270°, 180°。",
]
LAG = "The crank pins are at 0°, 90°, and $\\theta_i = \\theta - \\delta_i$.\n\n"
SIX = "ピンは 0°, 240°, 120°, 120°, 240°, 0°。3気筒のエンジンを鏡合わせに2つ並べたもの。\n\n"


def last_verdict(page: str):
    checked = sb.check(page + "\n", {})
    assert not checked.faults
    return max(checked.verdicts, key=lambda v: (v.line, v.span))


@pytest.mark.parametrize("words", QUARTERS)
def test_pins_in_any_language_are_cranks(words):
    for formula, verdict in (
        (r"\sum_i \cos 2\theta_i = 0", CONDITIONAL),
        (r"\sum_k \cos 4\theta_k = 4\cos 4\theta", CONDITIONAL),
        (r"\sum_k \cos 4\theta_k = 0", REFUTED),
        (r"\sum_k \cos 4\theta_k = 2\cos 4\theta", REFUTED),
    ):
        assert last_verdict(f"{words}\n\n$${formula}$$").verdict == verdict


@pytest.mark.parametrize(
    ("formula", "verdict"),
    [
        (r"\sum_i \cos\theta_i = 0", CONDITIONAL),
        (r"\sum_i \cos 2\theta_i = 4\cos 2\theta", CONDITIONAL),
        (r"\sum_i \cos 4\theta_i = 0", REFUTED),
    ],
)
def test_an_angle_numbered_nought_is_no_cylinder(formula, verdict):
    assert last_verdict(f"{ANGLE_ELSEWHERE}$${formula}$$").verdict == verdict


@pytest.mark.parametrize(
    ("formula", "verdict"),
    [
        (r"\sum_i \cos\theta_i = \cos\theta + \sin\theta", CONDITIONAL),
        (r"\sum_i \cos\theta_i = \cos\theta - \sin\theta", CONDITIONAL),
        (r"\sum_i \cos\theta_i = 2\cos\theta", REFUTED),
        (r"\sum_i \cos\theta_i = 0", REFUTED),
    ],
)
def test_cranks_may_be_counted_either_way(formula, verdict):
    assert last_verdict(f"The crank pins are at 0°, 90°.\n\n$${formula}$$").verdict == verdict


@pytest.mark.parametrize(
    ("formula", "verdict"),
    [
        (r"\sum_i \cos\theta_i = \cos\theta + \sin\theta", CONDITIONAL),
        (r"\sum_i \cos\theta_i = \cos\theta - \sin\theta", UNDECIDED),
        (r"\sum_k \cos 4\theta_k = 2\cos 4\theta", CONDITIONAL),
        (r"\sum_k \cos 4\theta_k = 4\cos 4\theta", REFUTED),
    ],
)
def test_a_line_says_which_way_they_are_counted(formula, verdict):
    assert last_verdict(f"{LAG}$${formula}$$").verdict == verdict


def test_a_six_may_be_told_as_two_threes():
    assert last_verdict(rf"{SIX}$$\sum_i\cos 6\theta_i = 6\cos 6\theta$$").verdict == CONDITIONAL
    assert last_verdict(rf"{SIX}$$\sum_i\cos 6\theta_i = 3\cos 6\theta$$").verdict == REFUTED
    another = (
        "The pins of the six are at 0°, 240°, 120°, 120°, 240°, 0°. Now the three-cylinder engine:\n\n"
    )
    assert last_verdict(rf"{another}$$\sum_i\cos 6\theta_i = 3\cos 6\theta$$").verdict != REFUTED
