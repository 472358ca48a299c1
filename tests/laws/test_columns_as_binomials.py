r"""A column written \binom{a}{b} is a vector where the page shows it, and a coefficient elsewhere."""

from __future__ import annotations

import pytest

from symbalance.notes.checking import check
from symbalance.notes.checking.verdicts import PROVED_WORDS, REFUTED

COLUMNS = [
    (r"\binom{1}{0} + 2\binom{0}{-1} = \binom{1}{-2}", r"\binom{1}{0} + 2\binom{0}{-1} = \binom{1}{2}"),
    (
        r"bF\left[-\tfrac32\binom{1}{0} + \tfrac12\binom{0}{-1} + \tfrac32\binom{-1}{0}\right]"
        r" = bF\binom{-3}{-\tfrac12}",
        r"bF\left[-\tfrac32\binom{1}{0} + \tfrac12\binom{0}{-1} + \tfrac32\binom{-1}{0}\right]"
        r" = bF\binom{-2}{-\tfrac12}",
    ),
    (
        r"\dbinom{\cos 0}{\sin 0} + \dbinom{\cos\pi}{\sin\pi} = \dbinom{0}{0}",
        r"\dbinom{\cos 0}{\sin 0} + \dbinom{\cos\pi}{\sin\pi} = \dbinom{2}{0}",
    ),
]
COEFFICIENTS = [
    (r"\binom{4}{2} = 6", r"\binom{5}{2} = 12"),
    (r"\binom{n}{1} = n", r"\binom{n}{1} = 2n"),
    (r"\binom{-1/2}{2} = \frac38", r"\binom{-1/2}{2} = \frac14"),
]


def last(page: str) -> str:
    return max(check(page + "\n", {}).verdicts, key=lambda v: (v.line, v.span)).verdict


@pytest.mark.parametrize(("right", "wrong"), [*COLUMNS, *COEFFICIENTS])
def test_columns_and_coefficients_are_told_apart(right, wrong):
    assert last(f"$${right}$$") in PROVED_WORDS
    assert last(f"$${wrong}$$") == REFUTED


def test_what_is_said_to_be_a_letter_with_an_arrow_is_a_column():
    page = "$$\\vec M = b\\binom{2}{1} + b\\binom{1}{1} = b\\binom{3}{VALUE}$$"
    assert last(page.replace("VALUE", "2")) in PROVED_WORDS
    assert last(page.replace("VALUE", "1")) == REFUTED
