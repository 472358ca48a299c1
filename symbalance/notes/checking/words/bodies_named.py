"""Bodies that words name before a formula: a disc: J = m R²/2; thin rim: J ≈ m R²."""

from __future__ import annotations

from symbalance.notes.checking.words.glossary import glossary_of
from symbalance.text import lazy_patterns as re

_BODY = re.compile(
    r"(?<![A-Za-z])(?:(?:thin|solid|hollow|slender|full|heavy|dünne[rsn]?|volle[rsn]?|hohle[rsn]?)[ -])?"
    r"(?:discs?|disks?|rims?|rings?|hoops?|rods?|bars?|spheres?|balls?|cylinders?|shells?|tubes?|plates?"
    r"|Scheiben?|Kranz|Ring|Stab|Kugel|Zylinder|Vollzylinder|Hohlzylinder|Rohr|Platte)(?![A-Za-z])"
    r"|円板|円盤|リム|円環|リング|棒|球|円柱|円筒",
    re.IGNORECASE,
)
_CLAUSE = re.compile(r"[.;!?。；\n]")
_REACH = 60
"""Characters before a formula in which its body is named."""


def body_named(text: str, start: int) -> str:
    """Return the body that a clause names before a place, "" for none.

    >>> text = "disc: J = m R^2/2; thin rim: J = m R^2"
    >>> body_named(text, 6), body_named(text, 29), body_named(text, 3)
    ('disc', 'thin rim', '')
    """
    before = glossary_of(text).english(_CLAUSE.split(text[max(start - _REACH, 0) : start])[-1])
    named = [match[0].lower() for match in _BODY.finditer(before)]
    return named[-1] if named else ""
