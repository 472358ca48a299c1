"""Decisions whether one relation (=, ≈, <, ...) holds, in any of the readings of its two sides."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from typing import Any

from symbalance.document.formula import Dots, Formula, Name, names, walk
from symbalance.notes.algebra import values
from symbalance.notes.algebra.construct_rules import may_fail
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.checking.deciding.branches import decide_branches, has_branches
from symbalance.notes.checking.deciding.equality import (
    PROVED,
    REFUTED,
    UNDECIDED,
    Decision,
    decide_equality,
    digits,
    without_dots,
)
from symbalance.notes.checking.deciding.induction import decide_by_induction
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.matrix_relations import decide_matrices, is_of_matrices
from symbalance.notes.checking.deciding.order_agreement import decide_agreement, degree
from symbalance.notes.checking.verdicts import DEFINITION
from symbalance.notes.reading.equations import Chain, Side

MOST_READINGS = 16
"""Pairs of readings that are tried: a decision may cost a second."""


def decide(
    left: Side, right: Side, sign: str, knowledge: Knowledge, through: int | None = None
) -> Decision:
    """Decide a relation = or ≈ in the first pair of readings that proves it; else in the usual ones."""
    first: Decision | None = None
    pairs = list(product(left.readings, right.readings))[:MOST_READINGS]
    for left_node, right_node in pairs:
        decision = decide_reading(left_node, right_node, sign, knowledge, through)
        if decision.is_proved:
            return decision
        first = first or decision
    return first or Decision(UNDECIDED, "nothing to compare")


def decide_reading(
    left: Formula, right: Formula, sign: str, knowledge: Knowledge, through: int | None = None
) -> Decision:
    """Decide left = right or left ≈ right; what is refuted under an open premise is not decided."""
    decision = _decide_reading(left, right, sign, knowledge, through)
    if decision.status == REFUTED and decision.left is not None:
        open_premises = [text for text in decision.left.domain.assumptions if may_fail(text)]
        if open_premises:
            return replace(decision, status=UNDECIDED, reason=f"differs if {open_premises[0]}; say so")
    return decision


def _decide_reading(
    left: Formula, right: Formula, sign: str, knowledge: Knowledge, through: int | None
) -> Decision:
    if is_of_matrices(left, right, knowledge):
        return decide_matrices(left, right, sign, knowledge)
    if has_branches(left, right, knowledge):

        def decide_branch(one: Formula, other: Formula, known: Knowledge) -> Decision:
            return decide_reading(one, other, sign, known, through)

        return decide_branches(left, right, knowledge, decide_branch)
    by_steps = decide_by_induction(left, right, knowledge)
    if by_steps is not None:
        return by_steps if by_steps.is_proved else _by_closed_form(left, right, knowledge) or by_steps
    (bare_left, left_is_cut), (bare_right, right_is_cut) = without_dots(left), without_dots(right)
    if sign == "≈" or left_is_cut or right_is_cut or through is not None:
        return decide_agreement(
            left, right, knowledge, through=through, loose=left_is_cut or right_is_cut
        )
    decision = decide_equality(bare_left, bare_right, knowledge)
    if decision.status == REFUTED and _is_cut_off(left, decision, knowledge):
        return decide_agreement(left, right, knowledge)
    return decision


def _by_closed_form(left: Formula, right: Formula, knowledge: Knowledge) -> Decision | None:
    """Decide by the closed form of sums whose bounds are whole numbers; None without one."""
    parts = [part for node in (left, right) for part in walk(node)]
    if any(isinstance(part, Dots) for part in parts):
        return None
    decision = decide_equality(left, right, knowledge)
    return None if decision.left is None else decision


def _is_cut_off(node: Formula, decision: Decision, knowledge: Knowledge) -> bool:
    """Tell whether = stands between an exact form and its series, cut off: then ≈ is meant.

    The exact form is one that is no polynomial in the ratio, or a letter of known meaning.
    """
    if (
        knowledge.crank is None
        or knowledge.crank.small is None
        or not decision.left
        or not decision.right
    ):
        return False
    letter, sign = knowledge.crank.small
    has_meaning = isinstance(node, Name) and node.name in knowledge.meaning.values
    exact = has_meaning or degree(decision.left, letter, sign) is None
    return exact and degree(decision.right, letter, sign) is not None


def decide_inequality(chain: Chain, k: int, knowledge: Knowledge) -> Decision:
    """Decide an inequality between numbers; a range of a letter is stated, unless it is empty.

    In a < x < b the two bounds are compared as well: 1/3 < x < 1/5 holds for no x.
    """
    sign = chain.relations[k].sign
    decision = _compare(chain.sides[k].node, chain.sides[k + 1].node, sign, knowledge)
    if decision is not None:
        return decision
    if not names(chain.sides[k].node) and not names(chain.sides[k + 1].node):
        return Decision(UNDECIDED, "two numbers that could not be compared")
    signs = {r.sign for r in chain.relations}
    if k == 1 and len(chain.sides) == 3 and (signs <= {"<", "≤"} or signs <= {">", "≥"}):
        outer = _compare(chain.sides[0].node, chain.sides[2].node, sign, knowledge)
        if outer is not None and not outer.is_proved:
            return Decision(REFUTED, "the range is empty", witness=outer.witness)
    return Decision(DEFINITION, "a stated range")


def _is_real(value: Any) -> bool:
    return abs(value.imag) <= abs(value) * values.context().mpf(10) ** -20


def _compare(left: Formula, right: Formula, sign: str, knowledge: Knowledge) -> Decision | None:
    """Decide an inequality between two numbers; None where a letter stands in one."""
    for level in knowledge.levels(left, right):
        evaluator = knowledge.evaluator(level)
        try:
            first, second = evaluator.form(left), evaluator.form(right)
        except (NoFormError, TooLargeError):
            continue
        if values.letters(first) or values.letters(second):
            continue
        same = first.equals(second)
        points = values.sample([first, second])
        if not points:
            return None
        if sign != "≠" and not all(_is_real(value) for value in points[0][1]):
            return Decision(
                UNDECIDED, "one side is not a real number", level=level, left=first, right=second
            )
        left_value, right_value = (value.real for value in points[0][1])
        holds = {
            "<": not same and left_value < right_value,
            ">": not same and left_value > right_value,
            "≤": same or left_value < right_value,
            "≥": same or left_value > right_value,
            "≠": not same,
        }[sign]
        witness = {"left": digits(points[0][1][0]), "right": digits(points[0][1][1])}
        if holds:
            return Decision(PROVED, level=level, left=first, right=second)
        return Decision(REFUTED, level=level, left=first, right=second, witness=witness)
    return None
