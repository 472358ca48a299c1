"""Relations with ≈ behind words that name their order: to second order in x, e^x ≈ 1 + x is wrong.

Where the words name no letter, it is the one that the page calls small, or the only one there is. Of
harmonics nothing is said here: "up to the second order" may be of 2θ.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Call, Constant, Formula, Name, Number, Product, names, walk
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.named_truncations import decide_proof_through, decide_through
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import PREMISE, PROVED_WORDS, UNDECIDED, Verdict
from symbalance.notes.checking.words.orders_named import order_named
from symbalance.notes.reading.equations import Chain

REACH = 300
"""Characters before a relation in which its sentence may name the order."""
_SPELLED = {"ϵ": "ε", "ϑ": "θ", "ϕ": "φ"}


def unless_of_lower_order(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a rough relation agrees through the order that its words name, or is wrong."""
    is_judged = verdict.verdict in (*PROVED_WORDS, PREMISE, UNDECIDED)
    if chain.relations[k].sign != "≈" or not is_judged:
        return verdict
    named = order_named(state.document.text[max(0, chain.start - REACH) : chain.start])
    if named is None:
        return verdict
    knowledge = state.knowledge(chain.lines[0])
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    usual = knowledge.crank.small[0] if knowledge.crank and knowledge.crank.small else None
    own = sorted(names(left) | names(right))
    small = [name for name in own if name in knowledge.small or name == usual]
    if named.letter:
        small = [name for name in own if _shown(name) == named.letter] or [
            name for name in (usual, *knowledge.small) if name and _shown(name) == named.letter
        ]
    elif _has_harmonics(left) or _has_harmonics(right) or isinstance(left, Name):
        return verdict
    elif verdict.decision is not None and verdict.decision.expanded_in in own:
        small = [verdict.decision.expanded_in]
    elif not small and len(own) == 1 and names(left) == names(right):
        small = own
    if len(small) != 1 or (not names(right) and _has_number(small[0], knowledge)):
        return verdict  # of ½ F_1 ≈ 4825 N nothing is cut off
    own_line = knowledge.definitions.get(left.name) if isinstance(left, Name) else None
    is_own = own_line is not None and own_line.line in chain.lines  # it is what it is defined to be here
    decision = None if is_own else decide_through(left, right, knowledge, small[0], named.order)
    if not (decision and decision.is_proved) and verdict.decision and verdict.verdict in PROVED_WORDS:
        by_proof = decide_proof_through(verdict.decision, right, small[0], named.order)
        decision = by_proof or decision
        if decision is not None and not decision.is_proved and verdict.assumption:
            decision = replace(decision, reason=f"{decision.reason}; if {verdict.assumption}")
    is_left = decision is None or (decision.is_proved and verdict.verdict in PROVED_WORDS)
    return verdict if is_left or decision is None else describe(state.document, chain, k, decision)


def _has_number(name: str, knowledge: Knowledge) -> bool:
    """Tell whether a letter has its value by the page: a number behind it is then a result."""
    definition = knowledge.definitions.get(name)
    return definition is not None and not names(definition.node)


def _shown(name: str) -> str:
    shown = plain_letter(name)
    return _SPELLED.get(shown, shown)


def _has_harmonics(node: Formula) -> bool:
    """Tell whether a wave of a multiple of an angle stands in a formula: cos 2θ."""
    waves = (part for part in walk(node) if isinstance(part, Call) and part.function in ("sin", "cos"))
    return any(
        isinstance(part, Product) and any(isinstance(f, Number | Constant) for f in part.factors)
        for wave in waves
        for part in walk(wave.argument)
    )
