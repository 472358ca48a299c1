"""Angles that words alone name: "at γ = 90° the second order vanishes. With 60 degrees: F_2 = 957 N".

The number that a letter has for the angle named before is not the one it has for the next, and an angle
that was given in a relation, γ = 90°, is no longer that of what follows. Nothing is known of the letters
then but their formulas.
"""

from __future__ import annotations

from symbalance.document.formula import Name, names
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.steps.another_case import whole_degrees
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.words.cases_named import angle_of_case
from symbalance.notes.reading.equations import Chain

REACH = 600
"""Characters above a relation in which the angle is named that it is for."""


def leave_angle_above(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget the angle that lines above give a letter where words name another one; tell of any."""
    now = _angle_before(state, chain)
    if now is None:
        return False
    place, degrees = now
    values = {name: d.node for name, d in state.definitions.at(chain.lines[0]).items()}
    own = {n for side in chain.sides[k : k + 2] for n in names(side.node)}
    behind = own.union(*(names_behind(side.node, values) for side in chain.sides[k : k + 2]))
    is_known = False
    for name in sorted(behind & values.keys()):
        given = state.sections.chains_above(Name(name), place)
        turn = whole_degrees(values[name])
        if given and turn is not None and turn != degrees:
            is_known |= state.definitions.forget_line(name, given[-1].lines[0])
    return is_known


def leave_number_at_angle(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget the number that a letter has at the angle that words named before; tell of any."""
    head = chain.sides[0].node
    if k or not isinstance(head, Name) or names(chain.sides[1].node):
        return False
    above = state.sections.chains_above(head, chain.start)
    if not above or names(above[-1].sides[1].node):
        return False
    before, now = _angle_before(state, above[-1]), _angle_before(state, chain)
    if before is None or now is None or now[0] < above[-1].end or before[1] == now[1]:
        return False
    return state.definitions.forget_number(head.name, above[-1].lines[0])


def _angle_before(state: JudgingState, chain: Chain) -> tuple[int, int] | None:
    return angle_of_case(state.document.text, max(0, chain.start - REACH), chain.start)
