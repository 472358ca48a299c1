"""What a page says in one section of a letter of its own confines that letter, and nothing else there."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check

LETTERS = {"a": "piston acceleration", "r": "crank radius", "l": "rod length", "theta": "crank angle"}


def last_word(text, symbols):
    return max(check(text, symbols).verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize(("value", "word"), [("6", "holds"), ("7", "refuted")])
def test_a_value_given_beside_an_index_reaches_the_next_section(value, word):
    first = "# First\n\nThe orders are $k = 1, 2, 3, \\dots$\n\n$$\\cos 2\\pi k = 1$$\n\n$$P = 3$$\n"
    text = f"{first}\n# Second\n\n$$2P = {value}$$\n"
    assert last_word(text, {}) == word


@pytest.mark.parametrize(("value", "word"), [("6", "holds"), ("7", "refuted")])
def test_a_value_given_beside_a_letter_used_anew_reaches_the_next_section(value, word):
    text = f"# First\n\nThe pitch is $a = 88$ mm.\n\n$$P = 3$$\n\n# Second\n\n$$2P = {value}$$\n"
    assert last_word(text, LETTERS) == word


def test_what_rests_on_a_letter_used_anew_stays_in_its_section():
    text = "# First\n\nThe pitch is $a = 88$ mm.\n\n$$b = 2 a$$\n\n# Second\n\n$$b = 0.2$$\n"
    assert last_word(text, LETTERS) == "definition"
