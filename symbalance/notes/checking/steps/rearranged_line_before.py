"""Relations that words derive from the equation right before them: J θ + K φ = 0, therefore φ/θ = -J/K.

Whatever else is open of its letters, such a relation is the equation before it, solved: with one letter
of that put in, both sides are the same, or it does not follow.
"""

from __future__ import annotations

from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.system import Premise, eliminate
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import DECLARE_IT, UNDECIDED, Verdict
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading.equations import Chain

FEWEST_LETTERS = 3
"""Of an equation from which a relation follows: with two, x = 2y, anything may be meant."""


def by_line_before(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; an open relation is decided by the equation right before it, if words say so."""
    is_one = not k and len(chain.relations) == 1 and chain.relations[0].sign == "="
    is_open = verdict.verdict == UNDECIDED and verdict.reason.endswith(DECLARE_IT)
    if not is_open or not is_one or not state.sections.is_consequence(chain):
        return verdict
    before = state.sections.chain_before(chain.start)
    if before is None or not state.sections.follows_at_once(chain) or not _is_equation(state, before):
        return verdict
    if len(before.letters) < FEWEST_LETTERS or not chain.letters <= before.letters:
        return verdict
    decision = _decide(before, chain)
    return verdict if decision is None else describe(state.document, chain, k, decision)


def _is_equation(state: JudgingState, before: Chain) -> bool:
    """Tell whether a chain is one equation, and not refuted."""
    is_one = len(before.relations) == 1 and before.relations[0].sign == "="
    return is_one and before.sides[1].span[0] not in state.refuted


def _decide(before: Chain, chain: Chain) -> Decision | None:
    """Return whether a relation is another one solved; None where that can not be told."""
    premise = Premise(before.sides[0].node, before.sides[1].node, before.lines[0])
    try:
        solved = eliminate([premise], Knowledge()).values
        left, right = (side.node for side in chain.sides)
        for name, value in solved.items():
            left, right = (substitute(node, name, value) for node in (left, right))
        decision = decide(lone_side(left), lone_side(right), "=", Knowledge())
    except (NoFormError, TooLargeError):
        return None
    line = before.lines[0]
    if not solved or not (decision.is_proved or decision.status == REFUTED):
        return None
    if decision.is_proved:
        return Decision(PROVED, f"by line {line}", assumptions=decision.assumptions)
    return Decision(REFUTED, f"does not follow from line {line}", witness=decision.witness)
