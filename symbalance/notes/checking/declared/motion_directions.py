"""The direction in which a declared motion counts as positive: "piston velocity, away from the crank".

The formulas of `geometry` count a velocity and an acceleration towards the crank, as from top dead
centre, and the inertia force away from it. A declaration that names the other direction gives its letter
the other sign; one that names none has the sign of the formulas.
"""

from __future__ import annotations

from symbalance.document.formula import Formula, Negative
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.text import lazy_patterns as re

DIRECTED = ("piston velocity", "piston acceleration", "inertia force")
"""Meanings that have either sign, by the direction that a page counts as positive."""
AWAY = "away from the crank"
_AWAY = re.compile(
    r"away from (?:the )?crank|(?:toward|to)s? (?:the )?(?:tdc|top dead|outer dead|cylinder head|head)"
    r"|\b(?:up|upwards?|outwards?)\b|von der kurbel(?:welle)? weg|weg von der kurbel"
    r"|\b(?:nach (?:oben|außen|aussen)|aufwärts|auswärts)\b|zum (?:zylinderkopf|ot\b|oberen totpunkt)"
    r"|クランク(?:軸|中心|シャフト)?(?:の中心)?から(?:離|遠)|上向き|上方|上死点(?:の方)?(?:へ|に)?向",
    re.IGNORECASE,
)
_TOWARDS = re.compile(
    r"(?:toward|to)s? (?:the )?(?:crank|bdc|bottom dead|inner dead)|\b(?:down|downwards?|inwards?)\b"
    r"|\bzu[rm] (?:kurbel|ut\b|unteren totpunkt)|\b(?:nach (?:unten|innen)|abwärts|einwärts)\b"
    r"|クランク(?:軸|中心|シャフト)?(?:の中心)?(?:の方)?(?:へ|に)向|下向き|下方|下死点(?:の方)?(?:へ|に)?向",
    re.IGNORECASE,
)


def direction_of(text: str) -> int:
    """Return 1 for a declaration that counts a motion towards the crank, -1 away from it, 0 for neither.

    >>> direction_of("piston velocity, away from the crank"), direction_of("piston velocity")
    (-1, 0)
    """
    away, towards = _AWAY.search(text) is not None, _TOWARDS.search(text) is not None
    return 0 if away == towards else (-1 if away else 1)


def directed(text: str, node: Formula) -> Formula:
    """Return a declared motion's formula, with the other sign where its text names that direction."""
    role, direction = role_of(text), direction_of(text)
    if role not in DIRECTED or not direction:
        return node
    usual = -1 if role == "inertia force" else 1
    return node if direction == usual else Negative(node)
