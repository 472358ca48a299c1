"""Angles on both sides of ≡ are congruent where they differ by whole turns: 480° ≡ 120°."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import PROVED_WORDS

RIGHT = [
    "The second order has $480° \\equiv 120°$.",
    "The second order has $2\\cdot 240° = 480° \\equiv 120°$ (modulo a full turn).",
    "Die Winkel: $-120^\\circ \\equiv 240^\\circ$.",
    "位相は 1440° ≡ 0° である。",
    "Es ist $\\frac{7\\pi}{3} \\equiv \\frac{\\pi}{3}$.",
    "Also $\\theta + 480° \\equiv \\theta + 120°$.",
]
WRONG = [
    "The second order has $480° \\equiv 240°$.",
    "The second order has $2\\cdot 240° = 480° \\equiv 140°$ (modulo a full turn).",
    "Die Winkel: $-120^\\circ \\equiv 120^\\circ$.",
    "位相は 1440° ≡ 180° である。",
    "Es ist $\\frac{7\\pi}{3} \\equiv \\frac{2\\pi}{3}$.",
    "Also $\\theta + 480° \\equiv \\theta + 240°$.",
    "The second order has $480° = 120°$.",
]


@pytest.mark.parametrize("line", RIGHT)
def test_angles_some_turns_apart_are_congruent(tmp_path, line):
    assert _verdict(tmp_path, line) in PROVED_WORDS


@pytest.mark.parametrize("line", WRONG)
def test_other_angles_are_not(tmp_path, line):
    assert _verdict(tmp_path, line) == "refuted"


def _verdict(folder, line):
    path = folder / "page.md"
    path.write_text(line + "\n", encoding="utf-8")
    return check(path, fixes=False).verdicts[-1].verdict
