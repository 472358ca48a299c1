"""A comma in the brackets of a function of one number is decimal, where others on the page are."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

CASES = [
    ("Alles in Grad: cos(22,5)^2 = 0,854", "holds_to_order"),
    ("Alles in Grad: cos(22,5)^2 = 0,845", "refuted"),
    ("In Grad: sin²(22,5) = 0,146", "holds_to_order"),
    ("Es ist tan(22,5°) = 0,414", "holds_to_order"),
    ("Es ist sqrt(2,25) = 1,5", "holds"),
    ("Es ist sqrt(2,25) = 1,6", "refuted"),
    ("Es ist (1,5)^2 = 2,25", "holds"),
    ("Es ist (1,5)² = 2,5", "refuted"),
    ("Es ist max(1,5) = 5", "holds"),
]


@pytest.mark.parametrize(("line", "word"), CASES)
def test_one_number_in_brackets(tmp_path, line, word):
    path = tmp_path / "page.txt"
    path.write_text(f"Hier ist x = 0,25 und y = 0,75.\n\n{line}\n", encoding="utf-8")
    assert check(path, fixes=False).verdicts[-1].verdict == word
