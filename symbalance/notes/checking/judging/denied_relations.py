"""What a page itself calls wrong claims nothing, and gives no letter a value; unless it is right."""

from __future__ import annotations

from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, Verdict
from symbalance.notes.checking.words.said_wrong import is_said_wrong
from symbalance.notes.reading.equations import Chain

SAID_WRONG = "said to be wrong"


def verdict_on_denied(state: JudgingState, chain: Chain) -> Verdict | None:
    """Return the verdict on a relation that the words around it call wrong; None for any other.

    One that holds without any assumption is refuted: the words about it are false. Of numbers alone they
    call what it is put to wrong, 1775 + 1834 = 3609 N for forces at right angles, and not the sum.
    """
    text, is_one = state.document.text, len(chain.relations) == 1 and bool(chain.letters)
    if not is_one or not is_said_wrong(text, chain.start, chain.end):
        return None
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    left, right = chain.sides
    there = decide(left, right, chain.relations[0].sign, knowledge)
    if there.is_proved and not there.assumptions and not there.order:
        reason = "it is said to be wrong, and it holds"
        return describe(state.document, chain, 0, Decision(REFUTED, reason))
    return describe(state.document, chain, 0, Decision(CONDITION, SAID_WRONG))
