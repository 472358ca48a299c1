"""Formulas at one point: what they are where letters have numbers, and what a law gives a letter then."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction

from symbalance.document.formula import Formula, Number, names
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.reading.formulas.result_units import value_of

_CLOSE = 1e-9


def value_at(node: Formula, values: Mapping[str, float]) -> float | None:
    """Return what a formula is where its letters have numbers, None for one that has no such value."""
    for name, value in values.items():
        try:
            node = substitute(node, name, Number(Fraction(value)))
        except NoFormError:
            return None
    return None if names(node) else value_of(node)


def solved_at(sides: tuple[Formula, Formula], head: str, values: Mapping[str, float]) -> float | None:
    """Return what an equation of products of powers gives a letter at a point; None for any other one.

    The quotient of its sides is then a power of the letter, which three values of it tell.
    """
    sizes = []
    for at in (1.0, 2.0, 4.0):
        first, second = (value_at(node, {**values, head: at}) for node in sides)
        if not first or not second or first * second < 0:
            return None
        sizes.append(math.log(first / second))
    power = (sizes[1] - sizes[0]) / math.log(2)
    is_power = math.isclose(sizes[2] - sizes[1], sizes[1] - sizes[0], abs_tol=_CLOSE)
    return math.exp(-sizes[0] / power) if is_power and abs(power) > _CLOSE else None
