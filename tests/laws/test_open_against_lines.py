"""Right relations that lines above do not fit, and that another case explains: open, and not accused."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import REFUTED, UNDECIDED

OPEN = (
    "Here $d = 30$ mm and $W = \\pi d^3/16$.\n\nWith $W = 2651$ mm³",
    "$N = 60 p/(2\\pi)$ with $p = 1670$ rad/s, $N = 15947$.\n\nThe speed is $N/n$. For $N = 16000$",
    "$m_c = 0.92$ kg, $m_p = 0.68$ kg, $r = 45$ mm. Each web would need\n\n"
    "$$2 m_g r_g = (m_c + m_p) r$$\n\n"
    "For the release the weights are made $2 m_g r_g = (m_c + \\frac12 m_p) r$",
    "The speed in feet per minute is $V = S N/6$. For S = 4.5 in. and N = 3600, $V = 4.5\\times3600/6$",
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
