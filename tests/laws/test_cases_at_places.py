"""What is given by cases has at a number the value of the case that holds there."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")
ABS = "\\begin{cases} x & x \\ge 0 \\\\ -x & x < 0\\end{cases}"
BENT = "\\begin{cases} x^2 & x \\ge 1 \\\\ x & \\text{otherwise}\\end{cases}"


def last_word(page: str) -> str:
    return check(page, fixes=False).data()["links"][-1]["verdict"]


@pytest.mark.parametrize("head", ["f", "f(x)"])
@pytest.mark.parametrize("word", ["Here", "Then", "So"])
@pytest.mark.parametrize(
    ("cases", "place", "right", "wrong"),
    [
        (ABS, "-2", "2", "-2"),
        (ABS, "3", "3", "-3"),
        (BENT, "3", "9", "3"),
        (BENT, "-1", "-1", "1"),
        (BENT, "1", "1", "2"),
    ],
)
def test_the_case_that_holds_at_a_number_gives_the_value(head, word, cases, place, right, wrong):
    page = f"${head} = {cases}$. {word} $f({place}) = "
    assert last_word(page + right + "$.") in PROVED
    assert last_word(page + wrong + "$.") == "refuted"


@pytest.mark.parametrize("word", ["Then", "So", "Also", "Donc"])
def test_a_value_of_a_function_is_no_solution_of_its_equation(word):
    assert last_word(f"$f(x) = x^2$. {word} $f(-2) = 4$.") in PROVED
    assert last_word(f"$f(x) = x^2$. {word} $f(-2) = -4$.") == "refuted"
