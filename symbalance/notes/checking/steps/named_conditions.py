"""Letters solved for that their words name: with ε = (V_h + V_c)/V_c the clearance volume is no V_h/ε.

A formula that holds a letter of a line above is taken for a condition on that letter. Where words name
what it gives, it is judged by the standard formula of that.
"""

from __future__ import annotations

from symbalance.document.formula import Name, names
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, REFUTED, Verdict
from symbalance.notes.reading.equations import Chain


def unless_named_otherwise(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a condition is wrong where words name the letter, and it is another formula."""
    if verdict.verdict != CONDITION or k or not isinstance(chain.sides[0].node, Name):
        return verdict
    if not names(chain.sides[1].node):
        return verdict
    outcome = state.named.judge(chain, k, state.knowledge(chain.lines[0]))
    is_wrong = isinstance(outcome, Verdict) and outcome.verdict == REFUTED
    return outcome if is_wrong and isinstance(outcome, Verdict) else verdict
