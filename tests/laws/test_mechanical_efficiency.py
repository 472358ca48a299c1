"""The mechanical efficiency is what friction leaves of the indicated power, and not what it takes."""

from __future__ import annotations

import pytest

from tests.checked_pages import verdicts_of

PAGE = r"The indicated power is $P_i$, the friction power $P_f$ and the brake power $P_b$. "
CASES = [
    (r"The mechanical efficiency is $\eta = \frac{P_b}{P_i}$.", True),
    (r"The mechanical efficiency is $\eta = 1 - \frac{P_f}{P_i}$.", True),
    (r"The share of friction, 1 minus the mechanical efficiency, is $\eta_f = \frac{P_f}{P_i}$.", True),
    (r"The mechanical efficiency is $\eta = \frac{P_f}{P_i}$.", False),
    (r"The mechanical efficiency is $\eta = \frac{P_i}{P_b}$.", False),
]


@pytest.mark.parametrize(("sentence", "is_right"), CASES)
def test_it_is_what_friction_leaves(tmp_path, sentence, is_right):
    assert (verdicts_of(tmp_path, PAGE + sentence)[-1] != "refuted") is is_right
