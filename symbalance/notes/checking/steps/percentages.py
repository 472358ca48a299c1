"""Percentages of what stands before them: x_1 = x_0 + 20 % = 60 is x_0 and 20 % of it.

Taken as the number 0.2 they give nonsense; what is refuted so holds where it is right of the share.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Formula, Negative, Product, Sum, names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONTRADICTION, REFUTED, Verdict
from symbalance.notes.reading.equations import Chain, Side

OF_IT = "the percentage is of what stands before it"


def unless_percent_of_it(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a refuted one is right if percentages are of what is before them."""
    if verdict.verdict not in (REFUTED, CONTRADICTION):
        return verdict
    if "%" not in state.document.text[chain.start : chain.end]:
        return verdict
    left, right = (_of_what_is_before(state, side) for side in chain.sides[k : k + 2])
    if left is chain.sides[k] and right is chain.sides[k + 1]:
        return verdict
    there = decide(left, right, chain.relations[k].sign, state.knowledge(chain.lines[0]))
    if not there.is_proved:
        return verdict
    assumed = replace(there, assumptions=(*there.assumptions, OF_IT))
    return describe(state.document, chain, k, assumed)


def _of_what_is_before(state: JudgingState, side: Side) -> Side:
    """Return a side whose percentage, the last of its terms, is times the terms before; else itself."""
    node = side.node
    if not isinstance(node, Sum) or len(node.terms) < 2 or names(node.terms[-1]):
        return side
    share = node.terms[-1]
    is_share = isinstance(share.operand if isinstance(share, Negative) else share, Product)
    if not is_share or not state.document.source(share.span).rstrip(" }$").endswith("%"):
        return side
    before: Formula = node.terms[0] if len(node.terms) == 2 else Sum(node.terms[:-1])
    return replace(side, readings=(Sum((before, Product((share, before))), span=node.span),))
