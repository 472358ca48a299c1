"""What a section says at one crank angle, and the next section does not: the largest β is at α = 90°.

A section below its own heading has its own angles: numbers put in letter by letter, m a = 0.50·13708,
that are refuted at an angle of another section are judged without it.
"""

from __future__ import annotations

from symbalance.document.formula import Name
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.numbers_put_in import paired
from symbalance.notes.checking.steps.dead_centres import angle_of_crank
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain


def leave_angle_of_section(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget the crank angle's value of another section, where a relation rests on it; tell of any.

    Numbers are put in for the letters one by one, m a = 0.50·13708: they say themselves what each is.
    """
    line, left = chain.lines[0], chain.sides[k].node
    if isinstance(left, Name) or paired(left, chain.sides[k + 1].node) is None:
        return False
    knowledge = state.knowledge(line)
    theta = angle_of_crank(state, line, knowledge)
    definition = knowledge.definitions.get(theta)
    if definition is None or not definition.numeric or not _is_in_another(state, definition.line, line):
        return False
    values = {name: d.node for name, d in knowledge.definitions.items() if name != theta}
    sides = chain.sides[k : k + 2]
    if all(theta not in names_behind(side.node, values) for side in sides):
        return False
    return state.definitions.forget_line(theta, definition.line)


def _is_in_another(state: JudgingState, earlier: int, line: int) -> bool:
    return earlier < line and not state.sections.same_section(earlier, line)
