"""The numbers of one row, list item or case are of one engine: its formulas are to be true in it."""

from __future__ import annotations

import pytest

from tests.checked_pages import last_verdict

SYMBOLS = (
    '[symbols]\n"r" = "crank radius"\n"l" = "rod length"\n"lambda" = "crank ratio r/l"\n"s" = "stroke"\n'
    '"n" = "engine speed"\n"omega" = "angular speed"\n'
)
ROWS = "| engine | | | |\n|---|---|---|---|\n| A | $r = 40$ mm | $l = 160$ mm | $\\lambda = 0.25$ |\n"
OMEGA = "$$\\omega = \\frac{2\\pi n}{60}$$\n\n| $n$ | $\\omega$ |\n|---|---|\n"
SPEEDS = OMEGA + "| 1000 rpm | $\\omega = 104.7$ rad/s |\n| 3000 rpm | $\\omega = 314.2$ rad/s |\n"
KEYS = "| 量 | 値 |\n|---|---|\n| クランク半径 | $r = 35$ mm |\n| 連接棒長 | $l = 140$ mm |\n"
COLUMNS = (
    "| | A | B |\n|---|---|---|\n| | $r = 40$ mm | $r = 50$ mm |\n| | $l = 140$ mm | $l = 150$ mm |\n"
)
PAGES = [
    ROWS + "| B | $r = 50$ mm | $l = 160$ mm | $\\lambda = ?$ |",
    "- Motor A: $r = 40$ mm, $l = 140$ mm, $\\lambda = 0{,}286$\n"
    "- Motor B: $r = 50$ mm, $l = 140$ mm, $\\lambda = ?$",
    "1. $r = 30$ mm, $l = 120$ mm, so $\\lambda = 0.25$\n2. $r = 30$ mm, $l = 100$ mm, so $\\lambda = ?$",
    "Moteur A : $r = 40$ mm, $s = 80$ mm.\n\nMoteur B : $r = 45$ mm, $s = ?$ mm.",
    "1. $r = 40$ mm, $s = 80$ mm\n2. $r = 50$ mm, $s = ?$ mm",
    SPEEDS + "| 2000 rpm | $\\omega = ?$ rad/s |",
    KEYS + "| 連桿比 | $\\lambda = ?$ |",
    COLUMNS + "| | $\\lambda = 0.286$ | $\\lambda = ?$ |",
    "$F_2 = \\lambda F_1$ with $F_1 = 3000$ N.\n\n| engine | $\\lambda$ | $F_2$ |\n|---|---|---|\n"
    "| A | $\\lambda = 0.25$ | $F_2 = 750$ N |\n| B | $\\lambda = 0.3$ | $F_2 = ?$ N |",
]
RIGHT = ["0.3125", "0{,}357", "0.3", "90", "100", "209.4", "0.25", "0.333", "900"]
WRONG = ["0.25", "0{,}286", "0.33", "80", "80", "214.4", "0.30", "0.286", "750"]
OF_OTHERS = [
    KEYS + "| short rod | $\\lambda = 0.35$ |\n| long rod | $\\lambda = 0.2$ |",
    "With $r = 40$ mm and $l = 160$ mm:\n\n- engine A: $\\lambda = 0.25$\n- engine B: $\\lambda = 0.3$",
    "- A: $r = 50$ mm, $l = 140$ mm, $\\lambda = 0.357$\n"
    "- B: $r = 40$ mm, $l = 140$ mm, measured $\\lambda = 0.3$",
]


@pytest.mark.parametrize(("page", "number"), [*zip(PAGES, RIGHT, strict=True)])
def test_a_row_that_is_right_stays(tmp_path, page, number):
    assert last_verdict(tmp_path, page.replace("?", number), SYMBOLS) not in (
        "refuted",
        "undecided",
        "contradiction",
    )


@pytest.mark.parametrize(("page", "number"), [*zip(PAGES, WRONG, strict=True)])
def test_a_wrong_number_of_its_row_is_no_new_case(tmp_path, page, number):
    assert last_verdict(tmp_path, page.replace("?", number), SYMBOLS) in (
        "refuted",
        "undecided",
        "contradiction",
    )


@pytest.mark.parametrize("page", OF_OTHERS)
def test_numbers_of_several_things_in_one_list_refute_none(tmp_path, page):
    assert last_verdict(tmp_path, page, SYMBOLS) != "refuted"


def test_a_number_of_a_row_is_not_the_rounded_one_of_the_row_above(tmp_path):
    rows = "| engine | $\\lambda$ |\n|---|---|\n| A | $\\lambda = 0.25$ |\n"
    assert last_verdict(tmp_path, rows + "| B | $\\lambda = 0.3$ |") == "premise"
