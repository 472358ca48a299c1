"""Data that a line gives anew hold for all that follows from them, also where a number stands between."""

from __future__ import annotations

import pytest

from tests.checked_pages import last_verdict

PAGES = [
    ("With $x = 2$: $y = x + 1 = 3$, $z = 2y = 6$. With $x = 5$: $z = ?$.", "12", "6"),
    ("If $x = 2$ then $y = x + 1 = 3$, $z = 2y = 6$. If $x = 5$ then $z = ?$.", "12", "6"),
    ("Let $x = 2$. So $y = x + 1 = 3$, $z = 2y = 6$. Now $x = 5$, so $z = ?$.", "12", "6"),
    ("Mit $x = 2$ wird $y = x + 1 = 3$, $z = 2y = 6$ und mit $x = 5$ $z = ?$.", "12", "6"),
    ("$z = 2y$, $y = x + 1$. With $x = 2$: $y = 3$, $z = 6$. With $x = 5$: $z = ?$.", "12", "6"),
    ("With $x = 2$: $y = x + 1 = 3$, $z = 2y = 6$. With $x = 5$: $y = 6$, $z = ?$.", "12", "6"),
    (
        "With $x = 2$: $y = x + 1 = 3$, $z = 2y = 6$, $w = z - 1 = 5$. With $x = 5$: $w = ?$.",
        "11",
        "5",
    ),
    ("With $x = 2$: $y = x + 1 = 3$ and $2y = 6$. With $x = 5$: $2y = ?$.", "12", "6"),
    (
        "$p = 10$ bar, $A = 50$ cm², $r = 0.04$ m: $F = pA = 5000$ N, $T = Fr = 200$ N m. "
        "With $p = 20$ bar: $T = ?$ N m.",
        "400",
        "200",
    ),
    (
        "For $r = 40$ mm, $s = 2r = 80$ mm and $A = s^2 = 6400$ mm²; for $r = 50$ mm, $A = ?$ mm².",
        "10000",
        "6400",
    ),
]


@pytest.mark.parametrize(("page", "right", "wrong"), PAGES)
def test_what_follows_from_new_data_is_judged_by_them(tmp_path, page, right, wrong):
    assert last_verdict(tmp_path, page.replace("?", right)) in ("holds", "holds_to_order", "conditional")
    assert last_verdict(tmp_path, page.replace("?", wrong)) == "refuted"
