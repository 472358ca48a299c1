r"""Extremes written otherwise than by a subscript: β max = 14.5° is β_{max}, |M|_{\max} is \max |M|.

Without TeX the subscript is typed on the line. Within a formula, before a relation, the two words can be
nothing else.
"""

from __future__ import annotations

from symbalance.notes.reading.markup.marked_formulas import is_inside, marked_formulas
from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_APART = re.compile(
    r"(?<![\w\\}'’])(?P<letter>[α-ωϕϑ]|[A-Zb-z](?:_?[0-9]|[₀-₉])?)[ \t\u00a0](?P<word>max|min)\.?"
    r"(?=[ \t]*(?:=(?![=>])|[≈<>≤≥]))"
)


_BEHIND_COMMA = re.compile(
    r"(?<![\w\\}'’])(?P<letter>[A-Za-zα-ωϕϑ])_(?P<own>[A-Za-z0-9]{1,4}),"
    r"(?P<word>max|min|res|ges|tot|osz|rot|rms|eff|mean)(?![A-Za-z0-9_])"
)


def with_extremes_apart(text: str) -> Rewritten | None:
    """Return a text with β max as β_{max} and P_I,max as P_{I,max}, None where there is none.

    >>> with_extremes_apart("sin β max = λ").text
    'sin β_{max} = λ'
    """
    inside = marked_formulas(text)
    rewriter, changed = Rewriter(text), False
    matches = sorted([*_APART.finditer(text), *_BEHIND_COMMA.finditer(text)], key=re.Match.start)
    for match in matches:
        if is_inside(match.start(), inside) or match.start() < rewriter.place:
            continue
        own = match["own"] + "," if "own" in match.groupdict() else ""
        rewriter.replace(match.end("letter"), match.end(), f"_{{{own}", match.span("word"), "}")
        changed = True
    return rewriter.finish() if changed else None


_BAR = r"(?:\\left\s*|\\[bB]igg?l?\s*)?(?:\||\\vert(?![A-Za-z])|\\lvert(?![A-Za-z]))"
_CLOSING = r"(?:\\right\s*|\\[bB]igg?r?\s*)?(?:\||\\vert(?![A-Za-z])|\\rvert(?![A-Za-z]))"
_FONT = r"\\(?:mathrm|text|textrm|mathsf|mathit|rm|operatorname)\s*"
_WORD = r"\\?(?P<word>max|min)(?![A-Za-z])"
_OF_BARS = re.compile(
    rf"{_BAR}(?P<inside>[^|$\n=<>]{{1,80}}?){_CLOSING}(?:\s*_\s*"
    rf"(?:\{{\s*(?:{_FONT}\{{?\s*)?{_WORD}\s*\}}{{1,2}}"
    rf"|{_FONT}\{{\s*{_WORD.replace('word', 'upright')}\s*\}}"
    rf"|{_WORD.replace('word', 'bare')})|(?P<touching>max|min)(?=\s?(?:[≈≤≥<>]|=(?!=))))"
)


def with_extremes_of_bars(text: str) -> Rewritten | None:
    r"""Return a text with |M|_{\max} as \max |M|, None where there is none.

    >>> with_extremes_of_bars(r"$|M|_{\max} = 3$").text
    '$\\max \\left|M\\right| = 3$'
    """
    rewriter, changed = Rewriter(text), False
    for match in _OF_BARS.finditer(text):
        word = match["word"] or match["upright"] or match["bare"] or match["touching"]
        rewriter.replace(*match.span(), f"\\{word} \\left|", match.span("inside"), "\\right|")
        changed = True
    return rewriter.finish() if changed else None
