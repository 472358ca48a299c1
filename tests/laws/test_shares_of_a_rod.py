"""A mass in two points, by its sum and its centre of gravity: each share goes with the other's lever."""

from __future__ import annotations

import re

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import CONTRADICTION, PROVED_WORDS, REFUTED

FRENCH = (
    "# La bielle\n\nBielle : $m_b = 385$ g, entraxe $l = 138$ mm, $a = 96{,}6$ mm du pied et"
    " $b = l - a = 41{,}4$ mm de la tête.\n\n$$m_A + m_B = m_b, \\qquad m_A a = m_B b$$\n\nd'où "
)
PLAIN = (
    "It has $M = 12$ kg and $l = 900$ mm; its centre is $p = 300$ mm from A and $q = l - p$ from B.\n\n"
    "$$A + B = M, \\quad A p = B q$$\n\nHence "
)
RIGHT = (
    "$m_A = m_b b/l$",
    "$m_B = m_b a/l$",
    "$m_A = m_b b/(a + b)$",
    "$m_A a^2 + m_B b^2 = m_b a b$",
)
WRONG = (
    "$m_A = m_b a/l$",
    "$m_B = m_b b/l$",
    "$m_A = m_b a/(a + b)$",
    "$m_A a^2 + m_B b^2 = m_b a l$",
)


def last_word(page: str) -> str:
    return max(check(page + "\n", {}).verdicts, key=lambda v: (v.line, v.span)).verdict


OTHER_LETTERS = (("m_A", "A"), ("m_B", "B"), ("m_b", "M"), ("a", "p"), ("b", "q"))


def in_other_letters(share: str) -> str:
    words = re.split(r"(m_A|m_B|m_b|[ab])", share)
    return "".join(dict(OTHER_LETTERS).get(word, word) for word in words)


@pytest.mark.parametrize("share", RIGHT)
def test_a_right_share_is_proved(share):
    assert last_word(FRENCH + share) in PROVED_WORDS
    assert last_word(PLAIN + in_other_letters(share)) in PROVED_WORDS


@pytest.mark.parametrize("share", WRONG)
def test_a_share_with_the_own_lever_is_refuted(share):
    assert last_word(FRENCH + share) in (REFUTED, CONTRADICTION)
    assert last_word(PLAIN + in_other_letters(share)) in (REFUTED, CONTRADICTION)
