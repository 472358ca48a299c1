"""What words derive from the equation right before it is decided by that equation alone."""

import pytest

from tests.checked_pages import last_in

MOTION = (
    "$$J_1\\ddot\\theta_1 + k(\\theta_1-\\theta_2) = 0$$\n\n"
    "$$J_2\\ddot\\theta_2 + k(\\theta_2-\\theta_1) = 0$$\n\n"
    "In the free mode $J_1\\theta_1 + J_2\\theta_2 = 0$. "
    "Therefore $$\\frac{{\\theta_2}}{{\\theta_1}} = {}$$"
)


@pytest.mark.parametrize(
    ("page", "right", "wrong"),
    [
        (MOTION, "-\\frac{J_1}{J_2}", "-\\frac{J_2}{J_1}"),
        ("The balance is $a x + b y = 0$, hence $y/x = {}$.", "-a/b", "-b/a"),
        (
            "$p + q = l$, $m_1 + m_2 = m$, $m_1 p = m_2 q$. The solution is $$m_1 = {}$$",
            "\\frac{q}{l}m",
            "\\frac{2q}{l}m",
        ),
    ],
)
def test_an_equation_solved_rightly_and_wrongly(page, right, wrong):
    assert last_in(page.format(right)) in ("holds", "conditional")
    assert last_in(page.format(wrong)) == "refuted"
