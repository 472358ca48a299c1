r"""Times in hours, minutes and seconds side by side: 3 h 20 min is 200 min, and no product."""

from __future__ import annotations

from decimal import Decimal

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_GAP = r"(?:[ \t\u00a0\u202f]|\\[,;: ]|~){0,4}"


def _unit(letters: str) -> str:
    return (
        rf"(?:\\(?:mathrm|text|textrm|mbox)\s?\{{\s?(?:{letters})\s?\}}|(?:{letters})(?![A-Za-z0-9_^(]))"
    )


_TIME = re.compile(
    rf"(?<![\w.,^_{{])(?:(?P<hours>[0-9]{{1,4}}){_GAP}{_unit('h|hr|hrs|Std')}{_GAP})?"
    rf"(?P<minutes>[0-9]{{1,4}}){_GAP}(?P<unit>{_unit('min')})"
    rf"(?:{_GAP}(?P<seconds>[0-9]{{1,3}}(?:\.[0-9]{{1,4}})?){_GAP}(?P<last>{_unit('s|sec|Sek')}))?"
)


def with_times_in_one(text: str) -> Rewritten | None:
    """Return a text with such times in their last unit, None where there are none.

    >>> with_times_in_one("t = 3 h 20 min = 12000 s").text
    't = 200 min = 12000 s'
    >>> with_times_in_one("20 min 30 s").text
    '1230 s'
    """
    if "min" not in text:
        return None
    rewriter, changed = Rewriter(text), False
    for match in _TIME.finditer(text):
        if not match["hours"] and not match["seconds"]:
            continue
        seconds = 60 * int(match["minutes"]) + 3600 * int(match["hours"] or 0)
        if match["seconds"]:
            total, unit = Decimal(seconds) + Decimal(match["seconds"]), match.span("last")
        else:
            total, unit = Decimal(seconds // 60), match.span("unit")
        rewriter.replace(*match.span(), f"{total} ", unit)
        changed = True
    return rewriter.finish() if changed else None
