"""A spring's two forces are opposite: an equation of motion with one of the wrong sign is refuted."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import FAILING, REFUTED

SYSTEMS = [  # above and below an equation, the equation, and it with a wrong sign
    (
        r"$$J_1\ddot\varphi_1 + c_1(\varphi_1-\varphi_2) = 0$$",
        r"$$J_3\ddot\varphi_3 - c_2(\varphi_2-\varphi_3) = 0$$",
        r"J_2\ddot\varphi_2 - c_1(\varphi_1-\varphi_2) + c_2(\varphi_2-\varphi_3) = 0",
        r"J_2\ddot\varphi_2 - c_1(\varphi_1-\varphi_2) - c_2(\varphi_2-\varphi_3) = 0",
    ),
    ("", r"$$J_2\ddot\psi_2 = k(\psi_1-\psi_2)$$", r"J_1\ddot\psi_1 = -k(\psi_1-\psi_2)",
     r"J_1\ddot\psi_1 = k(\psi_1-\psi_2)"),
    (r"$$m_1\ddot y_1 = -c_1 y_1 + c_2(y_2 - y_1)$$", "", r"m_2\ddot y_2 = -c_2(y_2 - y_1)",
     r"m_2\ddot y_2 = c_2(y_2 - y_1)"),
    ("", r"$$m l^2\ddot\beta = -m g l\beta + k a^2(\alpha-\beta)$$",
     r"m l^2\ddot\alpha = -m g l\alpha - k a^2(\alpha-\beta)",
     r"m l^2\ddot\alpha = -m g l\alpha + k a^2(\alpha-\beta)"),
]  # fmt: skip
GEARS = r"""Zwei Zahnräder, die gegensinnig drehen:

$$J_1\ddot\varphi_1 + c\,r_1(r_1\varphi_1 + r_2\varphi_2) = 0$$

$$J_2\ddot\varphi_2 + c\,r_2(r_1\varphi_1 + r_2\varphi_2) = 0$$
"""


@pytest.mark.parametrize(("above", "below", "right", "wrong"), SYSTEMS)
@pytest.mark.parametrize("words", ["The equations of motion:", "運動方程式は次のとおり。"])
def test_a_spring_that_drives_two_bodies_apart_is_refuted(above, below, right, wrong, words):
    for own, is_right in ((right, True), (wrong, False)):
        page = f"{words}\n\n{above}\n\n$${own}$$\n\n{below}\n"
        checked = check(page, {})
        assert not checked.derivation.unreadable
        line = page[: page.index(own)].count("\n") + 1
        failing = [(v.line, v.verdict) for v in checked.verdicts if v.verdict in FAILING]
        assert failing == ([] if is_right else [(line, REFUTED)])


def test_one_equation_alone_is_not_accused():
    assert not {v.verdict for v in check("$$m\\ddot x = k(x - y)$$\n", {}).verdicts} & {*FAILING}


def test_angles_of_opposite_directions_are_not_accused():
    assert not {v.verdict for v in check(GEARS, {}).verdicts} & {*FAILING}
