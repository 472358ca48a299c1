"""Formulas whose constant of units is rounded: P = T n/9549 and T = 9550 P/n are one and the same.

A whole number of four digits or more beside letters is a rounded one where the other formula has it a
little otherwise, within half a unit of its fourth digit.
"""

from __future__ import annotations

import math

from symbalance.document.formula import Formula, Name, Number, names, walk
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, Decision
from symbalance.notes.checking.deciding.values_at_points import solved_at, value_at
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.rounded_wholes import DIGITS_PRINTED
from symbalance.notes.checking.verdicts import CONTRADICTION, REFUTED, Verdict
from symbalance.notes.reading.equations import Chain

_FEWEST = 1000
_ROUNDED = 5e-4
_POINTS = (1.0, 1.3, 0.8)


def unless_constant_is_rounded(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a proof to the digits printed where only a rounded constant makes it wrong."""
    head, right = chain.sides[0].node, chain.sides[1].node
    is_formula = not k and isinstance(head, Name) and names(right) and head.name not in names(right)
    if not is_formula or verdict.verdict not in (REFUTED, CONTRADICTION) or not isinstance(head, Name):
        return verdict
    letters = names(right) | {head.name}
    for above in reversed(state.sections.chains_between(0, chain.start)):
        sides = [side.node for side in above.sides]
        is_same = len(sides) == 2 and names(sides[0]) | names(sides[1]) == letters
        if not is_same or above.sides[1].span[0] in state.refuted or above.relations[0].sign not in "=≈":
            continue
        if not (_has_constant(right) or any(_has_constant(side) for side in sides)):
            continue
        if _agree((sides[0], sides[1]), head.name, right):
            reason = f"as in line {above.lines[0]}, with its constant rounded"
            return describe(state.document, chain, k, Decision(PROVED, reason, order=DIGITS_PRINTED))
    return verdict


def _has_constant(node: Formula) -> bool:
    """Tell whether a formula has a whole number of four digits or more."""
    numbers = (part.value for part in walk(node) if isinstance(part, Number))
    return any(value.denominator == 1 and abs(value) >= _FEWEST for value in numbers)


def _agree(law: tuple[Formula, Formula], head: str, right: Formula) -> bool:
    """Tell whether a formula gives a letter what an equation of its letters does, but for rounding."""
    for point in _POINTS:
        values = {name: point + 0.37 * place for place, name in enumerate(sorted(names(right)))}
        exact, claimed = solved_at(law, head, values), value_at(right, values)
        if exact is None or claimed is None or not math.isclose(exact, claimed, rel_tol=_ROUNDED):
            return False
    return True
