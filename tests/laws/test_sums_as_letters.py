"""Identities of sums over cylinders that nobody lists hold for any, and fail for any."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

Z = "With $Z_n = \\sum_{i=1}^N e^{jn\\alpha_i}$ and $W_n = \\sum_{i=1}^N z_i e^{jn\\alpha_i}$ we have "
PARTS = (
    "$C_n = \\sum_i\\cos n\\alpha_i$ and $S_n = \\sum_i\\sin n\\alpha_i$,"
    " $Z_n = \\sum_i e^{jn\\alpha_i}$. "
)
SUM = "\\sum_{i=1}^N"
TURNED = f"$${SUM} F\\cos(\\theta+\\delta_i) = F\\cos\\theta{SUM}\\cos\\delta_i"
RIGHT = [
    Z + f"$${SUM} \\cos n(\\theta+\\alpha_i) = \\Re(e^{{jn\\theta}} Z_n)$$",
    Z + f"$${SUM} \\sin n(\\theta+\\alpha_i) = \\Im(e^{{jn\\theta}} Z_n)$$",
    Z + f"$${SUM} z_i\\cos n(\\theta+\\alpha_i) = \\Re(e^{{jn\\theta}} W_n)$$",
    Z + f"$${SUM} \\cos n(\\theta-\\alpha_i) = \\Re(e^{{jn\\theta}} \\bar Z_n)$$",
    PARTS + "$$\\Re(e^{jn\\theta} Z_n) = C_n\\cos n\\theta - S_n\\sin n\\theta$$",
    PARTS + "$$|Z_n|^2 = C_n^2 + S_n^2$$",
    PARTS + "$$\\sum_i \\cos n(\\theta+\\alpha_i) = C_n\\cos n\\theta - S_n\\sin n\\theta$$",
    TURNED + f" - F\\sin\\theta{SUM}\\sin\\delta_i$$",
]
WRONG = [
    Z + f"$${SUM} \\cos n(\\theta+\\alpha_i) = \\Im(e^{{jn\\theta}} Z_n)$$",
    Z + f"$${SUM} \\cos n(\\theta-\\alpha_i) = \\Re(e^{{jn\\theta}} Z_n)$$",
    PARTS + "$$\\Re(e^{jn\\theta} Z_n) = C_n\\cos n\\theta + S_n\\sin n\\theta$$",
    PARTS + "$$|Z_n|^2 = C_n^2 - S_n^2$$",
    PARTS + "$$\\sum_i \\cos n(\\theta+\\alpha_i) = C_n\\sin n\\theta - S_n\\cos n\\theta$$",
    TURNED + f" + F\\sin\\theta{SUM}\\sin\\delta_i$$",
]


def _last(tmp_path, text):
    page = tmp_path / "page.md"
    page.write_text(f"{text}\n", encoding="utf-8")
    return check(page, fixes=False).verdicts[-1]


@pytest.mark.parametrize("text", RIGHT)
def test_what_holds_for_any_cylinders_is_proved(tmp_path, text):
    assert _last(tmp_path, text).verdict in ("holds", "conditional")


@pytest.mark.parametrize("text", WRONG)
def test_what_fails_for_them_is_refuted(tmp_path, text):
    verdict = _last(tmp_path, text)
    assert verdict.verdict == "refuted"


def test_a_sum_that_is_said_to_vanish_is_left_open(tmp_path):
    assert _last(tmp_path, PARTS + "$$C_n\\cos n\\theta = 0$$").verdict == "undecided"


def test_a_letter_that_only_one_side_carries_leaves_it_open(tmp_path):
    text = Z + f"$${SUM} z_i\\cos n(\\theta+\\alpha_i) = \\Re(e^{{jn\\theta}} Z_n)$$"
    assert _last(tmp_path, text).verdict in ("undecided", "refuted")


@pytest.mark.parametrize("claim", ["|Z_n|^2 = Z_n^2", "|Z_n| = Z_n", "|Z_n|^2 = Z_n Z_n"])
def test_a_sum_of_phasors_is_not_taken_as_positive(tmp_path, claim):
    assert _last(tmp_path, PARTS + f"$${claim}$$").verdict == "refuted"
