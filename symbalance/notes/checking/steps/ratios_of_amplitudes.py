"""Ratios of largest values: X_max/Y_max of X = 2 F cos²(γ/2) cos θ and Y = 2 F sin²(γ/2) sin θ above.

Each of the two is the amplitude of its wave, so that their ratio is cot²(γ/2), and not cot(γ/2).
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Product,
    Quotient,
    names,
    parts_of_kind,
)
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.motions.named_extremes import base_of_largest
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.checking.words.plain_formulas import lone_side, plain_text
from symbalance.notes.reading.equations import Chain

_OPEN = (DEFINITION, PREMISE, CONDITION, UNDECIDED)
_WAVES = ("sin", "cos")


def unless_other_ratio(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a ratio of two largest values is judged by the amplitudes of their formulas."""
    head, right = chain.sides[0].node, chain.sides[1]
    if (
        k
        or verdict.verdict not in _OPEN
        or not isinstance(head, Quotient)
        or chain.relations[0].sign not in "=≈"
    ):
        return verdict
    pair = head.numerator, head.denominator
    sizes = [_amplitude(state, chain, part) for part in pair if isinstance(part, Name)]
    first, second = sizes if len(sizes) == len(pair) else (None, None)
    if first is None or second is None or not names(right.node) or names(head) & names(right.node):
        return verdict
    knowledge = state.knowledge(chain.lines[0])
    exact = Quotient(first, second)
    free = names(first) | names(second)
    if not names(right.node) <= free:
        return verdict
    positive = replace(knowledge.meaning, positive=knowledge.meaning.positive | free)
    known = replace(knowledge, meaning=positive)
    decisions = [decide(lone_side(node), right, "=", known) for node in (exact, Negative(exact))]
    shown = " and ".join(
        f"{plain_text(part)} is {plain_text(size)}"
        for part, size in zip(pair, sizes, strict=True)
        if size
    )
    if decisions[0].is_proved:
        there = replace(decisions[0], assumptions=(*decisions[0].assumptions, shown))
        return describe(state.document, chain, k, there)
    if any(each.status != REFUTED for each in decisions):
        return verdict
    for part in pair:
        assert isinstance(part, Name)
        state.definitions.forget(part.name, chain.lines[0])
    reason = f"by the formulas above {shown}"
    return describe(state.document, chain, k, replace(decisions[0], reason=reason))


def _amplitude(state: JudgingState, chain: Chain, part: Name) -> Formula | None:
    """Return the amplitude of the one wave that a largest value's letter has by a formula above."""
    base = base_of_largest(part.name)
    above = state.sections.chains_above(Name(base), chain.start) if base else []
    near = [c for c in above if state.sections.same_section(c.lines[0], chain.lines[0])]
    sizes = [size for c in near for side in c.sides[1:] if (size := _without_wave(side.node)) is not None]
    return sizes[-1] if sizes else None


def _without_wave(node: Formula) -> Formula | None:
    """Return a product without its last sine or cosine; None where its angle stands elsewhere too."""
    bare = node.operand if isinstance(node, Negative) else node
    if not isinstance(bare, Product):
        return None
    *others, wave = bare.factors
    if not isinstance(wave, Call) or wave.function not in _WAVES or not others:
        return None
    turning = names(wave.argument)
    if not turning or any(turning & names(each) for each in others):
        return None
    if any(part.function not in _WAVES for each in others for part in parts_of_kind(each, Call)):
        return None
    return Product(tuple(others)) if len(others) > 1 else others[0]
