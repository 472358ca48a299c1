r"""Commands for the sign of a differential: \mathop{}\!\mathrm{d}θ, and \rmd θ that no page defines.

Authors name such a command in their preamble, which a page often leaves out. Behind an integral sign, and
before a letter, it can be nothing else.
"""

from __future__ import annotations

from symbalance.document.wordlists import words
from symbalance.text import lazy_patterns as re

Texts = list[str | tuple[int, int]]
NAMES = tuple(words("de dif diff intd rmd ud id dint mathd upd ddif diffd"))
"""Usual names of the command for the sign of a differential."""
_FURTHEST = 400
"""Characters between an integral sign and its differential."""
_GROUP = re.compile(r"\s*\{([^{}]{0,60}(?:\{[^{}]{0,20}\}[^{}]{0,20})?)\}")
_UPRIGHT_D = re.compile(r"\\(?:mathrm|mathsf|mathbf|mathit|text|rm|operatorname)\s*\{?\s*d\s*\}?|d")
_LETTER = re.compile(r"\s*\{?\s*(?:\\[A-Za-z]+|[A-Za-z])(?![A-Za-z])")
_TWO_GROUPS = re.compile(r"\s*(?:\[[^\]\n]{0,20}\]\s*)?\{[^{}]{1,60}\}\s*\{")
_INTEGRAL = re.compile(r"\\(?:oint|int)(?![A-Za-z])")
_END_OF_FORMULA = re.compile(r"\$|\n\s*\n|\\[\[\]()]|\\\\(?![A-Za-z])|\\(?:begin|end)\b")


def operator_sign(text: str, place: int, pairs: dict[int, int]) -> tuple[Texts, int] | None:
    r"""Write \mathop{\mathrm{d}} as its sign, and \mathop{} as a space."""
    match = _GROUP.match(text, place)
    if match is None:
        return None
    inside = match[1].replace("\\!", "").strip()
    if inside and not _UPRIGHT_D.fullmatch(inside):
        return [" ", match.span(1), " "], match.end()
    return [" \\mathrm{d} " if inside else " "], match.end()


def without_definition(text: str, place: int, pairs: dict[int, int]) -> tuple[Texts, int] | None:
    r"""Write \rmd θ behind an integral sign as \mathrm{d} θ; elsewhere the command stays."""
    first = max(place - _FURTHEST, 0)
    before = text[first:place]
    ends = [end.end() for end in _END_OF_FORMULA.finditer(before)]
    inside = before[ends[-1] if ends else 0 :]
    is_letter = _LETTER.match(text, place) is not None and _TWO_GROUPS.match(text, place) is None
    return ([" \\mathrm{d} "], place) if is_letter and _INTEGRAL.search(inside) else None
