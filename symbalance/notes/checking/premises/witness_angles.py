"""Angles in steps of 15 degrees that satisfy an unsolved equation, and a relation's decision at each."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from math import pi

from symbalance.document.formula import Constant, Formula, Name, Product, names
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.checking.deciding.equality import REFUTED, Decision, decide_equality
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.solved_premises import Solved
from symbalance.notes.checking.premises.system import lines_of
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Side


def refuted_at_angles(left: Side, right: Side, sign: str, solved: Solved) -> Decision | None:
    """Return the refutation at an angle that satisfies what could not be solved, such as cos 2θ = 1.

    None where that is more than equations for one angle, or no multiple of 15 degrees is such a witness.
    """
    for twelfths, letter, decision in _at_angles(left, right, sign, solved):
        if decision.status == REFUTED:
            reason = (
                f"also at {plain_text(Name(letter))} = {15 * twelfths}°, by {lines_of(solved.leftover)}"
            )
            witness = {letter: f"{twelfths * pi / 12:.12g}", **decision.witness}
            return replace(decision, reason=decision.reason or reason, witness=witness)
    return None


def holds_at_angles(left: Side, right: Side, sign: str, solved: Solved) -> bool:
    """Tell whether a relation holds at each multiple of 15 degrees that satisfies what is left over.

    0 = 0 does not count: there sin³θ is whatever has a factor sin θ.
    """
    decisions = [decision for _, _, decision in _at_angles(left, right, sign, solved)]
    is_trivial = names(right.node) and any(d.left is not None and d.left.is_zero() for d in decisions)
    return bool(decisions) and not is_trivial and all(decision.is_proved for decision in decisions)


def _at_angles(left: Side, right: Side, sign: str, solved: Solved) -> Iterator[tuple[int, str, Decision]]:
    """Yield the decisions at the multiples of 15 degrees that satisfy premises on one angle."""
    own = {name for premise in solved.leftover for name in premise.names}
    if len(own) != 1 or not own <= solved.knowledge.angles:
        return
    (letter,) = own
    for twelfths in range(24):
        angle = Product((rational_node(Fraction(twelfths, 12)), Constant("pi")))

        def at_angle(node: Formula, angle: Formula = angle) -> Formula:
            return substitute(node, letter, angle)

        try:
            satisfies = all(
                decide_equality(at_angle(p.left), at_angle(p.right), solved.knowledge).is_proved
                for p in solved.leftover
            )
            if not satisfies:
                continue
            first, second = (replace(s, readings=tuple(map(at_angle, s.readings))) for s in (left, right))
        except NoFormError:  # a derivative by the angle: it has no value there
            return
        yield twelfths, letter, decide(first, second, sign, solved.knowledge)
