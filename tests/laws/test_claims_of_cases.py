"""An inequality that is claimed of a case right before it is true or false of its number."""

from __future__ import annotations

import pytest

from tests.checked_pages import last_verdict

WRONG = [
    r"If $\lambda = 4$, then $1/\lambda > 1/3$.",
    r"If $\lambda = 4$, then $\lambda > 5$.",
    "Suppose $x = 2$. Then $x^2 > 5$.",
    "Suppose that $n = 3000$ rpm. Then $n > 4000$ rpm.",
    "For $x = 2$ it is $x^2 > 5$.",
    "At $x = 2$ we have $x^2 > 5$.",
    "When $x = 2$, $x^2 > 5$.",
    r"Pour $\lambda = 4$, $1/\lambda > 1/3$.",
    r"Si $\lambda = 4$, alors $1/\lambda > 1/3$.",
    "Für $x = 2$ ist $x^2 > 5$.",
    "Per $x = 2$ si ha $x^2 > 5$.",
    "Para $x = 2$ tenemos $x^2 > 5$.",
    "$x = 2$ のとき $x^2 > 5$.",
    "Suppose $x = 2$. Then $x < 3$ and $x^2 > 5$.",
    "If $x = 2$, then $x^2 < 5$. If $x = 2$, then $x^2 < 3$.",
]
RIGHT = [
    r"If $\lambda = 4$, then $1/\lambda < 1/3$.",
    "For $x = 2$ and $x > 3$ the function is smooth.",
    "For $x = 2$, $y = 4$; for $x > 2$, $y > 4$.",
    "If $x = 2$ or $x > 5$, all is well.",
    "If $x = 2$, then $x^2 < 5$. If $x > 3$, then $x^2 > 9$.",
    "Suppose $x = 2$. Then $x < 3$. For $x > 5$ it is different.",
    r"For $\lambda = 0.25$ the rod is long. $\lambda > 0.3$ is rare.",
    r"For $\lambda = 0$ the motion is a sine; real engines have $\lambda > 0.2$.",
    r"If $\lambda = 0$ the motion is a sine, but real engines have $\lambda > 0.2$.",
]


@pytest.mark.parametrize("page", WRONG)
def test_a_false_claim_is_refuted(tmp_path, page):
    assert last_verdict(tmp_path, page) == "refuted"


@pytest.mark.parametrize("page", RIGHT)
def test_a_true_one_or_another_case_is_not(tmp_path, page):
    assert last_verdict(tmp_path, page) not in ("refuted", "contradiction")
