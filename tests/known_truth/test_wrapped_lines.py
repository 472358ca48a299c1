"""Formulas in prose that the ends of lines cut in two are read whole, each relation on its own line."""

from __future__ import annotations

import pytest

from symbalance.checking import check as check_with_engines
from symbalance.notes.checking import check

PAGES = [
    (
        "1 + 2 = 3\nG = cos²θ + sin²θ\nG = 1\n",
        [(1, "holds"), (2, "definition"), (3, "holds")],
    ),
    (
        "The torque is then T = 4.69 × 10⁶ ×\n0.00873 = 40.9 × 10³ lb.-in.\n",
        [(1, "definition"), (2, "holds_to_order")],
    ),
    (
        "The torque is then T = 4.69 × 10⁶ ×\n0.00873 = 42.9 × 10³ lb.-in.\n",
        [(1, "definition"), (2, "refuted")],
    ),
    ("The sum is 2 + 3\n+ 4 = 9, and 2 · 3\n· 4 = 24.\n", [(2, "holds"), (3, "holds")]),
    ("The sum is 2 + 3\n+ 4 = 8, and 2 · 3\n· 4 = 23.\n", [(2, "refuted"), (3, "refuted")]),
    ("The difference 5 −\n2 = 3 and 5 −\n2 = 4.\n", [(2, "holds"), (3, "refuted")]),
    (
        "The force is F = m a (cos t +\nq cos 2t), so F/m = a\ncos t + a q cos 2t.\n",
        [(1, "definition"), (2, "holds")],
    ),
    (
        "The force is F = m a (cos t +\nq cos 2t), so F/m = a\ncos t − a q cos 2t.\n",
        [(1, "definition"), (2, "refuted")],
    ),
    (
        "The radius is r = 40\nmm, the rod l = 160\nmm and the speed 3000, so r/l = 0.25.\n",
        [(1, "definition"), (2, "definition"), (3, "holds")],
    ),
    (
        "The forces are\nx = 3 a\ny = 4 a\n\nThe sum is x + y =\n7 a and the product is x y =\n7 a².\n",
        [(2, "definition"), (3, "definition"), (5, "holds"), (6, "refuted")],
    ),
    (
        "The sum is x = 3\n- it is small\n- it is 4 less than 7\n\nThe mass is m = 3\nis small.\n",
        [(1, "definition"), (5, "definition")],
    ),
]


@pytest.mark.parametrize("judge", [check, check_with_engines])
@pytest.mark.parametrize(("page", "words"), PAGES)
def test_a_wrapped_formula_is_read_whole(tmp_path, page, words, judge):
    path = tmp_path / "notes.txt"
    path.write_text(page, encoding="utf-8")
    checked = judge(path, fixes=False)
    assert [(v.line, v.verdict) for v in checked.verdicts] == words


def test_a_refusal_behind_a_wrapped_formula_stands_at_its_own_place(tmp_path):
    path = tmp_path / "notes.txt"
    path.write_text("The sum is 2 +\n3 = 5.\n\nThe value is y = 3 ±± 4.\n", encoding="utf-8")
    (part,) = check(path, fixes=False).derivation.unreadable
    assert (part.line, part.column) == (4, 21)
