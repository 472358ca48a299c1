"""A formula is judged at the engine speed that its sentence names, and at no other number."""

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
        SLOW + "例:6000 rpm で $r\\omega = 0.040\\times 628.3$",
    ],
)
def test_another_speed_in_the_sentence_is_that_of_its_formula(page):
    word, assumption = last_verdict(page)
    assert (word, "6000 revolutions per minute" in assumption) == ("conditional", True)


@pytest.mark.parametrize(
    "page",
    [
        SLOW + r"It is $m r\omega^2 = 0.5\cdot 0.040\cdot 628.3^2$.",  # no speed is named
        SLOW + r"At 6000 rpm it is $m r\omega^2 = 0.5\cdot 0.040\cdot 528.3^2$.",
        SLOW + r"At 6000 rpm it is $m r\omega^2 = 0.5\cdot 0.045\cdot 628.3^2$.",
        SLOW + r"At 6000 rpm the force is $m r\omega^2 = 9.70$ kN.",
        LANGSAM + "Bei 6000 U/min ist $ω r = 523,6 · 0,045$.",
        LANGSAM + "Bei 6000 U/min läuft er. Es ist $ω r = 628 · 0,045$.",
    ],
)
def test_other_numbers_are_not_excused(page):
    assert last_verdict(page)[0] in ("refuted", "contradiction", "undecided")
