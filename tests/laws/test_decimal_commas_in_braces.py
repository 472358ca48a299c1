r"""A comma in braces, 3{,}162, is a decimal sign where another on the page is, whatever \SI has."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

DATA = r"Gegeben sind \SI{0,65}{\kilogram}, \SI{11,5}{\newton} \SI{4,5}{\meter} und $y = 0{,}3$."
POINTS = r"Given are \SI{0.65}{\kilogram}, \SI{11.5}{\newton}, \SI{4.5}{\meter} and $x = 1.5$."
CASES = [
    (DATA, r"\sqrt{10} \approx 3{,}162", True),
    (DATA, r"\sqrt{10} \approx 3{,}126", False),
    (DATA, r"\sqrt{10} \approx 3162", False),
    (DATA, r"3{,}162 \cdot 0{,}110 \approx \num{0,348}", True),
    (DATA, r"3{,}162 \cdot 0{,}110 \approx \num{348}", False),
    (DATA, r"\sqrt{10} \approx \num{3,162}", True),
    (DATA, r"\num{1,5} \cdot 2 = 3", True),
    (DATA, r"\num{1,5} \cdot 2 = 30", False),
    (POINTS + " $y = 0{,}3$", r"\sqrt{10} \approx 3{,}162", True),  # one brace speaks for the others
    (POINTS, r"1{,}200 \cdot 3 = 3{,}600", True),
    (POINTS, r"40 \cdot 30 = 1{,}200", True),
    (POINTS, r"40 \cdot 30 = 1{,}300", False),
]


@pytest.mark.parametrize(("data", "formula", "is_right"), CASES)
def test_a_comma_in_braces(tmp_path, data, formula, is_right):
    path = tmp_path / "page.tex"
    path.write_text(f"{data}\n\\[ {formula} \\]\n", encoding="utf-8")
    verdict = check(path, fixes=False).verdicts[-1].verdict
    assert verdict.startswith("holds") if is_right else verdict == "refuted"
