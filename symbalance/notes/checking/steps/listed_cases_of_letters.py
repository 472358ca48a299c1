"""Letters that run through listed values, z = a/2, -a/2: each is a case, and none is claimed of another.

The reader has such a list as the range that holds it. A line above may have had another of the cases, "at
n = 4", and a line below may: neither is at odds with the list.
"""

from __future__ import annotations

import re

from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.verdicts import RANGE
from symbalance.notes.reading.equations import Chain, ReadNotes

_INEQUALITY = re.compile(r"[<>≤≥≪≫≠]|\\(?:leq?|geq?|lt|gt|ll|gg|neq?|leqslant|geqslant)(?![A-Za-z])|!=")
_RUN = re.compile(r"\.{2,}|…|⋯|・・・|\\(?:l|c)?dots|(?<![A-Za-z])(?:to|bis)(?![A-Za-z])")
_LISTED = "runs through the values listed"


def case_of_listed_values(document: ReadNotes, chain: Chain) -> Decision | None:
    """Return that a relation only lists the values that a letter runs through; None for others."""
    if all(relation.sign == "=" for relation in chain.relations):
        return None
    written = document.text[chain.start : chain.end]
    if "=" not in written or _INEQUALITY.search(written) or _RUN.search(written):
        return None
    return Decision(RANGE, _LISTED)
