"""Angles that words alone name: what holds at one of them says nothing of the next."""

import pytest

from symbalance.checking import check

ACCUSED = {"refuted", "contradiction", "undecided"}


def words_of(page: str) -> list[str]:
    return [link["verdict"] for link in check(page).data()["links"]]


TWIN = "F2 = 2*q*F*cos(g/2)*cos(g)*cos(2*phi)\n\n"
WORDS = [
    ("At g = 90° it is zero.", "With 60 degrees:", "With 45 degrees:"),
    ("At g = 90° it is zero.", "For the 60° engine", "For the 45° engine"),
    ("Bei g = 90 Grad ist sie null.", "Mit 60 Grad (in Klammern der Rest):", "Und mit 45 Grad also"),
    ("À g = 90° elle est nulle.", "Pour 60° on a", "Pour 45° on a"),
    ("g = 90° のとき零になる。", "60°の場合、", "45°の場合、"),
]


@pytest.mark.parametrize(("first", "second", "third"), WORDS)
def test_a_result_is_of_the_angle_that_words_named_last(first, second, third):
    above = f"{TWIN}{first}\n\n{second}\n\n   F2 = 2*0.866*0.5*1105 = 957 N\n\n"
    page = above + third + "\n\n   F2 = {} = {} N\n"
    assert not {*words_of(page.format("2*0.924*0.707*1105", 1444))} & ACCUSED
    assert words_of(page.format("2*0.924*0.707*1105", 1544))[-1] == "refuted"


def test_without_another_angle_the_first_one_holds():
    page = TWIN + "At g = 90° it is zero.\n\nWith 90 degrees:\n\n   F2 = 2*0.866*0.5*1105 = 957 N\n"
    assert words_of(page)[-2] in ACCUSED


@pytest.mark.parametrize(
    "line",
    [
        "For 60° d = 40°, for 72° d = 36°.",
        "Für 60 Grad d = 40 Grad, für 72 Grad d = 36 Grad.",
        "At 3000 rpm F = 1974 N, at 4000 rpm F = 3500 N.",
        "Bei 3000 1/min F = 1974 N, bei 4000 1/min F = 3500 N.",
        "With 60 mm x = 3 mm, with 80 mm x = 5 mm.",
    ],
)
def test_a_quantity_behind_for_is_no_factor_of_the_letter(line):
    links = check(line).data()["links"]
    assert [link["left"] in ("d", "F", "x") for link in links] == [True, True]
    assert not {link["verdict"] for link in links} & ACCUSED


def test_a_value_in_brackets_in_the_same_unit_is_another_quantity():
    assert words_of("F = 1.5*3979 = 5969 N (1990 N)") == ["definition", "holds_to_order"]
    assert words_of("F = 1.5*3979 = 5969 N (5.969 kN)")[-1] == "holds"
    assert words_of("F = 1.5*3979 = 5969 N (5.696 kN)")[-1] == "refuted"


EQUAL = [
    r"For $\theta$ equal to $60^\circ$ we find",
    r"When $\theta$ is $60^\circ$ we find",
    r"Für $\theta$ gleich $60^\circ$ ist",
    r"Pour $\theta$ égal à $60^\circ$ on trouve",
    r"Per $\theta$ uguale a $60^\circ$ si ha",
]


@pytest.mark.parametrize("words", EQUAL)
def test_an_angle_may_be_said_to_be_equal_to_its_degrees(words):
    page = rf"$y = \sin\theta$. {words} $y \approx VALUE$."
    assert words_of(page.replace("VALUE", "0.866"))[-1] == "conditional"
    assert words_of(page.replace("VALUE", "0.766"))[-1] == "refuted"


OFFSETS = [
    "For 60° this gives d = {}°, for 72° d = {}° and at 90° d = {}.",
    "Fuer 60 Grad gibt das d = {} Grad, fuer 72 Grad d = {} Grad, und bei 90 Grad ist d = {}.",
    "Pour 60° on a d = {}°, pour 72° d = {}° et pour 90° d = {}.",
    "60°では d = {}°、72°では d = {}°、90°では d = {} となる。",
]


@pytest.mark.parametrize("line", OFFSETS)
@pytest.mark.parametrize("above", ["", "At g = 90° it is a circle.\n\n"])
def test_an_angle_by_its_formula_in_another_one(line, above):
    page = above + "d = 180° - 2*g\n\n"
    assert words_of(page + line.format(60, 36, 0))[-3:] == ["conditional"] * 3
    assert words_of(page + line.format(60, 63, 0))[-3:] == ["conditional", "undecided", "conditional"]


def test_a_list_of_angles_before_a_case_stays_a_list():
    assert words_of("θ = 0°、180°では x = 0 である。") == ["range", "range", "definition"]
