"""Cases in a list: "Three cases are looked at", then an item for each, 1. idling: F = A, 2. load: F = B.

A letter has a value of its own in each item, and none of them is said of the others.
"""

from __future__ import annotations

from collections.abc import Sequence

from symbalance.text import lazy_patterns as re

FARTHEST = 4
"""Lines between the words that announce cases and the first item."""
_ITEM = re.compile(r"(?P<indent>[ \t]*)(?:(?P<number>#|[0-9]{1,2}|[a-h])[.)]|(?P<bullet>[-*+•]))[ \t]+")
_CASES = re.compile(
    r"(?<![A-Za-z])(?:(?:load[ -]?|special[ -]?)?cases|(?:Last|Sonder|Betriebs)?fälle|cas|casi|casos)"
    r"(?![A-Za-z])|場合",
    re.IGNORECASE,
)
_LABEL = re.compile(r"[^=$`\\\n]{4,120}:[ \t]*(?::math:)?[$`\\]*$")


def item_of_cases(lines: Sequence[str], line: int, column: int) -> tuple[int, int] | None:
    """Return the list and the last line of the item, of a list of cases, that opens with a formula.

    The list is told by the line of its first item; a formula opens its item behind words and a colon.

    >>> page = ["Two cases:", "", "1. idling: F = A", "2. full load: F = B"]
    >>> item_of_cases(page, 3, 11), item_of_cases(page, 4, 14), item_of_cases(page, 1, 0)
    ((3, 3), (3, 4), None)
    """
    own = _ITEM.match(lines[line - 1]) if 0 < line <= len(lines) else None
    if own is None or not _LABEL.fullmatch(lines[line - 1][own.end() : column]):
        return None
    first, last = _first_of_list(lines, line, own), line
    while last < len(lines) and lines[last].strip() and not _ITEM.match(lines[last]):
        last += 1
    above = [text for text in lines[max(first - 1 - FARTHEST, 0) : first - 1] if text.strip()]
    return (first, last) if above and _CASES.search(above[-1]) else None


def _first_of_list(lines: Sequence[str], line: int, own: re.Match[str]) -> int:
    """Return the line of the first item of the list that an item stands in."""
    first = line
    for n in range(line - 1, 0, -1):
        text = lines[n - 1]
        item = _ITEM.match(text)
        if item is not None and item["indent"] == own["indent"]:
            if bool(item["bullet"]) != bool(own["bullet"]):
                break
            first = n
        elif text.strip() and not text.startswith((" ", "\t")):
            break
    return first
