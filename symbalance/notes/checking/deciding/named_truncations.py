"""Whether two sides agree through an order of a small letter that words name, whatever a side keeps.

A line with ≈ is judged by the order that it keeps itself. Where words say "to second order in x", the
sides may differ in nothing up to that order: e^x ≈ 1 + x is no more than of first order.
"""

from __future__ import annotations

from symbalance.document.formula import Formula
from symbalance.notes.algebra import values
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator, SymbolValue
from symbalance.notes.algebra.forms import Form
from symbalance.notes.algebra.series import Expansion
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge, Level
from symbalance.notes.checking.deciding.order_agreement import (
    SmallLetter,
    degree,
    truncated_sum,
    witness_of,
)


def decide_through(
    left: Formula, right: Formula, knowledge: Knowledge, letter: str, order: int
) -> Decision | None:
    """Return whether two sides agree in every power of a letter up to an order; None where that is open.

    The left side has to be known: it has the letter, and every letter of the right one.
    """
    refuted: Decision | None = None
    small = SmallLetter(letter, 1, order)
    for level in knowledge.levels(left, right):
        evaluator = knowledge.evaluator(level)
        try:
            first, second = evaluator.form(left), evaluator.form(right)
            own = {*values.letters(first)}
            if letter not in own or not {*values.letters(second)} <= own:
                continue
            decision = _at_level(first, second, level, small)
        except (NoFormError, TooLargeError):
            continue
        if decision.is_proved:
            return decision
        refuted = refuted or decision
    return refuted


def decide_proof_through(proof: Decision, right: Formula, letter: str, order: int) -> Decision | None:
    """Return whether a proof's two sides agree through an order; None where they do, or may do.

    They are what its letters mean, the displacement of a piston for x, where the page defines none. Where
    a proof shows no sides, the series of a crank drive are meant, which go on two powers further on.
    """
    try:
        first, second, level = proof.left, proof.right, proof.level
        if first and second and level and letter in {*values.letters(first)}:
            return _at_level(first, second, level, SmallLetter(letter, 1, order))
        form = FormEvaluator(SymbolValue().domain()).form(right)
        kept = degree(form, letter, 1) if letter in {*values.letters(form)} else None
    except (NoFormError, TooLargeError):
        return None
    if kept is None or kept + 1 >= order:
        return None
    written, said = (SmallLetter(letter, 1, power).text for power in (kept, order))
    reason = f"proved through {written}, and said to hold through {said}: nothing gives the terms between"
    return Decision(UNDECIDED, reason)


def _at_level(first: Form, second: Form, level: Level, small: SmallLetter) -> Decision:
    expansion = Expansion(first.domain, small.letter, small.sign, small.order)
    left, right = (expansion.of(form).cut(small.order) for form in (first, second))
    if min(left.through, right.through) < small.order:
        raise NoFormError("the series does not reach that order")
    difference = left.plus(right.scaled(Form.number(first.domain, -1)))
    if not difference.terms:
        return Decision(
            PROVED, order=small.text, assumptions=level.assumptions, level=level, left=first, right=second
        )
    forms = truncated_sum(left, small), truncated_sum(right, small)
    lowest = SmallLetter(small.letter, 1, min(difference.terms)).text
    return Decision(
        REFUTED,
        f"the sides differ in {lowest}, and it is said to hold through {small.text}",
        level=level,
        left=forms[0],
        right=forms[1],
        witness=witness_of(*forms),
        through=small.order,
        expanded_in=small.letter,
    )
