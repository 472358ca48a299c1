r"""Decimals that recur, 0.8\overline{3}: they are fractions, 5/6, and no product of 0.8 and a mean."""

from __future__ import annotations

from fractions import Fraction

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_RECURRING = re.compile(
    r"(?<![\w.,])(?P<whole>[0-9]{1,9})(?:[.,]|\{,\})(?P<first>[0-9]{0,9})\\(?:overline|bar)\s?"
    r"(?:\{\s?(?P<again>[0-9]{1,9})\s?\}|(?P<digit>[0-9]))"
)


def with_recurring_decimals(text: str) -> Rewritten | None:
    r"""Return a text with such decimals as fractions, None where there are none.

    >>> with_recurring_decimals(r"$x = 0.8\overline{3}$ and $y = 2{,}\bar{6}$").text
    '$x = \\frac{5}{6}$ and $y = \\frac{8}{3}$'
    """
    rewriter, found = Rewriter(text), False
    for match in _RECURRING.finditer(text):
        first, again = match["first"], match["again"] or match["digit"]
        shift, ring = 10 ** len(first), 10 ** len(again) - 1
        value = Fraction(int(match["whole"])) + Fraction(int(first or 0), shift)
        value += Fraction(int(again), shift * ring)
        above, below = value.numerator, value.denominator
        rewriter.replace(match.start(), match.end(), f"\\frac{{{above}}}{{{below}}}")
        found = True
    return rewriter.finish() if found else None
