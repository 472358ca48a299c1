"""Results with the π that a page rounds: π = 3.14 and r = 2 make A = π r² = 12.56, and not 12.57.

A page that says what it takes π for goes on with that number. What is right with it holds if π is that.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Constant, Formula, Number, names, with_parts_changed
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONTRADICTION, REFUTED, Verdict
from symbalance.notes.checking.words.plain_formulas import lone_side, plain_text
from symbalance.notes.reading.equations import Chain

_PI = Constant("pi")


def unless_with_own_pi(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a refuted result is tried with the number that the page gives π above."""
    right = chain.sides[k + 1].node
    if verdict.verdict not in (REFUTED, CONTRADICTION) or names(right):
        return verdict
    given = state.sections.last_above(_PI, chain.start)
    rounded = given.sides[1].node if given is not None else None
    if given is None or not isinstance(rounded, Number) or rounded.last_place is None:
        return verdict
    knowledge = state.knowledge(chain.lines[0])
    exact = Number(rounded.value)
    definitions = {n: replace(d, node=_with(d.node, exact)) for n, d in knowledge.definitions.items()}
    known = replace(knowledge, definitions=definitions)
    left = _with(chain.sides[k].node, exact)
    there = decide(lone_side(left), lone_side(_with(right, exact)), chain.relations[k].sign, known)
    if not there.is_proved:
        return verdict
    text = f"π = {plain_text(rounded)} of line {given.lines[0]}"
    return describe(state.document, chain, k, replace(there, assumptions=(*there.assumptions, text)))


def _with(node: Formula, number: Number) -> Formula:
    """Return a formula with a number for π."""
    if node == _PI:
        return number
    return with_parts_changed(node, lambda part: _with(part, number))
