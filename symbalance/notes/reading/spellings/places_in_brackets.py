r"""Places written as an equation within a function's brackets: F(θ = 90°) is put as F|_{θ=90°}."""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_LETTER = (
    r"(?:\\(?:dot|ddot|hat|bar|tilde|vec|overline)\s?\{?)?"
    r"(?:\\(?!left|right|cdot|times|frac|sqrt|quad|text|mathrm|in\b|to\b)[A-Za-z]{2,12}|[^\W\d_])\}?"
    r"(?:_\{[\w,]{1,12}\}|_\w|[₀-₉])?"
)
_VARIABLE = r"(?:\\(?:var)?(?:theta|phi|psi|alpha|beta|tau)(?![A-Za-z])|[θϑφϕψαβτtx])"
_NUMBER = r"(?:[0-9]{1,4}(?:(?:[.,]|\{,\})[0-9]{1,4})?|\\pi(?![A-Za-z])|π|\\[dt]?frac\{\\pi\}\{[0-9]\})"
_DEGREE = r"(?:\s?(?:°|º)|\^\{?\\circ\}?|\\degree(?![A-Za-z]))"
_VALUE = rf"[-−]?{_NUMBER}(?:\s?(?:\\pi(?![A-Za-z])|π))?(?:/[0-9])?{_DEGREE}?"
_PLACE = re.compile(
    rf"(?<![\w\\}}{{^_]){_LETTER}(?P<open>\\left\(|\\?\(|\\[Bb]igl?\()\s?(?P<letter>{_VARIABLE})\s?=\s?"
    rf"(?P<value>{_VALUE})\s?(?P<close>\\right\)|\\[Bb]igr?\)|\))"
)


def with_places(text: str) -> Rewritten | None:
    r"""Return a text with such brackets as bars at a place, None where there are none.

    >>> with_places(r"F(\theta = 90°) = 0").text, with_places("where (θ = 0) and F (x + 1) = 2")
    ('F|_{\\theta=90°} = 0', None)
    """
    rewriter, changed = Rewriter(text), False
    for match in _PLACE.finditer(text):
        rewriter.replace(match.start("open"), match.start("letter"), "|_{")
        rewriter.replace(match.end("letter"), match.start("value"), "=")
        rewriter.replace(match.end("value"), match.end(), "}")
        changed = True
    return rewriter.finish() if changed else None
