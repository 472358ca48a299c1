"""Fractions whose denominator is zero by what the page says: if x = 0, x/x is no 1."""

from __future__ import annotations

from symbalance.document.formula import Quotient, names, parts_of_kind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import UNDECIDED, Decision
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import PROVED_WORDS, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain


def unless_divided_by_zero(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; what is proved by leaving out a factor that is zero there is open."""
    if verdict.verdict not in PROVED_WORDS:
        return verdict
    sides = chain.sides[k : k + 2]
    below = [part.denominator for side in sides for part in parts_of_kind(side.node, Quotient)]
    below = [node for node in below if names(node)]
    if not below:
        return verdict
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    for node in below:
        behind = names(node) & knowledge.definitions.keys()
        if behind and number_of(node, knowledge) == 0:
            reason = f"it divides by {plain_text(node)}, which is zero here"
            return describe(state.document, chain, k, Decision(UNDECIDED, reason))
    return verdict
