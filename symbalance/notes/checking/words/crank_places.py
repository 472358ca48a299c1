"""The crank angle at which words look at an engine: at 30° after top dead centre, 40° vor OT."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

from symbalance.text import lazy_patterns as re

_NUMBER = r"(?P<{}>[0-9]{{1,3}}(?:[.,][0-9]{{1,2}})?)"
_DEGREES = _NUMBER.format("degrees")
_SIGN = (
    r"(?:[\s~]|\\[,;:])?(?:°|\^\s?\{?\s?\\circ\s?\}?|\\degree|-?(?:degrees?|deg\.?|Grad|degrés|grados|gradi)(?![a-z])|度)"
    r"(?:\s?(?:KW|CA|Kurbelwinkel|crank(?: angle)?)(?![a-z]))?[\s$~]*"
)
_TOP = (
    r"(?:the\s+|dem\s+|le\s+|il\s+|el\s+|del\s+|al\s+)?"
    r"(?:(?:top|upper|inner|front|outer)\s+dead[\s-](?:cent(?:re|er)|point)|T\.?D\.?C\.?(?![A-Za-z])|I\.?D\.?C\.?(?![A-Za-z])"
    r"|(?:obere[mn]\s+)?Totpunkt|OT(?![A-Za-z])|o\.\s?T\.|PMH(?![A-Za-z])|PMS(?![A-Za-z])|point\s+mort\s+haut"
    r"|punto\s+morto\s+superiore|punto\s+muerto\s+superior|the\s+top(?![a-z]))"
)
_BEHIND = re.compile(
    rf"(?<![0-9.,]){_DEGREES}{_SIGN}(?P<way>after|past|beyond|before|ahead\s+of|nach|hinter|vor|après|avant|dopo"
    rf"|prima\s+d|después\s+d|antes\s+d|A(?=TDC)|B(?=TDC)|n\.\s?(?=O)|v\.\s?(?=O))(?:el|e)?\s*{_TOP}"
    rf"|上死点(?P<later>後|前)\s?{_NUMBER.format('japanese')}\s?(?:°|度)",
    re.IGNORECASE,
)
_CRANK_ANGLE = re.compile(
    r"(?:(?:at|for|with)\s+(?:a|the)\s+crank(?:shaft)?\s+angle\s+of"
    r"|(?:bei|für)\s+(?:einem|dem)\s+Kurbelwinkel\s+von|à\s+un\s+angle\s+de\s+manivelle\s+de"
    rf"|クランク角)[\s$]*{_DEGREES}{_SIGN}",
    re.IGNORECASE,
)
_BEFORE_TOP = re.compile(r"before|ahead|vor|avant|prima|antes|B|v\.|前", re.IGNORECASE)


class CrankPlace(NamedTuple):
    """A crank angle that words name: where they begin, the angle from the top in degrees, the words."""

    start: int
    degrees: Fraction
    words: str


@lru_cache(maxsize=64)
def crank_places(text: str) -> tuple[CrankPlace, ...]:
    """Return the crank angles that the words of a text name, in order.

    >>> [(float(a), w) for _, a, w in crank_places("At 30° after TDC it is 5, at 40° before TDC 3.")]
    [(30.0, '30° after TDC'), (-40.0, '40° before TDC')]
    >>> crank_places("It turns by 30° after the start; the valve opens at 12°.")
    ()
    """
    places: list[CrankPlace] = []
    for pattern in (_BEHIND, _CRANK_ANGLE):
        for match in pattern.finditer(text):
            groups = match.groupdict()
            digits = groups["degrees"] or groups.get("japanese") or "0"
            way = groups.get("way") or groups.get("later") or ""
            angle = Fraction(digits.replace(",", "."))
            angle = -angle if way and _BEFORE_TOP.match(way) else angle
            words = " ".join(match[0].replace("$", "").replace("^\\circ", "°").split())
            places.append(CrankPlace(match.start(), angle, words))
    return tuple(sorted(places))
