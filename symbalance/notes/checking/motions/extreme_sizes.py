"""The largest size of a motion, |ẍ|_max = r ω² (1 + λ): of its largest and its smallest value the larger.

The sign of the value there does not count, so that it does not matter which way the motion is measured.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from symbalance.document.formula import (
    Call,
    Derivative,
    Extremum,
    Formula,
    Name,
    Negative,
    Number,
    Sum,
    names,
    walk,
)
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.values import context
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision, digits
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.motions.extremes import (
    BY_NUMBERS,
    FAR,
    NEAR,
    NOTHING,
    at_dead_centre,
    theta_name,
    values_over_turn,
)
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Side


def decide_largest_size(left: Side, right: Side, sign: str, knowledge: Knowledge) -> Decision | None:
    """Decide what a line says of the largest size of a motion; None where it says nothing of one."""
    motion = _motion(left.node, knowledge)
    own = names(right.node)
    if motion is None or not own or own & (knowledge.angles | knowledge.moving):
        return None
    decision = _decide_size(motion, right, sign, knowledge)
    given = {} if decision.is_proved else _numbers_given(motion, right, knowledge)
    return _decide_size(motion, right, sign, knowledge, given) if given else decision


def _numbers_given(motion: Formula, right: Side, knowledge: Knowledge) -> dict[str, Fraction]:
    """Return the numbers above of letters that a motion has and its claimed size has not: λ = 3.5."""
    values = list(knowledge.levels(motion, right.node))[-1].values
    behind = {*names_behind(motion, values)} - {*names_behind(right.node, values)} - knowledge.angles
    known = {name: knowledge.definitions[name].node for name in behind & knowledge.definitions.keys()}
    return {name: node.value for name, node in known.items() if isinstance(node, Number)}


def _decide_size(
    motion: Formula,
    right: Side,
    sign: str,
    knowledge: Knowledge,
    given: Mapping[str, Fraction] = NOTHING,
) -> Decision:
    """Decide what a line says of the largest size of a known motion; a size is never negative."""
    rows = values_over_turn(motion, right.node, knowledge, given)
    if not rows:
        return Decision(UNDECIDED, "the extreme of what has no values here")
    sizes = [max(abs(value) for value in turn) for _, turn, _ in rows]
    is_signed = any(claim < 0 for _, _, claim in rows)
    has_either_sign = any(isinstance(part, Sum) and names(part) for part in walk(right.node))  # 1 - c
    if is_signed and names(right.node) <= knowledge.meaning.positive and not has_either_sign:
        return Decision(REFUTED, "a size is never negative")
    least = (f"{formula_text(right.node, plain=True)} ≥ 0",) if is_signed else ()
    least += tuple(f"{plain_text(Name(n))} = {plain_text(Number(value))}" for n, value in given.items())
    claims = [abs(claim) for _, _, claim in rows]
    tiny = context().mpf(10) ** -12
    if all(size <= claim * (1 + tiny) for size, claim in zip(sizes, claims, strict=True)):
        for each in (motion, Negative(motion)):
            for place in (0, 1):
                at_centre = at_dead_centre(each, right, sign, place, knowledge)
                if at_centre.is_proved:
                    where = f"at θ = {'π' if place else '0'}"
                    return replace(at_centre, reason=where, assumptions=(*at_centre.assumptions, *least))
    errors: list[Any] = [abs(c - s) / s for c, s in zip(claims, sizes, strict=True) if s]
    worst = digits(context().mpf(max(errors, default=0)), 2)
    if len(errors) == len(rows) and max(errors) <= NEAR:
        reason = f"within {worst} of the largest size, by numbers"
        return Decision(PROVED, reason, order=f"{BY_NUMBERS} {worst}", assumptions=least)
    if len(errors) < len(rows) or min(errors) <= FAR:
        return Decision(
            UNDECIDED, f"off by up to {worst} of the largest size: say ≈, and in which letter"
        )
    witness = {name: f"{float(value):.6g}" for name, value in rows[0][0].items()}
    witness |= {"left": digits(context().mpf(sizes[0]), 6), "right": digits(context().mpf(claims[0]), 6)}
    return Decision(REFUTED, "not the largest size of a turn", witness=witness)


def _motion(node: Formula, knowledge: Knowledge) -> Formula | None:
    """Return the motion of |ẍ|_max, one that is known as a function of the crank angle; else None."""
    if not isinstance(node, Extremum) or node.function != "max" or not isinstance(node.body, Call):
        return None
    motion = node.body.argument
    letter = motion.expression if isinstance(motion, Derivative) else motion
    if node.body.function != "abs" or not isinstance(letter, Name) or not theta_name(knowledge):
        return None
    definition = knowledge.definitions.get(letter.name)
    if letter.name in knowledge.moving and letter.name in knowledge.meaning.values:
        return motion
    is_formula = definition is not None and not (definition.numeric or definition.assumption)
    return motion if is_formula and theta_name(knowledge) in _behind(letter, knowledge) else None


def _behind(letter: Name, knowledge: Knowledge) -> set[str]:
    values = {name: definition.node for name, definition in knowledge.definitions.items()}
    return {*names_behind(letter, values | dict(knowledge.meaning.values))}
