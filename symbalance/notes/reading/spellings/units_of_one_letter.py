"""Tonnes, litres, volts, amperes and ohms behind the dollar that ends a formula: $m = 2$ t, $U = 12$ V.

Their signs are letters of most formulas. One is a unit by the letter that has the value, and everywhere
else where the page's formulas have no such letter.
"""

from __future__ import annotations

from functools import lru_cache

from symbalance.notes.reading.units import is_of_volume, scale_of, with_electric_names
from symbalance.text import lazy_patterns as re

_UNITS = {"t": "Mg", "l": "dm^3", "L": "dm^3", "V": "V", "A": "A", "Ω": "Ω", "\u2126": "Ω"}
_OF_HEADS = {"t": "mMGQW", "l": "VQ", "L": "VQ", "A": "Ii", "V": "Uu", "Ω": "RZX", "\u2126": "RZX"}
"""Letters that have their values in such a unit."""
_ONE = re.compile(
    r"[tlLVAΩ\u2126](?![^\W\d_])(?=[\s.,;:)|\ue000]|$)(?!/)"
    r"(?![ ·](?:[kcm]?[msNVA]|h|min|kg)(?![^\W\d_]))"
)
_GAP = re.compile(r" |\\,|~")
_COMPOUND = re.compile(r"[A-Za-zµμΩ\u2126]+(?:[/·⋅][A-Za-zµμΩ\u2126]+[²³]?){0,3}")
_PART = re.compile(r"(?<![^\W\d_])[tlL](?![^\W\d_])")
_HEAD = re.compile(
    r"[^A-Za-z\\]*(?:\\(?:Delta|dot|bar|hat|sum)(?![A-Za-z])[\s{]*)?([A-Za-z])(?![A-Za-z])"
)
_FORMULA = re.compile(r"\$[^$\n]{1,400}\$|\\\((?:(?!\\[()])[^\n]){1,400}\\\)")
_LETTER = re.compile(
    r"(?<![A-Za-z\\{])[tlLVA](?![A-Za-z])|(?<=\{)(?<!mathrm\{)(?<!text\{)[tlLVA](?![A-Za-z])"
)
_LONGEST = 400
"""Characters before the dollar in which its formula begins."""


def sure_unit_behind(text: str, match: re.Match[str]) -> tuple[str, int]:
    """Return the unit behind the mark of a formula's end and its length; "" and 0 where none is sure.

    `match` has the mark that ends the formula, and behind it what may be the `unit`.
    """
    words, start = match["unit"], match.start("unit")
    ends = sorted({len(words), *(gap.start() for gap in _GAP.finditer(words))}, reverse=True)
    for end in ends[:-1]:  # A s, N m/A
        named = with_electric_names(words[:end])
        if named != words[:end] and scale_of(named) is not None:
            return words[:end], end
    one = _ONE.match(text, start)
    if one is not None:
        head = _head_before(text, match.start(), match["mark"])
        is_volume = one[0] in "lL" and is_of_volume(text, match.start())
        is_free = one[0] not in letters_in_dollars(text)
        is_unit = is_volume or is_free or head in _OF_HEADS[one[0]]
        return (_UNITS[one[0]], 1) if is_unit else ("", 0)
    compound = _COMPOUND.match(words)
    if compound is None or compound.end() == 1 or scale_of(compound[0]) is not None:
        return "", 0
    unit = _PART.sub(lambda part: _UNITS[part[0]], compound[0])
    is_unit = scale_of(with_electric_names(unit)) is not None
    return (unit, compound.end()) if is_unit else ("", 0)


def _head_before(text: str, place: int, mark: str) -> str:
    """Return the letter that begins the formula whose end a place is, "" for a command or a word."""
    opening = "$" if mark == "$" else "\\("
    begin = text.rfind(opening, max(place - _LONGEST, 0), place)
    head = _HEAD.match(text, begin + len(opening), place) if begin >= 0 else None
    return head[1] if head else ""


@lru_cache(maxsize=8)
def letters_in_dollars(text: str) -> frozenset[str]:
    r"""Return those of the letters that the formulas of a text have as letters.

    >>> sorted(letters_in_dollars(r"$x = v t$, $V_h = 2$ l, $m = 2\,\mathrm{t}$, A"))
    ['V', 't']
    """
    return frozenset(
        letter for formula in _FORMULA.finditer(text) for letter in _LETTER.findall(formula[0])
    )
