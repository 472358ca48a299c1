"""Solutions for the cosine of an angle: cos α = (−1 + √(1 + 8λ²))/(4λ) after cos α + λ cos 2α = 0."""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Call, Formula, Name, names, walk
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide_solution
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading.equations import Chain

_INVERSE = {"cos": "acos", "sin": "asin", "tan": "atan"}


def decide_solved_wave(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Decide a value of a cosine by the equation above that it solves; None where it is no solution.

    It is refuted only where it is said to follow, and where the equation is one of cosines of the
    angle: a sine is of either sign.
    """
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    is_wave = isinstance(left, Call) and left.function in _INVERSE and isinstance(left.argument, Name)
    if k or chain.relations[0].sign != "=" or not is_wave or not names(right):
        return None
    assert isinstance(left, Call)
    assert isinstance(left.argument, Name)
    angle = left.argument.name
    others = {n: d for n, d in knowledge.definitions.items() if n != angle}
    known = replace(knowledge, definitions=others)
    equation = _equation_above(state, chain, angle, names(right))
    if equation is None or angle in names(right):
        return None
    decision = _put_in(equation, angle, Call(_INVERSE[left.function], right), known)
    if decision.is_proved:
        return replace(decision, assumptions=(*decision.assumptions, equation.text))
    follows = state.sections.is_consequence(chain) or state.sections.follows_at_once(chain)
    is_said = follows and _is_of_cosines(equation, angle)
    if decision.status == REFUTED and left.function == "cos" and is_said:
        return replace(decision, reason=f"does not satisfy {equation.text} of line {equation.line}")
    return None


def _put_in(equation: Premise, angle: str, value: Formula, knowledge: Knowledge) -> Decision:
    try:
        left, right = (substitute(node, angle, value) for node in (equation.left, equation.right))
    except NoFormError as problem:
        return Decision(UNDECIDED, str(problem))
    return decide_solution(lone_side(left), lone_side(right), knowledge)


def _equation_above(state: JudgingState, chain: Chain, angle: str, own: frozenset[str]) -> Premise | None:
    """Return the last equation above in the angle and the letters of its value."""
    above = [
        p
        for p in state.definitions.premises_at(chain.lines[0])
        if p.line <= chain.lines[0] and angle in p.names and p.names <= own | {angle}
    ]
    return max(above, key=lambda p: p.line, default=None)


def _is_of_cosines(equation: Premise, angle: str) -> bool:
    functions = {
        part.function
        for node in (equation.left, equation.right)
        for part in walk(node)
        if isinstance(part, Call) and angle in names(part.argument)
    }
    return (
        functions == {"cos"}
        and not _stands_bare(equation.left, angle)
        and not _stands_bare(equation.right, angle)
    )


def _stands_bare(node: Formula, angle: str) -> bool:
    """Tell whether an angle stands outside every function."""
    inside = {id(p) for part in walk(node) if isinstance(part, Call) for p in walk(part.argument)}
    return any(isinstance(p, Name) and p.name == angle and id(p) not in inside for p in walk(node))
