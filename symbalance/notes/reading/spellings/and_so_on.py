r"""Words for dots behind the last sign of a sum, put as dots: + etc., − &c., - \text{usw.}, + . . ."""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_GAP = r"(?:\\[,;: ]|[ \t~])*"
_WORDS = rf"(?:etc|usw|usf|u\.{_GAP}s\.{_GAP}[wf]|h\.{_GAP}o\.{_GAP}t|\\?&{_GAP}c)(?![A-Za-z])\.?"
_AND_SO_ON = re.compile(
    rf"(?<=[-+−–±]){_GAP}(?P<words>{_WORDS}|\\(?:text|textrm|textit|mathrm|mbox)\s*\{{\s*{_WORDS}\s*\}}"
    rf"|\.(?:{_GAP}\.){{2,}})"
)


def with_dots(text: str) -> Rewritten | None:
    r"""Return a text with dots for such words, None where there are none.

    >>> with_dots(r"1 - x - \text{etc.}").text, with_dots("a + b, etc.")
    ('1 - x - …', None)
    """
    rewriter, changed = Rewriter(text), False
    for match in _AND_SO_ON.finditer(text):
        if match["words"] != "...":
            rewriter.replace(*match.span("words"), "…")
            changed = True
    return rewriter.finish() if changed else None
