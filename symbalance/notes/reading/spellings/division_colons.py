"""Colons that divide, as handbooks print them: 110 : 2 = 55 mm and λ = 1 : 4.5 become strokes.

A colon behind a label is none: Fig. 3 : 4 · 2 = 8. So a number before it is one of the formula only
behind a sign of the formula, or where it has several digits. 12:30 is a time, 1 : 2 : 3 a proportion of
three, and a ratio that stands in no relation stays as it is.
"""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_NUMBER = r"[0-9]+(?:[.,][0-9]+)?"
_LETTER = r"(?:\\[a-z]+|[^\W\d_])(?:_\{?[A-Za-z0-9]{1,4}\}?|[₀-₉]{1,2})?"
_UNIT = r"(?:[ ~]?(?:[kcm]?m|k?g|k?N|k?W|s|min|PS)(?![A-Za-z]))?"
_RATIO = re.compile(
    rf"(?<![\w.,:])(?P<first>{_NUMBER}{_UNIT})(?P<colon>[ ]:[ ]|:)(?P<second>{_NUMBER})"
    r"(?![\w:]|[.,][0-9])(?![ ]?:)"
)
_OF_LETTERS = re.compile(
    rf"(?:=|≈|\\approx)[ ]*{_LETTER}(?P<colon>[ ]:[ ]|:)"
    rf"(?={_LETTER}(?:[ ]?[.,;)$]|[ ]*(?:[=≈\n]|$)|[ ][^\W\d_]{{2,}}))"
)
_OF_TWO_LETTERS = re.compile(
    rf"(?<![\w.,:\\]){_LETTER}(?P<colon>[ ]:[ ]|:)"
    rf"(?={_LETTER}[ ]*(?:[=≈]|\\approx)[ ]*(?:{_NUMBER}|{_LETTER})(?:[ ]:[ ]|:)"
    rf"(?:{_NUMBER}|{_LETTER})(?![\w:])(?![ ]?:))"
)
"""The first half of a proportion: x : y = 2 : 3."""
_SIGN_BEFORE = re.compile(r"(?:[=≈<>≤≥+−·×*/(]|\\(?:approx|cdot|times)|[ ]-)[ ~]*$")
_RELATION_BEFORE = re.compile(r"(?:[=≈]|\\approx)[ ~]*$")
_GOES_ON = re.compile(
    r"[ ~]*(?:\\[,;: ])?(?:[A-Za-z]{1,3}[ ]*)?(?:[=≈+−·×*/]|\\(?:approx|cdot|times)|-[ ])"
)
_RATIO_BEHIND = re.compile(rf"[ ~]*[=≈][ ~]*{_NUMBER}(?:[ ]:[ ]|:){_NUMBER}(?![\w:])")
_TIME = re.compile(r"[0-9]{1,2}:[0-5][0-9]")
_LABEL = re.compile(
    r"(?:\b(?:[Aa]bb|[Ff]ig|[Tt]ab|[Gg]l|[Ee]q|[Nn]r|[Nn]o|[Kk]ap|[Cc]h|[Ss]ec|[Bb]sp|[Aa]ufg|[Ss]|[Pp])\.?"
    r"|\b(?:[Ff]igure|[Tt]able|[Bb]ild|[Tt]afel|[Tt]abelle|[Ee]quation|[Gg]leichung|[Cc]ase|[Ff]all|[Cc]as|[Ss]tep"
    r"|[Ss]chritt|[Ee]xercise|[Aa]ufgabe|[Ee]xample|[Bb]eispiel|[Cc]ylinders?|[Zz]ylinder|[Ll]ine|[Zz]eile|[Pp]age"
    r"|[Ss]eite|[Pp]art|[Tt]eil|[Cc]hapter|[Kk]apitel|[Jj]ob|[Nn]ote|[Vv]ersuch|[Tt]est|[Rr]un)"
    r"|[§#№])[ ~]*(?:\(|\[)?$"
)
_WORD_BEFORE = re.compile(r"[^\W\d_][ ~\n]*$")
_MEASURED = re.compile(r"[0-9]{3}|[0-9][.,][0-9]")
_BEFORE = 40
"""Characters before a ratio that tell whether its first number is a label's."""


def with_divisions(text: str) -> Rewritten | None:
    """Return a text with its dividing colons as strokes, None where there are none.

    >>> with_divisions("b = 110 : 2 = 55 mm, λ = r : l").text
    'b = 110 / 2 = 55 mm, λ = r / l'
    >>> with_divisions("x : y = 2 : 3").text
    'x / y = 2 / 3'
    >>> with_divisions("Fig. 3 : 4 · 2 = 8, at 12:30, mixed 1 : 4") is None
    True
    """
    if ":" not in text:
        return None
    colons = [match.span("colon") for match in _RATIO.finditer(text) if _divides(text, match)]
    for ratio in (_OF_LETTERS, _OF_TWO_LETTERS):
        colons += [match.span("colon") for match in ratio.finditer(text)]
    if not colons:
        return None
    rewriter = Rewriter(text)
    for start, end in sorted({*colons}):
        rewriter.replace(start, end, " / " if end - start > 1 else "/")
    return rewriter.finish()


def _divides(text: str, match: re.Match[str]) -> bool:
    """Tell whether the colon of a ratio divides: the ratio is a part of a relation, and no label's."""
    before = text[max(match.start() - _BEFORE, 0) : match.start()]
    if _TIME.fullmatch(match.group()):
        return False
    goes_on = _GOES_ON.match(text, match.end()) is not None
    if _RELATION_BEFORE.search(before) or (goes_on and before.endswith(("$", "\\("))):
        return True  # no label stands in a formula: $8:2 = 4$
    if not goes_on:
        return False
    is_behind_sign = _SIGN_BEFORE.search(before) is not None
    if is_behind_sign or _LABEL.search(before.rpartition("\n")[2]):
        return is_behind_sign
    if match["colon"] == ":":
        return _RATIO_BEHIND.match(text, match.end()) is not None
    is_measured = _MEASURED.search(match["first"]) is not None
    return is_measured or (len(match["first"]) > 1 and _WORD_BEFORE.search(before) is None)
