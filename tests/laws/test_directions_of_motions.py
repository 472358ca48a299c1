"""A velocity and the acceleration behind it count in one direction; a force does where words say so."""

import pytest

from symbalance.notes.checking import check
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


AGAINST = [
    ("The piston acceleration $a = {}$, $\\lambda = r/l$, is positive towards the crank. "
     "The inertia force is opposite to the acceleration{}, ", " and has the magnitude"),
    ("Die Kolbenbeschleunigung $a = {}$, $\\lambda = r/l$, ist zur Kurbel hin positiv. "
     "Die Massenkraft ist der Beschleunigung entgegengerichtet{}, ", " und hat den Betrag"),
    ("L'accélération du piston $a = {}$, $\\lambda = r/l$, est positive vers la manivelle. "
     "La force d'inertie est opposée à l'accélération{}, ", " et a pour module"),
    ("L'accelerazione del pistone $a = {}$, $\\lambda = r/l$, è positiva verso la manovella. "
     "La forza d'inerzia è opposta all'accelerazione{}, ", " e ha il modulo"),
    ("ピストンの加速度 $a = {}$ はクランクに向かう方向を正とする($\\lambda = r/l$)。"
     "慣性力は加速度と逆向きで{}、", "その大きさは"),
]  # fmt: skip


@pytest.mark.parametrize(("words", "size"), AGAINST, ids=["en", "de", "fr", "it", "ja"])
def test_a_force_said_to_be_against_the_acceleration_has_the_other_sign(words, size):
    formula = ACCELERATION.removesuffix("$.")
    page = words.format(formula, "")
    assert last_in(f"{page}$F = -m {ACCELERATION}") == "conditional"
    assert last_in(f"{page}$F = m {ACCELERATION}") == "refuted"
    assert last_in(f"{words.format(formula, size)}$F = m {ACCELERATION}") == "conditional"
    assert last_in(f"{page}$F = m {ACCELERATION[:-1]}, positive outwards.") == "conditional"


def test_without_a_positive_direction_only_the_size_may_be_meant():
    page = f"The piston acceleration is $a = {ACCELERATION} "
    page += "The inertia force is opposite to the acceleration, "
    assert last_in(f"{page}$F = m {ACCELERATION}") == "conditional"


def test_a_declared_acceleration_counts_too():
    def last(formula: str) -> str:
        verdicts = check(f"{page}{formula}\n", symbols).verdicts
        return max(verdicts, key=lambda v: (v.line, v.span)).verdict

    symbols = {"a": "ピストン加速度 [m/s^2]", "lambda": "r/l [-]", "m": "往復質量 [kg]"}
    page = f"加速度 $a = {ACCELERATION[:-1]} はクランクに向かう向きを正とし、"
    page += "力も同じ向きを正とする。慣性力は "
    assert last(f"$F = -m {ACCELERATION}") == "conditional"
    assert last(f"$F = m {ACCELERATION}") == "refuted"
