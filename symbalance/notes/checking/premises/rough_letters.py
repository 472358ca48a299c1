"""Equations between letters that a page has approximately: T ω = -m a v, where a ≈ r ω² cos θ."""

from __future__ import annotations

from dataclasses import replace

from symbalance.notes.algebra.tree_values import names_behind
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import MEANT_ROUGHLY, decide
from symbalance.notes.reading.equations import Side


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
    return replace(by_order, reason=by_order.reason or MEANT_ROUGHLY)
