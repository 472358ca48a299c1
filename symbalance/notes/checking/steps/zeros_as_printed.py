"""Zeros at angles that are printed with their digits: cos θ + 0.3 cos 2θ = 0 at θ = 75.0°.

At exactly 75.0° the sum is -0.001. Its zero lies at 74.96°, which is printed as 75.0°: where a formula
changes its sign while each printed number of the angle moves by half of its last place, it is zero there.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Call, Formula, Name, Number, names, parts_of_kind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import replace_part, substitute
from symbalance.notes.checking.premises.angles_at import solves_as_printed
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import REFUTED, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain

_ZERO = Number(Fraction(0))
_NO_LETTER = " "


def unless_zero_as_printed(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a refuted zero is proved where the digits of a printed angle allow it."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    is_zero = isinstance(right, Number) and not right.value and right.last_place is None
    if verdict.verdict != REFUTED or not is_zero or chain.relations[k].sign not in ("=", "≈"):
        return verdict
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    angles = frozenset[str]().union(*(names(call) for call in parts_of_kind(left, Call)))
    printed = {n: d.node for n, d in knowledge.definitions.items() if n in angles and _is_printed(d.node)}
    if not printed and not any(_is_printed(call) for call in parts_of_kind(left, Call)):
        return verdict
    if not _has_zero(left, printed, chain.lines[0], knowledge):
        return verdict
    texts = tuple(f"{plain_text(Name(n))} = {plain_text(value)}" for n, value in sorted(printed.items()))
    decision = Decision(PROVED, order="the digits printed", assumptions=texts)
    return describe(state.document, chain, k, decision)


def _is_printed(value: Formula) -> bool:
    """Tell whether a formula is one of numbers alone, of which one has printed decimals."""
    return not names(value) and bool(decimals(value))


def _has_zero(left: Formula, printed: dict[str, Formula], line: int, knowledge: Knowledge) -> bool:
    """Tell whether a formula has a zero within the printed digits of one angle, the others put in."""
    (name, value), *others = sorted(printed.items()) or [(_NO_LETTER, _ZERO)]
    for other, number in others:
        left = substitute(left, other, number)
    within = {id(number) for call in parts_of_kind(left, Call) for number in decimals(call)}
    for number in decimals(left):
        if id(number) not in within:  # a factor is what the page says it is
            left = replace_part(left, number, Number(number.value))
    return bool(solves_as_printed(Premise(left, _ZERO, line), name, value, knowledge))
