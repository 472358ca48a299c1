"""Extremes with a space before max and min, β max = 14.5°, put as the letter they are: β_{max}.

Without TeX the subscript is typed on the line. Within a formula, before a relation, the two words can be
nothing else.
"""

from __future__ import annotations

import re

from symbalance.notes.reading.marked_formulas import marked_formulas
from symbalance.notes.reading.rewriting import Rewriter, Rewritten

_APART = re.compile(
    r"(?<![^\W\d]['’])(?<![\w\\}'’])(?P<letter>[α-ωϕϑ]|[A-Zb-z](?:_?[0-9]|[₀-₉])?)[ \t\u00a0](?P<word>max|min)\.?"
    r"(?=[ \t]*(?:=(?![=>])|[≈<>≤≥]))"
)


def with_extremes_apart(text: str) -> Rewritten | None:
    """Return a text with β max as β_{max}, None where there is none.

    >>> with_extremes_apart("sin β max = λ").text
    'sin β_{max} = λ'
    """
    inside = marked_formulas(text)
    rewriter, changed = Rewriter(text), False
    for match in _APART.finditer(text):
        if any(start <= match.start() < end for start, end in inside):
            continue
        rewriter.replace(match.end("letter"), match.end(), "_{", match.span("word"), "}")
        changed = True
    return rewriter.finish() if changed else None
