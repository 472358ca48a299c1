"""A V8 that words name with its crankshaft's plane: "the cross-plane V8", "V8 mit ebener Kurbelwelle".

Two cylinders are on each of four pins, at 0°, 90°, 270°, 180° or at 0°, 180°, 180°, 0°, and the banks are
90° apart. Where words name another angle, both planes, or another engine beside it, it is none.
"""

from __future__ import annotations

from symbalance.notes.checking.words.engines_in_words import CrankStar, EnginesInWords, NamedEngine
from symbalance.text import lazy_patterns as re

_EIGHT = re.compile(
    r"(?<![A-Za-z])[VＶ](?:[-\s]?(?:8(?![0-9])|eight|achtzylinder)|型\s?8\s?気筒)", re.IGNORECASE
)
_CYLINDERS = 8
_BANK_WORD = re.compile(r"banks?|バンク|bankwinkel|[VＶ]型", re.IGNORECASE)
_CROSS = re.compile(
    r"cross[\s-]?plane|クロスプレーン|Kreuz(?:kröpfung|kurbelwelle|welle)|crociata|albero\s+a\s+croce|vilebrequin\s+(?:en\s+croix|croisé)|cigüeñal\s+(?:en\s+cruz|cruzado)",
    re.IGNORECASE,
)
_FLAT = re.compile(
    r"flat[\s-]?plane|single[\s-]plane|フラットプレーン|eben\w*\s+kurbelwelle|flachen?\s+kurbelwelle|vilebrequin\s+plat|cigüeñal\s+plano",
    re.IGNORECASE,
)
_OTHER_ANGLE = re.compile(
    r"(?<![0-9.,])(?!90)[1-9][0-9]{1,2}\s?(?:°|º|度|-?deg\w*|Grad)\s?-?\s?[VＶ]|offset|split|versetz|オフセット"
    r"|(?:bank|V)[\s-]?(?:angle|winkel)\D{0,12}(?!90)[0-9]{2,3}",
    re.IGNORECASE,
)
_AS_FOURS = re.compile(
    r"\bfours?\b(?![\s-](?:stroke|cycle))|vierzylinder|(?<![0-9])4\s?気筒|quatre\scyl|cuatro\scil",
    re.IGNORECASE,
)
"""Words for an eight as two fours, of which each may be meant."""
_STARS = {
    _CROSS: CrankStar((0, 90, 270, 180), banks=90),
    _FLAT: CrankStar((0, 180, 180, 0), banks=90),
}


def eight_named(engines: EnginesInWords, first: int, last: int, around: str) -> NamedEngine | None:
    """Return the V8 that a part of a text is about, if it or the words around it tell its plane."""
    own = engines.text[first:last]
    named = _EIGHT.search(own)
    others = [e for e in engines.every if first <= e.place < last]
    is_alone = all(
        _EIGHT.match(e.words)
        or (e.has_banks and _BANK_WORD.fullmatch(e.words))
        or e.cylinders in (_CYLINDERS, 1)  # the mass of one cylinder is no other engine
        for e in others
    )
    if named is None or not is_alone or _AS_FOURS.search(own):
        return None
    for words in (own, around):
        planes = [star for plane, star in _STARS.items() if plane.search(words)]
        if len(planes) > 1 or _OTHER_ANGLE.search(words):
            return None
        if planes:
            return NamedEngine(
                first + named.start(), named[0], _CYLINDERS, has_banks=True, stars=(planes[0],)
            )
    return None
