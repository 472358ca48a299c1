"""Sums of whole results that are put in for a formula: [-4000 cos 2θ - 3000 sin 2θ] = 5000 - (-5000).

Each of them is rounded, as the number is that they come to. An open relation with such a sum is judged
with that number: what it may be off by is half a unit, of the sum as of each.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Formula, Negative, Number, Sum, names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import REFUTED, UNDECIDED, Verdict
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading.equations import Chain

_LEAST = 100
"""A whole number with fewer digits is no result that is rounded."""


def unless_sum_of_results(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a formula beside a sum of whole results is judged by what they come to."""
    left, right = chain.sides[k], chain.sides[k + 1]
    is_open = verdict.verdict in (UNDECIDED, REFUTED) and chain.relations[k].sign in "=≈"
    if not is_open or not names(left.node) or not isinstance(right.node, Sum):
        return verdict
    numbers = [_whole(term) for term in right.node.terms]
    if any(number is None or abs(number) < _LEAST for number in numbers):
        return verdict
    total = Number(sum((number for number in numbers if number is not None), Fraction(0)))
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    there = decide(left, lone_side(total), chain.relations[k].sign, knowledge)
    return describe(state.document, chain, k, there) if there.is_proved else verdict


def _whole(node: Formula) -> Fraction | None:
    """Return the whole number that a term is, with its sign; None for other terms."""
    if isinstance(node, Negative):
        inner = _whole(node.operand)
        return None if inner is None else -inner
    is_whole = isinstance(node, Number) and node.last_place is None and node.value.denominator == 1
    return node.value if isinstance(node, Number) and is_whole else None
