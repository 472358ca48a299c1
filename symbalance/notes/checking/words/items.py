"""The items of a page, a) b) c), Example 1, article 92: how far what is looked at in one of them reaches.

An angle that one item is looked at (at θ = 0, bei α = 90°) is free again where the next item of its kind
begins, or one of a higher kind: a numbered article stands above an example, an example above a).
"""

from __future__ import annotations

from collections.abc import Sequence

from symbalance.text import lazy_patterns as re

_OPEN = r"\s*(?:[-*+•>]\s+)?(?:\*{1,2}|_{1,2})?"
_KINDS = (
    re.compile(r"\s*[■◆●▼□◇]\s*\S"),
    re.compile(
        rf"{_OPEN}(?:§\s*)?[0-9]{{1,3}}\.\s+[A-ZÄÖÜ\u2e80-\u9fff][^=]{{3,}}|{_OPEN}\([0-9]{{1,2}}\)\s*[\u2e80-\u9fff]"
        rf"|{_OPEN}[0-9]{{1,2}}\)\s+[A-Za-zÄÖÜ\u2e80-\u9fff][^=]{{3,}}"
    ),
    re.compile(
        rf"{_OPEN}(?:example|exercise|problem|question|case|beispiel|aufgabe|fall|übung|例題?|問題?|演習)"
        r"\s*\(?(?:[0-9]{1,3}|[a-h]\b)",
        re.IGNORECASE,
    ),
    re.compile(rf"{_OPEN}\(?[a-h]\)(?=[\s*_]|$)|{_OPEN}\(?i{{1,3}}\)(?=\s)"),
)
"""How the items of a kind begin, the highest kind first."""


def item_end(lines: Sequence[str], line: int) -> int:
    """Return the last line of the innermost item that a line, from 1, stands in.

    >>> item_end(["a) at α = 90°:", "   F = 1", "b) in general", "c) more"], 1)
    2
    """
    own = next((found for text in reversed(lines[:line]) if (found := _rank(text)) is not None), None)
    if own is None:
        return len(lines)
    for n in range(line + 1, len(lines) + 1):
        found = _rank(lines[n - 1])
        if found is not None and found <= own:
            return n - 1
    return len(lines)


def _rank(text: str) -> int | None:
    return next((rank for rank, kind in enumerate(_KINDS) if kind.match(text)), None)
