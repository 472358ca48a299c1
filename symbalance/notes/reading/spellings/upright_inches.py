r"""Units with inches or pounds that are set upright, \mathrm{lb\cdot in}, are put in signs: lbf·inch.

The word in is a preposition elsewhere; set upright behind a number, alone or beside other units, it is
the inch. A unit may be set in several pieces, \mathrm{lb}\cdot\mathrm{s^2/in}.
"""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.notes.reading.spellings.pointed_units import unit_with_inches
from symbalance.text import lazy_patterns as re

_SET = r"\\(?:mathrm|text|textrm|mbox)\s?\{(?:[^{}$\n]|\{[^{}$\n]{0,10}\}){1,40}\}"
_GAP = r"(?:\\[,;:! ]|[~ ])*"
_POWER = r"(?:\s?\^\s?(?:\{\s?[-−]?[0-9]\s?\}|[0-9]))?"
_BETWEEN = r"(?:\\[,;: ]|[~ ·/]|\{?\\cdot(?![A-Za-z])\}?|\{/\}){0,4}"
_NUMBER_END = r"(?:(?<=[0-9)½¼¾])|(?<=[0-9]\}))(?<!_[0-9])"
_UPRIGHT = re.compile(
    rf"{_NUMBER_END}{_GAP}(?P<brace>\{{{_GAP})?"
    rf"(?P<unit>{_SET}{_POWER}(?:{_BETWEEN}{_SET}{_POWER}){{0,3}})(?(brace)\}})"
)
_ENDS = re.compile(
    r"(?:\s|~|\\[,;: !]|\\right|\\[bB]igg?r|&)*(?:[=≈<>≤≥.,;:)\]$+\-−}]"
    r"|\\(?:approx|[lg]eq?|simeq|times|q?quad|tag|label|end|\\|\)|\])|$)"
)
"""What may follow a unit; behind `2 \text{ in } [0, 1]` a formula goes on, and the word is no unit."""


def with_upright_inches(text: str) -> Rewritten | None:
    r"""Return a text with such units in signs, None where there are none.

    >>> with_upright_inches(r"r = 1.7\,\mathrm{in}, M = 3\,\mathrm{lb{\cdot}in}").text
    'r = 1.7\\,\\mathrm{inch}, M = 3\\,\\mathrm{lbf·inch}'
    >>> with_upright_inches(r"2\,\text{in the next section}"), with_upright_inches(r"3\,\mathrm{mm}")
    (None, None)
    """
    if "in" not in text and "lb" not in text:
        return None
    rewriter, is_new = Rewriter(text), False
    for match in _UPRIGHT.finditer(text):
        sign = unit_with_inches(match["unit"])
        if sign and _ENDS.match(text, match.end()):
            rewriter.replace(match.start(), match.end(), f"\\,\\mathrm{{{sign}}}")
            is_new = True
    return rewriter.finish() if is_new else None
