"""Numbers that are worked out in the line, 2π·3000/60, and those only given, 84 mm or 2·10⁵ N/m."""

from __future__ import annotations

from symbalance.text import lazy_patterns as re

_POWER_OF_TEN = re.compile(
    r"(?:\\cdot|\\times|[·×*])\s*10\s*(?:\^\s*\{?\s*-?[0-9]{1,2}\s*\}?|[⁰¹²³⁴-⁹⁻]{1,3})"
)
_ARITHMETIC = re.compile(r"\\(?:cdot|times|[dt]?frac|sqrt)|[·×*+√]|[0-9)}]\s*[/−-]\s*[0-9]")
_UNIT_BELOW_ONE = re.compile(r"(?<![0-9.,])1/(?:min|s)")
_UNITS = re.compile(r"[^\W\d_]\s*(?:\\cdot|[·*])\s*(?=[^\W\d_])")


def is_worked_out(source: str) -> bool:
    """Tell whether a side, as it is typed, holds an arithmetic.

    >>> is_worked_out("0.04·314.2"), is_worked_out("2.1·10^5 N/mm²"), is_worked_out("3000 1/min")
    (True, False, False)
    """
    bare = _UNITS.sub("", _UNIT_BELOW_ONE.sub("", _POWER_OF_TEN.sub("", source)))
    return _ARITHMETIC.search(bare) is not None
