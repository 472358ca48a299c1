"""Complex numbers as engineers write them: 3 + 4i = 5 e^{i 53.13°} to the digits printed, and j for i."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction
from typing import Any

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Number,
    Product,
    Sum,
    names,
    walk,
)
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.tree_values import NO_VALUE, TreeValues
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import replace_part, substitute
from symbalance.notes.reading.equations import Side

SMALLEST = 1e-12
"""Beside the size of a number, what counts as no imaginary part."""
_UNIT = "j"


def decide_as_complex(
    left: Side, right: Side, sign: str, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Return the proof of a refuted relation as one of complex numbers, else the decision as it is.

    A letter j that nobody declared nor defined may be the imaginary unit: that is assumed then.
    """
    if decision.status != REFUTED or sign not in "=≈≡":
        return decision
    turned = (
        _some_turns_further(left, right, knowledge)
        if sign == "≡"
        else _a_turn_further(left, right, sign, knowledge)
    )
    if turned is not None:
        return turned
    own = names(left.node) | names(right.node)
    if not own:
        agrees = _agree_as_printed(left.node, right.node, knowledge)
        return Decision(PROVED, order="the digits printed") if agrees else decision
    if _UNIT not in own or _UNIT in knowledge.meanings or knowledge.has_meaning(_UNIT):
        return decision
    try:
        sides = [
            side.changed(lambda node: substitute(node, _UNIT, Constant("i"))) for side in (left, right)
        ]
    except NoFormError:
        return decision
    there = decide(sides[0], sides[1], sign, knowledge)
    assumption = f"{_UNIT} is the imaginary unit"
    return replace(there, assumptions=(*there.assumptions, assumption)) if there.is_proved else decision


def _a_turn_further(left: Side, right: Side, sign: str, knowledge: Knowledge) -> Decision | None:
    """Return the proof that an angle is right but for a turn: arg z = 234° or -126°."""
    if not any(isinstance(p, Call) and p.function == "arg" for s in (left, right) for p in walk(s.node)):
        return None
    for turns in (2, -2):
        turn = Product((Number(Fraction(turns)), Constant("pi")))
        try:
            further = left.changed(lambda node, turn=turn: Sum((node, turn)))
        except NoFormError:
            return None
        there = decide(further, right, sign, knowledge)
        if there.is_proved:
            return there
    return None


def _some_turns_further(left: Side, right: Side, knowledge: Knowledge) -> Decision | None:
    """Return the proof that angles are congruent, 480° ≡ 120°: they differ by whole turns; or None."""
    sides = (left, right)
    if not all(any(part == Constant("pi") for part in walk(side.node)) for side in sides):
        return None
    values = {name: Number(Fraction(1)) for side in sides for name in names(side.node)}
    nodes = [side.node for side in sides]
    for name, value in values.items():
        nodes = [substitute(node, name, value) for node in nodes]
    gap = _gap(nodes[1], nodes[0], knowledge)
    turns = 0 if gap is None else round(float(gap.real) / math.tau)
    if not turns:
        return None
    turn = Product((Number(Fraction(2 * turns)), Constant("pi")))
    try:
        further = left.changed(lambda node: Sum((node, turn)))
    except NoFormError:
        return None
    there = decide(further, right, "=", knowledge)
    text = f"{abs(turns)} turn{'' if abs(turns) == 1 else 's'} apart"
    return replace(there, assumptions=(*there.assumptions, text)) if there.is_proved else None


def _agree_as_printed(left: Formula, right: Formula, knowledge: Knowledge) -> bool:
    """Tell whether two complex numbers differ by half a unit of their decimals' last places at most."""
    printed = {id(number): number for node in (left, right) for number in decimals(node)}
    gap = _gap(left, right, knowledge)
    if gap is None or not printed or not any(_is_complex(node, knowledge) for node in (left, right)):
        return False
    margin = 0.0
    for number in printed.values():
        assert number.last_place is not None
        off = Number(number.value + number.last_place / 2, number.last_place)
        moved = _gap(replace_part(left, number, off), replace_part(right, number, off), knowledge)
        if moved is None:
            return False
        margin += float(abs(moved - gap))
    return bool(abs(gap) <= margin * (1 + Fraction(1, 10**9)))


def _gap(left: Formula, right: Formula, knowledge: Knowledge) -> Any:
    """Return left - right, None where one has no value."""
    values = TreeValues(knowledge.meaning, {})
    try:
        return values.value(left) - values.value(right)
    except NO_VALUE:
        return None


def _is_complex(node: Formula, knowledge: Knowledge) -> bool:
    value = TreeValues(knowledge.meaning, {}).value(node)
    return bool(abs(value.imag) > abs(value) * SMALLEST)
