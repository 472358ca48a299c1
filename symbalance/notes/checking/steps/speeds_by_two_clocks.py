r"""Formulas in which a speed counts by the minute beside one by the second: v = 2 s n, and v = s n/30.

Both are written with n, and no two numbers make both true. The one with 30 or 60 in it is the other one
with a number of revolutions per minute: it holds if n is that, and its numbers are put in as such.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Formula, Name, Number, Product, names
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.cases import NUMBERS_PUT_IN
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, Decision, decide_equality
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.own_units import is_divided_by_minute
from symbalance.notes.checking.verdicts import CONTRADICTION, PREMISE, REFUTED, Verdict
from symbalance.notes.reading.equations import Chain

_SPEEDS = ("n", "N")
"""The letters that count revolutions."""


def unless_by_the_minute(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a formula that is refuted by another one may count its speed by the minute."""
    if verdict.verdict not in (REFUTED, CONTRADICTION) or chain.relations[k].sign not in "=≈":
        return verdict
    head, formula = chain.sides[0].node, chain.sides[k if k else 1].node
    if k > 1 or not isinstance(head, Name) or not is_divided_by_minute(formula):
        return verdict
    name = _speed_by_minute(state, chain, head, formula)
    knowledge = state.knowledge(chain.lines[0])
    is_put_in = any(not names(side.node) for side in chain.sides[2:])  # s n/30 = 0.09·3000/30
    if not is_put_in and (knowledge.knows(name) or name in knowledge.meanings):
        return verdict  # the page says in which unit it counts
    there = _with_speed_by_minute(state, chain, k, name) if name else None
    return verdict if there is None else describe(state.document, chain, k, there)


def _with_speed_by_minute(state: JudgingState, chain: Chain, k: int, name: str) -> Decision | None:
    """Return the decision on a formula with a speed by the minute, or on numbers put into it."""
    formula, right = chain.sides[k].node, chain.sides[k + 1].node
    by_minute = f"{plain_letter(name)} counts by the minute, and by the second above"
    proof = Decision(PROVED, assumptions=(by_minute,))
    if not k or names(right):
        return None if k else proof
    knowledge = state.knowledge(chain.lines[0])
    if not all(knowledge.knows(each) for each in names(formula)):
        return Decision(PREMISE, NUMBERS_PUT_IN)
    is_so = decide_equality(_by_minute(formula, name), right, knowledge).is_proved
    return proof if is_so else None


def _speed_by_minute(state: JudgingState, chain: Chain, head: Name, formula: Formula) -> str:
    """Return the speed by whose sixtieth a formula differs from the last one above of its letter."""
    for above in reversed(state.sections.chains_above(head, chain.start)):
        if not state.sections.same_section(above.lines[0], chain.lines[0]):
            return ""
        others = [side.node for side in above.sides[1:] if names(side.node) == names(formula)]
        for other in others:
            for name in sorted(n for n in names(formula) if n.partition("_")[0] in _SPEEDS):
                if is_divided_by_minute(other):
                    return ""
                try:
                    turned = _by_minute(formula, name)
                except NoFormError:
                    continue
                if decide_equality(turned, other, Knowledge()).is_proved:
                    return name
    return ""


def _by_minute(formula: Formula, name: str) -> Formula:
    return substitute(formula, name, Product((Number(Fraction(60)), Name(name))))
