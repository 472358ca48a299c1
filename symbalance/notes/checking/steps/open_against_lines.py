"""Relations refuted by lines above that may all the same be meant otherwise: units, or an unknown letter.

N = 258 rev/min stands above, and N = √(Q/(0.00034 B R)) with a load Q that nothing has given yet: it says
at which speed Q is lifted, and no number of N refutes it. V = 4.5·3600/6 has the numbers of V = S N/6 as
they are typed, in inches and per minute, and the formula may be meant so.
"""

from __future__ import annotations

from symbalance.document.formula import Name
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.formulas_between_numbers import puts_in_as_typed
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain


def open_against_lines(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return why a relation that lines above refute is left open; None where it is not."""
    left, right = chain.sides[0], chain.sides[k + 1]
    if not isinstance(left.node, Name):
        return None
    if puts_in_as_typed(left, right, state.document, knowledge):
        return Decision(UNDECIDED, "true of the numbers as typed: say in which units its formula is")
    known = knowledge.definitions.get(left.node.name)
    if k or known is None or not known.numeric or known.line in chain.lines:  # a mended one of its own
        return None
    new = _new_letters(state, chain, knowledge)
    if not new:
        return None
    shown = ", ".join(plain_text(Name(name)) for name in new)
    return Decision(UNDECIDED, f"{shown} has no value above: it may be what this fixes")


def _new_letters(state: JudgingState, chain: Chain, knowledge: Knowledge) -> list[str]:
    """Return the letters of a formula that have no value above, and no known meaning."""
    values = {name: d.node for name, d in knowledge.definitions.items()}
    own = {*names_behind(chain.sides[1].node, values)} - values.keys()
    return sorted(n for n in own if not knowledge.has_meaning(n) and n not in knowledge.angles)
