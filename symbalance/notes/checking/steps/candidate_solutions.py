r"""Candidates of an equation that was squared: √(x+1) = x-1 ⇒ x+1 = (x-1)² ⇒ x = 0 or x = 3.

That x is 0 or 3 follows from the last equation, though 0 does not solve the first: only a value that is
said to be the one is a slip. So what stands beside an "or" is open, if it solves the equation before it.
"""

from __future__ import annotations

from symbalance.document.formula import Name, names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.premises.angles_at import solves_as_printed
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONTRADICTION, REFUTED, UNDECIDED, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain


def unless_candidate(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; open where a value beside an "or" solves the equation that it follows from."""
    head, value = chain.sides[0].node, chain.sides[-1].node
    is_value = isinstance(head, Name) and not names(value) and len(chain.relations) == 1
    if verdict.verdict not in (REFUTED, CONTRADICTION) or not is_value or not isinstance(head, Name):
        return verdict
    if not state.sections.is_one_of_several(chain):
        return verdict
    equation = state.sections.equation_before(chain.start, {head.name})
    if equation is None or equation.sides[1].span[0] in state.refuted:
        return verdict
    condition = Premise(equation.sides[0].node, equation.sides[1].node, equation.lines[0])
    if not solves_as_printed(condition, head.name, value, Knowledge()):
        return verdict
    shown = " = ".join(plain_text(side.node) for side in equation.sides)
    reason = f"it satisfies {shown}, and not what that was drawn from: test it"
    return describe(state.document, chain, k, Decision(UNDECIDED, reason))
