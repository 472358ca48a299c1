"""Corrections of a relation that is refuted, on its right side or on its left one."""

from __future__ import annotations

from symbalance.document.formula import Formula, Name
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.repair.fixes import add_fix, is_proved_as_far
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.reading.equations import Chain, Side


def add_fix_of_relation(
    state: JudgingState,
    verdict: Verdict,
    chain: Chain,
    k: int,
    left: Side,
    decision: Decision,
    knowledge: Knowledge,
) -> Verdict:
    """Return the verdict with the change that would make its relation true, on either side."""
    right, sign = chain.sides[k + 1], chain.relations[k].sign
    as_written = "≈" if left is not chain.sides[k] else sign

    def proves_right(node: Formula) -> bool:
        return is_proved_as_far(decide(left, Side((node,), right.span), as_written, knowledge), decision)

    def proves_left(node: Formula) -> bool:
        return is_proved_as_far(decide(Side((node,), left.span), right, as_written, knowledge), decision)

    # What stood right of the relation before was said there: the slip is in what is new.
    is_old = k > 0 or isinstance(left.node, Name)
    of_left = None if is_old else proves_left
    return add_fix(
        verdict, state.document, right, decision, knowledge, proves_right, chain.sides[k], of_left
    )
