"""Where sentences end in a page's text, and what stands between words and a formula set off from them."""

from __future__ import annotations

from symbalance.text import lazy_patterns as re

SENTENCE_END = re.compile(
    r"[;!?](?:\s|$)"
    r"|\.(?:\s+(?!(?:(?:und|bzw\.|oder|and|or)\s)?(?:[IVX0-9]{1,3}\.)?\s?(?:Ordnung|Harmonische|order|rzędu|řádu|ordning|orde|ordine|ordre|orden|ordem))|$)"
    r"|[。；]|\n\s*\n|\n#|\n\s*\||\n\s*(?:[-*+•]|[0-9]{1,3}[.)])\s|\\item|\\section|<p\b|<li\b|<td\b"
)
"""The end of a sentence, an item, a cell or a paragraph; "2. Ordnung" does not end one."""
OPENING = re.compile(
    r"(?:\s|\$|\\\[|\\\(|\\begin\{[a-z]+\*?\}|\\displaystyle|&|\||`|>"
    r"|</?(?:p|div|math|span|li)\b[^<>]{0,40}>)+$"
)
"""Signs between words and a formula that stands in a line of its own."""


def bare(words: str) -> str:
    """Return words without the signs that set off the formula behind them."""
    return OPENING.sub("", words)
