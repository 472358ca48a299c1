"""Greek letters by the first letters of their names, cos(2*th) and om = 2*pi*n/60, as their signs.

A mail writes th for θ and be for β, where it has no other letters. Such a word is one where it stands in
a formula, and is none where the page has its two letters as letters of their own: with a = 3 and l = 4,
al is their product, unless a sine is taken of it. "to be = 3" and "the 4th + 1" are words.
"""

from __future__ import annotations

from collections.abc import Callable

from symbalance.document.letters import GREEK_SIGN
from symbalance.notes.reading.letters.greek_words import is_between_factors
from symbalance.notes.reading.markup.marked_formulas import is_inside, marked_formulas
from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_SHORT = {
    "th": "theta",
    "thet": "theta",
    "al": "alpha",
    "alph": "alpha",
    "be": "beta",
    "om": "omega",
    "omeg": "omega",
    "lam": "lambda",
    "lamb": "lambda",
    "eps": "epsilon",
    "gam": "gamma",
    "sig": "sigma",
}
_NAMES = "|".join(sorted(_SHORT, key=len, reverse=True))
_WORD = re.compile(rf"(?<![A-Za-z\\_{{.'’@/#<-])(?P<name>{_NAMES})(?![A-Za-z{{'’@])")
_AFTER = re.compile(
    r"[0-9]{1,2}(?![0-9A-Za-z])|_[0-9A-Za-z]|[ \t]*[=≈^*·/+²³<>≤≥)](?!/)|[ \t]+[-−][ \t](?=[0-9(a-zA-Z])"
)
_BEFORE = re.compile(r"(?:[=≈*·/+<>≤≥−]|(?<![A-Za-z0-9)]) -|[0-9)\]A-Za-z] -)[ \t]*$|(?<=[a-z])\($")
_OF_SINE = re.compile(
    r"(?<![A-Za-z])(?:sin|cos|tan|cot|exp)(?:\^?[0-9²³])?(?:[ ]?\([^()\n=]{0,40}|[ ][0-9]{0,2}[ *]?)$"
)
_VERBS = re.compile(
    r"(?<![A-Za-z])(?:to|must|should|shall|will|would|may|might|can|cannot|could|not|also|always|never|just"
    r"|it|let|et|then|only)[ \t]+$",
    re.IGNORECASE,
)
_BEGINS = re.compile(r"(?:^|[\n(,;:.=|&\ue000]|(?<=[A-Za-z]{2}))[ \t]*$")
_END = re.compile(r"[ \t]|[.,;)\n\ue000]|\Z")
_COUNTED = re.compile(r"[=≈*·/+−-][ ]?[0-9]{1,2}$")
_ARGUMENT = 60
"""Characters looked at before a word for the sine that is taken of it."""


def with_short_greek(
    text: str, is_letter: Callable[[str, int], bool] = lambda name, line: False
) -> tuple[Rewritten | None, tuple[str, ...]]:
    """Return a text with the short names in its formulas as Greek letters, None for none, and notes.

    `is_letter` tells the letters declared on a line: these stay as they are.

    >>> rewritten, notes = with_short_greek("F = m*w^2*(cos(th) + q*cos(2*th))")
    >>> rewritten.text, notes
    ('F = m*w^2*(cos(θ) + q*cos(2*θ))', ('th is read as θ',))
    >>> with_short_greek("it has to be = 3, the 4th (th) term")
    (None, ())
    """
    formulas = marked_formulas(text)
    words = list(_WORD.finditer(text))
    of_sine = {match["name"] for match in words if _is_of_sine(text, match.start())}
    standing = [
        name for name in dict.fromkeys(match["name"] for match in words)
        if name in of_sine or _is_free(text, name)
    ]  # fmt: skip
    rewriter, read_as = Rewriter(text), set()
    line, counted = 1, 0
    for match in words:
        start, name = match.start(), match["name"]
        line, counted = line + text.count("\n", counted, start), start
        if name not in standing or is_inside(start, formulas) or _is_declared(name, line, is_letter):
            continue
        if _stands_in_formula(text, match):
            rewriter.replace(*match.span(), GREEK_SIGN[_SHORT[name]])
            read_as.add(name)
    if not read_as:
        return None, ()
    notes = tuple(f"{name} is read as {GREEK_SIGN[_SHORT[name]]}" for name in sorted(read_as))
    return rewriter.finish(), notes


def _is_declared(name: str, line: int, is_letter: Callable[[str, int], bool]) -> bool:
    """Tell whether a word is a letter of the page's declarations, or a product of two of them."""
    if is_letter(name, line):
        return True
    return not is_letter(_SHORT[name], line) and all(is_letter(letter, line) for letter in name)


def _is_of_sine(text: str, place: int) -> bool:
    return _OF_SINE.search(text, max(place - _ARGUMENT, 0), place) is not None


def _is_free(text: str, name: str) -> bool:
    """Tell whether not all letters of a word stand alone in formulas of the page."""
    return not all(
        re.search(
            rf"(?<![A-Za-z\\_'’]){letter}(?![A-Za-z'’])(?:_[A-Za-z0-9]+)?[ \t]*[=≈^*·/+²³)]"
            rf"|[=≈*·/+(][ \t]*{letter}(?![A-Za-z'’])",
            text,
        )
        for letter in name
    )


def _stands_in_formula(text: str, match: re.Match[str]) -> bool:
    before = text[max(match.start() - _ARGUMENT, 0) : match.start()]
    if _is_of_sine(text, match.start()):
        return True
    is_bracketed = before.endswith((" (", "\n(")) and text.startswith(")", match.end())
    if _COUNTED.search(before):
        return _AFTER.match(text, match.end()) is not None
    if _VERBS.search(before) or before[-1:].isdigit() or is_bracketed:
        return False
    if _BEFORE.search(before):
        return _ends_whole(text, match.end())
    if _AFTER.match(text, match.end()) is not None and _BEGINS.search(before) is not None:
        return True
    return is_between_factors(text, *match.span(), _AFTER)


def _ends_whole(text: str, place: int) -> bool:
    """Tell whether a word ends with what may stand behind a letter in a formula."""
    return (
        _AFTER.match(text, place) is not None
        or re.match(r"[ \t]*(?:$|[.,;)\n])|[ \t]", text[place:]) is not None
    )
