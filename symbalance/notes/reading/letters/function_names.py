"""Functions under the names that other languages have for them: sen, tg and cotg are sin, tan and cot."""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.text import lazy_patterns as re

_NAMES = {
    "sen": "sin", "senh": "sinh", "tg": "tan", "tgh": "tanh", "ctg": "cot", "cotg": "cot", "cotan": "cot",
    "arcsen": "arcsin", "arctg": "arctan", "arctag": "arctan",
    "Arg": "arg",
}  # fmt: skip
_CAPITALS = ("SQRT", "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN", "EXP", "ABS", "LN")
"""As in the cells of a sheet, SQRT(L^2-(R*SIN(a))^2)."""
_NAMES |= {name: name.lower() for name in _CAPITALS}
_ANGLE = (
    r"(?:[0-9]{1,2}(?:[.,][0-9])?[ ]?)?[α-ω](?![a-z])|[0-9]{1,3}(?:[.,][0-9]+)?[ ]?(?:°|\^\{?\\circ)"
    r"|(?<=[²³] )[a-z](?![A-Za-z])"
)
"""A Greek letter or a multiple of one, without brackets, or degrees; behind a power any letter."""
_ANGLE_OF = (
    r"(?:(?<=[=≈$(\[&,;:\n])|(?<=[=≈$(\[&,;:\n] )|(?<=\A))(?:∠|\\angle(?![A-Za-z]))(?=\s*(?:\(|[A-Za-z]))"
    r"(?!\s*\{?\s*[A-Z]\s?[A-Z])"
)
"""The sign of an angle before a complex number, ∠z; ∠ABC is one at a point, and 5∠30° a number."""
_COMPLEX = re.compile(
    r"complex|komplex|phasor|imagin|zeiger|argument|\\arg(?![A-Za-z])|複素|e\^\{?[-+]?[ij]", re.IGNORECASE
)
"""What says that letters are of complex numbers."""
_NAME = re.compile(
    rf"(?<![A-Za-z\\_])(?P<plain>{'|'.join(_NAMES)})(?=(?:[²³]|\^[0-9])?[ ]?(?:\(|{_ANGLE}))"
    rf"|\\(?P<command>{'|'.join(_NAMES)})(?![A-Za-z])"
    rf"|(?P<angle>{_ANGLE_OF})"
    rf"|\\operatorname\*?\s*\{{\s*(?P<operator>{'|'.join(_NAMES)})\s*\}}"
    rf"|\\(?:mathrm|text|mathop)\s*\{{\s*(?P<upright>{'|'.join(_NAMES)})\s*\}}(?=(?:\s|\\[,;:!])*(?:\^|\(|\\left|\\[a-z]))"
)


def with_function_names(text: str) -> Rewritten | None:
    r"""Return a text with such functions under their usual names, None where there are none.

    A word counts only before brackets or a Greek letter: tg alone is a letter, t times g.

    >>> with_function_names("tg(x) = sen(x)/cos(x), sen² α + sen 2β").text
    'tan(x) = sin(x)/cos(x), sin² α + sin 2β'
    >>> with_function_names(r"\operatorname{sen}\beta = \mathrm{tg}^2\alpha").text
    '\\sin \\beta = \\tan ^2\\alpha'
    """
    rewriter, changed = Rewriter(text), False
    is_complex = _COMPLEX.search(text) is not None
    for match in _NAME.finditer(text):
        plain = match["plain"]
        if match["angle"] and not is_complex:
            continue
        if match["angle"]:
            rewriter.replace(*match.span(), "\\arg ")
            changed = True
            continue
        command = match["command"] or match["operator"] or match["upright"]
        rewriter.replace(*match.span(), _NAMES[plain] if plain else f"\\{_NAMES[command]} ")
        changed = True
    return rewriter.finish() if changed else None
