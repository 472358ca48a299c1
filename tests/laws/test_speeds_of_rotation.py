"""A speed of rotation with the letter of an angular speed is that, unless it counts by the minute."""

import pytest

from symbalance.notes.checking import check

PAGE = "$$F = -m\\ddot x \\approx m R\\Omega^2(\\cos\\alpha + \\lambda\\cos 2\\alpha)$$\n"
LETTERS = {
    "R": "crank radius",
    "lambda": "crank ratio r/l",
    "alpha": "crank angle",
    "m": "reciprocating mass",
}


@pytest.mark.parametrize(
    "meaning",
    [
        "vitesse de rotation du vilebrequin",
        "rotational speed of the crank",
        "Drehgeschwindigkeit",
        "回転速度",
    ],
)
def test_it_is_the_angular_speed(meaning):
    symbols = {**LETTERS, "x": "displacement from top dead centre", "Omega": meaning}
    by_minute = {**symbols, "Omega": f"{meaning} (min)"}
    right, wrong = (check(PAGE.replace("R", r), symbols).verdicts[-1].verdict for r in ("R", "2R"))
    assert right == check(PAGE, {**symbols, "Omega": "angular speed"}).verdicts[-1].verdict
    assert wrong == "refuted"
    assert check(PAGE, by_minute).verdicts[-1].verdict == "refuted"
