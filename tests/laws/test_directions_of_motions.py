"""A velocity and the acceleration behind it count in one direction; a force does where words say so."""

import pytest

from tests.checked_pages import last_in

VELOCITY = (
    "$v {} r\\omega\\left(\\sin\\theta+\\frac{\\lambda}{2}\\sin 2\\theta\\right)$, $\\lambda = r/l$."
)
ACCELERATION = "r\\omega^2\\left(\\cos\\theta+\\lambda\\cos 2\\theta\\right)$."
WORDS = [
    ("The velocity of the piston is ", "Its acceleration is therefore "),
    ("Die Kolbengeschwindigkeit ist ", "Die Kolbenbeschleunigung ist somit "),
    ("La vitesse du piston est ", "Son accélération est donc "),
    ("ピストンの速度は ", "したがってピストンの加速度は "),
]


@pytest.mark.parametrize("sign", ["=", "\\approx"])
@pytest.mark.parametrize("words", WORDS, ids=["en", "de", "fr", "ja"])
def test_an_acceleration_has_the_direction_of_the_velocity_before(words, sign):
    page = words[0] + VELOCITY.replace("{}", sign) + " " + words[1]
    assert last_in(f"{page}$a {sign} {ACCELERATION}") == "conditional"
    assert last_in(f"{page}$a {sign} -{ACCELERATION}") == "refuted"


def test_without_a_word_that_it_follows_it_is_open():
    page = f"The velocity of the piston is {VELOCITY.replace('{}', '=')} The piston acceleration is "
    assert last_in(f"{page}$a = -{ACCELERATION}") == "undecided"


def test_a_motion_alone_may_count_in_either_direction():
    assert (
        last_in(f"With $\\lambda = r/l$ the piston acceleration is $a = -{ACCELERATION}") == "conditional"
    )


@pytest.mark.parametrize(
    ("words", "verdict"), [("Forces count in the same direction. ", "refuted"), ("", "conditional")]
)
def test_a_force_is_against_the_acceleration_where_both_count_alike(words, verdict):
    page = f"The piston acceleration is $a = {ACCELERATION} {words}The inertia force is "
    assert last_in(f"{page}$F = -m {ACCELERATION}") == "conditional"
    assert last_in(f"{page}$F = m {ACCELERATION}") == verdict
