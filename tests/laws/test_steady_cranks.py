"""The crank turns steadily, whatever letter its angle has: what a page differentiates is judged alike."""

from __future__ import annotations

import pytest

from symbalance.checking import check

LETTERS = [r"\varphi", r"\alpha", r"\psi", r"\gamma", "q"]
NAMED = "Let ${}$ be the crank angle, $r$ the crank radius and $\\omega$ the angular speed.\n"
OF_TWO_TERMS = "$x = r[1 - \\cos @ + \\frac{k}{4}(1 - \\cos 2@)]$ where $k$ is small.\n\n"


def last(text: str, letter: str):
    """Return the verdict on the last relation, with the letter of the angle put in."""
    return check(text.replace("@", letter)).verdicts[-1]


@pytest.mark.parametrize("letter", LETTERS)
def test_a_velocity_is_judged_in_every_letter_of_the_angle(letter):
    page = NAMED.format(letter) + OF_TWO_TERMS
    right = last(page + r"$\dot x = r\omega(\sin @ + \frac{k}{2}\sin 2@)$", letter)
    assert (right.verdict, "= ω is constant" in right.assumption) == ("conditional", True)
    wrong = last(page + r"$\dot x = r\omega(\sin @ + k\sin 2@)$", letter)
    assert (wrong.verdict, "= ω is constant" in wrong.reason) == ("refuted", True)
    assert last(page + r"$\ddot x = r\omega^2(\cos @ + k\cos 2@)$", letter).verdict == "conditional"


@pytest.mark.parametrize("letter", LETTERS[:3])
def test_the_formulas_of_a_page_make_a_letter_its_crank_angle(letter):
    page = OF_TWO_TERMS
    assert last(page + r"$\ddot x = r\omega^2(\cos @ + k\cos 2@)$", letter).verdict == "conditional"
    assert last(page + r"$\ddot x = r\omega^2(\cos @ + 2k\cos 2@)$", letter).verdict == "refuted"


@pytest.mark.parametrize("unsteady", [r"\ddot @ = \epsilon", r"\dot\omega = \epsilon", r"@ = 3 a"])
def test_a_crank_that_the_page_lets_turn_otherwise_is_not_steady(unsteady):
    page = NAMED.format("@") + f"$x = r\\cos @$.\n\n${unsteady}$\n\n$\\ddot x = -r\\omega^2\\cos @$"
    assert "is constant" not in last(page, r"\varphi").assumption


def test_a_phase_is_no_angle_that_turns():
    page = (
        "$x = X\\cos(\\omega t - \\varphi)$ and $P = k\\omega\\cos\\varphi$.\n\n$y = Y\\cos\\varphi$\n\n"
    )
    assert last(page + r"$\dot y = -Y\omega\sin\varphi$", "").verdict == "undecided"
