"""Crank angles said by one angle for two or three cylinders: "two cylinders, cranks at 180°".

The first crank is where the crank angle is counted from. Of two cranks any angle says where the second
stands; three stand evenly, or nothing is said of the third.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from symbalance.notes.checking.words.case_words import engine_named
from symbalance.text import lazy_patterns as re

_CRANKS = (
    r"(?:cranks?|crank\s?pins?|throws?|kurbeln|kurbelversatz|kröpfungen|kröpfungswinkel|kröpfungsversatz|hubzapfen"
    r"|manivelles|manetons|calage\s+des\s+manivelles|manovelle|manivelas|muñequillas)"
)
_SET = (
    r"(?:are|is|being|stand(?:ing)?|set|placed|spaced|arranged|displaced|offset|keyed|stehen|steht|liegen|versetzt"
    r"|beträgt|von|sont|calées|décalées|sono|disposte|sfasate|están|colocadas|an|angle|of|each|all|je|jeweils)"
)
_AT = r"(?:at|by|um|unter|auf|mit|à|de|a|di)"
_APART = re.compile(
    rf"(?<![^\W\d_]){_CRANKS}(?:[\s,]+{_SET})*(?:\s+{_AT})?(?:\s+(?:an\s+angle\s+of|einem\s+Winkel\s+von))?[\s$(]+"
    r"(?P<angle>[0-9]{2,3})\s*(?:°|º|\^\s*\{?\s*\\circ\s*\}?|\\degree|\\textdegree|\s(?:Grad|degrees?|deg)(?![^\W\d_]))"
    r"(?![\s$]*(?:,|and|und|et|e|y|/|-|–)[\s$]*[0-9])",
    re.IGNORECASE,
)
"""Words that say where the cranks stand by one angle, behind which no second one follows."""
_CLAUSE = re.compile(r"[.!?。]\s|[;；]|\n")
_BEFORE = 60
"""Characters before the cranks in which the cylinders are counted, within a clause."""
_FULL_TURN = 360


def cranks_apart(text: str) -> Iterator[tuple[tuple[Fraction, ...], int]]:
    """Yield the crank angles in degrees that words of a page give by one angle, and where they stand.

    >>> [list(map(str, angles)) for angles, _ in cranks_apart("Three cylinders, cranks at 120°.")]
    [['0', '120', '240']]
    """
    for match in _APART.finditer(text) if any(map(str.isdecimal, text)) else ():
        before = _CLAUSE.split(text[max(0, match.start() - _BEFORE) : match.start()])[-1]
        named = engine_named(before, len(before))
        angle = Fraction(match["angle"])
        if named is None or named[1] == "v" or named[0] not in (2, 3):
            continue
        if named[0] == 2 or named[0] * angle == _FULL_TURN:
            yield tuple(k * angle for k in range(named[0])), match.start()
