"""A result with revolutions in a second stands beside ω = 2πn/60; a wrong one is refuted all the same."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

DATA = (
    "| $V_H$ | $n$ | $p_e$ |\n|---|---|---|\n| 1170 cm³ | 6500 rpm | 10.5 bar |\n\n"
    "$\\omega = \\frac{2\\pi n}{60} = 680.7\\ \\text{s}^{-1}$\n\n"
)


@pytest.mark.parametrize(
    ("number", "word"), [("66.5", "conditional"), ("65.6", "refuted"), ("3.99", "refuted")]
)
def test_power_with_revolutions_in_a_second(tmp_path, number, word):
    page = tmp_path / "page.md"
    page.write_text(
        DATA + f"$$P_e = \\frac{{p_e V_H n}}{{2}} = {number}\\ \\text{{kW}}$$\n", encoding="utf-8"
    )
    assert check(page, fixes=False).verdicts[-1].verdict == word


@pytest.mark.parametrize(
    ("words", "word"),
    [
        ("rod ratio $\\lambda$ (crank radius over rod length)", "conditional"),
        ("rod ratio $\\lambda$ (rod length over crank radius)", "refuted"),
    ],
)
def test_a_bracket_behind_a_letter_says_which_ratio_it_is(tmp_path, words, word):
    page = tmp_path / "page.md"
    text = f"Crank radius $r$, rod length $l$, {words}, crank angle $\\varphi$.\n\n"
    text += "The piston acceleration is $a = r\\omega^2(\\cos\\varphi + \\lambda\\cos 2\\varphi)$.\n"
    page.write_text(text, encoding="utf-8")
    assert check(page, fixes=False).verdicts[-1].verdict == word


@pytest.mark.parametrize("rate", ["", ", $\\omega = 2\\pi n/60$"])
@pytest.mark.parametrize(("number", "is_right"), [("50", True), ("0.833", False), ("3000", False)])
def test_no_result_is_divided_by_sixty_twice(tmp_path, rate, number, is_right):
    page = tmp_path / "page.md"
    text = f"$n = 3000$ rpm, $p = 10$ bar, $V = 2$ dm³{rate}.\n\n$P = p V n/2 = {number}$ kW\n"
    page.write_text(text, encoding="utf-8")
    word = check(page, fixes=False).verdicts[-1].verdict
    assert word != "refuted" if is_right else word in ("refuted", "undecided")
