"""Greek letters written out in plain text, lambda = r/l and cos(2phi), as their signs.

Only where they stand in a formula: beside an operator, a relation or a digit, in brackets, behind a
function, r cos theta, or between factors that stand side by side behind a relation, F = lambda m r.
"""

from __future__ import annotations

from collections.abc import Callable

from symbalance.document.letters import FUNCTION_WORDS, GREEK_SIGN, SHORT_NAMES
from symbalance.notes.reading.markup.marked_formulas import is_inside, marked_formulas
from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_SIGNS = {**GREEK_SIGN, **{short: GREEK_SIGN[name] for short, name in SHORT_NAMES.items()}}
_WORDS = sorted((name for name in _SIGNS if name not in ("pi", "ell")), key=len, reverse=True)
_WORD = re.compile(
    rf"(?<![A-Za-z\\_{{])(?P<name>{'|'.join(_WORDS)})(?![A-Za-z{{]|['’][A-Za-z]|_(?![A-Za-z0-9]{{1,8}}(?![\w{{])))"
)
_AFTER = re.compile(
    r"[0-9]|(?:_\w{1,8})?['′’]{0,3}[ \t]*[=≈^*·/+²³<>≤≥)]"
    r"|['′’]{1,3}_\w{1,8}[ \t]*[=≈^*·/+²³<>≤≥)]|[ \t]+-[ \t]"
)
_BEFORE = re.compile(r"[0-9=≈*·/+(<>≤≥−][ \t]*$|[ \t]-[ \t]*$")
_FUNCTION_BEFORE = re.compile(r"(?<![^\W\d_])(?:sin|cos|tan|cot|sec|exp)(?:\^?[0-9²³])?[ \t]+$")
_LONGEST_FUNCTION = 10
"""Characters before a name in which a function that it is the argument of begins."""
_SIGN = re.compile(r"[=≈≒≃]")
_RUN = re.compile(r"[^\W\d_]{2,}")
_FACTOR_BEHIND = re.compile(
    r"[ \t]+(?:(?![aAI])[A-Za-z](?![A-Za-z'’])|[α-ωϕ]|[(\[]"
    rf"|(?:{'|'.join(sorted(FUNCTION_WORDS, key=len, reverse=True))})(?![A-Za-z]))|[ \t]*(?:\n|$)"
)
_LINE = 200
"""Characters of a line before a name that are looked at."""


def is_between_factors(text: str, start: int, end: int, after: re.Pattern[str] = _AFTER) -> bool:
    """Tell whether a name stands among factors side by side, and nothing but these since the relation.

    >>> text = "F = sqrt(2) lam m r, of F = 3 lam of"
    >>> is_between_factors(text, 12, 15), is_between_factors(text, 30, 33)
    (True, False)
    """
    before = text[max(start - _LINE, 0) : start].rpartition("\n")[2]
    signs = [sign.end() for sign in _SIGN.finditer(before)]
    factors = before[signs[-1] :].strip() if signs else ""
    if not factors or factors[-1] in ",;.:" or not before[-1].isspace():
        return False
    are_factors = all(run in FUNCTION_WORDS or run in _SIGNS for run in _RUN.findall(factors))
    goes_on = after.match(text, end) or _FACTOR_BEHIND.match(text, end)
    return are_factors and goes_on is not None


def with_greek_words(
    text: str, is_letter: Callable[[str, int], bool] = lambda name, line: False
) -> Rewritten | None:
    """Return a text with the names of Greek letters in formulas as signs, None where there are none.

    >>> with_greek_words("also lambda=r/l, cos(2phi)").text
    'also λ=r/l, cos(2φ)'
    >>> with_greek_words("sigma_W' = 0.85*sigma_W").text
    "σ_W' = 0.85*σ_W"
    >>> with_greek_words("is H = b*sin phi,  (3)").text
    'is H = b*sin φ,  (3)'
    >>> with_greek_words("the angle theta of phi, and theta's cosine") is None
    True
    """
    formulas = marked_formulas(text)
    rewriter, has_words = Rewriter(text), False
    line, counted = 1, 0
    for match in _WORD.finditer(text):
        start, end = match.span()
        line, counted = line + text.count("\n", counted, start), start
        if is_letter(match["name"], line) or is_inside(start, formulas):
            continue
        before = text[max(start - 4, 0) : start]
        if match["name"] == "psi" and before.rstrip(" ~$")[-1:].isdigit():
            continue  # 120 psi
        is_argument = _FUNCTION_BEFORE.search(text, max(start - _LONGEST_FUNCTION, 0), start)
        is_factor = _AFTER.match(text, end) or _BEFORE.search(before)
        if is_argument or is_factor or is_between_factors(text, start, end):
            rewriter.replace(start, end, _SIGNS[match["name"]])
            has_words = True
    return rewriter.finish() if has_words else None
