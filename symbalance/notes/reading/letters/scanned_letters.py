"""The letter l that a scanner took for the figure 1: the rod 1 = 160 mm, and r/1 = 0.25 with it.

A one that is given a length is no number, and nobody divides by one.
"""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_GIVEN = re.compile(
    r"(?<![\w.,/*·×+−^=(-])(?<![=+*/·×−-]\s)1(?=\s?=\s?[0-9]+(?:[.,][0-9]+)?\s?(?:mm|cm|m|in|inch|inches|ft)\b)"
)
_RATIO = re.compile(
    r"(?<![\w.,])(?P<above>[rRsλ])\s?/\s?1(?![\w.,/^])|(?<![\w.,)/*·×])1\s?/\s?(?P<below>[rs])(?=\s?=\s?[0-9λ])"
)


def with_scanned_letters(text: str) -> tuple[Rewritten | None, tuple[str, ...]]:
    """Return a text with the letter for such ones, None where there are none, and what to say of it.

    >>> done, notes = with_scanned_letters("the rod 1 = 160 mm, so r/1 = 0.25")
    >>> done.text, notes
    ('the rod l = 160 mm, so r/l = 0.25', ('the figure 1 for the letter l (2×)',))
    """
    places = [match.start() for match in _GIVEN.finditer(text)]
    if not places:
        return None, ()
    for match in _RATIO.finditer(text):
        places.append(match.start() if match["below"] else match.end() - 1)
    rewriter = Rewriter(text)
    for place in sorted(places):
        rewriter.replace(place, place + 1, "l")
    return rewriter.finish(), (f"the figure 1 for the letter l ({len(places)}×)",)
