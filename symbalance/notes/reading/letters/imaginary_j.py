r"""The imaginary unit written j, on a page that says so: j² = −1, j = \sqrt{-1}, the imaginary unit j.

Elsewhere j is imaginary in a power of e only. A subscript j stays a subscript; a page that counts by i,
or gives j another value, keeps its j.
"""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_SAYS_SO = re.compile(
    r"(?<![A-Za-z\\_{])j\s?(?:\^\s?\{?2\}?|²)\s?=\s?[-−]\s?1|(?<![A-Za-z\\_{])j\s?=\s?(?:\\sqrt\s?\{?|√|sqrt\()\s?\(?[-−]\s?1"
    r"|(?:imaginary\s+unit|imaginäre[rn]?\s+Einheit|虚数単位(?:を|は)?)\s?(?:\$|\\\()?\s?j(?![A-Za-z])"
    r"|(?<![A-Za-z\\_])j(?:\$|\\\))?\s?(?:is|denotes|for|ist|=|は|を)?\s?(?:the|die|an?)?\s?(?:imaginary\s+unit|imaginäre\s+Einheit|虚数単位)"
)
_J = re.compile(
    r"(?<![A-Za-z\\_])(?<!_\{)(?<![A-Za-z0-9],)j(?![a-z]{2}|[A-Za-z]{0,3}\s?=\s?[0-9])(?![_'{])"
)
_IN_SUBSCRIPT = re.compile(r"_\{[^{}]*$")
_I_COUNTS = re.compile(
    r"(?:\\sum|\\prod|Σ|∑)\s?(?:\\limits)?\s?_\s?\{?\s?i(?![A-Za-z])|_\{?[a-z]?i\}?(?![A-Za-z])"
)
_J_COUNTS = re.compile(
    r"(?<![A-Za-z\\_{])j\s?(?:=\s?(?![-−+\s]*(?:\\sqrt|√|sqrt|e|\\mathrm\{e))|\\in(?![a-z])|∈|\\?[<>≤≥]|\\[lg]eq?(?![a-z]))"
)
_AROUND = 16


def with_imaginary_j(text: str, is_declared: bool = False) -> Rewritten | None:
    """Return a text with i for a j that the page calls the imaginary unit, None where there is none.

    With `is_declared`, its author has said so apart.

    >>> with_imaginary_j("$Z = 3 + 4j$ with $j^2 = -1$, $x_j$").text
    '$Z = 3 + 4i$ with $i^2 = -1$, $x_j$'
    >>> with_imaginary_j("$Z = 3 + 4j$, $j = 1, 2$") is None
    True
    """
    if not (is_declared or _SAYS_SO.search(text)) or _I_COUNTS.search(text) or _J_COUNTS.search(text):
        return None
    rewriter, changed = Rewriter(text), False
    for match in _J.finditer(text):
        if _IN_SUBSCRIPT.search(text[max(match.start() - _AROUND, 0) : match.start()]) is None:
            rewriter.replace(*match.span(), "i")
            changed = True
    return rewriter.finish() if changed else None
