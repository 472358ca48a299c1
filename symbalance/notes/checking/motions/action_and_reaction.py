"""Equations of motion of bodies that springs join: what pulls one back pulls the other along.

    J_1 φ̈_1 = -k (φ_1 - φ_2)        J_2 φ̈_2 = k (φ_1 - φ_2)

The two torques of a shaft are opposite. Where both equations have it with the same sign, one of them
drives its body away from the other, and that one is wrong, whatever the page says around it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Negative, Number, Product, Sum, names
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.tree_values import NO_VALUE, TreeValues
from symbalance.notes.checking.deciding.equality import REFUTED, Decision, decide_equality
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.motions.equations_of_motion import EquationOfMotion
from symbalance.notes.checking.words.plain_formulas import plain_text

_NOTHING = Number(Fraction(0))
_SIZES = ((3, 7, 11, 13, 17, 26, 9), (5, 2, 19, 23, 29, 14, 33))
"""Values of positive letters at which the sign of a factor is looked up."""


def against_reaction(
    equation: EquationOfMotion, others: Sequence[EquationOfMotion]
) -> tuple[Decision, EquationOfMotion] | None:
    """Return that an equation has a spring's force with the wrong sign, and the equation as it should be.

    Another equation has to have the force of the same spring, between the same two bodies, rightly.
    """
    own = _accelerated(equation)
    for other in others if own else ():
        body = _accelerated(other)
        if not body or body == own or body not in equation.moving or own not in other.moving:
            continue
        for spring in sorted(
            names(_stiffness(equation, own, body)) & names(_stiffness(other, body, own))
        ):
            pulls_along = _part(equation, own, body, spring)
            if (
                _is_positive(pulls_along)
                and _agree(Negative(pulls_along), _part(equation, own, own, spring))
                and _agree(pulls_along, _part(other, body, body, spring))
                and _agree(Negative(pulls_along), _part(other, body, own, spring))
            ):
                text, moved, from_it = (plain_text(Name(name)) for name in (spring, own, body))
                reason = (
                    f"{text} drives {moved} away from {from_it}, and by line {other.line} it pulls them"
                    " together: its two forces have to be opposite"
                )
                return Decision(REFUTED, reason), _mended(equation, own, body, spring)
    return None


def _accelerated(equation: EquationOfMotion) -> str:
    """Return the one letter whose second rate stands in an equation, times a mass; "" for others."""
    heads = [name for name, order in equation.factors if order == 2]
    is_of_mass = len(heads) == 1 and bool(names(equation.factors[heads[0], 2]))
    return heads[0] if is_of_mass else ""


def _stiffness(equation: EquationOfMotion, own: str, moving: str) -> Formula:
    """Return the factor of a deflection, with the mass counted positive."""
    factor = equation.factors.get((moving, 0), _NOTHING)
    return factor if _is_positive(equation.factors[own, 2]) else Negative(factor)


def _part(equation: EquationOfMotion, own: str, moving: str, spring: str) -> Formula:
    """Return what of the factor of a deflection is a spring's."""
    whole = _stiffness(equation, own, moving)
    return Sum((whole, Negative(substitute(whole, spring, _NOTHING))))


def _agree(one: Formula, other: Formula) -> bool:
    return decide_equality(one, other, Knowledge()).is_proved


def _is_positive(node: Formula) -> bool:
    """Tell whether a formula is positive where its letters are."""
    letters = sorted(names(node))
    if not letters or len(letters) > len(_SIZES[0]):
        return False
    for row in _SIZES:
        try:
            value = TreeValues(SymbolValue(), {n: Fraction(row[k]) for k, n in enumerate(letters)}).value(
                node
            )
        except NO_VALUE:
            return False
        if not value.real > 0:
            return False
    return True


def _mended(equation: EquationOfMotion, own: str, body: str, spring: str) -> EquationOfMotion:
    """Return an equation with the other sign of a spring's force."""
    factors = dict(equation.factors)
    for moving in (own, body):
        factor = factors[moving, 0]
        part = Sum((factor, Negative(substitute(factor, spring, _NOTHING))))
        factors[moving, 0] = Sum((factor, Negative(Product((Number(Fraction(2)), part)))))
    return replace(equation, factors=factors)
