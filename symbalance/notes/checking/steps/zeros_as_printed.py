"""Zeros at angles that are printed with their digits: cos θ + 0.3 cos 2θ = 0 at θ = 75.0°.

At exactly 75.0° the sum is -0.001. Its zero lies at 74.96°, which is printed as 75.0°: where a formula
changes its sign while each printed number of the angle moves by half of its last place, it is zero there.
So is a sum of numbers, 2.4 + 18·0.267 - 6.5·1.11 ≈ 0, whose terms are large beside what their rounding
leaves.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Call, Formula, Name, Number, Sum, names, parts_of_kind
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
from symbalance.notes.reading.formulas.result_units import value_of

_ZERO = Number(Fraction(0))
_NO_LETTER = " "
LEFT_OVER = 0.01
"""Of the largest term of a sum that is about zero: more is a number of its own, 0.3 - 0.25."""


def unless_zero_as_printed(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a refuted zero is proved where the digits of a printed angle allow it."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    is_zero = isinstance(right, Number) and not right.value and right.last_place is None
    if verdict.verdict != REFUTED or not is_zero or chain.relations[k].sign not in ("=", "≈"):
        return verdict
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    if chain.relations[k].sign == "≈" and (put_in := _is_sum_left_over(left, knowledge)) is not None:
        decision = Decision(PROVED, order="the digits printed", assumptions=put_in)
        return describe(state.document, chain, k, decision)
    angles = frozenset[str]().union(*(names(call) for call in parts_of_kind(left, Call)))
    printed = {n: d.node for n, d in knowledge.definitions.items() if n in angles and _is_printed(d.node)}
    if not printed and not any(_is_printed(call) for call in parts_of_kind(left, Call)):
        return verdict
    if not _has_zero(left, printed, chain.lines[0], knowledge):
        return verdict
    texts = tuple(f"{plain_text(Name(n))} = {plain_text(value)}" for n, value in sorted(printed.items()))
    decision = Decision(PROVED, order="the digits printed", assumptions=texts)
    return describe(state.document, chain, k, decision)


def _is_sum_left_over(left: Formula, knowledge: Knowledge) -> tuple[str, ...] | None:
    """Return the numbers put in for letters of a sum that vanishes to its printed digits; or None."""
    numbers = {n: knowledge.definitions[n].node for n in names(left) if n in knowledge.definitions}
    for name, value in numbers.items():
        left = substitute(left, name, value)
    if names(left) or not isinstance(left, Sum):
        return None
    gap, terms = value_of(left), [value_of(term) for term in left.terms]
    largest = max((abs(term) for term in terms if term is not None), default=0.0)
    if gap is None or None in terms or abs(gap) > LEFT_OVER * largest:
        return None
    spread = 0.0
    for number in decimals(left):
        step = number.last_place / 2 if number.last_place is not None else Fraction(0)
        moved = value_of(replace_part(left, number, Number(number.value + step)))
        spread += 0.0 if moved is None else abs(moved - gap)
    texts = tuple(f"{plain_text(Name(n))} = {plain_text(value)}" for n, value in sorted(numbers.items()))
    return texts if abs(gap) <= spread else None


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
