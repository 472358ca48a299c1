"""A formula is judged at the engine speed that its sentence names, and at no other number."""

import re

import pytest

from symbalance.checking import check

SLOW = (
    "At $n = 3000$ rpm the speed is $\\omega = 2\\pi n/60 = 314.2$ rad/s, $r = 40$ mm and"
    " $m = 0.5$ kg.\n\n"
)
LANGSAM = "Bei 3000/min sind ω = 314,2 1/s, r = 0,045 m und R = 0,16 m.\n\n"


def last_verdict(page: str) -> tuple[str, str]:
    verdict = check(page + "\n").verdicts[-1]
    return verdict.verdict, verdict.assumption


@pytest.mark.parametrize(
    "page",
    [
        SLOW + r"At the red line of 6000 rpm it is $m r\omega^2 = 0.5\cdot 0.040\cdot 628.3^2$.",
        SLOW + r"At 6000 rpm the force is $m r\omega^2 = 7.90$ kN.",
        LANGSAM + "Festigkeit bei 6000/min: $ω R = 628,3 · 0,16$.",
        LANGSAM + "Bei 6000 U/min ist $ω r = 628 · 0,045$.",
        LANGSAM + "Bei 6000 U/min läuft er. Es ist $ω r = 628 · 0,045$.",
        SLOW + "例:6000 rpm で $r\\omega = 0.040\\times 628.3$",
    ],
)
def test_another_speed_in_the_sentence_is_that_of_its_formula(page):
    word, assumption = last_verdict(page)
    is_named = re.search("6000 revolutions per minute|“6000 rpm” is n", assumption) is not None
    assert (word, is_named) == ("conditional", True)


@pytest.mark.parametrize(
    "page",
    [
        SLOW + r"It is $m r\omega^2 = 0.5\cdot 0.040\cdot 628.3^2$.",  # no speed is named
        SLOW + r"At 6000 rpm it is $m r\omega^2 = 0.5\cdot 0.040\cdot 528.3^2$.",
        SLOW + r"At 6000 rpm it is $m r\omega^2 = 0.5\cdot 0.045\cdot 628.3^2$.",
        SLOW + r"At 6000 rpm the force is $m r\omega^2 = 9.70$ kN.",
        LANGSAM + "Bei 6000 U/min ist $ω r = 523,6 · 0,045$.",
        LANGSAM + "Bei 6000 U/min läuft er. Es ist $ω r = 682 · 0,045$.",
    ],
)
def test_other_numbers_are_not_excused(page):
    assert last_verdict(page)[0] in ("refuted", "contradiction", "undecided")


GERMAN = (
    "Mit $m_o = 1{,}35$ kg, $r = 62$ mm und $n = 2400$ 1/min ist $\\omega = \\pi n/30 = 251{,}3$ 1/s und"
    " $F_1 = m_o r\\omega^2 = 5{,}29$ kN.\n\n"
)
GROWS = "The free force is $F = 6.2$ kN at 4000 rpm. It goes with the square of the speed.\n\n"


@pytest.mark.parametrize(
    ("page", "right", "wrong"),
    [
        (GERMAN + "Bei halber Drehzahl ist die Kraft erster Ordnung $F_1 = {}$ N.", "1322", "2644"),
        (GERMAN + "Bei halber Drehzahl ist die Kraft erster Ordnung $F_1 = {}$ N.", "5287/4", "5287/2"),
        (GROWS + "At half the speed, $F = {}$ kN.", "6.2/4", "6.2/2"),
        (GROWS + "At 5500 rpm it grows to $F = {}$ kN.", "11.7", "8.53"),
        (
            "La force vaut $F = 3{,}2$ kN à 3000 tr/min. Elle croît avec le carré de la vitesse.\n\n"
            "À 4500 tr/min on a $F = {}$ kN.",
            "7{,}2",
            "4{,}8",
        ),
    ],
)
def test_a_force_at_another_speed_goes_with_its_square(page, right, wrong):
    word, _ = last_verdict(page.replace("{}", right))
    assert word in ("holds", "conditional", "holds_to_order")
    word, _ = last_verdict(page.replace("{}", wrong))
    assert word == "refuted"


def test_where_nothing_says_how_a_couple_grows_it_is_open():
    page = "La coppia è $M = 2 F b$ con $F = 378$ N e $b = 36$ mm, cioè $M = 27{,}2$ N m."
    word, _ = last_verdict(page + " A regime doppio $M = 109$ N m.")
    assert word == "undecided"
