"""Letters that run through listed values, z = a/2, -a/2: each is a case, and none is claimed of another.

The reader has such a list as the range that holds it. A line above may have had another of the cases, "at
n = 4", and a line below may: neither is at odds with the list.
"""

from __future__ import annotations

from symbalance.document.formula import Name, Negative, Number, names
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.verdicts import RANGE
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

_INEQUALITY = re.compile(r"[<>≤≥≪≫≠]|\\(?:leq?|geq?|lt|gt|ll|gg|neq?|leqslant|geqslant)(?![A-Za-z])|!=")
_RUN = re.compile(r"\.{2,}|…|⋯|・・・|\\(?:l|c)?dots|(?<![A-Za-z])(?:to|bis)(?![A-Za-z])")
_LISTED = "runs through the values listed"


def case_of_listed_values(document: ReadNotes, chain: Chain) -> Decision | None:
    """Return that a relation only lists lengths or angles that a letter runs through; None for others.

    Bare numbers, k = 1, 2, 3, may be those that an index has in the sums of the page: they are noted.
    """
    written = _written_list(document, chain)
    is_index = all(isinstance(side.node, Number | Negative | Name) for side in chain.sides)
    if is_index and not any(names(side.node) for side in (chain.sides[0], chain.sides[-1])):
        return None
    return Decision(RANGE, _LISTED) if written and not _RUN.search(written) else None


def case_of_run(document: ReadNotes, chain: Chain) -> Decision | None:
    """Return that a letter runs through numbers, n = ½, 1, 1½, …, which has another value above."""
    written = _written_list(document, chain)
    return Decision(RANGE, _LISTED) if "," in written else None


def _written_list(document: ReadNotes, chain: Chain) -> str:
    """Return how a range is written that the page has as a list behind =; "" for other relations."""
    if all(relation.sign == "=" for relation in chain.relations):
        return ""
    written = document.text[chain.start : chain.end]
    return "" if "=" not in written or _INEQUALITY.search(written) else written
