"""Functions under the names that other languages have for them: sen, tg and cotg are sin, tan and cot."""

from __future__ import annotations

import re

from symbalance.notes.reading.rewriting import Rewriter, Rewritten

_NAMES = {
    "sen": "sin", "senh": "sinh", "tg": "tan", "tgh": "tanh", "ctg": "cot", "cotg": "cot", "cotan": "cot",
    "arcsen": "arcsin", "arctg": "arctan", "arctag": "arctan",
}  # fmt: skip
_CAPITALS = ("SQRT", "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN", "EXP", "ABS", "LN")
"""As in the cells of a sheet, SQRT(L^2-(R*SIN(a))^2)."""
_NAMES |= {name: name.lower() for name in _CAPITALS}
_NAME = re.compile(
    rf"(?<![A-Za-z\\_])(?P<plain>{'|'.join(_NAMES)})(?=(?:[²³]|\^[0-9])?[ ]?\()"
    rf"|\\(?P<command>{'|'.join(_NAMES)})(?![A-Za-z])"
)


def with_function_names(text: str) -> Rewritten | None:
    """Return a text with such functions under their usual names, None where there are none.

    A word counts only before brackets: tg alone is a letter.

    >>> with_function_names("tg(x) = sen(x)/cos(x)").text
    'tan(x) = sin(x)/cos(x)'
    """
    rewriter, changed = Rewriter(text), False
    for match in _NAME.finditer(text):
        plain, command = match["plain"], match["command"]
        rewriter.replace(*match.span(), _NAMES[plain] if plain else f"\\{_NAMES[command]} ")
        changed = True
    return rewriter.finish() if changed else None
