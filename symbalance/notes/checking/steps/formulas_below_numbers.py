"""Formulas of a letter that has its number above, in letters that have none: f = 40 Hz, and f = ω/(2π).

A formula says then what its letters are, and nothing that the number could be at odds with.
"""

from __future__ import annotations

from symbalance.document.formula import Name, names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import DEFINITION, REFUTED, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain


def unless_it_fixes_letters(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a formula of a given number says what a letter is that has no value."""
    head, right = chain.sides[0].node, chain.sides[1].node
    is_one = not k and len(chain.relations) == 1 and chain.relations[0].sign == "="
    if not is_one or verdict.verdict != REFUTED or verdict.reason or not isinstance(head, Name):
        return verdict
    own, knowledge = names(right), state.knowledge(chain.lines[0])
    known = knowledge.definitions.get(head.name)
    if known is None or not known.numeric or known.formula is not None or names(known.node):
        return verdict
    if not own or head.name in knowledge.meaning.values or head.name in own:
        return verdict
    if any(_is_known(state, chain, name, knowledge) for name in own):
        return verdict
    state.definitions.note_premise(chain, k)
    fixed = plain_text(Name(sorted(own)[0]))
    return describe(state.document, chain, k, Decision(DEFINITION, f"read as what fixes {fixed}"))


def _is_known(state: JudgingState, chain: Chain, name: str, knowledge: Knowledge) -> bool:
    """Tell whether a letter has a value, runs through all of them, or stands in a premise above."""
    premises = state.definitions.premises_at(chain.lines[0])
    is_bound = any(name in premise.names for premise in premises if premise.line < chain.lines[0])
    return knowledge.knows(name) or name in knowledge.universal or is_bound
