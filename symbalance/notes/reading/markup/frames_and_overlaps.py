r"""Frames around formulas and parts set over their neighbours: \boxed{a = b}, \mathclap{k}, \smash[b]{x}.

They say how a formula is set and nothing else, so that what stands in them is read in their place.
"""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.notes.reading.signs import RELATION
from symbalance.text import lazy_patterns as re

_FRAMED = re.compile(
    r"\\(?P<command>boxed|Aboxed|mathclap|mathllap|mathrlap|clap|llap|rlap|smash|vphantom|hphantom|phantom"
    r"|displaylimits|mathstrut)(?![A-Za-z])(?:\s?\[[tblr]\])?\s?(?=\{)"
)
_LONGEST = 2000
_FRAMES = ("boxed", "Aboxed")
_EMPTY = ("vphantom", "hphantom", "phantom")


def with_frames_opened(text: str) -> Rewritten | None:
    r"""Return a text without such frames, None where there are none.

    A frame around a part of an equation stays: the reader knows it.

    >>> with_frames_opened(r"$\boxed{a = b}$ and $\sum_{\mathclap{k=1}}^3 \boxed{k}$").text
    '$a = b$ and $\\sum_{k=1}^3 \\boxed{k}$'
    """
    if "\\" not in text:
        return None
    rewriter, changed = Rewriter(text), False
    for match in _FRAMED.finditer(text):
        end = _closing(text, match.end())
        if end < 0 or match.start() < rewriter.place:
            continue
        inside = match.end() + 1, end - 1
        if match["command"] in _FRAMES and not RELATION.search(text, *inside):
            continue
        rewriter.replace(*match.span(), "")
        rewriter.replace(match.end(), end, *(() if match["command"] in _EMPTY else (inside,)))
        changed = True
    return rewriter.finish() if changed else None


def _closing(text: str, start: int) -> int:
    depth = 0
    for place in range(start, min(len(text), start + _LONGEST)):
        depth += {"{": 1, "}": -1}.get(text[place], 0)
        if not depth:
            return place + 1
    return -1
