"""Decisions whether one relation = or ≈ holds, in any of the readings of its two sides."""

from __future__ import annotations

from itertools import product

from symbalance.document.formula import Formula, Name
from symbalance.notes.checking.deciding.equality import (
    REFUTED,
    UNDECIDED,
    Decision,
    decide_equality,
    without_dots,
)
from symbalance.notes.checking.deciding.induction import decide_by_induction
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.order_agreement import decide_agreement, degree
from symbalance.notes.reading.equations import Side

MOST_READINGS = 16
"""Pairs of readings that are tried: a decision may cost a second."""


def decide(
    left: Side, right: Side, sign: str, knowledge: Knowledge, through: int | None = None
) -> Decision:
    """Decide a relation = or ≈ in the first pair of readings that proves it; else in the usual ones."""
    first: Decision | None = None
    pairs = list(product(left.readings, right.readings))[:MOST_READINGS]
    for left_node, right_node in pairs:
        decision = decide_reading(left_node, right_node, sign, knowledge, through)
        if decision.is_proved:
            return decision
        first = first or decision
    return first or Decision(UNDECIDED, "nothing to compare")


def decide_reading(
    left: Formula, right: Formula, sign: str, knowledge: Knowledge, through: int | None = None
) -> Decision:
    """Decide left = right or left ≈ right."""
    by_steps = decide_by_induction(left, right, knowledge)
    if by_steps is not None:
        return by_steps
    (bare_left, left_is_cut), (bare_right, right_is_cut) = without_dots(left), without_dots(right)
    if sign == "≈" or left_is_cut or right_is_cut or through is not None:
        return decide_agreement(
            left, right, knowledge, through=through, loose=left_is_cut or right_is_cut
        )
    decision = decide_equality(bare_left, bare_right, knowledge)
    if decision.status == REFUTED and _is_cut_off(left, decision, knowledge):
        return decide_agreement(left, right, knowledge)
    return decision


def _is_cut_off(node: Formula, decision: Decision, knowledge: Knowledge) -> bool:
    """Tell whether = stands between an exact form and its series, cut off: then ≈ is meant.

    The exact form is one that is no polynomial in the ratio, or a letter of known meaning.
    """
    if (
        knowledge.crank is None
        or knowledge.crank.small is None
        or not decision.left
        or not decision.right
    ):
        return False
    letter, sign = knowledge.crank.small
    has_meaning = isinstance(node, Name) and node.name in knowledge.meaning.values
    exact = has_meaning or degree(decision.left, letter, sign) is None
    return exact and degree(decision.right, letter, sign) is not None
