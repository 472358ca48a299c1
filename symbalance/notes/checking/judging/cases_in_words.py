"""Cases that words open for another formula of a letter: if both are bolted together, ω = √(k/(m₁ + m₂)).

A letter alone that gets a second formula there speaks of another setup than in the line above, whatever
factor lies between. Words with a relation of their own, "with S = J", only put something into the first
formula, and words of a conclusion, "so", "hence", go on with it.
"""

from __future__ import annotations

from symbalance.document.formula import Call, Name, Number, names, walk
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_OPENS = re.compile(
    r"(?<![A-Za-z])(?:if|when|without|otherwise|whereas|instead|for|in\s+the|in\s+an?|on|of\s+the|unlike|but)(?![A-Za-z])"
    r"|(?<![A-Za-zÄÖÜäöü])(?:wenn|falls|ohne|sonst|dagegen|für|im|bei|beim|in\s+der)(?![A-Za-zÄÖÜäöü])|場合|のとき|なら|では",
    re.IGNORECASE,
)
_GOES_ON = re.compile(
    r"(?<![A-Za-z])(?:so|hence|thus|therefore|gives|yields|becomes?|reduces|simplifies|follows|equals|i\.e|that\s+is|same"
    r"|again|general|small|approximat\w*|roughly|insert\w*|substitut\w*|solv\w*|also|damit|folgt|ergibt|daraus|wird|oder"
    r"|or|allgemein|klein\w*|näherungs\w*|einsetzen|eingesetzt)(?![A-Za-z])|よって|ゆえに|したがって|すなわち|代入|近似",
    re.IGNORECASE,
)
_RELATION = re.compile(r"[=≈<>≪≫]|\\(?:approx|ll|gg|to|infty|rightarrow)\b|->")
_BOUNDARY = re.compile(r"[.;:!?](?:\s|$)|[。；]|\n\s*\n")
FARTHEST = 400
"""Characters from one formula of a letter to the next."""


def opens_case_in_words(chain: Chain, document: ReadNotes) -> bool:
    """Tell whether words between two formulas of a letter say that the second is of another setup."""
    head, right = chain.sides[0].node, chain.sides[1].node
    if not isinstance(head, Name) or isinstance(right, Number) or not names(right):
        return False
    if any(isinstance(part, Call) and part.function in ("sin", "cos", "tan") for part in walk(right)):
        return False
    start = chain.start
    ends = [
        max(side.span[1] for side in other.sides)
        for other in document.chains
        if other.relations and other.sides[0].node == head
    ]
    end = max((each for each in ends if each <= start), default=start)
    if start - end > FARTHEST:
        return False
    words = _BOUNDARY.split(document.text[end:start])[-1]
    return bool(_OPENS.search(words)) and not _GOES_ON.search(words) and not _RELATION.search(words)
