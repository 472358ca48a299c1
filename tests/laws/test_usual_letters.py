"""Formulas of letters that nobody explains: a torque, a force or an energy goes with ω²."""

import pytest

from tests.checked_pages import last_verdict

NAMED = [
    ("The inertia torque is", r"T = \frac14 m r^2 \omega{} \sin 2\theta"),
    ("The free couple of first order is", r"M_1 = \sqrt3 m r \omega{} a"),
    (
        "The kinetic energy of the pistons is",
        r"E_2 = \tfrac12 m r^2 \omega{} (\sin^2\theta + \sin^2\phi)",
    ),
    ("Die Massenkraft ist", r"F_1 = m r \omega{} \cos\varphi"),
    ("Das Drehmoment beträgt", r"M_2 = \tfrac12 m r^2 \omega{} \lambda \sin\theta"),
    ("The force on the bearing is", r"F_3 = \frac{{m r \omega{} b}}{{a + b}}"),
]


@pytest.mark.parametrize(("words", "formula"), NAMED)
def test_a_named_size_goes_with_the_square_of_the_speed(tmp_path, words, formula):
    assert last_verdict(tmp_path, f"{words} ${formula.format('^2')}$.") != "refuted"
    assert last_verdict(tmp_path, f"{words} ${formula.format('')}$.") == "refuted"


@pytest.mark.parametrize(
    "page",
    [
        r"The couple over the lever arm is $M_2 = \sqrt3 m r \omega^2$.",
        r"The angular momentum is $M = m r^2 \omega$.",
        r"The damping torque is $T = c r^2 \omega$.",
        r"The torque of the brake with its constant $m$ is $T = m r \omega$.",
    ],
)
def test_what_may_be_of_another_size_is_not_refuted(tmp_path, page):
    assert last_verdict(tmp_path, page) != "refuted"
