"""The equation that stands nearest above a number of a letter: for the hollow shaft τ is another formula.

A page has τ = 16 M/(π d³), and further down for another thing τ = 16 M D/(π (D⁴ - d⁴)), or u b = c a in a
section of its own where u had a formula before. A number of the letter that follows is that of the
equation nearest above it, with the numbers given last.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Formula, Name, names
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading.equations import Chain

FEWEST = 2
"""Letters with numbers that an equation has besides the one that is worked out."""


def by_nearest_equation(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the proof that a refuted number of a letter is what the equation nearest above gives it.

    None where it is not, where that equation is refuted itself, or is the one that the letter has its
    value from.
    """
    head, value = chain.sides[0].node, chain.sides[k + 1].node
    if not isinstance(head, Name) or names(value) or any(names(s.node) for s in chain.sides[1 : k + 1]):
        return None
    equation = _nearest_equation(state, head, chain)
    known = knowledge.definitions.get(head.name)
    if equation is None or (known is not None and known.line >= equation.lines[0] and not known.numeric):
        return None
    others = (names(equation.sides[0].node) | names(equation.sides[1].node)) - {head.name}
    numbers = {name: _number_above(state, name, chain) for name in sorted(others)}
    given = {name: each for name, each in numbers.items() if each is not None}
    if len(given) < FEWEST:
        return None
    rest = {name: each for name, each in knowledge.definitions.items() if name != head.name}
    freer = replace(knowledge, definitions={**rest, **given}, solved={}, solved_from=())
    sides = (substitute(side.node, head.name, value) for side in equation.sides)
    decision = decide(*map(lone_side, sides), chain.relations[k].sign, freer)
    if not decision.is_proved:
        return None
    by_line = f"by line {equation.lines[0]}"
    return replace(decision, assumptions=(*decision.assumptions, by_line))


def _nearest_equation(state: JudgingState, head: Name, chain: Chain) -> Chain | None:
    """Return the last equation above a relation that has its letter among others; None if refuted."""
    line = chain.lines[0]
    for other in reversed(state.sections.in_order):
        if other.start >= chain.start or len(other.relations) != 1 or other.relations[0].sign not in "=≈":
            continue
        if not state.sections.same_section(other.lines[0], line):
            return None
        left, right = (side.node for side in other.sides)
        if not names(right) or not _is_asked_of(head, left) or head.name in names(right):
            continue
        return None if other.sides[1].span[0] in state.refuted else other
    return None


def _is_asked_of(head: Name, left: Formula) -> bool:
    """Tell whether an equation's left side is a letter, or a product in which it stands."""
    return left == head or (not isinstance(left, Name) and head.name in names(left))


def _number_above(state: JudgingState, name: str, chain: Chain) -> Definition | None:
    """Return the number that a letter is given last above a relation, in its section."""
    line = chain.lines[0]
    above = [c for c in state.sections.chains_of(Name(name)) if c.end <= chain.start]
    above = [c for c in above if state.sections.same_section(c.lines[0], line)]
    last = max(above, key=lambda each: each.start, default=None)
    if last is None or names(last.sides[-1].node) or last.relations[-1].sign not in "=≈":
        return None
    return Definition(last.sides[-1].node, last.lines[0], numeric=True)
