r"""Ratios that are written with a colon become quotients: λ = r : l, i = z₁:z₂, 478 : 4 = 119.5.

A colon also stands behind a label and a case ("for θ = 0 : F = 3"), where the French put a space before
it. A ratio stands between two letters or numbers that a relation sets equal to something, with a space on
both sides or on neither.
"""

from __future__ import annotations

import re

from symbalance.notes.reading.rewriting import Rewriter, Rewritten

_INDEX = r"(?:_(?:\{[A-Za-z0-9]{1,4}\}|[A-Za-z0-9])|[₀-₉]{1,2})?"
_LETTER = rf"(?:\\[a-z]{{2,8}}(?![A-Za-z])|[^\W\d_](?![A-Za-zÀ-ÿα-ω])){_INDEX}"
_NUMBER = r"[0-9]{1,6}(?:[.,][0-9]{1,6})?"
_SIGN = r"(?:=|≈|\\approx(?![A-Za-z]))"
_COLON = r"(?P<before>[ ]?):(?P<after>(?P=before))"
_NOT_LONGER = r"(?![\w.,]*\w|[ ]?:)"
"""Behind a ratio: no more of its last number or word, and no third term as in 1 : 2 : 3."""
_RATIO = re.compile(
    rf"{_SIGN}\s*(?:(?P<letters>{_LETTER}){_COLON}{_LETTER}{_NOT_LONGER}(?!\s*{_SIGN})"
    rf"|(?P<numbers>{_NUMBER})(?P<gap>[ ]?):(?P=gap){_NUMBER}{_NOT_LONGER})"
)
_CLOCK = re.compile(r"[0-9]{1,2}:[0-9]{2}(?![0-9])")
_QUOTIENT = re.compile(
    rf"(?<![\w.,:])(?:[0-9]{{3,6}}|[0-9]{{1,6}}[.,][0-9]{{1,6}})(?P<gap>[ ]?):(?P=gap){_NUMBER}"
    rf"{_NOT_LONGER}(?=\s*{_SIGN})"
)
"""A number that is no label's, divided by another, with its result."""


def with_ratios(text: str) -> Rewritten | None:
    r"""Return a text with the colons of ratios as strokes of fractions, None where there are none.

    >>> with_ratios("the ratio λ = r : l of 478 : 4 = 119.5").text
    'the ratio λ = r / l of 478 / 4 = 119.5'
    >>> with_ratios("Pour θ = 0 : F = 3, and a = b: c = d, 1 : 2 : 3 = x") is None
    True
    """
    rewriter, changed = Rewriter(text), False
    for match in sorted((*_RATIO.finditer(text), *_QUOTIENT.finditer(text)), key=lambda m: m.start()):
        place = text.index(":", match.start())
        first = match.start("numbers") if match.re is _RATIO and match["numbers"] else match.start()
        is_case = match.re is _RATIO and match["numbers"] and _opens_case(text, match)
        if place < rewriter.place or _CLOCK.match(text, first) or is_case:
            continue
        rewriter.replace(place, place + 1, "/")
        changed = True
    return rewriter.finish() if changed else None


def _opens_case(text: str, match: re.Match[str]) -> bool:
    """Tell whether a number before a colon may be a case's: θ = 0 : 3 = 3, and not 1 : 4."""
    return float(match["numbers"].replace(",", ".")) == 0 or text[match.end() :].lstrip()[:1] in "+-−*·/"
