"""Right relations that lines above do not fit, and that another case explains: open, and not accused."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import CONTRADICTION, REFUTED, UNDECIDED

OPEN = (
    "Here $d = 30$ mm and $W = \\pi d^3/16$.\n\nWith $W = 2651$ mm³",
    "$N = 60 p/(2\\pi)$ with $p = 1670$ rad/s, $N = 15947$.\n\nThe speed is $N/n$. For $N = 16000$",
    "$m_c = 0.92$ kg, $m_p = 0.68$ kg, $r = 45$ mm. Each web would need\n\n"
    "$$2 m_g r_g = (m_c + m_p) r$$\n\n"
    "For the release the weights are made $2 m_g r_g = (m_c + \\frac12 m_p) r$",
    "The speed in feet per minute is $V = S N/6$. For S = 4.5 in. and N = 3600, $V = 4.5\\times3600/6$",
)
SIZES = "$m = 0.48$ kg, $r = 43$ mm, $a = 82$ mm and $b = 290$ mm"
HALF = f"The condition is $m_A r_A b = \\sqrt{{3}} m r a$.\n\nWith {SIZES} it is $m_A r_A = "
MASSES = "$m_1 = 0.4495$ kg, $m_2 = 0.5275$ kg, $r = 41$ mm and $q = 50$ mm"
SIGN = f"Bei 50 % ist $m_c q = (m_1 - \\tfrac12 m_2) r$.\n\nMit {MASSES} wird $m_c = "
TWINS = (
    "The pins are set apart by $\\delta = 180° - \\gamma$.\n\n"
    "For $\\gamma = 45°$ more. The 52° twins have "
)
FORCE = "Here $U = m r c^2$.\n\nWith $m = 0.62$ kg, $r = 37$ mm and $c = 314$ s⁻¹, $U = "
ANOTHER_FACTOR = (
    HALF + "\\frac{\\sqrt3}{2}\\cdot\\frac{0.48\\cdot0.043\\cdot0.082}{0.290}$",
    HALF + "3\\cdot0.48\\cdot0.043\\cdot0.082/0.290$",
    SIGN + "(0.4495 + 0.2638)\\cdot 41/50$",
    SIGN + "(0.4495 - 0.5275)\\cdot 0.041/0.050$",
    TWINS + "$\\delta = 180° - 2\\cdot 52°$",
    TWINS + "$\\delta = 180° + 52°$",
    FORCE + "\\frac12\\cdot0.62\\cdot0.037\\cdot314^2$",
    FORCE + "-0.62\\cdot0.037\\cdot314^2$",
)
"""Numbers put in with another factor or sign than a formula that only stands there."""
SLIPS_OF_NUMBERS = (
    HALF + "\\sqrt3\\cdot0.84\\cdot0.043\\cdot0.082/0.290$",
    HALF + "\\sqrt3\\cdot0.48\\cdot0.043/0.290$",
    SIGN + "(0.4459 - 0.2638)\\cdot 41/50$",
    SIGN + "(0.4495 - 0.2638)\\cdot 50/41$",
    FORCE + "0.62\\cdot0.037\\cdot314$",
    FORCE + "0.62\\cdot0.073\\cdot314^2$",
)
WRONG = (
    "Here $d = 30$ mm and $W = \\pi d^3/32$.\n\nThis is $W = 2561$ mm³",
    "The speed in feet per minute is $V = S N/6$. For S = 4.5 in. and N = 3600, $V = 4.5\\times3600/8$",
    "$r = 45$ mm, $\\omega = 565$ rad/s and $a = r\\omega^2$. So $a = 45\\cdot 565^2 = 14365125$ m/s²",
)


def last_word(page: str) -> str:
    return max(check(page + "\n", {}).verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize("page", OPEN)
def test_what_another_case_explains_is_open(page):
    assert last_word(page) == UNDECIDED


@pytest.mark.parametrize("page", WRONG)
def test_what_follows_and_is_wrong_is_refuted(page):
    assert last_word(page) == REFUTED


@pytest.mark.parametrize("page", ANOTHER_FACTOR)
def test_between_numbers_and_an_unproved_formula_it_is_open_which_is_wrong(page):
    verdict = max(check(page + "\n", {}).verdicts, key=lambda v: (v.line, v.span))
    assert verdict.verdict == UNDECIDED
    assert verdict.reason == (
        "has another factor or sign than line 1, which nothing proves: one of the two is wrong"
    )


@pytest.mark.parametrize("page", SLIPS_OF_NUMBERS)
def test_a_number_that_is_none_of_the_pages_is_wrong(page):
    assert last_word(page) in (REFUTED, CONTRADICTION)


def test_numbers_against_a_proved_formula_are_wrong():
    page = (
        "# One cylinder\n\nThe first order of the force of inertia is $F = m r ω² \\cos θ$"
        " at the crank angle θ.\n\n"
        "At θ = 0 with $m = 0.62$ kg, $r = 37$ mm and $ω = 314$ s⁻¹ it is"
        " $F = 2\\cdot0.62\\cdot0.037\\cdot314^2$"
    )
    assert last_word(page) in (REFUTED, CONTRADICTION)
