"""A result goes with the number of its own column, index, turn or case, not with the last one given."""

import pytest

from symbalance.checking import check

PROVED = ("holds", "holds_to_order", "conditional")
ACCUSED = ("refuted", "contradiction")


def words_of(page: str) -> list[str]:
    return [link["verdict"] for link in check(page + "\n", fixes=False).data()["links"]]


TWO = "Motor A: $m = 2$ kg. Motor B: $m = 4$ kg. With $g = 9.81$ m/s² "
STROKES = "Engine 1: $r = 40$ mm. Engine 2: $r = 50$ mm. The strokes are "
CASES = "Case (a): $x = 1$, $y = 2$. Case (b): $x = 3$, $y = 4$. The sum is "
TABLE = (
    "| quantity | A | B |\n|---|---|---|\n| r | $r = 40$ mm | $r = 50$ mm |\n"
    "| speed | $\\omega = 100$ rad/s | $\\omega = 100$ rad/s |\n"
)
RIGHT = [
    TWO + "$G_A = m g = 19.62$ N.",
    TWO + "$G_B = m g = 39.24$ N.",
    STROKES + "$s_1 = 2r = 80$ mm and $s_2 = 2r = 100$ mm.",
    CASES + "$x + y = 3$ in case (a).",
    "For $r = 40$ mm and $r = 50$ mm the stroke is $s = 2r = 80$ mm and $s = 2r = 100$ mm, respectively.",
    "Pour $r = 40$ mm et $r = 50$ mm on a $s = 2r = 80$ mm et $s = 2r = 100$ mm respectivement.",
    TABLE + "| acceleration | $r\\omega^2 = 400$ m/s² | $r\\omega^2 = 500$ m/s² |",
]
WRONG = [
    (TWO + "$G_A = m g = 39.24$ N.", -1),
    (STROKES + "$s_1 = 2r = 100$ mm and $s_2 = 2r = 80$ mm.", -3),
    (CASES + "$x + y = 7$ in case (a).", -1),
    (
        "For $r = 40$ mm and $r = 50$ mm the stroke is $s = 2r = 100$ mm and $s = 2r = 80$ mm,"
        " respectively.",
        -3,
    ),
    (TABLE + "| acceleration | $r\\omega^2 = 500$ m/s² | $r\\omega^2 = 400$ m/s² |", -2),
]


@pytest.mark.parametrize("page", RIGHT)
def test_a_result_of_its_own_number_is_not_accused(page):
    words = words_of(page)
    assert not set(words) & {*ACCUSED, "undecided"}
    assert words[-1] in PROVED


@pytest.mark.parametrize(("page", "place"), WRONG)
def test_a_result_of_another_ones_number_does_not_hold(page, place):
    assert words_of(page)[place] not in PROVED


WIKI = (
    'The mean speed is <math>v = 2CN/60 = CN/30</math>\n\n{| class="wikitable"\n|-\n! Engine !! v\n'
    "|-\n| Saloon || <math>v = 17.6</math> m/s\n|-\n| Diesel || <math>v = 12.7</math> m/s\n"
    "|-\n| Racer || <math>v \\approx 19.8</math> m/s\n|}\n"
)


def test_a_row_of_a_wiki_table_is_another_engine(tmp_path):
    page = tmp_path / "speeds.wiki"
    page.write_text(WIKI, encoding="utf-8")
    assert not {link["verdict"] for link in check(page).data()["links"]} & {*ACCUSED, "undecided"}
    same = WIKI.replace("| Racer ||", "| Diesel ||")
    page.write_text(same, encoding="utf-8")
    assert check(page).data()["links"][-1]["verdict"] in (*ACCUSED, "undecided")
