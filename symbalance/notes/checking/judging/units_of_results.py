"""A unit that is wrong behind numbers put in without theirs: m r = 0.8355·33.0 = 27.57 kg m, not kg mm.

The radius is 33.0 mm there and the numbers are right; the kilogram metres behind them are a thousand
times too large. So the step that puts the numbers in holds, and the one behind it is wrong.
"""

from __future__ import annotations

from math import log10

from symbalance.document.formula import Name, names
from symbalance.notes.checking.deciding.cases import UNITS_LEFT_OUT
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.numbers_put_in import is_lone_number
from symbalance.notes.checking.judging.one_relation import FOLLOWS
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.dimensions import written_unit
from symbalance.notes.checking.verdicts import PROVED_WORDS, Verdict
from symbalance.notes.reading.equations import Chain

_ROUNDED = 0.01
"""By how much numbers put in may differ from what they stand for by their rounding."""
_PREFIXES = (3, 6, 9)
"""The powers of ten between two units of one size: any other is a slip in a number."""


def blame_unit(state: JudgingState, chain: Chain, verdicts: list[Verdict]) -> None:
    """Let a step hold whose numbers are right but for a power of ten, and refute the unit behind it.

    The list is changed in place.
    """
    for k in range(len(verdicts) - 1):
        power = _power_between(state, chain, k, verdicts)
        if not power:
            continue
        size = f"10^{abs(power)} times too {'large' if power > 0 else 'small'}"
        numbers = state.document.source(chain.sides[k + 1].span)
        reason = f"the unit: {size} for {numbers}, whose units are left out"
        verdicts[k] = describe(state.document, chain, k, Decision(PROVED, UNITS_LEFT_OUT))
        verdicts[k + 1] = describe(state.document, chain, k + 1, Decision(REFUTED, reason))


def _power_between(state: JudgingState, chain: Chain, k: int, verdicts: list[Verdict]) -> int:
    """Return the power of ten between a formula and the numbers put in, 0 where it is no such case."""
    wrong, behind = verdicts[k : k + 2]
    left, numbers = chain.sides[k].node, chain.sides[k + 1].node
    is_here = wrong.verdict == REFUTED and behind.verdict in PROVED_WORDS and behind.reason == FOLLOWS
    if not is_here or k + 2 >= len(chain.sides) or names(numbers) or not names(left):
        return 0
    result = chain.sides[k + 2]
    has_number, unit = written_unit(state.document.source(result.span))
    if isinstance(numbers, Name) or not is_lone_number(result.node) or not (has_number and unit):
        return 0
    knowledge = state.knowledge(chain.lines[0])
    exact, typed = number_of(left, knowledge), number_of(numbers, knowledge)
    if not exact or not typed or exact * typed < 0:
        return 0
    ratio = float(typed) / float(exact)
    power = round(log10(ratio))
    is_of_ten = abs(power) in _PREFIXES and abs(ratio / 10.0**power - 1) < _ROUNDED
    return power if is_of_ten else 0
