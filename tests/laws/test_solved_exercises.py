"""Equations and inequalities that are solved one after the other are exercises of their own."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

RIGHT = [
    r"$2x > 6 \iff x > 3$. $-2x > 6 \iff x < -3$.",
    "$2x > 6 \\iff x > 3$.\n$-2x > 6 \\iff x < -3$.",
    r"(a) $2x > 6 \iff x > 3$. (b) $-2x > 6 \iff x < -3$.",
    r"$|x| > 3 \iff x > 3$ or $x < -3$. $|x|<2 \iff -2 < x < 2$.",
    r"$2x = 6 \iff x = 3$. $-2x = 6 \iff x = -3$.",
    r"$2x = 6 \Rightarrow x = 3$; $-2x = 6 \Rightarrow x = -3$.",
]
WRONG = [
    r"$2x > 6 \iff x > 3$. $-2x > 6 \iff x < 3$.",
    r"$2x > 6 \iff x > 3$; $-2x > 6 \iff x < -3$; $3x > 6 \iff x > 3$.",
    "$2x = 6 \\Rightarrow x = 3$.\n\n$-2x = 6 \\Rightarrow x = 3$.",
    r"$2x = 6 \Rightarrow x = 3$. $-2x = 6 \Rightarrow x = 3$.",
    "$x > 3$. $-2x > 6$.",
]


@pytest.mark.parametrize("page", RIGHT)
def test_the_one_before_does_not_refute_it(tmp_path, page):
    assert not {"refuted", "contradiction"} & {*verdicts_of(tmp_path, page)}


@pytest.mark.parametrize("page", WRONG)
def test_nor_proves_it(tmp_path, page):
    assert verdicts_of(tmp_path, page)[-1] in ("refuted", "contradiction")
