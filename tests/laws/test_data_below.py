"""A number before its data, in a display with "where" below it, or beside sizes that words alone give."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")
DATA = r"$m = 0.5$ kg, $r = 40$ mm, $\omega = 314.2$ rad/s"
DISPLAYS = (
    "$$F = m r \\omega^2 = %s\\,\\mathrm{N},$$\nwhere DATA.",
    "\\begin{equation}\nF = m r \\omega^2 = %s\\,\\mathrm{N}\n\\end{equation}\nwith DATA.",
    "\\[ F = m r \\omega^2 = %s\\,\\mathrm{N} \\]\nwobei DATA ist.",
    "$$F = m r \\omega^2 = %s\\,\\mathrm{N}$$\n\navec DATA.",
    "$$F = m r \\omega^2 = %s\\,\\mathrm{N}$$\nここで DATA である。",
)
WORDS = (
    "A piston of mass 0.5 kg on a crank of radius 40 mm at 3000 rpm has $F = mr\\omega^2 = %s$ N.",
    "The mass is 0.5 kg, the crank radius 40 mm. At 3000 rpm the force is $F = m r\\omega^2 = %s$ N.",
    "Bei einer Masse von 0,5 kg, einem Kurbelradius von 40 mm und 3000 U/min: $F = mr\\omega^2 = %s$ N.",
    "質量を 0.5 kg、クランク半径を 40 mm、回転数を 3000 rpm とすると、$F = mr\\omega^2 = %s$ N である。",
)


def verdict_of_number(page: str) -> str:
    found = check(page + "\n", fixes=False).data()["links"]
    return found[1]["verdict"]


@pytest.mark.parametrize("display", DISPLAYS)
def test_a_display_is_judged_with_the_data_of_the_clause_below(display):
    page = display.replace("DATA", DATA)
    assert verdict_of_number(page % "1974") in PROVED
    assert verdict_of_number(page % "1794") == "refuted"


@pytest.mark.parametrize("words", WORDS)
def test_a_number_is_judged_with_the_sizes_of_the_words(words):
    assert verdict_of_number(words % "1974") in PROVED
    assert verdict_of_number(words % "1794") == "refuted"


def test_data_of_the_next_sentence_are_of_something_else():
    page = "$$F = m r \\omega^2 = 1794\\,\\mathrm{N}.$$\nLater we take " + DATA + "."
    assert verdict_of_number(page) == "premise"


def test_two_masses_in_words_are_none():
    page = (
        "The rod has a mass of 0.8 kg and the piston a mass of 0.5 kg; the crank radius is 40 mm. "
        r"At 3000 rpm $F = m r\omega^2 = 1794$ N."
    )
    assert verdict_of_number(page) == "premise"
