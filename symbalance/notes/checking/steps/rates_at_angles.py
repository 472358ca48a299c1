"""Rates in numbers at an angle: at θ = 60° it is ẋ = 15.71 (0.866 + 0.125·0.866), and not 0.

With the angle's number put in first nothing moves, and every rate is nothing. What is differentiated is
so at any angle, and the number is put in then.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from symbalance.document.formula import Derivative, Name, names, parts_of_kind
from symbalance.document.letters import is_greek
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.relations import decide_at_value
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONTRADICTION, REFUTED, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain, Side


def unless_rate_at_angle(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; proved for a rate in numbers that is right at the angle in force."""
    left, right = chain.sides[k : k + 2]
    is_rate = any(True for _ in parts_of_kind(left.node, Derivative)) and not names(right.node)
    if verdict.verdict not in (REFUTED, CONTRADICTION) or not is_rate:
        return verdict
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    definitions = knowledge.definitions
    numbered = [name for name, each in definitions.items() if each.numeric and is_greek(name)]
    for angle in (name for name in numbered if name in knowledge.angles):
        rest = {name: each for name, each in definitions.items() if name != angle}
        freer = replace(knowledge, definitions=rest, solved={}, solved_from=())
        value = definitions[angle].node
        for side in (left, *_formulas_above(state, chain, left, angle)):
            there = decide_at_value(side, right, chain.relations[k].sign, freer, angle, value)
            if there.is_proved:
                text = f"{plain_text(Name(angle))} = {plain_text(value)}"
                proof = replace(there, assumptions=(*there.assumptions, text))
                return describe(state.document, chain, k, proof)
    return verdict


def _formulas_above(state: JudgingState, chain: Chain, rate: Side, angle: str) -> Iterator[Side]:
    """Yield the formula in an angle that the page gives a rate last, which may be a series cut off."""
    for above in reversed(state.sections.chains_of(rate.node)):
        if above.start >= chain.start:
            continue
        for side in above.sides[1:]:
            if angle in names(side.node) and side.span[0] not in state.refuted:
                yield replace(side, span=rate.span)
                return
