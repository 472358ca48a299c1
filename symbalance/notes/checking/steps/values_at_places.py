"""Numbers of a motion at angles that words name, one after another: TDC: a = 4680, BDC: a = -2520.

Where the page has the motion's formula above, each number is its value at the angle named right before
it. None of them says anything of the next: the letter is not defined by it, nor is the angle. So it is
with an angle by its formula in one other: δ = 180° - 2γ, so for 72° δ = 36°.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    names,
    walk,
)
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import MEANT_ROUGHLY, decide_at_value
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.meant_roughly import is_said_roughly
from symbalance.notes.checking.verdicts import PREMISE, REFUTED, UNDECIDED
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain


def value_at_named_place(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return the proof that a number is a motion's value at the angle named before it; None for others.

    Where it cannot be proved for want of numbers it is a premise of that place alone.
    """
    head, right = chain.sides[0].node, chain.sides[1]
    place = None if k or not chain.inline else _place_of(state, chain, knowledge)
    if place is None or not isinstance(head, Name):
        return None
    formula, theta, angle = place
    is_motion = any(isinstance(part, Call) for part in walk(formula))
    rest = {n: d for n, d in knowledge.definitions.items() if n not in (head.name, theta)}
    freer = replace(knowledge, definitions=rest, solved={}, solved_from=())
    motion = replace(chain.sides[0], readings=(formula,))
    there = decide_at_value(motion, right, chain.relations[0].sign, freer, theta, angle)
    text = f"at {plain_text(Name(theta))} = {plain_text(angle)}"
    if there.is_proved:
        return replace(there, assumptions=(*there.assumptions, text))
    if there.status == REFUTED and not is_motion:
        reason = f"{text}, which words name, it has another value: wrong, or of something else"
        return Decision(UNDECIDED, reason)
    if names(right.node) and there.status == REFUTED:
        is_rough = chain.relations[0].sign == "=" and is_said_roughly(state, chain)
        rough = decide_at_value(motion, right, "≈", freer, theta, angle) if is_rough else there
        as_meant = replace(rough, assumptions=(*rough.assumptions, text), reason=MEANT_ROUGHLY)
        return as_meant if rough.is_proved else replace(there, reason=text)
    values = {n: d.node for n, d in rest.items()}
    unknown = {*names_behind(formula, values)} - values.keys() - {theta}
    is_number = there.left is not None and not letters(there.left)  # 2 m cos 90°, whatever m is
    is_open = there.status == UNDECIDED or (bool(unknown) and not is_number)
    if is_number and there.status == REFUTED:
        return replace(there, reason=text)
    return Decision(PREMISE, text) if is_open else None  # no letter has its number by it


def _place_of(
    state: JudgingState, chain: Chain, knowledge: Knowledge
) -> tuple[Formula, str, Formula] | None:
    """Return a motion's formula, its angle and the value of that, which words beside a value name."""
    head = chain.sides[0].node
    if not isinstance(head, Name):
        return None
    formula = _formula_of(knowledge.definitions.get(head.name))
    formula = formula or knowledge.meaning.values.get(head.name)
    named = state.sections.place_behind(chain) or state.sections.place_before(chain)
    if formula is None or named is None:
        return None
    values = {n: d.node for n, d in knowledge.definitions.items() if n != head.name}
    behind = {*names_behind(formula, values)}
    turning = {n for n in behind if _turns(n, formula, values)} or _lone_angle(formula, behind, values)
    right = chain.sides[1].node
    rests_on = {*names_behind(right, values)}
    if len(turning) != 1 or (turning | {head.name}) & rests_on:
        return None
    angle = turning.pop()
    is_its_own = named.may_be_of(angle, state.document.text)
    return (formula, angle, named.angle) if is_its_own else None


def _lone_angle(formula: Formula, behind: set[str], values: dict[str, Formula]) -> set[str]:
    """Return the only letter of a formula for an angle, as γ of δ = 180° - 2γ."""
    free = {n for n in behind if n not in values or not names(values[n])}
    parts = list(walk(formula))
    has_degrees = any(isinstance(part, Constant) and part.name == "pi" for part in parts)
    is_plain = has_degrees and not any(isinstance(part, Call) for part in parts)
    return free if is_plain and len(free) == 1 else set()


def _formula_of(definition: Definition | None) -> Formula | None:
    """Return the formula that a letter has, before the number that it was given last."""
    if definition is None:
        return None
    return definition.formula if definition.numeric else definition.node


def _turns(name: str, formula: Formula, values: dict[str, Formula]) -> bool:
    """Tell whether a letter without a formula stands in a sine or a cosine of a formula, or behind it."""
    if name in values and names(values[name]):
        return False
    nodes = [formula, *(values[n] for n in names_behind(formula, values) if n in values)]
    waves = (p for node in nodes for p in walk(node) if isinstance(p, Call))
    return any(wave.function in ("sin", "cos") and name in names(wave.argument) for wave in waves)
