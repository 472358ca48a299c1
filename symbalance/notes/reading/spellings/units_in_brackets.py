"""Units in round brackets behind a number, r = 40 (mm): the brackets are left out.

Read as they stand they are a number without a unit and words behind it, or a product, m = 450·(g). A unit
in words, λ = 3.5 (metres), is said of all the numbers of a sentence, and stays.
"""

from __future__ import annotations

from symbalance.notes.reading.rewriting import Rewriter, Rewritten
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

_NUMBER = r"[-−]?[0-9][0-9.,{}]{0,12}(?:[ ]?[·×][ ]?10(?:\^\{?[-−]?[0-9]{1,2}\}?|[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]{1,3}))?"
_UNIT = r"(?P<unit>[A-Za-zµμΩ°%1][A-Za-zµμΩ·*/²³⁴⁻¹^0-9 .-]{0,14})"
_STATED = re.compile(
    rf"[=≈][ ~$]{{0,3}}{_NUMBER}(?:\$|\\\))?[ ~](?P<brackets>\((?:in[ ])?{_UNIT}\))(?![ ]?[-+−·⋅×*/^=(])"
)

_WORD = re.compile(r"[A-Za-z]{4}")
_BARE_BEFORE = re.compile(r"[=≈][\s$]*[-−]?[0-9][0-9.,]*\$?\s*(?:,|;|and|und|et|e|y)\s[^=.;\n]{0,30}$")
"""Before a number whose unit in brackets is that of the one before too: a = 92 and b = 20 (MPa)."""
_NEAR = 60


def with_units_without_brackets(text: str) -> Rewritten | None:
    """Return a text with units behind numbers out of their brackets, None where there are none.

    >>> with_units_without_brackets("r = 40 (mm) and ω = 300 (rad/s), F = 5 (a)").text
    'r = 40 mm and ω = 300 rad/s, F = 5 (a)'
    """
    found = [match for match in _STATED.finditer(text) if _is_sign(match["unit"])]
    found = [m for m in found if not _BARE_BEFORE.search(text, max(0, m.start() - _NEAR), m.start())]
    if not found:
        return None
    rewriter = Rewriter(text)
    for match in found:
        rewriter.replace(*match.span("brackets"), match["unit"])
    return rewriter.finish()


def _is_sign(unit: str) -> bool:
    """Tell whether this is a unit by its sign, and not written out."""
    return scale_of(unit) is not None and _WORD.search(unit) is None
