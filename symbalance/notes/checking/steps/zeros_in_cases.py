"""Zeros that a formula does not have in the case at hand: F = (m - m_c) r ω², for m_c = m/2 it is F = 0.

A number that a letter with a formula is said to have somewhere is that of a case, and fixes another
letter. Zero fixes none where the case leaves one product of sizes: it would make one of them vanish.
"""

from __future__ import annotations

from collections.abc import Mapping

from symbalance.document.formula import Call, Formula, Name, Number, Sum, names, walk
from symbalance.notes.algebra.domain import TURN, NoFormError, TooLargeError
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, PREMISE, Verdict
from symbalance.notes.checking.words.plain_formulas import lone_side, plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_OPEN = (DEFINITION, PREMISE, CONDITION)
_NEAR_LINES = 6
"""Lines above a value within which its formula stands."""
_NEAR = 90
"""Characters between what opens a case and what is said of it."""
_LEAVES = re.compile(
    r"[.;!?]\s|[。；]|\n\s*\n|(?<![^\W\d_])(?:but|while|whereas|except|aber|mais)(?![^\W\d_])"
)


def unless_false_zero(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a zero is refuted where a formula above is one product of sizes in its case."""
    head, right = chain.sides[0].node, chain.sides[1].node
    is_zero = isinstance(right, Number) and not right.value and not right.last_place
    if k or verdict.verdict not in _OPEN or len(chain.relations) != 1 or not is_zero:
        return verdict
    above = _formula_above(state, chain, head) if isinstance(head, Name) else None
    if above is None or not isinstance(head, Name):
        return verdict
    cases = _cases_of_sentence(state, chain, _letters_that_may_cancel(above[1]))
    if not cases or not _is_product_in(state, chain, above[1], cases):
        return verdict
    state.definitions.forget(head.name, chain.lines[0])
    shown = ", ".join(f"{plain_text(Name(name))} = {plain_text(node)}" for name, node in cases.items())
    reason = f"not what line {above[0]} gives at {shown}"
    return describe(state.document, chain, k, Decision(REFUTED, reason))


def _formula_above(state: JudgingState, chain: Chain, head: Name) -> tuple[int, Formula] | None:
    """Return the formula that the last relation of a letter above gives it, with its line."""
    last = state.sections.last_above(head, chain.start)
    if last is None or last.relations[0].sign != "=" or not names(last.sides[1].node):
        return None
    is_near = chain.lines[0] - last.lines[0] <= _NEAR_LINES
    is_near = is_near and state.sections.same_section(last.lines[0], chain.lines[0])
    return (last.lines[0], last.sides[1].node) if is_near else None


def _letters_that_may_cancel(formula: Formula) -> frozenset[str]:
    """Return the letters in sums and waves of a formula: with other values of them it may vanish."""
    parts = [part for part in walk(formula) if isinstance(part, Sum | Call)]
    return frozenset[str]().union(*map(names, parts))


def _cases_of_sentence(
    state: JudgingState, chain: Chain, letters: frozenset[str]
) -> Mapping[str, Formula]:
    """Return what the sentence gives the letters of a formula right before a relation."""
    text, cases = state.document.text, dict[str, Formula]()
    for other in state.document.chains:
        head = other.sides[0].node
        is_case = isinstance(head, Name) and head.name in letters and len(other.relations) == 1
        if not is_case or not 0 < chain.start - other.end < _NEAR or other.relations[0].sign != "=":
            continue
        if isinstance(head, Name) and not _LEAVES.search(text, other.end, chain.start):
            cases[head.name] = other.sides[1].node
    return cases


def _is_product_in(
    state: JudgingState, chain: Chain, formula: Formula, cases: Mapping[str, Formula]
) -> bool:
    """Tell whether a formula is a product of letters, and no sum, with the values of a case."""
    knowledge = state.knowledge(chain.lines[0])
    try:
        for name, value in cases.items():
            formula = substitute(formula, name, value)
        decision = decide(lone_side(formula), lone_side(chain.sides[1].node), "=", knowledge)
    except (NoFormError, TooLargeError):
        return False  # the relation stays what it was: a premise, which nothing is said to prove
    form = decision.left
    if decision.status != REFUTED or form is None:
        return False
    return len({tuple(power for power in term if power[0] != TURN) for term in form.numerator}) == 1
