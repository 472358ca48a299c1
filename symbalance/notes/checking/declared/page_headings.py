"""Headings of a page, the order they name, and short quotations of its lines."""

from __future__ import annotations

from collections.abc import Sequence

from symbalance.text import lazy_patterns as re

LONGEST_LINE = 2000
"""Characters of a line of prose that is searched: longer ones are no sentences of a derivation."""
_ORDER = (
    re.compile(r"(?<![0-9])([0-9]{1,2}|[一二四六])\s*次"),
    re.compile(r"(?<![0-9.])([0-9]{1,2})(?:st|nd|rd|th)[- ]order", re.IGNORECASE),
    re.compile(r"\border\s+([0-9]{1,2})\b", re.IGNORECASE),
    re.compile(r"(?<![0-9.])([0-9]{1,2})\.\s*Ordnung"),
    re.compile(
        r"\b(first|second|fourth|sixth|erster?|zweiter?|vierter?|sechster?)[- ](?:order|Ordnung)",
        re.IGNORECASE,
    ),
)
_ORDINALS = {
    "first": 1, "second": 2, "fourth": 4, "sixth": 6, "erste": 1, "erster": 1, "zweite": 2, "zweiter": 2,
    "vierte": 4, "vierter": 4, "sechste": 6, "sechster": 6, "一": 1, "二": 2, "四": 4, "六": 6,
}  # fmt: skip


def order_in(heading: str) -> int | None:
    """Return the order a heading names.

    >>> order_in("6次慣性力"), order_in("Kräfte zweiter Ordnung"), order_in("The fourth-order force")
    (6, 2, 4)
    """
    for pattern in _ORDER:
        if match := pattern.search(heading):
            word = match[1].casefold()
            return _ORDINALS.get(word) or int(word)
    return None


def is_heading(lines: Sequence[str], number: int) -> bool:
    """Tell whether a line (from 1) is a heading: marked as one, or short, alone and no sentence."""
    words = lines[number - 1].strip()
    if not words:
        return False
    if words.startswith(
        ("#", "\\section", "\\subsection", "\\subsubsection", "\\paragraph", "\\chapter")
    ):
        return True
    around = [lines[k].strip() if 0 <= k < len(lines) else "" for k in (number - 2, number)]
    if re.fullmatch(r"([=\-~^*])\1{2,}", around[1]):
        return True
    has_formula = any(sign in words for sign in "=≈$\\")
    return not any(around) and len(words) <= 40 and words[-1] not in "。.、,:：;" and not has_formula


def section_start(lines: Sequence[str], number: int) -> int:
    """Return the line of the heading above a line; itself where there is none."""
    return next((n for n in range(number, 0, -1) if is_heading(lines, n)), number)


def words_around(line: str, start: int, end: int) -> str:
    """Return the words around a phrase, to show where a proposal is from."""
    return short_words(line[max(0, start - 14) : end + 14].strip())


def short_words(words: str) -> str:
    """Return words in one line of at most 60 characters."""
    line = " ".join(words.split())
    return line if len(line) <= 60 else line[:59] + "…"
