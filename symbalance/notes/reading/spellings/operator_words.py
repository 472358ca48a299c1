r"""Formulas joined by a word of arithmetic, `$\\sqrt3$ times $m r$`, put together as one formula.

Every other word between two formulas is prose, and the formulas are two. So they are where the first says
of numbers alone what they are: the amplitude is `$\sqrt{1 + 2} = \sqrt3$ times $m r$`.
"""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.notes.reading.signs import RELATION
from symbalance.text import lazy_patterns as re

_FORMULA = r"(?<![\\$])\$(?!\$)[^$\n]{1,400}(?<!\\)\$(?!\$)|\\\((?:(?!\\[()])[^\n]){1,400}\\\)"
_WORDS = {
    **dict.fromkeys(("times", "mal", "fois", "por", "multiplied by", "multipliziert mit"), r"\times"),
    **dict.fromkeys(("plus", "más"), "+"),
    **dict.fromkeys(("minus", "moins", "menos"), "-"),
    **dict.fromkeys(("divided by", "geteilt durch", "over", "durch"), "/"),
}
_WORD = rf"[ ~]*\n?[ ~]*(?P<word>{'|'.join(_WORDS)})[ ~]*\n?[ ~]*"
_JOINED = re.compile(rf"({_FORMULA}){_WORD}(?={_FORMULA})")
_NEXT = re.compile(_FORMULA)
_SUM = re.compile(r"[-+−±]|\\[pm]m(?![A-Za-z])")


def with_operator_words(text: str) -> Rewritten | None:
    r"""Return a text with such formulas within one pair of delimiters, None where there are none.

    >>> with_operator_words(r"The sum is $F = \sqrt3$ times $m r$.").text
    'The sum is $F = \\sqrt3 \\times m r$.'
    """
    joins: list[tuple[int, int, str]] = []
    place = 0
    while match := _JOINED.search(text, place):
        following = _NEXT.match(text, match.end())
        if following is None:
            break
        place = match.end()
        sign = _WORDS[match["word"]]
        inside = [part.strip("$") if part[0] == "$" else part[2:-2] for part in (match[1], following[0])]
        if not any(map(RELATION.search, inside)) or RELATION.match(inside[1].lstrip()):
            continue
        if sign in ("\\times", "/") and _is_numbers(inside[0]) and not _is_numbers(inside[1]):
            joins.append((*match.span("word"), ","))
            continue
        if sign in ("\\times", "/") and _is_sum(*inside):
            continue
        first = match.end(1) - (1 if match[1][0] == "$" else 2)
        joins.append((first, match.end() + (1 if following[0][0] == "$" else 2), sign))
    if not joins:
        return None
    rewriter = Rewriter(text)
    for start, end, sign in joins:
        rewriter.replace(start, end, sign if sign == "," else f" {sign} ")
    return rewriter.finish()


def _is_sum(before: str, after: str) -> bool:
    """Tell whether a sum stands next to a word that multiplies: what it multiplies is not clear."""
    sides = (RELATION.split(before)[-1], RELATION.split(after)[0])
    return any(_SUM.search(re.sub(r"\{[^{}]*\}|\([^()]*\)", "", side)) is not None for side in sides)


def _is_numbers(formula: str) -> bool:
    """Tell whether a formula holds no letters but π."""
    bare = re.sub(
        r"\\(?:left|right|pi|sqrt|[dt]?frac|cdot|times|approx|sin|cos|tan|,)(?![A-Za-z])", "", formula
    )
    return re.search(r"[^\W\d_]", bare.replace("π", "").replace("\\circ", "")) is None
