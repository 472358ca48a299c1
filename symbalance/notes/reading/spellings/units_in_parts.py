"""Quantities in two units, 6 ft. 3 in. and 2 lb. 4 oz., become sums: (6 ft + 3 inch).

Feet and inches may have their marks, 4' 3"; behind a degree these are minutes and seconds of an angle.
"""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_NUMBER = r"[0-9]+(?:[.,·][0-9]+)?[½¼¾⅛⅜⅝⅞]?"
_PAIRS = (
    ("ft", r"(?:ft\.?|feet|foot|[′'’])", "inch", r"(?:ins?\b\.?|inch(?:es)?\b|[″”\"]|'')"),
    ("lb", r"(?:lbs?\b\.?|pounds?)", "oz", r"(?:ozs?\b\.?|ounces?\b)"),
)
_PATTERNS = tuple(
    (
        first,
        second,
        re.compile(
            rf"(?<![\w.,·°^_])(?P<major>{_NUMBER})[ ~]?{whole}[ ,~]{{0,2}}(?:and[ ])?"
            rf"(?P<minor>{_NUMBER})[ ~]?{part}"
        ),
    )
    for first, whole, second, part in _PAIRS
)
_DEGREES_BEFORE = re.compile(r"(?:[°º]|\\circ\s?\}?|\\degree)(?:\s|~|\\[,;: ])?$")
"""What makes of the marks behind it minutes and seconds: 7° 10' 30", 26^\\circ 33' 54''."""
_LONGEST_MARK = 12
"""Characters of a degree mark, with room for the spaces in it: "\\circ }\\, " has nine."""


def with_sums_of_units(text: str) -> Rewritten | None:
    """Return a text with such quantities as sums, None where there are none.

    >>> with_sums_of_units("a = 6 ft. 3 in. = 6.25 ft").text, with_sums_of_units("7° 10' 30\\"")
    ('a = (6 ft + 3 inch) = 6.25 ft', None)
    >>> with_sums_of_units(r"26^{\\circ} 33' 54''") is None
    True
    """
    found = sorted(
        (match.start(), match.end(), f"({match['major']} {first} + {match['minor']} {second})")
        for first, second, pattern in _PATTERNS
        for match in pattern.finditer(text)
        if not _DEGREES_BEFORE.search(text, max(0, match.start() - _LONGEST_MARK), match.start())
    )
    if not found:
        return None
    rewriter = Rewriter(text)
    for start, end, written in found:
        rewriter.replace(start, end, written)
    return rewriter.finish()
