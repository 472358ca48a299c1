r"""Units below a stroke right behind a number: 900/min is 900 1/min, and 157/\mathrm{s} is 157 1/s.

An s in plain letters is a second there where it is no letter of the page: 90/s by a stroke s divides.
"""

from __future__ import annotations

from collections.abc import Callable

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_NUMBER_END = (
    r"(?:(?<=[0-9π])|(?<=\\pi)|(?<=\^\{[0-9]\})|(?<=[⁰¹²³⁴⁵⁶⁷⁸⁹]))(?<![A-Za-z_][0-9])(?<![^0-9.]1)"
)
_GAP = r"(?:[ ~\u2009\u202f]|\\[,;: ])?"
_SET = re.compile(
    rf"{_NUMBER_END}{_GAP}(?:/{_GAP}\\(?:mathrm|text|textrm|mbox)\s?\{{|\\(?:mathrm|text|textrm|mbox)\s?\{{\s?/)"
    r"\s?(?P<unit>min|sec|s)\s?\}(?!\s?\^)"
)
_BELOW = re.compile(
    r"\\[dt]?frac\s?\{(?P<number>[0-9][0-9.,]*(?:\{,\}[0-9]+)?)\}\s?"
    r"\{\s?\\(?:mathrm|text|textrm|mbox)\s?\{\s?(?P<unit>min|sec|s)\s?\}\s?\}"
)
_TYPED = re.compile(rf"{_NUMBER_END}[ ]?/[ ]?(?P<unit>min|sec|s)(?![\w^'′(²³])(?!\.[0-9A-Za-z])")
_FUNCTION_BEHIND = re.compile(r"\s?(?:_|\(|\\left)")
_LETTER_S = re.compile(
    r"(?:(?<![\w\\/'’^{])s(?=[ ]?(?:[=≈/*·+^_]|\\cdot)|\s?\([0-9tφϕθ°])|\$s\$|[`*]s[`*]"
    r"|(?<![A-Za-z])[Hh]ub\s+s\b"
    r"|\b[Ss]troke\s+s\b|\b[0-9]?[ ]?s[ ][a-zA-Zω](?![A-Za-z])|=[ ]?s(?!\w))"
)
"""An s that is a letter of the page: s = 90 mm, s/2, $s$, the stroke s."""


def with_units_below_strokes(
    text: str, is_letter: Callable[[str, int], bool] = lambda name, line: False
) -> Rewritten | None:
    r"""Return a text with such units behind their numbers, None where there are none.

    >>> with_units_below_strokes(r"n = 900/min, $\omega = 94\,/\mathrm{s}$").text
    'n = 900 1/min, $\\omega = 94\\,\\mathrm{1/s}$'
    >>> with_units_below_strokes("s = 90 mm, so 180/s = 2")
    """
    changes = {m.start(): (m.end(), rf"\,\mathrm{{1/{_short(m)}}}") for m in _SET.finditer(text)}
    for match in _BELOW.finditer(text):
        if match["number"] != "1":
            changes[match.start()] = match.end(), rf"{match['number']}\,\mathrm{{1/{_short(match)}}}"
    for match in _TYPED.finditer(text):
        if _FUNCTION_BEHIND.match(text, match.end()):
            continue  # 3/min(a, b)
        line = text.count("\n", 0, match.start()) + 1
        word = match["unit"]
        is_own = is_letter(word, line) or (word == "s" and _LETTER_S.search(text) is not None)
        if not is_own:
            changes[match.start()] = match.end(), f" 1/{_short(match)}"
    if not changes:
        return None
    rewriter = Rewriter(text)
    for start, (end, written) in sorted(changes.items()):
        rewriter.replace(start, end, written)
    return rewriter.finish()


def _short(match: re.Match[str]) -> str:
    return "s" if match["unit"] == "sec" else match["unit"]
