"""What grows by a proportion: A ∝ d², and "with d_2 = 2 d_1 we get A_2 = 4 A_1".

The page says how a quantity grows, and of two values of a letter in it how many times the one is the
other. The same two values of the quantity then stand in a ratio that a number may get wrong.
"""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Number,
    Power,
    Product,
    Quotient,
    names,
    walk,
)
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.proportional import SIGN
from symbalance.notes.checking.verdicts import CONDITION, DEFINITION, PREMISE, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain

_CLOSE, _HALF = 1e-9, 0.5


class Times(NamedTuple):
    """That one value of a quantity is a number of times another: A_2 = 4 A_1."""

    stem: str
    first: str
    second: str
    value: Formula


def unless_scaled_against_proportion(
    state: JudgingState, chain: Chain, k: int, verdict: Verdict
) -> Verdict:
    """Return a verdict; a multiple is judged by a proportion above and the multiples of its letters."""
    if k or verdict.verdict not in (DEFINITION, PREMISE, CONDITION) or (own := _times(chain)) is None:
        return verdict
    proportion = _proportion(state, chain, own.stem)
    if proportion is None:
        return verdict
    right = proportion.sides[1].node
    given = _given(state, chain, own, right)
    claimed = number_of(own.value, Knowledge())
    expected = None if not given else _ratio(right, given)
    if claimed is None or expected is None:
        return verdict
    shown, line = (
        f"{plain_text(proportion.sides[0].node)} {SIGN} {plain_text(right)}",
        proportion.lines[0],
    )
    gap = abs(float(claimed) - expected)
    place = max((float(p.last_place or 0) for p in walk(own.value) if isinstance(p, Number)), default=0.0)
    if gap <= place * _HALF + _CLOSE * max(1.0, abs(expected)):
        decision = Decision(PROVED, f"by line {line}", assumptions=(shown,))
    else:
        decision = Decision(REFUTED, f"{shown} of line {line} makes it {expected:.6g} times as large")
    return describe(state.document, chain, k, decision)


def _times(chain: Chain) -> Times | None:
    """Return what a relation says of two values of a quantity, A_2 = 4 A_1 or A_2/A_1 = 4, or None."""
    if len(chain.relations) != 1 or chain.relations[0].sign != "=":
        return None
    left, right = (side.node for side in chain.sides)
    first: Formula
    second: Formula
    if isinstance(left, Quotient) and not names(right):
        first, second, value = left.numerator, left.denominator, right
    elif isinstance(right, Product) and len(right.factors) == 2 and not names(right.factors[0]):
        first, (value, second) = left, right.factors
    else:
        return None
    if not isinstance(first, Name) or not isinstance(second, Name):
        return None
    stems = {each.name.partition("_")[0] for each in (first, second)}
    indices = {each.name.partition("_")[2] for each in (first, second)}
    if len(stems) != 1 or len(indices) != 2 or "" in indices:
        return None
    return Times(stems.pop(), first.name.partition("_")[2], second.name.partition("_")[2], value)


def _proportion(state: JudgingState, chain: Chain, stem: str) -> Chain | None:
    """Return the last proportion of a letter to a product of powers above, in the same section."""
    for above in reversed(state.sections.chains_above(Name(stem), chain.start)):
        if not state.sections.same_section(above.lines[0], chain.lines[0]):
            return None
        is_one = len(above.relations) == 1 and above.relations[0].sign == SIGN
        if not is_one or above.sides[1].span[0] in state.refuted:
            continue
        return above if all(map(_is_of_power, walk(above.sides[1].node))) else None
    return None


def _is_of_power(part: Formula) -> bool:
    """Tell whether a part of a formula is one of a product of powers and roots."""
    is_root = isinstance(part, Call) and part.function == "sqrt"
    return is_root or isinstance(part, Name | Number | Product | Quotient | Power)


def _given(state: JudgingState, chain: Chain, own: Times, right: Formula) -> dict[str, Formula]:
    """Return how many times larger the letters of a proportion are, none where one is not told."""
    section = state.sections.start_of_line(state.sections.section_start(chain.lines[0]))
    given: dict[str, Formula] = {}
    for other in state.sections.chains_between(section, chain.start):
        times = _times(other) if other.relations else None
        if times is None or times.stem not in names(right):
            continue
        if (times.first, times.second) == (own.first, own.second):
            given[times.stem] = times.value
    every = {
        name for other in state.sections.chains_between(section, chain.start) for name in other.letters
    }
    untold = names(right) - given.keys()
    are_apart = any(f"{name}_{index}" in every for name in untold for index in (own.first, own.second))
    return {} if are_apart else given


def _ratio(right: Formula, given: dict[str, Formula]) -> float | None:
    """Return how many times larger a product of powers is where its letters are so many times larger."""
    one: Formula = Number(Fraction(1))
    values: list[float] = []
    for larger in (given, {}):
        node = right
        try:
            for name in names(right):
                node = substitute(node, name, larger.get(name, one))
        except NoFormError:
            return None
        number = number_of(node, Knowledge())
        if not number:
            return None
        values.append(float(number))
    return values[0] / values[1]
