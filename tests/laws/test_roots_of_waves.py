"""The value of a cosine satisfies the equation in it right above, or is wrong."""

import pytest

from tests.checked_pages import last_in

EQUATION = "$2\\lambda\\cos^2\\theta + \\cos\\theta - \\lambda = 0$"
LETTER = "$2\\lambda u^2 + u - \\lambda = 0$ is to be solved, where $u = \\cos\\theta$."


@pytest.mark.parametrize("words", ["so", "The root with $|\\cos\\theta| < 1$ is", "daraus folgt", "d'où"])
@pytest.mark.parametrize("sign", ["+", "\\pm"])
def test_the_root_of_an_equation_in_a_cosine(words, sign):
    page = f"It is greatest where {EQUATION}. {words} $\\cos\\theta = {{}}$."
    right = f"\\frac{{-1 {sign} \\sqrt{{1 + 8\\lambda^2}}}}{{4\\lambda}}"
    assert last_in(page.replace("{}", right)) in ("holds", "conditional")
    assert last_in(page.replace("{}", right.replace("{4", "{2"))) in ("refuted", "contradiction")
    assert last_in(page.replace("{}", right.replace("8", "4"))) in ("refuted", "contradiction")


def test_the_roots_of_a_letter_that_stands_for_a_cosine():
    page = f"{LETTER} The formula gives $u_{{1,2}} = {{}}$."
    right = "\\frac{-1 \\pm \\sqrt{1 + 8\\lambda^2}}{4\\lambda}"
    assert last_in(page.replace("{}", right)) in ("holds", "conditional")
    assert last_in(page.replace("{}", right.replace("+ 8", "- 8"))) == "refuted"
    assert last_in(page.replace("{}", right.replace("-1 ", "1 "))) == "refuted"


def test_for_a_small_ratio_another_value_is_given():
    page = f"It is greatest where {EQUATION}. For small $\\lambda$ roughly $\\cos\\theta = \\lambda$."
    assert last_in(page) not in ("refuted", "holds")
