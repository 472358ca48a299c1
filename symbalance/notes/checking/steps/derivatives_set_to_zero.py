"""Derivatives that are set to zero: dS/dk = -2(1 - k) + 2k = 0 is a step, and then an equation for k.

What is differentiated is a formula of the page. So the first relation is right or wrong whatever k is,
and the last one is solved for k: by the derivative that is right, not by what a slip made of it.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Derivative, Name, Number, names
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.cases import decide_case
from symbalance.notes.checking.deciding.equality import Decision, decide_equality
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION
from symbalance.notes.reading.equations import Chain

_ZERO = Number(Fraction(0))


def slope_set_to_zero(chain: Chain, knowledge: Knowledge) -> Decision | None:
    """Return the comparison with 0 of a derivative that a chain sets to zero; None for other chains.

    One that is constant, or of what no line gives a formula, is none that could be solved.
    """
    slope, zero = chain.sides[0].node, chain.sides[-1].node
    if not isinstance(slope, Derivative) or zero != _ZERO or {r.sign for r in chain.relations} != {"="}:
        return None
    compared = decide_equality(slope, zero, knowledge)
    own = set() if compared.left is None else set(letters(compared.left))
    is_known = slope.variable.name in own and not any("/d" in name for name in own)
    return compared if is_known else None


def as_zero_of_derivative(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return that a derivative which a page works out is set to zero, to be solved; None elsewhere."""
    if not 0 < k == len(chain.relations) - 1 or slope_set_to_zero(chain, knowledge) is None:
        return None
    alone = replace(chain, sides=(chain.sides[0], chain.sides[-1]), relations=chain.relations[-1:])
    compared = slope_set_to_zero(alone, knowledge)
    case = compared and decide_case(alone, 0, compared, knowledge, is_solved=True)
    if case is None or case.status != CONDITION:
        return None
    premise = state.definitions.premise_of(alone, 0)
    end = state.sections.moment_end(premise.line)  # elsewhere the letter has values that are no extreme
    state.definitions.premises.append(replace(premise, last_line=min(premise.last_line, end)))
    return replace(case, reason="the derivative is set to zero")


def leave_extreme(state: JudgingState, chain: Chain) -> bool:
    """Forget a derivative that is zero, before another value than the one it was solved to; tell of any.

    It is smallest at k = 1/2, and a maker uses k = 0.6 all the same. "So k = 0.6" is no other value.
    """
    head, definitions = chain.sides[0].node, state.definitions
    is_value = len(chain.sides) == 2 and isinstance(head, Name) and not names(chain.sides[1].node)
    if not is_value or state.sections.is_consequence(chain):
        return False
    above = state.sections.chains_above(head, chain.start)
    left = [
        premise
        for premise in definitions.premises
        if isinstance(premise.left, Derivative)
        and premise.left.variable == head
        and premise.right == _ZERO
        and any(c.start > premise.left.span[1] for c in above)
    ]
    definitions.premises = [premise for premise in definitions.premises if premise not in left]
    return bool(left)
