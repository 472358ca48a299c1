r"""Commands that only say how a formula is set, put in one form: {\rm N} and \textrm{N} are \mathrm{N}.

So no rule of the reader has to know each way in which a unit may be set upright, or a formula large.
"""

from __future__ import annotations

from symbalance.notes.reading.markup.marked_formulas import marked_formulas
from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_STYLE = re.compile(r"(?<=[$(\[&])(\s*)(\\(?:display|text)style)(?![A-Za-z])")
_WORDS = (
    r"(?:and|or|with|for|where|if|so|thus|hence|since|und|oder|mit|für|wenn|also|wobei"
    r"|et|ou|avec|pour|où|donc)"
)
_UPRIGHT = re.compile(
    r"(?P<braced>(?<!\\)\{\s*\\(?:rm|rmfamily|upshape)(?![A-Za-z])\s*"
    r"(?P<upright>(?:[^{}\\]|\\[,;: !]){1,24})\})"
    r"|\\text(?:rm|normal|up)?\s*\{\s*(?P<sign>[de])\s*\}(?=\s*(?:\\[a-zA-Z]|[A-Za-zα-ω^]|\}\s*\{))"
    rf"|\\mathrm\s*(?P<word>\{{\s*{_WORDS}\s*\}})"
    r"|\\(?:textrm|textnormal|textup|textsf|hbox)(?=\s*\{)"
)
_IS_WORD = re.compile(rf"\s*{_WORDS}\s*")
_ROUND = re.compile(r"(?<!\\)\\\((?P<inside>(?:[^$\\\n]|\n(?!\s*\n)|\\(?![()\[\]])){1,2000}+)\\\)")
_TILDE = re.compile(r"(?<!\\)~")
_SCRIPT_BEFORE = re.compile(r"[_^]\s*$")


def with_styles_blank(text: str) -> str:
    r"""Return a text with blanks for the style that a formula begins with: each sign keeps its place.

    >>> with_styles_blank(r"$\textstyle x$")
    '$           x$'
    """
    return _STYLE.sub(lambda match: match[1] + " " * len(match[2]), text)


def with_upright_parts(text: str) -> Rewritten | None:
    r"""Return a text with its upright parts set one way, None where nothing changes.

    A differential's d, the number e and words are set as each of them is read.

    >>> with_upright_parts(r"$F = 3\,{\rm kN}$ or $3\,\textrm{kN}$, $F_{\rm osz}$").text
    '$F = 3\\,\\mathrm{kN}$ or $3\\,\\text{kN}$, $F_{\\rm osz}$'
    >>> with_upright_parts(r"$\frac{\text{d}x}{\text{d}t} = 0 \quad{\rm or}\quad \text{e}^x = 1$").text
    '$\\frac{\\mathrm{d}x}{\\mathrm{d}t} = 0 \\quad\\text{or}\\quad \\mathrm{e}^x = 1$'
    """
    rewriter, changed = Rewriter(text), False
    for match in _UPRIGHT.finditer(text):
        start, end = match.span()
        if match["braced"] and _SCRIPT_BEFORE.search(text[max(start - 4, 0) : start]):
            continue
        if match["braced"]:
            setting = "\\text{" if _IS_WORD.fullmatch(match["upright"]) else "\\mathrm{"
            rewriter.replace(start, end, setting, match.span("upright"), "}")
        elif match["sign"]:
            rewriter.replace(start, end, "\\mathrm{", match.span("sign"), "}")
        elif match["word"]:
            rewriter.replace(start, end, "\\text", match.span("word"))
        else:
            rewriter.replace(start, end, "\\text")
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


def with_tildes_blank(text: str, *, is_tex: bool) -> str:
    r"""Return a text with blanks for the spaces that TeX writes ~: all of them in TeX, else in formulas.

    >>> with_tildes_blank(r"about ~ 3 and $m_a~a \sim b$", is_tex=False)
    'about ~ 3 and $m_a a \\sim b$'
    """
    if "~" not in text:
        return text
    if is_tex:
        return _TILDE.sub(" ", text)
    parts, place = [], 0
    for start, end in marked_formulas(text):
        parts += [text[place:start], _TILDE.sub(" ", text[start:end])]
        place = end
    return "".join((*parts, text[place:]))
