"""Premises behind a formula that are worked out themselves: F(1 + λ) = 1.25 F with λ = 40/160 = 0.25.

Such a chain is taken before what it stands behind, as λ = 0.25 alone is. "Where", "with" and the like
lead to it, at once or over the other premises of a list: with m = 0.5 kg, r = 80/2 = 40 mm.
"""

from __future__ import annotations

from collections.abc import Sequence

from symbalance.document.formula import Name, names
from symbalance.notes.reading.equations import Chain, ReadNotes
from symbalance.text import lazy_patterns as re

FARTHEST = 60
"""Characters between "with" and the letter, or between two premises of a list."""
_LEADS = re.compile(
    r"(?<![^\W\d_])(?:with|where|for|at|when|if|since|because|taking|putting|mit|wobei|worin|wo|für|bei|wenn|falls|da|weil"
    r"|avec|où|pour|si|car|con|donde|para|per|dove|med|met|waar|dla|gdzie)\s[^.;:!?。；\n=]*$",
    re.IGNORECASE,
)
_BETWEEN = re.compile(
    r"[^.;:!?。；\n=]*(?:,|(?<![^\W\d_])(?:and|und|et|y|e|och|en|i)(?![^\W\d_]))[\s$\\(\[`]*"
)
_RESULT = re.compile(
    r"(?<![^\W\d_])(?:so|hence|thus|then|therefore|gives?|giving|yields?|becomes?|is|are|also|daher|somit|damit|folgt|ergibt"
    r"|wird|ist|donc|donne|est)(?![^\W\d_])|よって|⇒|\\Rightarrow",
    re.IGNORECASE,
)


def is_worked_out_behind(document: ReadNotes, chain: Chain, row: Sequence[Chain]) -> bool:
    """Tell whether a chain works out a letter behind a formula of its row that has the letter."""
    head = chain.sides[0].node
    is_worked_out = len(chain.sides) > 2 and isinstance(head, Name) and _gives_number(chain)
    if not is_worked_out or not isinstance(head, Name):
        return False
    before = [c for c in row if c.end <= chain.start]
    uses = [c for c in before if head.name in c.letters and c.sides[0].node != head]
    return bool(uses) and _is_led_to(document.text, chain, before)


def _gives_number(chain: Chain) -> bool:
    """Tell whether a chain does nothing but give a letter numbers."""
    is_equal = all(relation.sign in "=≈" for relation in chain.relations)
    return (
        is_equal
        and isinstance(chain.sides[0].node, Name)
        and not any(names(s.node) for s in chain.sides[1:])
    )


def _is_led_to(text: str, chain: Chain, before: Sequence[Chain]) -> bool:
    """Tell whether words lead to a premise, over nothing but other premises of its list."""
    last = max(before, key=lambda c: c.end)
    between = text[max(last.end, chain.start - FARTHEST) : chain.start]
    if _RESULT.search(between):
        return False
    if _LEADS.search(between):
        return True
    is_listed = _gives_number(last) and _BETWEEN.fullmatch(between) is not None
    rest = [c for c in before if c is not last]
    return is_listed and bool(rest) and _is_led_to(text, last, rest)
