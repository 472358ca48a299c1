r"""Letters in a row before one bound, m, n \ge 1: each of them has it."""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_LETTER = r"(?:\\[a-z]{2,8}(?![A-Za-z])|[A-Za-z\u03b1-\u03c9](?![A-Za-z]))(?:_\{\w{1,6}\}|_\w|[₀-₉])?"
_BOUND = re.compile(
    rf"(?<![\w\\}}^,.)])(?P<first>{_LETTER})\s*,\s*(?P<more>(?:{_LETTER}\s*,\s*)?{_LETTER})\s*"
    r"(?P<sign>\\(?:geq?|leq?|neq?|ne|gt|lt|gg|ll)(?![A-Za-z])|>=|<=|!=|[<>≥≤≠])\s*(?P<value>[-−]?(?:[0-9]+(?:\.[0-9]+)?|[A-Z]))"
    r"(?=\s*(?:\$|\\\)|\\\]|\\\\|[.,;:)](?![0-9])|\n|$))"
)
_SEPARATED = re.compile(r"(?:[$(;:\n]|\\q?quad|\\[,;: (]|^|[A-Za-z]{2,}\}?|[，、。：])\s*$")


def with_bounds_of_each(text: str) -> Rewritten | None:
    r"""Return a text with such a bound for each letter, None where there are none.

    >>> with_bounds_of_each(r"for $m,n\ge1$.").text
    'for $m\\ge1, n\\ge1$.'
    >>> with_bounds_of_each("$F = m, n > 1$") is None
    True
    """
    rewriter, changed = Rewriter(text), False
    for match in _BOUND.finditer(text):
        if _SEPARATED.search(text[max(match.start() - 12, 0) : match.start()]) is None:
            continue
        letters = [match["first"], *(part.strip() for part in match["more"].split(","))]
        bound = f"{match['sign']}{match['value']}"
        rewriter.replace(*match.span(), ", ".join(f"{letter}{bound}" for letter in letters))
        changed = True
    return rewriter.finish() if changed else None
