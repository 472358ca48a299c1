"""Quantities of another engine: max C_P of the five cylinders, where C_P was that of the three.

A page that goes on to another engine may speak of the largest value of a force or a couple without a
formula of its own for it. The formula above is of the engine before, and no statement is refuted by it:
what is said of the largest value is new, as F_max = … would be, and a second value is not.
"""

from __future__ import annotations

from symbalance.document.formula import Call, Extremum, Formula, Name, Negative, names
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import DEFINITION
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain


def leave_engine(state: JudgingState, chain: Chain) -> bool:
    """Forget the formula of a quantity of the engine before; tell whether there was one.

    The quantity is what a relation begins with, its largest value or its size; one that is declared is
    the same on the whole page.
    """
    name = _measured(chain.sides[0].node)
    line = chain.lines[0]
    if not name or name in state.declarations.symbols_at(line):
        return False
    lines = [
        entry.definition.line
        for entry in state.definitions.values.get(name, ())
        if state.sections.is_of_another_engine(chain, entry.definition.line)
    ]
    for earlier in lines:
        state.definitions.forget(name, earlier)
    return bool(lines)


def as_new_extreme(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return that a relation says how large a quantity gets of which no formula is known; None for others."""
    name, right = _measured(chain.sides[0].node), chain.sides[1]
    is_new = name and not knowledge.has_meaning(name) and name not in names(right.node)
    if k or not is_new or not isinstance(chain.sides[0].node, Extremum):
        return None
    key = (chain.sides[0].node.function, name)
    earlier = state.extremes.setdefault(key, (right, chain.lines[0]))
    if earlier[0] is not right and state.sections.same_section(earlier[1], chain.lines[0]):
        return None
    state.extremes[key] = (right, chain.lines[0])
    text = f"the {'largest' if key[0] == 'max' else 'smallest'} value of {plain_text(Name(name))}"
    return Decision(DEFINITION, f"{text}, of which no formula stands above")


def _measured(node: Formula) -> str:
    """Return the letter of max F, |F| and -max F; "" for anything else."""
    if isinstance(node, Negative):
        return _measured(node.operand)
    inner: Formula | None = None
    if isinstance(node, Extremum):
        inner = node.body
    elif isinstance(node, Call) and node.function == "abs":
        inner = node.argument
    if isinstance(inner, Call) and inner.function == "abs":
        inner = inner.argument
    return inner.name if isinstance(inner, Name) else ""
