"""What words lead to is a result of its equation, and a case opens what stands behind it alone."""

import pytest

from tests.checked_pages import verdicts_in

PROVED = ("holds", "holds_to_order", "conditional")


@pytest.mark.parametrize(
    ("page", "right", "wrong"),
    [
        ("$E = a x^2$ with $a = 5$ and $E = 490.5$ gives $x = {}$", "9.9", "8.9"),
        ("$s = \\frac12 g t^2$. $s = 10$ m, $g = 9.81$ m/s². $t = {}$ s.", "1.43", "1.53"),
        ("$v = s/t = 100/5 = 20$ m/s. For $t = 8$ s, $s = {}$ m.", "160", "170"),
        ("$F = kx$; $k = F/x = 30/2 = 15$ N/mm; for $x = 3$ mm, $F = {}$ N.", "45", "46"),
    ],
)
def test_the_last_number_is_the_result(page, right, wrong):
    assert verdicts_in(page.format(right))[-1] in PROVED
    assert not {"refuted", "contradiction"} & {*verdicts_in(page.format(right))}
    assert verdicts_in(page.format(wrong))[-1] in ("refuted", "contradiction", "undecided")


@pytest.mark.parametrize(
    ("page", "right", "wrong"),
    [
        ("$T_2 = T_1 c^{{0.4}}$, $T_1 = 300$ K, $c = 10$. $T_2 = {}$ K.", "754", "755"),
        ("$y = 300 x^{{0.4}}$, $x = 10$. $y = {}$.", "754", "753"),
        ("$y = 100\\sin x$, $x = 20°$. $y = {}$.", "34", "35"),
        ("$y = a/b$, $a = 1000$, $b = 3$. $y = {}$.", "333", "334"),
        (
            "$pV = mRT$. $p = 2$ bar, $m = 1$ kg, $R = 287$ J/(kg K), $V = 0.5$ m³. Hence $T = {}$ K.",
            "348",
            "368",
        ),
    ],
)
def test_a_result_may_be_rounded_to_a_whole_number(page, right, wrong):
    assert verdicts_in(page.format(right))[-1] in PROVED
    assert verdicts_in(page.format(wrong))[-1] in ("refuted", "contradiction", "undecided")


@pytest.mark.parametrize(
    "page", ["$x = 3/2$. $x = 2$.", "$100/3 = 33$", "$n = a/b$, $a = 7$, $b = 2$. $n = 4$."]
)
def test_a_short_whole_number_is_exact(page):
    assert verdicts_in(page)[-1] in ("refuted", "contradiction")


def test_a_number_of_the_letter_i_makes_it_one():
    page = "$J = J_1 + J_2/i^2$ with $J_1 = 0.2$, $J_2 = 0.4$ and $i = 2$: $J = {}$."
    assert verdicts_in(page.format("0.3"))[-1] in PROVED
    assert verdicts_in(page.format("0.1"))[-1] in ("refuted", "contradiction")
