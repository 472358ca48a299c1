"""What a page itself calls wrong claims nothing, and gives no letter a value; unless it is right."""

from __future__ import annotations

from dataclasses import replace

from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.inequalities import decide_inequality
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, Verdict
from symbalance.notes.checking.words.said_wrong import is_said_never, is_said_not_always, is_said_wrong
from symbalance.notes.reading.equations import Chain

SAID_WRONG = "said to be wrong"
OPPOSITE = {"<": "≥", "≥": "<", ">": "≤", "≤": ">"}


def verdict_on_denied(state: JudgingState, chain: Chain) -> Verdict | None:
    """Return the verdict on a relation that the words around it call wrong; None for any other.

    One that holds without any assumption is refuted: the words about it are false. Of numbers alone they
    call what it is put to wrong, 1775 + 1834 = 3609 N for forces at right angles, and not the sum.
    """
    text, is_one = state.document.text, len(chain.relations) == 1 and bool(chain.letters)
    if not is_one:
        return None
    if chain.relations[0].sign in OPPOSITE and is_said_never(text, chain.start, chain.end):
        return _verdict_on_never(state, chain)
    is_partly = chain.relations[0].sign == "=" and is_said_not_always(text, chain.end)
    if not is_partly and not is_said_wrong(text, chain.start, chain.end):
        return None
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    left, right = chain.sides
    there = decide(left, right, chain.relations[0].sign, knowledge)
    if there.is_proved and not there.assumptions and not there.order:
        how = "not to hold of everything" if is_partly else "to be wrong"
        return describe(state.document, chain, 0, Decision(REFUTED, f"it is said {how}, and it holds"))
    if is_partly and there.status != REFUTED:
        return None
    return describe(state.document, chain, 0, Decision(CONDITION, SAID_WRONG))


def _verdict_on_never(state: JudgingState, chain: Chain) -> Verdict | None:
    """Return the verdict on an inequality that is said to be true nowhere: its opposite is true then."""
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    relation = replace(chain.relations[0], sign=OPPOSITE[chain.relations[0].sign])
    opposite = decide_inequality(replace(chain, relations=(relation,)), 0, knowledge)
    if opposite.is_proved:
        found = replace(opposite, reason="true nowhere, as the words say")
    elif opposite.status == REFUTED:
        found = Decision(REFUTED, "said to be true nowhere, and true for some values at least")
    else:
        found = Decision(CONDITION, "said to be true nowhere")
    return describe(state.document, chain, 0, found)
