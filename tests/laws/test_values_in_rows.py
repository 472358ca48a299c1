"""Listed values, multiples by a proportion and cases side by side are judged by what they are of."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from tests.checked_pages import last_verdict

PAGES = [
    ("$y = 2x + 1$. For $x = 1, 2, 3$ we get $y = ?$.", "3, 5, 7", "3, 5, 8"),
    ("$y = x/3$. For $x = 1, 2, 3$ we get $y = ?$.", "0.33, 0.67, 1", "0.33, 0.57, 1"),
    ("$y = 2x + 1$. Für $x = 1; 2; 3$ wird $y = ?$.", "3; 5; 7", "3; 5; 8"),
    ("$y = a x$, $a = 2$. For $x = 1, 2, 3$, $y = ?$.", "2, 4, 6", "2, 4, 5"),
    ("$A \\propto d^2$. With $d_2 = 2d_1$ we get $A_2 = ? A_1$.", "4", "2"),
    ("$F \\propto m\\omega^2$. With $\\omega_2 = 2\\omega_1$: $F_2/F_1 = ?$.", "4", "2"),
    (
        "$F \\propto m\\omega^2$. With $\\omega_2 = 2\\omega_1$ and $m_2 = 0.5 m_1$: $F_2 = ?F_1$.",
        "2",
        "4",
    ),
    ("$f \\propto \\sqrt{k}$. With $k_2 = 2k_1$ we get $f_2 = ? f_1$.", "1.41", "2"),
    ("$t \\propto 1/v$. With $v_2 = 2v_1$ we get $t_2 = ? t_1$.", "0.5", "2"),
    ("$y = 2x + 1$. $x = 1$: $y = 3$. $x = 2$: $y = ?$.", "5", "6"),
    ("$z = 2x + 2$. With $x = 2$, $z = 6$. But $x = 5$ gives $z = ?$.", "12", "6"),
    ("$z = 2x + 2$. Mit $x = 2$ wird $z = 6$. Aber $x = 5$ ergibt $z = ?$.", "12", "6"),
    (
        "With $r = 40$ mm: $s = 2r = 80$ mm and $A = s^2 = 6400$ mm².\n"
        "In the second case $r = 50$ mm, $A = ?$ mm².",
        "10000",
        "6400",
    ),
    (
        "With $r = 40$ mm: $s = 2r = 80$ mm and $A = s^2 = 6400$ mm². "
        "Instead $r = 50$ mm gives $A = ?$ mm².",
        "10000",
        "6400",
    ),
    (
        "With $r = 40$ mm: $s = 2r = 80$ mm and $A = s^2 = 6400$ mm². "
        "The other engine has $r = 50$ mm and $A = ?$ mm².",
        "10000",
        "6400",
    ),
]
NOT_ACCUSED = [
    "$y = a x$. For $x = 1, 2, 3$, $y = 2, 4, 6$.",
    "$y = 2x + 1$. For $x = 1, 2, 3$ we get $y = 3, 5$.",
    "$y = 2x + 1$. For $x = 1, 2$ and $3$ we get $y = 3, 5$ and $7$.",
    "$F \\propto m\\omega^2$, $m_1 = 3$, $m_2 = 6$. With $\\omega_2 = 2\\omega_1$: $F_2 = 8F_1$.",
    "With $r = 40$ mm, $b = 2$ mm: $A = rb = 80$ mm². "
    "The other engine has $r = 50$ mm and $A = 150$ mm².",
]


@pytest.mark.parametrize(("page", "right", "wrong"), PAGES)
def test_each_is_judged_by_its_own(tmp_path, page, right, wrong):
    assert last_verdict(tmp_path, page.replace("?", right)) in ("holds", "holds_to_order", "conditional")
    assert last_verdict(tmp_path, page.replace("?", wrong)) == "refuted"


@pytest.mark.parametrize("page", NOT_ACCUSED)
def test_what_is_not_told_is_not_judged(tmp_path, page):
    assert last_verdict(tmp_path, page) in ("range", "definition", "premise")


def test_numbers_that_head_their_results_are_cases(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("$y = 2x + 1$. $x = 1$: $y = 3$. $x = 2$: $y = 5$. $x = 3$: $y = 7$.")
    words = [verdict.verdict for verdict in check(page).verdicts]
    assert words == ["definition", "definition", "holds", "premise", "holds", "premise", "holds"]
