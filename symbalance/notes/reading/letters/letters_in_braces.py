r"""Letters in braces of their own, {S}_1, {\bf F}_2 and {\dot x}_1: the braces only set the letter.

Braces that are an argument, as those of \frac{r}{l} and \vec{F}_1, or a script's, stay. Before an order
in brackets those of an accent go too: \hat{F}^{(2)}_x is the letter \hat F^{(2)}_x, and no square.
"""

from __future__ import annotations

from symbalance.document.letters import ACCENTS, FONTS, FUNCTION_WORDS, GREEK_SIGN, TIME_DOTS
from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.notes.reading.signs import OPERATOR_COMMANDS, RELATION_COMMANDS, SPACE_COMMANDS
from symbalance.text import lazy_patterns as re

_GREEK = "|".join(sorted(GREEK_SIGN, key=len, reverse=True))
_LETTER = rf"(?:[A-Za-z]|\\(?:{_GREEK})(?![A-Za-z])\s?)"
_FONT = rf"\\(?:{'|'.join(sorted(FONTS - {'operatorname'}, key=len, reverse=True))})(?![A-Za-z])\s*"
_ACCENT = rf"\\(?:{'|'.join([*ACCENTS, *TIME_DOTS])})(?![A-Za-z])\s*"
_BRACED = re.compile(
    rf"(?P<frame>\\boxed\s?)?\{{\s?(?:{_FONT})?(?P<letter>(?:{_ACCENT})?(?:{_LETTER}|\{{{_LETTER}\}}))\s?\}}"
    r"(?=\s?(?:_|'|\\prime|\^\s?\{(?:\\[,;:! ]|\s)*(?:\\left)?\())"
)
_ORDER = (
    r"\^\s?\{(?:\\[,;:! ]|\s)*(?:\\left)?\(\s*(?:[0-9]{1,2}|[A-Za-z]|[IVX]{1,4})\s*(?:\\right)?\)\s*\}"
)
_BELOW = r"_\s?(?:\{(?:[^{}]|\{[^{}]{0,20}\}){1,40}\}|\\[a-z]+\s?\{[^{}]{1,20}\}|\\[a-z]+|[A-Za-z0-9])"
_ACCENTED = re.compile(
    rf"(?P<accent>\\(?:{'|'.join([*ACCENTS, *TIME_DOTS, 'mathcal', 'mathscr'])})(?![A-Za-z])\s?)"
    rf"\{{\s?(?P<letter>{_LETTER})\s?\}}(?=\s?(?:{_BELOW})?\s?{_ORDER})"
)
"""An accent over a letter in braces that has an order in brackets above it."""
_COMMAND_BEFORE = re.compile(r"(?:\\(?P<command>[A-Za-z]+)\*?|[}\]_^])\s*$|\\[A-Za-z]+\s?[0-9]$")
_WITHOUT_ARGUMENT = frozenset(
    (*OPERATOR_COMMANDS, *RELATION_COMMANDS, *SPACE_COMMANDS, *GREEK_SIGN, *FUNCTION_WORDS, "left", "sum")
)
_AROUND = 24


def with_letters_unbraced(text: str) -> Rewritten | None:
    r"""Return a text without the braces around a letter that has a subscript or strokes behind them.

    >>> with_letters_unbraced(r"${S}_1 = {\bf F}_2 \cdot {\dot x}_3$").text
    '$S_1 = F_2 \\cdot \\dot x_3$'
    >>> with_letters_unbraced(r"${F}^{(1)}_x + \hat{F}_x^{(2)}$").text
    '$F^{(1)}_x + \\hat F_x^{(2)}$'
    >>> with_letters_unbraced(r"$\vec{F}_1 + \frac{r}{l}_2 + x^{a}_b$") is None
    True
    """
    rewriter, changed = Rewriter(text), False
    for match in sorted((*_BRACED.finditer(text), *_ACCENTED.finditer(text)), key=re.Match.start):
        if "accent" in match.re.groupindex:
            between = "" if match["letter"].startswith("\\") else " "
            rewriter.replace(*match.span(), match["accent"].rstrip(), between, match["letter"])
            changed = True
            continue
        before = text[max(match.start() - _AROUND, 0) : match.start()]
        command = _COMMAND_BEFORE.search(before)
        if not match["frame"] and command and command["command"] not in _WITHOUT_ARGUMENT:
            continue
        rewriter.replace(*match.span(), match["letter"])
        changed = True
    return rewriter.finish() if changed else None
