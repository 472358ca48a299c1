"""An order in brackets above a letter, \\hat{F}^{(2)}_x, names another letter, however it is set."""

from __future__ import annotations

from itertools import product

import pytest

from symbalance.notes.checking import check

LETTERS = [
    r"\hat F",
    r"\hat{F}",
    r"\widehat{F}",
    r"{\hat F}",
    r"\tilde{M}",
    r"\overline{M}",
    "{F}",
    r"\bar{p}",
    "F",
]
SCRIPTS = [
    "^{(2)}",
    "^{(2)}_{x}",
    "_{x}^{(2)}",
    r"^{\,(2)}",
    "^{(II)}_1",
    r"^{\left(2\right)}_\mathrm{res}",
]


@pytest.mark.parametrize(("letter", "script"), list(product(LETTERS, SCRIPTS)))
def test_an_order_is_no_power(tmp_path, letter, script):
    below = script.partition("_")[2].partition("^")[0]
    plain = f"{letter}_{below}" if below else letter
    path = tmp_path / "page.md"
    path.write_text(
        f"$${plain} = 3$$\n\n$${letter}{script} = 5$$\n\n"
        f"$$2 {letter}{script} = 10$$\n\n$$2{letter}{script} = 18$$\n",
        encoding="utf-8",
    )
    first, second, right, wrong = (verdict.verdict for verdict in check(path, fixes=False).verdicts)
    assert (first, second, right, wrong) == ("definition", "definition", "holds", "refuted")


def test_a_macro_may_hold_the_order(tmp_path):
    path = tmp_path / "page.tex"
    path.write_text(
        "\\newcommand{\\Fhat}[1]{\\widehat{F}^{(#1)}}\n"
        "$\\Fhat{2}_{6000} = 12.4$\n\n$\\Fhat{2}_{3000} = \\tfrac14\\Fhat{2}_{6000} = 3.1$\n\n"
        "$\\tfrac12\\Fhat{2}_{6000} = 3.1$\n",
        encoding="utf-8",
    )
    words = [verdict.verdict for verdict in check(path, fixes=False).verdicts]
    assert words == ["definition", "definition", "holds", "refuted"]
