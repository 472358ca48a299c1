"""Numbers that are finer than the number they stand behind: 45/150 = 0.3 = 0.34 has digits from nowhere.

Every number from 0.25 to 0.35 is 0.3, rounded, so that a chain could drift by a little in each step. What
has more digits than the number before it is the value of what stands before that one: √2 = 1.4 = 1.414.
"""

from __future__ import annotations

from symbalance.document.formula import Formula, Name, Negative, Number, Product, names
from symbalance.document.text_writer import formula_text
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import HOLDS_TO_ORDER, PREMISE, PROVED_WORDS, Verdict
from symbalance.notes.reading.equations import Chain
from symbalance.notes.reading.formulas.result_units import value_of

_NOTHING = 1e-9
"""Relative difference of floating numbers that says nothing."""


def unless_finer_by_nothing(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a number finer than the one before it has to be that of an earlier side."""
    if (of_datum := _unless_finer_than_datum(state, chain, k, verdict)) is not None:
        return of_datum
    left, right = chain.sides[k], chain.sides[k + 1]
    is_one = len(left.readings) == len(right.readings) == 1
    if not k or verdict.verdict != HOLDS_TO_ORDER or not is_one or not _is_finer(left.node, right.node):
        return verdict
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    earlier = chain.sides[:k] if not isinstance(chain.sides[0].node, Name) else chain.sides[1:k]
    judged = [(side, decide(side, right, chain.relations[k].sign, knowledge)) for side in earlier]
    against = [side for side, decision in judged if decision.status == REFUTED]
    is_value = any(d.is_proved and not _is_finer(side.node, right.node) for side, d in judged)
    if not against or is_value:
        return verdict
    exact = formula_text(against[-1].node, plain=True)
    reason = f"only the rounding of the side before allows it: it is not {exact}"
    return describe(state.document, chain, k, Decision(REFUTED, reason))


def _unless_finer_than_datum(
    state: JudgingState, chain: Chain, k: int, verdict: Verdict
) -> Verdict | None:
    """Return the verdict on a letter with more digits than its number has above: x = 0.5, then 0.51."""
    left, right = chain.sides[k].node, chain.sides[k + 1]
    is_claim = chain.relations[k].sign == "=" and verdict.verdict in PROVED_WORDS
    if not is_claim or not isinstance(left, Name) or len(right.readings) > 1:
        return None
    definition = state.knowledge(chain.lines[0]).definitions.get(left.name)
    is_lone = definition is not None and definition.numeric and definition.formula is None
    if definition is None or definition.is_rough or not is_lone:
        return None
    text, given = (formula_text(node, plain=True) for node in (left, definition.node))
    if definition.rounded is None and _is_finer(definition.node, right.node):
        if not k:
            state.definitions.define(left.name, right.node, chain)
            new = Decision(PREMISE, f"a new case: line {definition.line} had another value")
            return describe(state.document, chain, k, new)
        reason = f"{text} is given as {given}, and no line has more digits of it"
        return describe(state.document, chain, k, Decision(UNDECIDED, reason))
    if definition.rounded is None or not _is_finer_than_printed(definition, right.node):
        return None
    reason = f"only the rounding of line {definition.line} allows it: it is not {given}"
    return describe(state.document, chain, k, Decision(REFUTED, reason))


def _is_finer_than_printed(definition: Definition, number: Formula) -> bool:
    """Tell whether a number has digits beyond those printed for x = π = 3.14, and not those of π."""
    printed, value = definition.rounded, value_of(definition.node)
    first = None if printed is None else _as_printed(printed)
    second = _as_printed(number)
    if first is None or second is None or value is None:
        return False
    is_finer = second[1] < first[1] * (1 - _NOTHING)
    return is_finer and abs(value - second[0]) > second[1] / 2 * (1 + _NOTHING)


def _is_finer(before: Formula, number: Formula) -> bool:
    """Tell whether a number has finer digits than one before it, and is another number by them."""
    first, second = _as_printed(before), _as_printed(number)
    if first is None or second is None:
        return False
    apart = abs(first[0] - second[0])
    return second[1] < first[1] * (1 - _NOTHING) and apart > second[1] / 2 * (1 + _NOTHING)


def _as_printed(node: Formula) -> tuple[float, float] | None:
    """Return a number and the worth of its last digit: 2.2 kN is 2200 and 100; None for other sides."""
    if names(node):
        return None
    whole = node.operand if isinstance(node, Negative) else node
    factors = whole.factors if isinstance(whole, Product) else (whole,)
    number, value = factors[0], value_of(node)
    if not isinstance(number, Number) or not number.value or value is None:
        return None
    others = [factor for factor in factors[1:] if isinstance(factor, Number) and factor.last_place]
    if others or (len(factors) > 1 and not _is_unit(factors[1:])):
        return None
    return value, abs(value) * float((number.last_place or 1) / abs(number.value))


def _is_unit(factors: tuple[Formula, ...]) -> bool:
    """Tell whether factors behind a number are a unit's, one power of ten: 2 · 0.7071 is none."""
    value = value_of(Product(factors))
    return value is not None and value > 0 and f"{value:.6e}".startswith("1.000000e")
