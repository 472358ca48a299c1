"""Numbers put in for letters are in the unit that the words right before them say: (all in mm)."""

import pytest

import symbalance as sb

GIVEN = "$l = 200$ mm, $r = 50$ mm.\n\n$$s = l + r$$\n\n"
IN_MM = GIVEN + "Plugging in (all in mm):\n\n$$s = 200 + 50 = 250$$\n\n"


def _verdicts(page, line):
    return [each["verdict"] for each in sb.check(page, {}).data()["links"] if each["line"] == line]


@pytest.mark.parametrize(
    "words",
    [
        "Plugging in (all in mm):",
        "With all lengths in mm:",
        "Alles in mm:",
        "Alle Längen in mm gerechnet:",
        "Tout en mm :",
        "Tutto in mm:",
        "Todo en mm:",
        "すべてmmで代入すると",
        "mm単位で計算すると、",
    ],
)
def test_numbers_without_a_unit_are_in_that_of_the_words(words):
    assert _verdicts(f"{GIVEN}{words}\n\n$$s = 200 + 50 = 250$$\n", 7) == ["conditional", "holds"]
    assert _verdicts(f"{GIVEN}{words}\n\n$$s = 200 + 60 = 260$$\n", 7)[0] == "refuted"


@pytest.mark.parametrize("words", ["Plugging in (all in cm):", "Plugging in:", "It is in mm. Now"])
def test_words_of_another_unit_prove_nothing(words):
    assert _verdicts(f"{GIVEN}{words}\n\n$$s = 200 + 50 = 250$$\n", 7)[0] == "undecided"


def test_a_sum_that_is_wrong_in_the_unit_of_the_words_is_refuted():
    assert _verdicts(GIVEN + "All in mm:\n\n$$s = 200 + 50 = 260$$\n", 7)[1] == "refuted"


@pytest.mark.parametrize(("number", "verdict"), [("500 mm", "holds"), ("500 m", "refuted")])
def test_what_the_numbers_come_to_is_a_length_below(number, verdict):
    value, unit = number.split()
    page = IN_MM + f"$$u = 2s = {value}\\text{{ {unit}}}$$\n"
    assert _verdicts(page, 9)[-1] == verdict


def test_the_lines_of_a_display_are_in_the_unit_before_it():
    rows = "\\begin{aligned}\ns &= 200 + 50 \\\\\n &= 250\n\\end{aligned}"
    page = f"{GIVEN}Plugging in (all in mm):\n\n$$\n{rows}\n$$\n"
    assert _verdicts(page, 9) == ["conditional"]
    assert _verdicts(page, 10) == ["holds"]
