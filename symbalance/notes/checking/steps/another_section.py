"""What a section says at one crank angle, and the next section does not: the largest β is at α = 90°.

A section below its own heading has its own angles: what is refuted at an angle of another section is
judged without it, and a number that a sentence gives at an angle, "at α = 30° the force is F = 12 kN", is
not that which another section has a formula for.
"""

from __future__ import annotations

from symbalance.document.formula import Name, names
from symbalance.notes.algebra.tree_values import names_behind
from symbalance.notes.checking.steps.dead_centres import angle_of_crank
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain


def leave_angle_of_section(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget the crank angle's value of another section, where a relation rests on it; tell of any."""
    line = chain.lines[0]
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


def leave_formula_of_section(state: JudgingState, chain: Chain, k: int) -> bool:
    """Forget another section's formula of a letter that has a number at an angle here; tell of any."""
    head, line = chain.sides[0].node, chain.lines[0]
    is_number = not k and len(chain.relations) == 1 and chain.inline and not names(chain.sides[1].node)
    if not is_number or not isinstance(head, Name) or not _has_angle_before(state, chain):
        return False
    entries = [entry.definition for entry in state.definitions.values.get(head.name, ())]
    formulas = [d.line for d in entries if names(d.node)]
    if not formulas or not all(_is_in_another(state, earlier, line) for earlier in formulas):
        return False
    state.definitions.premises = [p for p in state.definitions.premises if p.left != head]
    state.definitions.forget_all(head.name)
    return True


def _has_angle_before(state: JudgingState, chain: Chain) -> bool:
    """Tell whether the same line gives the crank angle a number before a relation."""
    theta = angle_of_crank(state, chain.lines[0], state.knowledge(chain.lines[0]))
    before = [c for c in state.sections.chains_on(chain.lines[0]) if c.end <= chain.start]
    return any(c.sides[0].node == Name(theta) and not names(c.sides[-1].node) for c in before)


def _is_in_another(state: JudgingState, earlier: int, line: int) -> bool:
    return earlier < line and not state.sections.same_section(earlier, line)
