"""An engine speed said again in radians: 3000 rpm, that is ω = 314 rad/s, and no other number."""

import pytest

from symbalance.checking import check

RESTATED = [
    "The engine turns at $n = 3000$ rpm, so $\\omega = {}$ rad/s.",
    "At 3000 rpm, i.e. an angular speed $\\omega = {}$ rad/s, it is smooth.",
    "At 3000 rpm ($\\omega = {}$ s$^{{-1}}$) it is smooth.",
    "Die Drehzahl beträgt $n = 3000$ min$^{{-1}}$, also $\\omega = {}$ rad/s.",
    "Le moteur tourne à $N = 3000$ tr/min, soit une vitesse angulaire $\\omega = {}$ rad/s.",
    "Il motore gira a 3000 giri/min, cioè $\\omega = {}$ rad/s.",
    "毎分3000回転、すなわち角速度は $\\omega = {}$ rad/s である。",
]


@pytest.mark.parametrize("text", RESTATED)
@pytest.mark.parametrize("number", ["300", "50", "3000", "628"])
def test_another_number_is_refuted(text, number):
    verdict = check(text.format(number)).verdicts[-1]
    assert (verdict.verdict, "314.2" in verdict.reason) == ("refuted", True)


@pytest.mark.parametrize("text", RESTATED)
@pytest.mark.parametrize("number", ["314", "314.2", "310", "314.159"])
def test_its_own_number_is_not(text, number):
    assert check(text.format(number)).verdicts[-1].verdict != "refuted"


@pytest.mark.parametrize(
    "text",
    [
        "The engine turns at $n = 3000$ rpm; the pump's angular speed is $\\omega = 150$ rad/s.",
        "The engine runs at 3000 rpm and the natural frequency is $\\omega = 300$ rad/s.",
        "Idle is $n = 800$ rpm. At full load $\\omega = 500$ rad/s.",
        "The data are 3000 rpm, $\\Omega = 157$ rad/s.",
    ],
)
def test_the_speed_of_something_else_is_not(text):
    assert check(text).verdicts[-1].verdict != "refuted"
