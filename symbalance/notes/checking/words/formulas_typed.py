"""Formulas that stand alone in a sentence, without a relation: the force $4 λ m r ω^2$ of the pistons."""

from __future__ import annotations

from symbalance.document.formula import Formula, names
from symbalance.notes.reading import ReadingError, read_equation


def formula_typed(typed: str, letters: frozenset[str]) -> Formula | None:
    """Return a formula as it is typed, in some letters; None for what is none, or has others.

    >>> formula_typed("T V^2", frozenset("TV")) is None, formula_typed("T x", frozenset("TV")) is None
    (False, True)
    """
    try:
        node = read_equation(f"{typed.strip(' .,;')} = 0", letters).sides[0].node
    except ReadingError:
        return None
    return node if names(node) and names(node) <= letters else None
