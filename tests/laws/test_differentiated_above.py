"""Formulas that words call the derivative of what stands above, in letters that do not say so."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

PAGE = """The way of the pin is $h = b(1 - \\cos u + \\frac{{q}}{{4}}(1 - \\cos 2u))$.

{words}

$$ g = b w (\\sin u {sign} \\frac{{q}}{{{below}}}\\sin 2u) $$
"""
WORDS = [
    "Differentiate once, with $w$ constant:",
    "Its derivative is",
    "Differentiating, we find",
    "Einmal abgeleitet ergibt das bei konstantem $w$",
    "Durch Differenzieren folgt",
    "En dérivant on trouve",
    "Derivando si ottiene",
    "微分すると",
]


def verdicts_of(tmp_path, text):
    page = tmp_path / "page.md"
    page.write_text(text, encoding="utf-8")
    return [v.verdict for v in sorted(check(page).verdicts, key=lambda v: v.span)]


@pytest.mark.parametrize("words", WORDS)
def test_the_derivative_is_the_one_above(tmp_path, words):
    right = PAGE.format(words=words, sign="+", below="2")
    assert verdicts_of(tmp_path, right)[-1] == "conditional"
    for sign, below in (("+", "1"), ("-", "2"), ("+", "4")):
        wrong = PAGE.format(words=words, sign=sign, below=below)
        assert verdicts_of(tmp_path, wrong)[-1] == "refuted"


@pytest.mark.parametrize(
    "words", ["Another motion is", "The integral is", "Setting the derivative to zero gives"]
)
def test_other_words_say_nothing_of_it(tmp_path, words):
    text = PAGE.format(words=words, sign="+", below="1")
    assert verdicts_of(tmp_path, text)[-1] != "refuted"


def test_a_second_derivative_is_of_the_first_unless_that_is_wrong(tmp_path):
    again = "\nDifferentiate once more:\n\n$$ f = b w^2 (\\cos u + {factor}q\\cos 2u) $$\n"
    for below, factor, expected in (
        ("2", "", ["conditional", "conditional"]),
        ("2", "2", ["conditional", "refuted"]),
        ("1", "", ["refuted", "conditional"]),
    ):
        text = PAGE.format(words="Differentiate:", sign="+", below=below) + again.format(factor=factor)
        assert verdicts_of(tmp_path, text)[-2:] == expected


def test_a_small_term_may_be_left_out(tmp_path):
    text = "$h = b(1 - \\cos u + q\\cos 2u + q^3\\cos 4u)$."
    text += " Its derivative is $g = b w(\\sin u - 2q\\sin 2u)$.\n"
    assert verdicts_of(tmp_path, text)[-1] != "refuted"
