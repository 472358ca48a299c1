"""Two equations of two letters are conditions, and the numbers behind them their solution or refuted."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

WRONG = [
    "$x/y = 2/3$ and $x + y = 10$, so $x = 6$, $y = 4$.",
    "$x : y = 2 : 3$ and $x + y = 10$, so $x = 6$, $y = 4$.",
    "$2x = y$ and $x + y = 9$, so $x = 6$, $y = 3$.",
    "$x - y = 1$ and $x + y = 9$, so $x = 4$, $y = 5$.",
    "From $x + y = 9$ and $x - y = 1$ we get $x = 4$ and $y = 5$.",
    "Aus $x + y = 9$ und $x - y = 1$ folgt $x = 4$ und $y = 5$.",
    "$x + 2y = 9$, $x - y = 3$. Hence $x = 2$, $y = 5$.",
    "$F_A + F_B = 10$ kN and $2 F_A = 3 F_B$, so $F_A = 4$ kN, $F_B = 6$ kN.",
]
RIGHT = [
    "$x/y = 2/3$ and $x + y = 10$, so $x = 4$, $y = 6$.",
    "$x : y = 2 : 3$ and $x + y = 10$, so $x = 4$, $y = 6$.",
    "$2x = y$ and $x + y = 9$, so $x = 3$, $y = 6$.",
    "$x - y = 1$ and $x + y = 9$, so $x = 5$, $y = 4$.",
    "Aus $x + y = 9$ und $x - y = 1$ folgt $x = 5$ und $y = 4$.",
    "$x + y = 9$, $xy = 20$: $x = 4$, $y = 5$.",
    "$3x + 7y = 10$ and $x - y = 3$, so $x = 3.1$, $y = 0.1$.",
    "$F_A + F_B = 10$ kN and $2 F_A = 3 F_B$, so $F_A = 6$ kN, $F_B = 4$ kN.",
    "$x + y = 9$ and $x - y = 1$ for $x = 5$, $y = 4$.",
]
AGAINST = ("refuted", "contradiction")


def _words(folder, text):
    page = folder / "page.md"
    page.write_text(text, encoding="utf-8")
    return [verdict.verdict for verdict in check(page).verdicts]


@pytest.mark.parametrize("page", WRONG)
def test_numbers_that_solve_no_system_are_refuted(tmp_path, page):
    words = _words(tmp_path, page)
    assert all(word in AGAINST for word in words[-2:])
    assert not any(word in AGAINST for word in words[:-2])


@pytest.mark.parametrize("page", RIGHT)
def test_a_solved_system_is_not_accused(tmp_path, page):
    assert not any(word in AGAINST for word in _words(tmp_path, page))


def test_numbers_that_are_given_are_no_solution(tmp_path):
    page = "$x + y = 9$ and $x - y = 1$ hold with $x = 4$, $y = 5$."
    assert _words(tmp_path, page)[1:] == ["refuted", "premise", "definition"]
