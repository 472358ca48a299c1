"""A ratio of two letters that the next question gives is a datum, with its own number of one of them."""

import pytest

from tests.checked_pages import verdicts_in

FIRST = "# Question 1\n\nCrank radius $r = 50$ mm, rod $l = 200$ mm. The ratio is $n = l/r = 4$.\n\n"
SECOND = r"""# Question 2

A three-cylinder engine has $m = 1.2$ kg, $r = 45$ mm, $l/r = 3.6$ and $\omega = 251.33$ rad/s. So

$$F_S = \frac{m r\omega^2}{l/r} = NUMBER N$$
"""


@pytest.mark.parametrize(("number", "is_right"), [("947.5", True), ("852.8", False), ("1137", False)])
def test_a_ratio_of_the_next_question(number, is_right):
    verdicts = verdicts_in(FIRST + SECOND.replace("NUMBER", number))
    assert verdicts[6] in ("condition", "definition", "premise")
    wanted = (
        ("holds_to_order", "conditional", "holds", "premise")
        if is_right
        else ("refuted", "contradiction")
    )
    assert verdicts[-1] in wanted


def test_a_ratio_of_its_own_question_is_a_claim():
    page = "# Question 1\n\nCrank radius $r = 50$ mm, rod $l = 200$ mm, and $l/r = {0}$."
    assert verdicts_in(page.format("4"))[-1] == "holds"
    assert verdicts_in(page.format("3.6"))[-1] == "refuted"
