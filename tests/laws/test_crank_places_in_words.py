"""Results at the crank angle that words name, 30° after top dead centre, are computed there."""

import pytest

from tests.checked_pages import last_verdict

DATA = (
    "The crank radius $r = 40$ mm, rod length $l = 140$ mm, $\\theta$ the crank angle,"
    " $\\beta$ the rod angle.\n\n"
    "$$\\sin\\beta = \\frac{{r}}{{l}} \\sin\\theta$$\n\n{words} the force is $F = 9781$ N.\n\n"
    "$$T = F r \\frac{{\\sin(\\theta+\\beta)}}{{\\cos\\beta}} = {result}\\ \\mathrm{{N\\,m}}$$"
)
PLACES = [
    "At $30^\\circ$ after TDC",
    "At 30° after top dead centre",
    "30 degrees past the top dead center",
    "Bei 30° nach OT",
    "À 30° après le PMH",
    "A 30° dopo il PMS",
    "At a crank angle of 30°",
    "上死点後30°で",
]
PROVED = ("holds", "holds_to_order", "conditional")


@pytest.mark.parametrize("words", PLACES)
@pytest.mark.parametrize(("result", "is_right"), [("244.5", True), ("254.4", False), ("24.45", False)])
def test_a_result_at_the_crank_angle_of_the_words(tmp_path, words, result, is_right):
    verdict = last_verdict(tmp_path, DATA.format(words=words, result=result))
    assert verdict in PROVED if is_right else verdict == "refuted"


@pytest.mark.parametrize(
    "words", ["At 30° before TDC", "At 60° after TDC", "With a valve that opens 30° after it"]
)
def test_at_another_angle_it_does_not_hold(tmp_path, words):
    assert last_verdict(tmp_path, DATA.format(words=words, result="244.5")) not in PROVED


def test_the_angle_of_another_section_is_not_the_one_here(tmp_path):
    page = "At 30° after TDC it is small.\n\n## At the end\n\n" + DATA.format(
        words="There", result="244.5"
    )
    assert last_verdict(tmp_path, page) not in PROVED


def test_an_angle_given_further_up_gives_way_to_that_of_the_words(tmp_path):
    page = DATA.format(words="It is largest at $\\theta = 75.5^\\circ$. At 30° after TDC", result="244.5")
    assert last_verdict(tmp_path, page) in PROVED


def test_an_angle_given_behind_the_words_is_the_one_meant(tmp_path):
    page = DATA.format(words="At 30° after TDC it is small; with $\\theta = 75.5^\\circ$", result="244.5")
    assert last_verdict(tmp_path, page) not in PROVED
