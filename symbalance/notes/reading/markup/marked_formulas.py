r"""Where a page sets formulas off by TeX's marks: $…$, $$…$$, \(…\), \[…\] and \begin{…}…\end{…}.

Each closing mark is looked for once beyond the last place known: a megabyte of opening marks ends soon.
"""

from __future__ import annotations

import sys
from bisect import bisect_right
from collections.abc import Sequence

from symbalance.notes.reading.rewriting import Span
from symbalance.text import lazy_patterns as re

_OPENING = re.compile(r"\$\$|\$|\\\(|\\\[|\\begin\s*\{([a-z]+\*?)\}")
_CLOSING = {"$$": "$$", "\\(": "\\)", "\\[": "\\]"}
_IN_LINE = re.compile(r"\$[^$\n]{1,400}\$")


def marked_formulas(text: str) -> list[Span]:
    r"""Return where the formulas stand that TeX's marks set off, marks included.

    >>> text = r"the \(a\) of $b$ \[c"
    >>> [text[start:end] for start, end in marked_formulas(text)]
    ['\\(a\\)', '$b$']
    """
    spans: list[Span] = []
    missing: set[str] = set()
    place = 0
    while match := _OPENING.search(text, place):
        end = _end(text, match, missing)
        place = match.end() if end is None else end
        if end is not None:
            spans.append((match.start(), end))
    return spans


def _end(text: str, opening: re.Match[str], missing: set[str]) -> int | None:
    """Return where a formula ends, None where nothing closes it; `missing` marks close no other."""
    if opening[0] == "$":
        in_line = _IN_LINE.match(text, opening.start())
        return in_line.end() if in_line else None
    closing = _CLOSING.get(opening[0]) or f"\\end{{{opening[1]}}}"
    at = -1 if closing in missing else text.find(closing, opening.end())
    if at < 0:
        missing.add(closing)
        return None
    return at + len(closing)


def is_inside(place: int, spans: Sequence[Span]) -> bool:
    """Tell whether a place lies in one of the spans, which are in order.

    >>> is_inside(5, [(1, 3), (4, 6)]), is_inside(3, [(1, 3)])
    (True, False)
    """
    before = bisect_right(spans, (place, sys.maxsize))
    return before > 0 and place < spans[before - 1][1]
