"""What is said to vanish in a case of its sentence has to vanish by its formula there."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

FORMULAS = (
    "$\\varepsilon = 0.60$. $X = (1-\\varepsilon)F_1\\cos\\theta + F_2\\cos 2\\theta$ and"
    " $Y = -\\varepsilon F_1\\sin\\theta$.\n\n"
)
SYMBOLS = {"theta": "crank angle", "epsilon": "balance factor", "F_1": "force", "F_2": "force"}
CASES = [
    ("If $\\varepsilon = 1$, then $X = F_2\\cos 2\\theta$ and $Y = 0$.", "refuted"),
    ("If $\\varepsilon = 0$, then $X = F_1\\cos\\theta + F_2\\cos 2\\theta$ and $Y = 0$.", "conditional"),
    ("Wenn $\\varepsilon = 1$ ist, wird $Y = 0$.", "refuted"),
    ("Wenn $\\varepsilon = 0$ ist, wird $Y = 0$.", "conditional"),
    ("もし $\\varepsilon = 1$ まで重くすれば $Y = 0$ となる。", "refuted"),
]


@pytest.mark.parametrize(("sentence", "word"), CASES)
def test_a_letter_said_to_vanish_is_judged_by_its_formula_in_the_case(tmp_path, sentence, word):
    page = tmp_path / "page.md"
    page.write_text(f"{FORMULAS}{sentence}\n", encoding="utf-8")
    assert check(page, SYMBOLS, fixes=False).verdicts[-1].verdict == word
