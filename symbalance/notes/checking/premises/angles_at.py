"""Angles at which a condition is true, as near as they are printed: cos θ = 0.25 at θ = 75.5°."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product

from symbalance.document.formula import Formula, Negative, Number, Sum
from symbalance.notes.algebra.domain import Domain, NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator, SymbolValue
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import written_out
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import replace_part, substitute
from symbalance.notes.checking.premises.system import Premise

EXACTLY = 1e-15
"""Difference of two sides that is one of computing."""
MOST_NUMBERS = 6
"""Printed numbers that are each moved up and down."""


def is_round_angle(value: Formula) -> bool:
    """Tell whether an angle is a multiple of 15 degrees, and so meant exactly."""
    evaluator = FormEvaluator(Domain(), SymbolValue())
    try:
        over_pi = evaluator.form(value).over(Form.constant(evaluator.domain, "pi")).rational()
    except (NoFormError, TooLargeError):
        return False
    return over_pi is not None and (12 * over_pi).denominator == 1


def changes_sign_nearby(condition: Premise, name: str, value: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a condition has a solution within a degree of an angle: 76° for tan θ = 4.

    Also where its letters have no numbers: then nothing is said.
    """
    level = list(knowledge.levels(condition.left, rational_node(Fraction(0))))[-1]
    values = {n: node for n, node in level.values.items() if n != name}
    meaning = replace(knowledge.meaning, values=values)
    signs = set[bool]()
    try:
        gap = written_out(Sum((condition.left, Negative(condition.right))), knowledge, name)
    except (NoFormError, TooLargeError):
        return True
    for step in (Fraction(-1, 60), Fraction(1, 60)):
        moved = substitute(gap, name, Sum((value, rational_node(step))))
        points = sample_trees([moved], meaning)
        if not points:
            return True
        signs |= {bool(row[0].real > 0) for _, row in points}
    return len(signs) == 2


def solves_as_printed(condition: Premise, name: str, value: Formula, knowledge: Knowledge) -> bool | None:
    """Tell whether an angle solves a condition, each printed number off by half of its last place.

    None where it cannot be evaluated, or has too many numbers to go through.
    """
    values: dict[str, Formula] = {n: d.node for n, d in knowledge.definitions.items() if n != name}
    meaning = replace(knowledge.meaning, values={**values, **knowledge.meaning.values})
    sides, signs = (condition.left, condition.right), set[bool]()
    numbers = [(part, decimals(part)) for part in (value, *sides)]
    if sum(len(found) for _, found in numbers) > MOST_NUMBERS:
        return None
    for choice in product((1, -1), repeat=sum(len(found) for _, found in numbers)):
        steps = iter(choice)
        moved = [_moved(part, found, steps) for part, found in numbers]
        try:
            gap = written_out(Sum((moved[1], Negative(moved[2]))), knowledge, name)
            points = sample_trees([substitute(gap, name, moved[0])], meaning)
        except (NoFormError, TooLargeError):
            return None
        if not points:
            return None
        if any(abs(row[0]) < EXACTLY for _, row in points):
            return True
        signs |= {bool(row[0].real > 0) for _, row in points}
    return len(signs) == 2


def _moved(node: Formula, numbers: Sequence[Number], steps: Iterator[int]) -> Formula:
    for number in numbers:
        assert number.last_place is not None
        off = Number(number.value + next(steps) * number.last_place / 2, number.last_place)
        node = replace_part(node, number, off)
    return node
