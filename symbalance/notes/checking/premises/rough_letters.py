"""Equations between letters that a page has approximately: T ω = -m a v, where a ≈ r ω² cos θ.

They hold to the first order of the small letter. What a line writes beyond that is not passed over: it
is judged where both sides go as far, and else nobody knows.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.order_agreement import power_written
from symbalance.notes.checking.deciding.relations import MEANT_ROUGHLY, decide
from symbalance.notes.reading.equations import Side

BEYOND = "it agrees through the first order, and no line says enough of the terms that it has beyond"


def decide_roughly(left: Side, right: Side, decision: Decision, knowledge: Knowledge) -> Decision:
    """Return the decision on a refuted = by its first order, where a letter in it is cut off there.

    It is as exact as the least exact of its letters, and no more can be asked of it.
    """
    if decision.status != REFUTED or decision.of_matrices:
        return decision
    formulas = {n: d for n, d in knowledge.definitions.items() if not d.numeric}
    behind = {
        name
        for side in (left, right)
        for name in names_behind(side.node, {n: d.node for n, d in formulas.items()})
    }
    if not any(formulas[name].is_rough for name in behind & formulas.keys()):
        return decision
    in_letters = replace(knowledge, definitions=formulas)
    by_order = decide(left, right, "≈", in_letters, through=1)
    if not by_order.is_proved:
        return decision
    claimed, kept = _powers_kept(right, by_order, in_letters), _powers_kept(left, by_order, in_letters)
    if claimed > 1 and claimed == kept:
        return decision  # both go as far: M = -(cos θ + λ cos 2θ)(sin θ + λ/2 sin 2θ), multiplied out
    if claimed > 1:
        return Decision(UNDECIDED, BEYOND)
    return replace(by_order, reason=by_order.reason or MEANT_ROUGHLY)


def _powers_kept(side: Side, by_order: Decision, knowledge: Knowledge) -> int:
    """Return the highest power of the small letter that a side has; 0 where it is no polynomial in it."""
    try:
        return power_written(side.node, by_order.expanded_in, by_order, knowledge) or 0
    except (NoFormError, TooLargeError):
        return 0
