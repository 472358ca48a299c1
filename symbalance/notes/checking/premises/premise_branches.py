"""Decisions with a premise solved for a letter that stood on the page before it: sin φ = (sin θ)/n.

x = r + l - r cos θ - l cos φ comes first, what φ is after it. On the usual branch such a letter is
put in, and what is proved so is conditional on it; what is false on every branch is refuted.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from symbalance.document.formula import Formula, Name, names
from symbalance.document.text_writer import formula_text
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide, decide_at_value
from symbalance.notes.checking.premises.constraints import letter_counts, solutions
from symbalance.notes.checking.premises.system import Premise
from symbalance.notes.reading.equations import Side


def decide_on_branches(
    left: Side, right: Side, sign: str, premises: Sequence[Premise], knowledge: Knowledge
) -> Decision | None:
    """Return the decision with one premise solved for a letter; None where it says nothing."""
    if len(premises) != 1:
        return None
    (premise,) = premises
    counts = letter_counts(premise.left) + letter_counts(premise.right)
    for name in sorted(premise.names):
        if counts[name] != 1 or knowledge.has_meaning(name) or name in knowledge.angles:
            continue
        is_left = bool(letter_counts(premise.left)[name])
        node, other = (premise.left, premise.right) if is_left else (premise.right, premise.left)
        branches = list(solutions(node, other, name, knowledge.meaning.positive))
        decisions = [
            (_decide(left, right, sign, _with(knowledge, name, value, premise.line)), conditions)
            for value, conditions in branches
        ]
        for decision, conditions in decisions[:1]:
            if decision.is_proved:
                texts = (*decision.assumptions, premise.text, *conditions)
                return replace(decision, assumptions=tuple(dict.fromkeys(texts)))
        if decisions and all(decision.status == REFUTED for decision, _ in decisions):
            return decisions[0][0]
    return None


def _decide(left: Side, right: Side, sign: str, knowledge: Knowledge) -> Decision:
    """Decide a relation as it stands, or else at an angle that a line gives: at θ = 180°."""
    decision = decide(left, right, sign, knowledge)
    for name in sorted(knowledge.angles):
        definition = knowledge.definitions.get(name)
        if (
            decision.is_proved
            or definition is None
            or not definition.numeric
            or name in names(right.node)
        ):
            continue
        there = decide_at_value(left, right, sign, knowledge, name, definition.node)
        if there.is_proved:
            text = " = ".join(formula_text(n, plain=True) for n in (Name(name), definition.node))
            return replace(there, assumptions=(*there.assumptions, text))
    return decision


def _with(knowledge: Knowledge, name: str, value: Formula, line: int) -> Knowledge:
    return knowledge.with_definition(name, Definition(value, line, solved=True))
