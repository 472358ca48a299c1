"""A sum over n ≥ 0 or n > 0 is one without end that begins there."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

CASES = [
    (r"\frac{1}{1-x} = \sum_{n\ge 0} x^n", "holds_to_order"),
    (r"\frac{1}{1-x} = \sum_{n \geq 0} x^n", "holds_to_order"),
    (r"\frac{x}{1-x} = \sum_{n\ge 1} x^n", "holds_to_order"),
    (r"\frac{x}{1-x} = \sum_{n>0} x^n", "holds_to_order"),
    (r"\frac{1}{1-x} = \sum_{n\ge 1} x^n", "refuted"),
    (r"\frac{1}{1-x} = \sum_{n>0} x^n", "refuted"),
    (r"\frac{1}{1-x} = \sum_{n\le 3} x^n", "unreadable"),
    (r"\frac{1}{1-x} = \sum_{j<k} x^j", "unreadable"),
]


@pytest.mark.parametrize(("line", "word"), CASES)
def test_a_sum_begins_where_its_range_does(tmp_path, line, word):
    path = tmp_path / "page.md"
    path.write_text(f"The series of $x$:\n\n$$\n{line}\n$$\n", encoding="utf-8")
    assert check(path, fixes=False).verdicts[-1].verdict == word
