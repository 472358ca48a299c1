"""Which case of a page a line stands in decides which numbers are in force there."""

import pytest

from symbalance.checking import check
from symbalance.notes.checking.words.case_markers import case_marks

ACCUSED = ("refuted", "contradiction")


def words_of(page: str) -> list[str]:
    return [link["verdict"] for link in check(page).data()["links"]]


OPENINGS = [
    ("## Engine A\n\n", "## Engine B\n\n"),
    ("**Motor A**\n\n", "**Motor B**\n\n"),
    ("(a) ", "(b) "),
    ("Beispiel 1: ", "Beispiel 2: "),
    ("Case I. ", "Case II. "),
    ("Honda: ", "Yamaha: "),
    ("例1: ", "例2: "),
    ("- V8: ", "- V6: "),
    ("**Petrol.** ", "**Diesel.** "),
    ("■ 旧型エンジン\n\n", "■ 新型エンジン\n\n"),
    ("◆ Honda\n\n", "◆ Yamaha\n\n"),
    ("【旧型】\n\n", "【新型】\n\n"),
]


@pytest.mark.parametrize(("first", "second"), OPENINGS)
def test_the_second_case_has_its_own_data_and_results(first, second):
    right = f"{first}$s = 88$ mm, so $r = s/2 = 44$ mm.\n\n{second}$s = 84$ mm, so $r = s/2 = 42$ mm.\n"
    assert words_of(right)[3:] == ["premise", "holds", "holds"]
    stale = right.replace("= 42$", "= 44$")
    assert words_of(stale)[3:] == ["premise", "holds", "refuted"]


def test_a_result_without_its_formula_is_judged_by_the_formula_of_the_page():
    page = "**A**\n\n$s = 88$ mm, so $r = s/2 = 44$ mm.\n\n**B**\n\n$s = 84$ mm, so $r = {}$ mm.\n"
    assert words_of(page.format(42))[-1] in ("holds", "holds_to_order")
    assert words_of(page.format(44))[-1] in ACCUSED


def test_what_a_case_does_not_give_anew_is_that_of_the_case_before():
    page = (
        "(a) With $m = 0.5$ kg, $r = 0.04$ m and $\\omega = 300$ 1/s, $F = m r\\omega^2 = 1800$ N.\n\n"
        "(b) With $\\omega = 310$ 1/s, $F = {}$ N.\n"
    )
    assert words_of(page.format(1922))[-1] not in ACCUSED
    assert words_of(page.format(1822))[-1] in ACCUSED


@pytest.mark.parametrize(
    "page",
    [
        "**Radius.** The crank has $r = 40$ mm.\n\n**Speed.** $r = 42$ mm.\n",
        "**Data.** $r = 40$ mm, $s = 80$ mm.\n\n**Check.** $r = 42$ mm, $s = 80$ mm.\n",
    ],
)
def test_steps_of_one_case_keep_its_numbers(page):
    assert any(word in ACCUSED for word in words_of(page))


def test_no_mark_of_a_part_of_one_case_opens_another():
    lines = ["Given: m = 1", "Solution: m = 2", "**Summary**", "Step 2: m = 3", "so that: m = 4"]
    assert list(case_marks(lines, [])) == []


def test_a_place_where_something_is_zero_is_no_datum():
    page = "## Example 1\n\n$a = 3\\cdot 4 = 12$.\n\n## Example 2\n\nIt is largest when $a = 0$.\n"
    assert words_of(page)[-1] not in ACCUSED


def test_signs_right_below_one_another_are_a_list_and_no_headings():
    page = "■ 行程 84 mm\n■ 内径 80 mm\n\n$r = 42$ mm.\n\n$r = {}$ mm.\n"
    assert words_of(page.format(44))[-1] in ACCUSED


@pytest.mark.parametrize("mark", ["## ", "■ ", "== "])
@pytest.mark.parametrize("names", [("Boxer four", "Boxer six"), ("水平対向4気筒", "水平対向6気筒")])
def test_what_the_engine_before_has_is_no_reason_to_leave_another_one_open(mark, names):
    first, second = (f"{mark}{name}{' ==' if mark == '== ' else ''}\n\n" for name in names)
    page = f"{first}$M_2 = 2 q F a \\cos 2\\varphi$\n\n{{}}So $M_1 = M_2 = 0$.\n"
    assert words_of(page.format(second))[-1] == "definition"
    assert words_of(page.format(""))[-1] == "undecided"
