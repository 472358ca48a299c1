"""An angle may have another value in the next question: by its equation there, or by words for a case."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import CONDITION, FAILING, PREMISE, PROVED_WORDS

FIRST = ["A = 74°", "A = 16°"]
LINKS = ["so", "hence", "i.e.", "also", "d.h.", "donc", "cioè", "ossia", "quindi", "es decir", "すなわち"]
ANGLES = [
    ("cos A = −0.875", "151°", "131°"),
    ("sin A = 0.4", "23.6°", "27.9°"),
    ("tan A = 2.5", "68°", "62°"),
]


def verdicts(page: str) -> list[str]:
    return [v.verdict for v in sorted(check(page + "\n", {}).verdicts, key=lambda v: (v.line, v.span))]


@pytest.mark.parametrize("first", FIRST)
@pytest.mark.parametrize("link", LINKS)
def test_an_angle_solves_the_equation_right_before_it(first, link):
    for equation, right, wrong in ANGLES:
        page = f"{first}\n\nIt is least where\n\n   {equation}, {link} A ≈ "
        assert verdicts(page + right)[-1] in (CONDITION, *PROVED_WORDS)
        assert verdicts(page + wrong)[-1] in FAILING


TWINS = [
    ("For the 45° twin", "For"),
    ("Für den 45°-Motor ist", "Für"),
    ("Pour le bicylindre à 45°", "Pour"),
    ("Per il bicilindrico a 45°", "Per"),
]


@pytest.mark.parametrize(("twin", "words"), TWINS)
@pytest.mark.parametrize("value", ["315", "337.5"])
def test_another_bank_angle_is_another_engines(twin, words, value):
    page = (
        f"{twin}\n\n$$360^\\circ - \\gamma = {value}^\\circ$$\n\n$$\\delta = 180^\\circ - 2\\gamma$$\n\n"
        f"{words} $\\gamma = 52^\\circ$: $\\delta = RESULT^\\circ$."
    )
    right, wrong = (verdicts(page.replace("RESULT", result)) for result in ("76", "67"))
    assert right[-2] == PREMISE
    assert right[-1] in PROVED_WORDS
    assert wrong[-1] not in (*PROVED_WORDS, PREMISE)


@pytest.mark.parametrize("words", ["hence", "so", "also", "donc"])
def test_what_is_said_to_follow_is_no_other_case(words):
    page = f"For the 45° twin $360^\\circ - \\gamma = 315^\\circ$, {words} $\\gamma = 52^\\circ$."
    assert verdicts(page)[-1] in FAILING
