"""A letter given by a second formula in other letters: ω = (ω_max + ω_min)/2 above, ω = 2πN/60 here.

Where the two formulas have no letter in common, also behind their letters, neither follows from the other
and neither is wrong by it: together they tie quantities that nothing tied before. The second is what the
letter is from there on.
"""

from __future__ import annotations

from symbalance.document.formula import Name, names
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import PREMISE, UNDECIDED
from symbalance.notes.reading.equations import Chain

FEWEST = 2
"""Letters of the first formula: one alone is another name for the letter, v = u."""


def by_other_quantities(
    state: JudgingState, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
) -> Decision | None:
    """Return that a relation ties a letter to quantities that nothing tied to it; None for others."""
    head, right = chain.sides[0].node, chain.sides[1].node
    if k or decision.status not in (REFUTED, UNDECIDED) or not isinstance(head, Name) or state.general:
        return None
    earlier = knowledge.definitions.get(head.name)
    if (
        earlier is None
        or earlier.line > chain.lines[0]
        or not names(right)
        or chain.relations[0].sign != "="
    ):
        return None
    if earlier.rounded is not None or earlier.numeric:
        return None  # it has its number
    values = {name: definition.node for name, definition in knowledge.definitions.items()}
    behind = [frozenset(names_behind(node, values)) for node in (earlier.node, right)]
    first, second = behind
    is_free = len(names(earlier.node)) >= FEWEST and not names(earlier.node) & values.keys()
    is_apart = not first & second and head.name not in first | second
    if not (is_free and is_apart) or (first | second) & (knowledge.angles | knowledge.universal):
        return None
    tied = [premise for premise in state.definitions.premises_at(chain.lines[0]) if premise.names & first]
    if any(premise.names & second for premise in tied):
        return None
    state.definitions.note_premise(chain, k)
    state.definitions.define(head.name, right, chain)
    return Decision(PREMISE, f"ties it to other quantities than line {earlier.line}")
