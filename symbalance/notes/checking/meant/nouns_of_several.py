"""One noun for several letters: two masses, m_1 at the small end and m_2 at the big end.

Each letter is then that noun with the words behind the letter: the mass at the small end.
"""

from __future__ import annotations

from collections.abc import Iterator

from symbalance.notes.checking.meant.said_behind import SIGN, SaidBehind
from symbalance.text import lazy_patterns as re

_SINGULAR = {
    "masses": "mass", "massen": "Masse", "forces": "force", "kräfte": "Kraft", "moments": "moment",
    "momente": "Moment", "couples": "couple", "torques": "torque", "shares": "share", "parts": "part",
    "anteile": "Anteil", "amplitudes": "amplitude", "amplituden": "Amplitude", "masse": "massa",
    "masas": "masa",
}  # fmt: skip
_QUALIFIED = (
    r"(?:at|to|in|on|of|am|im|an|de[rs]?|du|des|au|aux|à|en|sur|nel|nella|al|alla|del|della|di)\s"
    r"[^\n,;:.$(=、。]{2,40}?"
)
_PAIR = re.compile(
    rf"(?<![^\W\d_])(?P<noun>{'|'.join(_SINGULAR)})(?:\s[^\W\d_]{{3,16}})?(?:,|:|\s[-–—]|\s\()?\s"
    rf"(?:one\s|eine[rs]?\s|l'une\s)?\$(?P<first>{SIGN})\$,?\s(?P<here>{_QUALIFIED})"
    rf"(?:,|,?\s(?:and|und|et|e|y))\s(?:the\sother\s)?\$(?P<second>{SIGN})\$,?\s(?P<there>{_QUALIFIED})"
    r"(?=[\s]*(?:[.,;:()]|\$\$|$))",
    re.IGNORECASE | re.MULTILINE,
)


def nouns_of_several(text: str) -> Iterator[SaidBehind]:
    """Yield two letters that one noun names, each with what the words behind it add.

    >>> text = "two point masses, $m_1$ at the small end and $m_2$ at the big end."
    >>> [(each.sign, each.words) for each in nouns_of_several(text)]
    [('m_1', 'mass at the small end'), ('m_2', 'mass at the big end')]
    """
    for match in _PAIR.finditer(text):
        noun = _SINGULAR[match["noun"].casefold()]
        for sign, words in (("first", "here"), ("second", "there")):
            place = re.sub("^to ", "at ", match[words].strip())  # as "au pied" is put in English
            yield SaidBehind(match[sign], match.start(sign), f"{noun} {place}")
