"""A relation is judged by the number that its own sentence gives a letter in words."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import PROVED_WORDS, REFUTED, UNDECIDED

ABOVE = "For the viscous damper $\\mu = 0.4$ and\n\n$$Q = 1+\\frac{2}{\\mu} = 6$$\n\n"
ABOVE_JAPANESE = "粘性ダンパ（慣性の比 $\\mu = 0.4$）では\n\n$$Q = 1+\\frac{2}{\\mu} = 6$$\n\n"
SENTENCES = [
    (
        ABOVE_JAPANESE,
        "ゴムダンパ（ばね付き、$\\mu$ は0.25）であれば、同調比は $1/(1+\\mu) = VALUE$ である。",
    ),
    (ABOVE_JAPANESE, "ゴムダンパ（$\\mu$ が0.25）では $1/(1+\\mu) = VALUE$ である。"),
    (ABOVE_JAPANESE, "ゴムダンパ（$\\mu$ を0.25とする）では $1/(1+\\mu) = VALUE$ である。"),
    (ABOVE, "With a rubber damper (with a spring, $\\mu$ is 0.25) the tuning is $1/(1+\\mu) = VALUE$."),
    (ABOVE, "For a rubber damper with $\\mu$ of 0.25 the tuning is $1/(1+\\mu) = VALUE$."),
    (ABOVE, "Beim Gummidämpfer (mit Feder, $\\mu$ ist 0.25) ist $1/(1+\\mu) = VALUE$."),
    (ABOVE, "Beim Gummidämpfer mit $\\mu$ von 0.25 ist $1/(1+\\mu) = VALUE$."),
    (ABOVE, "Pour l'amortisseur en caoutchouc ($\\mu$ vaut 0.25) on a $1/(1+\\mu) = VALUE$."),
    (ABOVE, "Per lo smorzatore di gomma ($\\mu$ è 0.25) si ha $1/(1+\\mu) = VALUE$."),
]


def last(page: str) -> str:
    return max(check(page + "\n", {}).verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize(("above", "sentence"), SENTENCES)
def test_the_number_of_the_sentence_counts(above, sentence):
    assert last(above + sentence.replace("VALUE", "0.8")) in PROVED_WORDS


@pytest.mark.parametrize(("above", "sentence"), SENTENCES)
def test_with_the_number_above_alone_nothing_holds(above, sentence):
    assert last(above + sentence.replace("VALUE", "0.714")) == UNDECIDED
    assert last(above + sentence.replace("VALUE", "0.5")) == REFUTED


@pytest.mark.parametrize("words", ["the largest $\\mu$ is 0.25; here", "The mean $\\mu$ is 0.25 and"])
def test_a_largest_or_a_mean_value_is_not_the_letters(words):
    assert last(f"{ABOVE}{words} the tuning is $1/(1+\\mu) = 0.714$.") in PROVED_WORDS


def test_a_size_with_its_unit_counts_too():
    page = "With $r = 40$ mm, $V = 2 r A$.\n\nIn the other engine the radius $r$ is 45 mm,"
    page += " so $2r = VALUE$ mm."
    assert last(page.replace("VALUE", "90")) in PROVED_WORDS
    assert last(page.replace("VALUE", "80")) not in PROVED_WORDS
