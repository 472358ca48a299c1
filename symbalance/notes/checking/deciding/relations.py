"""One relation between two sides, each of which may be read in more than one way."""

from __future__ import annotations

from itertools import product
from typing import Any

from symbalance.document.formula import Formula, Name, names
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.orders import agree, degree
from symbalance.notes.checking.deciding.progressions import by_induction
from symbalance.notes.checking.deciding.steps import (
    PROVED,
    REFUTED,
    UNDECIDED,
    Answer,
    digits,
    equal,
    without_dots,
)
from symbalance.notes.checking.verdicts import DEFINITION
from symbalance.notes.reading.equations import Chain, Side

MOST_READINGS = 16


def judged(
    left: Side, right: Side, sign: str, knowledge: Knowledge, through: int | None = None
) -> Answer:
    """Decide a relation = or ≈ in the first pair of readings that proves it; else in the usual ones."""
    first: Answer | None = None
    pairs = list(product(left.readings, right.readings))[:MOST_READINGS]
    for one, other in pairs:
        answer = decided(one, other, sign, knowledge, through)
        if answer.proved:
            return answer
        first = first or answer
    return first or Answer(UNDECIDED, "nothing to compare")


def decided(
    left: Formula, right: Formula, sign: str, knowledge: Knowledge, through: int | None = None
) -> Answer:
    """Decide left = right or left ≈ right."""
    by_steps = by_induction(left, right, knowledge)
    if by_steps is not None:
        return by_steps
    (bare_left, cut), (bare_right, dots) = without_dots(left), without_dots(right)
    if sign == "≈" or cut or dots or through is not None:
        return agree(left, right, knowledge, through=through, loose=cut or dots)
    answer = equal(bare_left, bare_right, knowledge)
    if answer.status == REFUTED and _is_cut_off(left, answer, knowledge):
        return agree(left, right, knowledge)
    return answer


def _is_cut_off(node: Formula, answer: Answer, knowledge: Knowledge) -> bool:
    """Tell whether = stands between an exact form and its series, cut off: then ≈ is meant.

    The exact form is one that is no polynomial in the ratio, or a letter of known meaning.
    """
    if knowledge.crank is None or knowledge.crank.small is None or not answer.left or not answer.right:
        return False
    letter, sign = knowledge.crank.small
    known = isinstance(node, Name) and node.name in knowledge.meaning.values
    exact = known or degree(answer.left, letter, sign) is None
    return exact and degree(answer.right, letter, sign) is not None


def ordering(chain: Chain, k: int, knowledge: Knowledge) -> Answer:
    """Decide an inequality between numbers; a range of a letter is stated, unless it is empty.

    In a < x < b the two bounds are compared as well: 1/3 < x < 1/5 holds for no x.
    """
    sign = chain.relations[k].sign
    found = _compared(chain.sides[k].node, chain.sides[k + 1].node, sign, knowledge)
    if found is not None:
        return found
    if not names(chain.sides[k].node) and not names(chain.sides[k + 1].node):
        return Answer(UNDECIDED, "two numbers that could not be compared")
    signs = {r.sign for r in chain.relations}
    if k == 1 and len(chain.sides) == 3 and (signs <= {"<", "≤"} or signs <= {">", "≥"}):
        outer = _compared(chain.sides[0].node, chain.sides[2].node, sign, knowledge)
        if outer is not None and not outer.proved:
            return Answer(REFUTED, "the range is empty", witness=outer.witness)
    return Answer(DEFINITION, "a stated range")


def _is_real(value: Any) -> bool:
    return abs(value.imag) <= abs(value) * values.context().mpf(10) ** -20


def _compared(left: Formula, right: Formula, sign: str, knowledge: Knowledge) -> Answer | None:
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
            return Answer(UNDECIDED, "one side is not a real number", "", (), level, first, second)
        one, other = (value.real for value in points[0][1])
        holds = {
            "<": not same and one < other,
            ">": not same and one > other,
            "≤": same or one < other,
            "≥": same or one > other,
            "≠": not same,
        }[sign]
        witness = {"left": digits(points[0][1][0]), "right": digits(points[0][1][1])}
        if holds:
            return Answer(PROVED, "", "", (), level, first, second)
        return Answer(REFUTED, "", "", (), level, first, second, witness)
    return None
