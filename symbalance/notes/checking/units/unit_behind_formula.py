r"""The unit that words name behind a formula, ω = √(g/δ) in rad/s, and whether the formula is in it."""

from __future__ import annotations

from symbalance.notes.checking.units.dimensions import Dimension, unit_of
from symbalance.text import lazy_patterns as re

_BEHIND = re.compile(
    r"[\s$]{0,3}\s(?:in|en)\s+(?:the\s+unit\s+)?\$?(?:\\(?:mathrm|text|unit|si)\s*\{)?"
    r"(?P<unit>[A-Za-zµ1][A-Za-z0-9/²³⁻¹^·{}-]{0,12}(?:\s(?:m|mm|s)(?![A-Za-z]))?)"
)
_PLAIN = ("Hz", "N", "Nm", "kg", "s", "J", "W", "m", "mm")
"""Units without a stroke that are taken for such."""


def unit_behind_formula(text: str, end: int) -> Dimension | None:
    """Return the dimension of the unit in which words say the formula is that ends at a place; else None.

    >>> unit_behind_formula("v = at$ in m/s.", 6) == unit_of("m/s")
    True
    >>> unit_behind_formula("v = at in words", 6)
    """
    match = _BEHIND.match(text, end)
    unit = "" if match is None else match["unit"].rstrip(".,;}")
    return unit_of(unit) if "/" in unit or unit in _PLAIN else None
