"""Equations that are solved further down, and whether the solution satisfies them."""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Formula, Name, names
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide_solution
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITION, REFUTED, UNDECIDED
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain, Side


def as_solved(
    state: JudgingState, chain: Chain, following: Chain | None, knowledge: Knowledge
) -> Decision | None:
    """Return that an equation is solved below, for a letter that has a value already: c = (…)/4.

    The value is put into it: what it comes to is the verdict on the line that gives it.
    """
    if following is None:
        return None
    head, value = following.sides[0].node, following.sides[1].node
    assert isinstance(head, Name)
    is_solved_already = chain.sides[0].node == head and head.name not in names(chain.sides[1].node)
    if not is_solved_already:  # s = r (1 + λ/2) is no equation for s = 2r below, its value elsewhere
        at_value = _decide_with(chain.sides[0], chain.sides[1], head.name, value, knowledge)
        state.solutions[following.sides[0].span[0]] = state.definitions.premise_of(chain, 0), at_value
    return Decision(CONDITION, f"solved for {plain_text(head)} below")


def as_solved_in_words(
    state: JudgingState,
    chain: Chain,
    following: Chain | None,
    knowledge: Knowledge,
    *,
    is_sure: bool = False,
) -> Decision | None:
    """Return that an equation is solved behind words, 2n/60 = f, so n = 2190: if that value solves it.

    `is_sure`: the value can be meant as nothing else; then it is wrong where it does not solve it.
    """
    if following is None:
        return None
    head, value = following.sides[0].node, following.sides[1].node
    assert isinstance(head, Name)
    left, right = chain.sides[:2]

    def with_value(first: Side, second: Side, known: Knowledge) -> Decision:
        return _decide_with(first, second, head.name, value, known)

    at_value = with_value(left, right, knowledge)
    if not at_value.is_proved:
        for pair in ((left, right), (right, left)):
            by_wrong = state.wrong_numbers.decide(pair, knowledge, with_value, lambda node: None)
            at_value = by_wrong or at_value
    if not at_value.is_proved and not (is_sure and at_value.status == REFUTED):
        return None
    state.solutions[following.sides[0].span[0]] = state.definitions.premise_of(chain, 0), at_value
    return Decision(CONDITION, f"solved for {plain_text(head)} behind it")


def _decide_with(left: Side, right: Side, name: str, value: Formula, knowledge: Knowledge) -> Decision:
    """Decide whether two sides are equal with a value put in for a letter."""
    try:
        sides = [side.changed(lambda node: substitute(node, name, value)) for side in (left, right)]
    except NoFormError as problem:
        return Decision(UNDECIDED, str(problem))
    return decide_solution(sides[0], sides[1], knowledge)


def as_proved_solution(state: JudgingState, chain: Chain, k: int) -> Decision | None:
    """Return the proof of an equation's solution, None for other relations and for one that is none."""
    decision = as_solution(state, chain, k)
    return decision if decision is not None and decision.is_proved else None


def as_solution(state: JudgingState, chain: Chain, k: int) -> Decision | None:
    """Return the decision on the solution of an equation above, None for other relations."""
    solution = None if k else state.solutions.get(chain.sides[0].span[0])
    if solution is None:
        return None
    equation, at_value = solution
    if at_value.is_proved:
        return replace(at_value, assumptions=(*at_value.assumptions, equation.text))
    reason = f"does not satisfy {equation.text} of line {equation.line}"
    return replace(at_value, reason=reason if at_value.status == REFUTED else at_value.reason)
