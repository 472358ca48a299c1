"""Formulas at rest of letters that an equation of motion has move: y = F/k, then m ÿ + k y = 0.

The deflection under a steady force is no solution of the equation: a force that does not change would
have ÿ = 0, and so F = 0. In the equation the letter is the one that moves, whatever it is at rest.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Derivative, Formula, Name, names, walk
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.letters_in_waves import letters_in_waves
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain

ACCELERATION = 2
"""The order of the derivative by which an equation is one of motion."""


def without_values_at_rest(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Knowledge:
    """Return what is known without the formulas at rest of the letters that an equation has move."""
    time = knowledge.crank.time if knowledge.crank else "t"
    sides = [side.node for side in chain.sides[k : k + 2]]
    rates = [
        part.expression.name
        for node in sides
        for part in walk(node)
        if isinstance(part, Derivative)
        and isinstance(part.expression, Name)
        and part.variable.name == time
        and part.order == ACCELERATION
    ]
    if not rates:
        return knowledge
    beside = {name for node in sides for name in _names_beside_rates(node)}
    resting = {name for name in rates if name in beside and _is_at_rest(state, name, knowledge)}
    others = {name: each for name, each in knowledge.definitions.items() if name not in resting}
    return replace(knowledge, definitions=others) if resting else knowledge


def _names_beside_rates(node: Formula) -> frozenset[str]:
    """Return the letters of a side that stand in it as they are, not by their rates alone."""
    inside = {id(each.expression) for each in walk(node) if isinstance(each, Derivative)}
    return frozenset(
        each.name for each in walk(node) if isinstance(each, Name) and id(each) not in inside
    )


def _is_at_rest(state: JudgingState, name: str, knowledge: Knowledge) -> bool:
    """Tell whether a letter's formula has nothing that moves: no time, no crank angle, no rate."""
    definition = knowledge.definitions.get(name)
    if definition is None or not names(definition.node):
        return False
    values = {each: d.node for each, d in knowledge.definitions.items()}
    behind = {*names(definition.node), *names_behind(definition.node, values)}
    nodes = [definition.node, *(values[each] for each in behind if each in values)]
    moving = {"t", *knowledge.angles, *(each.name for each in state.motions.differentiated)} - {name}
    has_waves = any(letters_in_waves(node) for node in nodes)
    has_rates = any(isinstance(part, Derivative) for node in nodes for part in walk(node))
    return not (behind & moving or has_waves or has_rates)
