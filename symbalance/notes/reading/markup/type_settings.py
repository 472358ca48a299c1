r"""Commands that only say how a formula is set, put in one form: {\rm N} and \textrm{N} are \mathrm{N}.

So no rule of the reader has to know each way in which a unit may be set upright, or a formula large.
"""

from __future__ import annotations

import re

from symbalance.notes.reading.rewriting import Rewriter, Rewritten

_STYLE = re.compile(r"(?<=[$(\[&])(\s*)(\\(?:display|text)style)(?![A-Za-z])")
_UPRIGHT = re.compile(
    r"(?P<braced>(?<!\\)\{\s*\\(?:rm|rmfamily|upshape)(?![A-Za-z])\s*"
    r"(?P<upright>(?:[^{}\\]|\\[,;: !]){1,24})\})"
    r"|\\(?:textrm|textnormal|textup|textsf|hbox)(?=\s*\{)"
)
_ROUND = re.compile(r"(?<!\\)\\\((?P<inside>(?:[^$\\\n]|\n(?!\s*\n)|\\(?![()\[\]])){1,2000}+)\\\)")
_SCRIPT_BEFORE = re.compile(r"[_^]\s*$")


def with_styles_blank(text: str) -> str:
    r"""Return a text with blanks for the style that a formula begins with: each sign keeps its place.

    >>> with_styles_blank(r"$\textstyle x$")
    '$           x$'
    """
    return _STYLE.sub(lambda match: match[1] + " " * len(match[2]), text)


def with_upright_parts(text: str) -> Rewritten | None:
    r"""Return a text with its upright parts set one way, None where nothing changes.

    >>> with_upright_parts(r"$F = 3\,{\rm kN}$ or $3\,\textrm{kN}$, $F_{\rm osz}$").text
    '$F = 3\\,\\mathrm{kN}$ or $3\\,\\text{kN}$, $F_{\\rm osz}$'
    """
    rewriter, changed = Rewriter(text), False
    for match in _UPRIGHT.finditer(text):
        start, end = match.span()
        if not match["braced"]:
            rewriter.replace(start, end, "\\text")
        elif _SCRIPT_BEFORE.search(text[max(start - 4, 0) : start]):
            continue
        else:
            rewriter.replace(start, end, "\\mathrm{", match.span("upright"), "}")
        changed = True
    return rewriter.finish() if changed else None


def with_one_inline_mark(text: str) -> Rewritten | None:
    r"""Return a text with its inline formulas between dollars, None where they are.

    >>> with_one_inline_mark(r"the spring \(c\) = 150 N/mm").text
    'the spring $c$ = 150 N/mm'
    """
    rewriter, changed = Rewriter(text), False
    for match in _ROUND.finditer(text):
        rewriter.replace(*match.span(), "$", match.span("inside"), "$")
        changed = True
    return rewriter.finish() if changed else None
