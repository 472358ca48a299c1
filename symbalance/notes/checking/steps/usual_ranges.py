"""Ranges that are usual: "typically 3 < l/r < 5" says nothing of the engine at hand, whose l/r is 5.2.

What is usual is no premise, and no number of the page refutes it. Bounds the wrong way round, or far from
the page's own value, stay what they are.
"""

from __future__ import annotations

from symbalance.document.formula import names
from symbalance.notes.checking.deciding.inequalities import compare
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.words.case_words import clause_before
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_USUAL = re.compile(
    r"(?<![A-Za-zäöü])(?:typical(?:ly)?|usual(?:ly)?|normal(?:ly)?|commonly?|often|mostly|as\s+a\s+rule|in\s+practice|rules?\s+of\s+thumb"
    r"|most\s+engines|customary|üblich(?:e[rns]?|erweise)?|typisch(?:e[rns]?|erweise)?|gewöhnlich|meist(?:ens)?|normalerweise"
    r"|in\s+der\s+Regel|in\s+der\s+Praxis|häufig|Richtwerte?|Erfahrungswerte?|habituellement|généralement|souvent|d'ordinaire)"
    r"(?![A-Za-zäöü])|通常|普通|一般的|多くの(?:機関|エンジン)|実用上|目安",
    re.IGNORECASE,
)
_BEHIND = 60
"""Characters behind a range in which its clause may say that it is usual."""
_FAR = 3
"""Times that a page's own value may be outside of what is usual."""


def is_usual_range(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> bool:
    """Tell whether words give a range as what is usual, and the page's own value is not far from it."""
    text, start, end = state.document.text, chain.start, chain.end
    before = clause_before(text, start)
    behind = re.split(r"[.;。；:\n=]", text[end : end + _BEHIND], maxsplit=1)[0]
    if not _USUAL.search(before) and not _USUAL.search(behind):
        return False
    first, last = chain.sides[0].node, chain.sides[-1].node
    if len(chain.sides) > 2 and not names(first) and not names(last):
        outer = compare(first, last, chain.relations[0].sign, knowledge)
        if outer is None or not outer.is_proved:
            return False
    values = [number_of(chain.sides[j].node, knowledge) for j in (k, k + 1)]
    if None in values or not all(values):
        return False
    ratio = abs(float(values[0] or 1) / float(values[1] or 1))
    return 1 / _FAR < ratio < _FAR
