"""Numbers of a motion at angles that words name, one after another: TDC: a = 4680, BDC: a = -2520.

Where the page has the motion's formula above, each number is its value at the angle named right before
it. None of them says anything of the next: the letter is not defined by it, nor is the angle.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Number,
    Product,
    Quotient,
    names,
    walk,
)
from symbalance.notes.algebra.tree_values import names_behind
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide_at_value
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import PREMISE, REFUTED, UNDECIDED
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain

HALF_TURN = 180
"""Degrees."""


def value_at_named_place(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return the proof that a number is a motion's value at the angle named before it; None for others.

    Where it cannot be proved for want of numbers it is a premise of that place alone.
    """
    head, right = chain.sides[0].node, chain.sides[1]
    if k or not isinstance(head, Name) or not chain.inline:
        return None
    formula = _formula_of(knowledge.definitions.get(head.name)) or knowledge.meaning.values.get(head.name)
    if formula is None:
        return None
    behind = state.sections.place_behind(chain)
    degrees = state.sections.place_before(chain) if behind is None else behind
    if degrees is None:
        return None
    angle = _angle(degrees)
    values = {n: d.node for n, d in knowledge.definitions.items() if n != head.name}
    turning = {n for n in (*names(formula), *names_behind(formula, values)) if _turns(n, formula, values)}
    if len(turning) != 1:
        return None
    theta = next(iter(turning))
    rests_on = {*names(right.node), *names_behind(right.node, values)}
    if theta in rests_on or head.name in rests_on:
        return None
    rest = {n: d for n, d in knowledge.definitions.items() if n not in (head.name, theta)}
    freer = replace(knowledge, definitions=rest, solved={}, solved_from=())
    motion = replace(chain.sides[0], readings=(formula,))
    there = decide_at_value(motion, right, chain.relations[0].sign, freer, theta, angle)
    text = f"at {plain_text(Name(theta))} = {plain_text(angle)}"
    if names(right.node) and there.status == REFUTED:
        return replace(there, reason=text)
    unknown = {*names(formula), *names_behind(formula, values)} - values.keys() - {theta}
    if there.status == UNDECIDED or (unknown and not there.is_proved):
        return Decision(PREMISE, text)  # letters have no numbers, and this one gives them none
    if not there.is_proved:
        return None
    return replace(there, assumptions=(*there.assumptions, text))


def _formula_of(definition: Definition | None) -> Formula | None:
    """Return the formula that a letter has, before the number that it was given last."""
    if definition is None:
        return None
    return definition.formula if definition.numeric else definition.node


def _angle(degrees: int) -> Formula:
    """Return an angle of whole degrees as a formula in radians."""
    turn = Fraction(degrees, HALF_TURN)
    if turn.denominator == 1:
        return _times_pi(turn) if turn else Number(turn)
    return Quotient(_times_pi(Fraction(turn.numerator)), Number(Fraction(turn.denominator)))


def _times_pi(number: Fraction) -> Formula:
    return Constant("pi") if number == 1 else Product((Number(number), Constant("pi")))


def _turns(name: str, formula: Formula, values: dict[str, Formula]) -> bool:
    """Tell whether a letter without a formula stands in a sine or a cosine of a formula, or behind it."""
    if name in values and names(values[name]):
        return False
    nodes = [formula, *(values[n] for n in names_behind(formula, values) if n in values)]
    waves = (p for node in nodes for p in walk(node) if isinstance(p, Call))
    return any(wave.function in ("sin", "cos") and name in names(wave.argument) for wave in waves)
