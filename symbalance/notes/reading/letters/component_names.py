"""Components of numbered forces typed on the line: F2x = … makes F2x the letter F_{2x}, not F_2 x."""

from __future__ import annotations

from symbalance.notes.reading.markup.marked_formulas import is_inside, marked_formulas
from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_COMPONENT = re.compile(r"(?<![\w\\^{}$'’])(?P<letter>[A-Z])(?P<script>[0-9][xyzhv])(?![A-Za-z0-9_('’])")
_HEAD_BEHIND = re.compile(r"[ ]?(?:[≈≤≥]|=(?![=>]))")
_OPERATION_BEFORE = re.compile(r"[+\-−*/·×^(][ ]?$|[0-9][ ]?$")


def with_components(text: str) -> Rewritten | None:
    """Return a text with the components that are given a value as letters, None where there are none.

    >>> with_components("F2x = 3, F2y = 0 and F2x² = 9").text
    'F_{2x} = 3, F_{2y} = 0 and F_{2x}² = 9'
    >>> with_components("3 F2x = 6") is None
    True
    """
    inside = marked_formulas(text)
    matches = [m for m in _COMPONENT.finditer(text) if not is_inside(m.start(), inside)]
    heads = {
        match[0]
        for match in matches
        if _HEAD_BEHIND.match(text, match.end())
        and _OPERATION_BEFORE.search(text, max(match.start() - 2, 0), match.start()) is None
    }
    if not heads:
        return None
    rewriter = Rewriter(text)
    for match in matches:
        if match[0] in heads:
            rewriter.replace(match.end("letter"), match.end(), "_{", match.span("script"), "}")
    return rewriter.finish()
