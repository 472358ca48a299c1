"""A value given for a formula in letters decides what is computed from that formula alone."""

from __future__ import annotations

import pytest

from tests.checked_pages import last_verdict

GAS = (
    r"$p_2 = p_1 (V_1/V_2)^{\kappa}$. With $p_1 = 1$ bar, $V_1/V_2 = 10$, $\kappa = 1.4$: $p_2 = %s$ bar."
)
HEAT = "$T_2 = T_1 (p_2/p_1)^{0.286}$. For $T_1 = 300$ K and $p_2/p_1 = 10$, $T_2 = %s$ K."
OTTO = r"$\eta = 1 - (V_2/V_1)^{0.4}$. $V_1/V_2 = 10$: $\eta = 0.602$. For $V_1/V_2 = 12$: $\eta = %s$."
RATIO = r"Since $\lambda = l/r = 4$, we have $1/\lambda %s$."
RIGHT = [GAS % 25.1, HEAT % 579.6, OTTO % "0.630", RATIO % "< 1/3", RATIO % "= 0.25"]
WRONG = [GAS % 10, HEAT % 600, OTTO % "0.602", RATIO % "> 1/3", RATIO % "= 1/3"]


@pytest.mark.parametrize("page", RIGHT)
def test_right_results_hold(tmp_path, page):
    assert last_verdict(tmp_path, page) in ("holds", "holds_to_order", "conditional")


@pytest.mark.parametrize("page", WRONG)
def test_wrong_results_are_refuted(tmp_path, page):
    assert last_verdict(tmp_path, page) == "refuted"


def test_another_case_of_a_formula_is_no_contradiction(tmp_path):
    page = "$V_1/V_2 = 10$. Here it is small. For $V_1/V_2 = 12$"
    assert last_verdict(tmp_path, page) == "premise"
    assert last_verdict(tmp_path, "$V_1/V_2 = 10$. Hence $V_1/V_2 = 12$.") == "contradiction"
