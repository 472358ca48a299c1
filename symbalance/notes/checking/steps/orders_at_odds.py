"""Orders that do not fit the sum that they are a part of: F_2 = λ m r ω² cos θ, below F = F_1 + F_2.

What does not fit a line above may be of another case. Where the letter's words or its declaration name
the order that it is, and its formula is wrong for that order by one slip, it is wrong.
"""

from __future__ import annotations

from symbalance.notes.checking.premises.premise_decisions import DOES_NOT_FIT
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import REFUTED, UNDECIDED, Verdict
from symbalance.notes.reading.equations import Chain


def unless_of_named_order(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; refuted where a formula that does not fit is wrong for the order words name."""
    is_open = verdict.verdict == UNDECIDED and (verdict.reason or "").startswith(DOES_NOT_FIT)
    if k or not is_open:
        return verdict
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    by_order = state.named_orders.judge(chain, k, knowledge, state.cranks_of)
    is_wrong = isinstance(by_order, Verdict) and by_order.verdict == REFUTED
    return by_order if is_wrong and isinstance(by_order, Verdict) else verdict
