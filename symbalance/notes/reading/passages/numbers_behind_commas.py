"""Where a formula of prose ends before a comma and a number of the words behind: A = 0.32, 2.5 % more."""

from __future__ import annotations

from symbalance.notes.reading.signs import RELATION
from symbalance.text import lazy_patterns as re

_NUMBER_LAST = re.compile(r",\s+[-−+±~≈]?[0-9]+(?:[.,][0-9]+)?\s?%?\s*$")
_WORD_BEHIND = re.compile(
    r"\s*(?!(?:plus|minus|times|mal|durch|over|and|or|und|oder|et|ou|y|o|degrees?|Grad)(?![^\W\d_]))[^\W\d_]{2}"
)
_MARGIN = 24
"""Characters of a comma, a number and its percent sign, with room to spare."""


def before_next_number(text: str, start: int, end: int) -> int:
    """Return where a relation ends before a comma and a number that the words behind are about.

    A list of numbers, 0, 120, 240, stays whole: a word of a unit may stand behind its last.

    >>> text = "A = 0.321, 2.5 % more"
    >>> text[: before_next_number(text, 0, 16)]
    'A = 0.321'
    >>> before_next_number("alpha = 0, 120, 240 in turn", 0, 19)
    19
    """
    match = _NUMBER_LAST.search(text, max(start, end - _MARGIN), end)
    if match is None or _WORD_BEHIND.match(text, end) is None:
        return end
    relations = list(RELATION.finditer(text, start, match.start()))
    if not relations or "," in text[relations[-1].end() : match.start()]:
        return end
    return match.start()
