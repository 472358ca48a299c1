"""Angles in whole degrees as results: after tan α = 4 it is α = 76°, to the degree."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Name, Number, Product
from symbalance.notes.algebra.tree_values import NO_VALUE, TreeValues
from symbalance.notes.checking.deciding.equality import PROVED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.premises.system import Premise, lines_of
from symbalance.notes.checking.words.written_degrees import degrees_of

_HALF = Fraction(1, 2)


def decide_to_the_degree(
    premises: Sequence[Premise], statement: Premise, knowledge: Knowledge
) -> Decision | None:
    """Return that an angle satisfies equations to the degree it is printed to; None where it does not.

    Each of the equations with the angle has to change its sign within half a degree of it, and be
    nearly satisfied in between: a pole, as of tan α at 90°, is no solution.
    """
    angle, value = statement.left, statement.right
    if not isinstance(angle, Name) or degrees_of(value) is None or not isinstance(value, Product):
        return None
    number = value.factors[0]
    if not isinstance(number, Number) or number.value.denominator != 1 or number.last_place is not None:
        return None
    own = [premise for premise in premises if angle.name in premise.names]
    if not own or not all(_is_satisfied_near(p, angle.name, number.value, knowledge) for p in own):
        return None
    texts = tuple(dict.fromkeys(premise.text for premise in own))
    return Decision(PROVED, f"by {lines_of(own)}", order="whole degrees", assumptions=texts)


def _is_satisfied_near(premise: Premise, name: str, degrees: Fraction, knowledge: Knowledge) -> bool:
    values = {n: d.node for n, d in knowledge.definitions.items() if n != name}
    meaning = replace(knowledge.meaning, values={**values, **knowledge.meaning.values})
    gaps: list[float] = []
    for step in (-_HALF, Fraction(0), _HALF):
        point = {name: Fraction(math.radians(degrees + step))}
        try:
            at = TreeValues(meaning, point)
            gap = at.value(premise.left) - at.value(premise.right)
        except NO_VALUE:
            return False  # another letter is open
        gaps.append(float(gap.real))
    return gaps[0] * gaps[2] <= 0 and abs(gaps[1]) <= max(abs(gaps[0]), abs(gaps[2]))
