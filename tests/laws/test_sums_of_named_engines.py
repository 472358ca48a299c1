"""Sums over the cylinders of an engine that a heading or a sentence names: by its usual cranks."""

from __future__ import annotations

import pytest

import symbalance as sb
from symbalance.notes.checking.verdicts import CONDITIONAL, REFUTED, UNDECIDED

SIX, FOUR, THREE = "## Inline-six\n\n", "## Four-cylinder engine\n\n", "## The inline three\n\n"
RIGHT = [
    SIX + r"$\sum_k \cos(\theta - \gamma_k) = 0$",
    SIX + r"$\sum_{k=1}^{6} z_k\cos(\theta - \gamma_k) = 0$",
    SIX + r"$\sum_k \cos 2(\theta + \gamma_k) = 0$",
    SIX + r"$\sum_k \cos 6(\theta - \gamma_k) = 6\cos 6\theta$",
    r"For the inline six the couples vanish: $\sum_k z_k \cos n(\theta - \gamma_k) = 0$ for every $n$.",
    FOUR + r"$\sum_i \cos\varphi_i = 0$",
    FOUR + r"$\sum_i \cos 2\varphi_i = 4\cos 2\varphi$",
    FOUR + r"$\sum_{i=1}^{4} \cos 2\varphi_i = 4\cos 2\varphi_1$",
    FOUR + r"$\sum_k z_k\sin(\theta-\gamma_k) = 0$",
    THREE + r"$\sum_{i=1}^{3} \sin\alpha_i = 0$",
    THREE + r"$\sum_k z_k\cos 3(\theta - \gamma_k) = 0$",
    r"Der Vierzylinder: $\sum_i \cos\varphi_i = 0$",
    "The four-cylinder engine has cranks at 0°, 180°, 180°, 0°.\n\n"
    + r"$\sum_k z_k\cos(\theta-\gamma_k) = 0$",
]
WRONG = [
    SIX + r"$\sum_k \cos 6(\theta - \gamma_k) = 0$",
    SIX + r"$\sum_k \cos 6(\theta - \gamma_k) = 3\cos 6\theta$",
    FOUR + r"$\sum_i \cos 2\varphi_i = 0$",
    FOUR + r"$\sum_i \cos 2\varphi_i = 2\cos 2\varphi$",
    FOUR + r"$\sum_i \cos 4\varphi_i = 0$",
    FOUR + r"$\sum_{i=1}^{4} \cos 2\varphi_i = -4\cos 2\varphi_1$",
    THREE + r"$\sum_k z_k\cos(\theta - \gamma_k) = 0$",
    THREE + r"$\sum_k \cos 3(\theta - \gamma_k) = 0$",
    r"Der Vierzylinder: $\sum_i \cos 2\varphi_i = 0$",
    "The cranks of the three are at 0°, 120°, 240°.\n\n" + r"$\sum_k z_k\cos(\theta-\gamma_k) = 0$",
]
OPEN = [
    r"The V6: $\sum_k z_k \cos(\theta - \gamma_k) = 0$",
    r"The two-cylinder engine: $\sum_k \cos(\theta - \gamma_k) = 0$",
    r"The six-cylinder engine: $\sum_k \cos(\theta - \gamma_k) = 0$",
    r"The two-stroke four-cylinder engine: $\sum_k \cos 2(\theta - \gamma_k) = 0$",
    r"Compare the inline four with the inline six. $\sum_k \cos(\theta - \gamma_k) = 0$",
    "## Inline-four with balance shafts\n\n" + r"$\sum_k \cos 2(\theta - \gamma_k) = 0$",
    SIX + r"For every order $n$ up to two, $\sum_k \cos n(\theta - \gamma_k) = 0$.",
    SIX + r"$\sum_k m_k \cos(\theta - \gamma_k) = 0$",
    SIX + r"$\sum_k a_k \cos k\theta = 0$",
    FOUR + r"For each pair, $\sum_k \cos 2(\theta - \gamma_k) = 0$.",
]  # fmt: skip


def last_verdict(page: str):
    checked = sb.check(page + "\n", {})
    assert not checked.faults
    return max(checked.verdicts, key=lambda v: (v.line, v.span))


@pytest.mark.parametrize("page", RIGHT)
def test_a_sum_holds_for_the_cranks_of_the_engine_named(page):
    verdict = last_verdict(page)
    assert verdict.verdict == CONDITIONAL
    assert "the cranks are at" in verdict.assumption
    assert ("the cylinders stand at equal distances" in verdict.assumption) == ("z_k" in page)


@pytest.mark.parametrize("page", WRONG)
def test_another_order_or_a_couple_that_is_left_is_refuted(page):
    assert last_verdict(page).verdict == REFUTED


@pytest.mark.parametrize("page", OPEN)
def test_another_arrangement_or_other_letters_are_left_open(page):
    assert last_verdict(page).verdict == UNDECIDED
