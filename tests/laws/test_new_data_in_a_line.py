"""Data that a line gives anew hold for all that follows from them, also where a number stands between."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

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
    ("$y = x^2$, $z = y + 1$. $y = 4$, $z = 5$ at $x = 2$; $z = ?$ at $x = 3$.", "10", "5"),
    ("$y = x + 1 = 3$, $z = 2y = 6$ with $x = 2$.\n\n$z = ?$ with $x = 5$.", "12", "6"),
    ("$z = 2x$. $z = 6$ mit $x = 3$, $z = ?$ mit $x = 5$.", "10", "6"),
    (
        "The laws are $\\omega = 2\\pi n$ and $P = T\\omega$.\nFor $n = 40$ s⁻¹, $T = 100$ N m we get "
        "$\\omega = 251.3$ rad/s and $P = 25133$ W.\nWith the new value $n = 80$ s⁻¹ it is $P = ?$ W.",
        "50265",
        "25133",
    ),
]


@pytest.mark.parametrize(("page", "right", "wrong"), PAGES)
def test_what_follows_from_new_data_is_judged_by_them(tmp_path, page, right, wrong):
    assert _result(tmp_path, page.replace("?", right)) in ("holds", "holds_to_order", "conditional")
    assert _result(tmp_path, page.replace("?", wrong)) == "refuted"


def _result(folder, page):
    """Return the verdict on the last relation, or the one before its datum behind."""
    written = folder / "page.md"
    written.write_text(page, encoding="utf-8")
    return check(written).verdicts[-2 if page.endswith(("$x = 3$.", "$x = 5$.")) else -1].verdict
