"""A ratio of two largest values is that of the amplitudes which their formulas have."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import CONDITIONAL, PROVED_WORDS, REFUTED

PAGES = [
    (
        "$X = 2F\\cos^2\\frac{\\gamma}{2}\\cos\\theta$ and"
        " $Y = 2F\\sin^2\\frac{\\gamma}{2}\\sin\\theta$.\n\n"
        "The axes are in the ratio\n\n$$\\frac{X_{\\max}}{Y_{\\max}} = RATIO$$",
        ("\\cot^2\\frac{\\gamma}{2}", "\\frac{\\cos^2(\\gamma/2)}{\\sin^2(\\gamma/2)}"),
        ("\\cot\\frac{\\gamma}{2}", "\\tan^2\\frac{\\gamma}{2}"),
    ),
    (
        "Die Kräfte sind $F_1 = m r\\omega^2\\cos\\varphi$ und"
        " $F_2 = \\lambda m r\\omega^2\\cos 2\\varphi$."
        " Es ist $\\hat F_2/\\hat F_1 = RATIO$.",
        ("\\lambda",),
        ("2\\lambda", "\\lambda^2", "\\frac{1}{\\lambda}"),
    ),
    (
        "前後方向の力は $P = a k\\cos\\alpha$、左右方向の力は $Q = b k\\sin\\alpha$。\n\n"
        "$$\\frac{P_{\\max}}{Q_{\\max}} = RATIO$$",
        ("\\frac{a}{b}",),
        ("\\frac{b}{a}", "\\frac{a^2}{b^2}"),
    ),
]


def last(page: str) -> str:
    return max(check(page + "\n", {}).verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize(("page", "right", "wrong"), PAGES)
def test_the_ratio_is_that_of_the_amplitudes(page, right, wrong):
    assert all(last(page.replace("RATIO", ratio)) == CONDITIONAL for ratio in right)
    assert all(last(page.replace("RATIO", ratio)) == REFUTED for ratio in wrong)


def test_a_number_of_letters_without_values_is_no_claim():
    page, _, _ = PAGES[0]
    assert last(page.replace("RATIO", "2.4")) not in (REFUTED, *PROVED_WORDS)
