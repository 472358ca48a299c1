"""Equations of motion in matrices, M ẍ + K x = 0 with written entries: one equation for each row.

They hold along one motion, as those without matrices do, and the natural frequencies follow from them.
"""

from __future__ import annotations

from collections.abc import Collection

from symbalance.document.formula import (
    Derivative,
    Formula,
    Matrix,
    names,
    walk,
)
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.matrices import Literal, MatrixEvaluator
from symbalance.notes.checking.deciding.knowledge import Knowledge, Level
from symbalance.notes.checking.motions.equations_of_motion import (
    EquationOfMotion,
    linear_equation,
    moving_letters,
)
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain

MOST_ROWS = 6


def rows_of_motion(
    chain: Chain, k: int, elsewhere: Collection[str], knowledge: Knowledge
) -> list[EquationOfMotion]:
    """Return the rows of a matrix relation as equations of motion; none where it is no such relation.

    A vector of dotted letters alone on a side is a value, and no equation of motion.
    """
    if k or len(chain.relations) != 1 or chain.relations[0].sign != "=":
        return []
    left, right = chain.sides[0].node, chain.sides[1].node
    moving = moving_letters(left, right, knowledge)
    if not moving or isinstance(left, Matrix) or _is_dotted(right):
        return []
    evaluator = MatrixEvaluator(knowledge.evaluator(Level({})), knowledge.meaning.kinds)
    try:
        value, other = evaluator.value(left), evaluator.value(right)
        gap = evaluator.plus(value, evaluator.scaled(other, evaluator.number(-1)))
    except (NoFormError, TooLargeError):
        return []
    if not isinstance(gap, Literal) or gap.shape[1] != 1 or not 1 < gap.shape[0] <= MOST_ROWS:
        return []
    free = {name for name in elsewhere if not knowledge.knows(name)}
    own = moving | (free & (names(left) | names(right)))
    text = f"{plain_text(left)} = {plain_text(right)}"
    rows = [linear_equation(row[0], own, chain.lines[0], text) for row in gap.rows]
    is_whole = all(row is not None and any(order for _, order in row.factors) for row in rows)
    return [row for row in rows if row is not None] if is_whole else []


def _is_dotted(node: Formula) -> bool:
    """Tell whether a side is a vector, and what it holds is dotted letters: v = (ẋ, ẏ)."""
    return isinstance(node, Matrix) and any(isinstance(part, Derivative) for part in walk(node))
