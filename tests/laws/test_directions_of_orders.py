"""The orders of a force are counted in one direction: with F_1 positive, F_4 is negative."""

import pytest

from symbalance.checking import check

SYMBOLS = {
    "m": "reciprocating mass",
    "r": "crank radius",
    "\\omega": "angular speed",
    "\\lambda": "crank ratio r/l",
    "\\theta": "crank angle",
}
FIRST = "The first order force is $F_1 = {}m r\\omega^2\\cos\\theta$. "
SECOND = "The second order force is $F_2 = {}\\lambda m r\\omega^2\\cos 2\\theta$."
FOURTH = (
    "The fourth order force is $F_4 \\approx {}m r\\omega^2 \\frac{{\\lambda^3}}{{4}}\\cos 4\\theta$."
)
SERIES = "The inertia force is $F \\approx {}m r\\omega^2(\\cos\\theta + \\lambda\\cos 2\\theta)$. "


def last_word(page: str) -> str:
    return check(page, SYMBOLS).data()["links"][-1]["verdict"]


@pytest.mark.parametrize("above", [FIRST, SERIES])
@pytest.mark.parametrize("sign", ["", "-"])
def test_an_order_has_the_direction_of_what_stands_above(above, sign):
    other = {"": "-", "-": ""}[sign]
    assert last_word(above.format(sign) + SECOND.format(sign)) == "conditional"
    assert last_word(above.format(sign) + FOURTH.format(other)) == "conditional"
    assert last_word(above.format(sign) + SECOND.format(other)) == "refuted"
    assert last_word(above.format(sign) + FOURTH.format(sign)) == "refuted"


def test_from_the_bottom_the_first_order_has_the_other_sign():
    page = "Angles count from the bottom dead centre. " + FIRST.format("-") + SECOND.format("")
    assert last_word(page) != "refuted"
