"""Largest and least values that a subscript names: of T = T_0 + T_1 sin θ, T_max = T_0 + T_1.

With one wave in a formula, its extremes are where that is 1 and where it is -1. A claim in the same
letters, or in numbers, is one of them or it is wrong. Sizes are taken to be positive.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    names,
    parts_of_kind,
    with_parts_changed,
)
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import DEFINITION, PREMISE, Verdict
from symbalance.notes.checking.words.plain_formulas import lone_side, plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_NAMED = re.compile(r"(?P<stem>[^\W_]+(?:_[^\W_]+)*)_(?P<kind>max|min)")
_LIMIT = re.compile(
    r"(?<![^\W\d_])(?:allow\w*|permi\w+|limit\w*|rated|yield|design|zul\w*|erlaub\w*|grenz\w*|nenn\w*|admissible|amissibil\w+"
    r"|admisible|limite|at\s+most|speed\s+range|governor"
    r"|between|from|within|zwischen|von|entre|da|desde)(?![^\W\d_])|許容|限界|定格|から",
    re.IGNORECASE,
)
"""Words for a bound that somebody sets or for a part of a turn, and no extreme of the formula."""


def unless_other_extreme(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; that on a largest or least value by the one wave of its letter's formula."""
    head, claim = chain.sides[0].node, chain.sides[1].node
    named = _NAMED.fullmatch(head.name) if isinstance(head, Name) else None
    if k or named is None or verdict.verdict not in (DEFINITION, PREMISE):
        return verdict
    if _LIMIT.search(state.sections.sentence_before(chain)):
        return verdict
    knowledge = state.knowledge(chain.lines[0])
    formula = _formula(state, chain, named["stem"])
    extremes = None if formula is None else _extremes(formula)
    if formula is None or extremes is None or _is_in_range(formula, knowledge):
        return verdict
    largest, least = extremes
    wanted, other = (largest, least) if named["kind"] == "max" else (least, largest)
    own = names(wanted) | names(other)
    numeric = {n for n in own if n in knowledge.definitions}
    if not names(claim) <= own or (not names(claim) and not own <= numeric):
        return verdict
    decision = _decide(wanted, other, claim, knowledge)
    return verdict if decision is None else describe(state.document, chain, k, decision)


def _is_in_range(formula: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a range is said of a letter in the wave: it may not come to its crest."""
    own = {n for part in parts_of_kind(formula, Call) for n in names(part)}
    return any(own & (names(stated.left) | names(stated.right)) for stated in knowledge.ranges)


def _decide(wanted: Formula, other: Formula, claim: Formula, knowledge: Knowledge) -> Decision | None:
    """Return whether a claim is an extreme, or the size of the other one; None where that is open."""
    own = names(wanted) | names(other) | names(claim)
    meaning = replace(knowledge.meaning, positive=knowledge.meaning.positive | own)
    known = replace(knowledge, meaning=meaning)
    try:
        there = decide(lone_side(wanted), lone_side(claim), "=", known)
        if there.is_proved:
            signs = tuple(t for t in there.assumptions if "≥ 0" not in t)
            return Decision(PROVED, order=there.order, assumptions=(*signs, "all sizes are positive"))
        others = [
            decide(lone_side(each), lone_side(claim), "=", known) for each in (other, Negative(other))
        ]
    except (NoFormError, TooLargeError):
        return None
    if there.status != REFUTED or any(each.is_proved for each in others[1:]):
        return None  # the size of a force that pulls
    return Decision(REFUTED, f"the wave leaves {plain_text(wanted)}", witness=there.witness)


def _formula(state: JudgingState, chain: Chain, stem: str) -> Formula | None:
    """Return the formula that a letter has last above, in the section; None for none, or a wrong one."""
    for above in reversed(state.sections.chains_above(Name(stem), chain.start)):
        if not state.sections.same_section(above.lines[0], chain.lines[0]):
            return None
        formula = above.sides[1]
        if above.relations[0].sign == "=" and names(formula.node):
            return None if formula.span[0] in state.refuted else formula.node
    return None


def _extremes(node: Formula) -> tuple[Formula, Formula] | None:
    """Return a formula where its one wave is 1 and -1, the larger first; None for others."""
    waves = list(parts_of_kind(node, Call))
    if len(waves) != 1 or not isinstance(waves[0], Call) or waves[0].function not in ("sin", "cos"):
        return None
    wave = waves[0]
    if not names(wave.argument) or not names(wave.argument).isdisjoint(names(_with_wave(node, wave, 1))):
        return None  # t sin ω t grows
    first, second = (_with_wave(node, wave, sign) for sign in (1, -1))
    positive = SymbolValue(positive=frozenset(names(node)))
    points = sample_trees([first, second], positive)
    larger = {bool(a.real > b.real) for _, (a, b) in points}
    if len(larger) != 1:
        return None
    return (first, second) if larger.pop() else (second, first)


def _with_wave(node: Formula, wave: Call, sign: int) -> Formula:
    """Return a formula with 1 or -1 for its wave, which a product goes without."""
    one = Number(Fraction(1))
    if node == wave:
        return one if sign > 0 else Negative(one)
    if isinstance(node, Product) and wave in node.factors and len(node.factors) > 1:
        rest = Product(tuple(factor for factor in node.factors if factor != wave))
        bare = rest.factors[0] if len(rest.factors) == 1 else rest
        return bare if sign > 0 else Negative(bare)
    return with_parts_changed(node, lambda part: _with_wave(part, wave, sign))
