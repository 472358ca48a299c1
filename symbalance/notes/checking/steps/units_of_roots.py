"""Roots with a unit of conditions without one: d³ = 16·18 000/(6000 π) = 15.28, so d = 2.48 in.

The numbers of the condition are in the unit of the root, which is named with the root alone.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Name, Number, names
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.units.conversions import quantity_of
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_NEAR = 6
"""Lines in which a root stands below its condition."""
_COMMAND = re.compile(r"\\[A-Za-z]+|π|(?<![A-Za-z])(?:pi|sqrt)(?![A-Za-z])")
_UNIT = re.compile(r"[^\W\d_]|[°%]")


def decide_root_with_unit(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return the proof of a root by the bare numbers of the condition above it; None for any other."""
    head, right = chain.sides[k].node, chain.sides[k + 1]
    if k or not isinstance(head, Name) or names(right.node) or len(chain.relations) > 1:
        return None
    condition = _condition_of_root(state, chain, head.name)
    quantity = quantity_of(right, state.document)
    if condition is None or quantity is None or _is_bound_elsewhere(state, head.name, condition, chain):
        return None
    if any(_has_unit(state.document.source(s.span)) for s in condition.sides[1:]):
        return None
    has_places = quantity.half and quantity.half < Fraction(1, 2)
    number = Number(quantity.value, 2 * quantity.half if has_places else None)
    line = chain.lines[0]
    there = state.given_numbers.decide(head.name, number, line, line, knowledge, of_it_alone=True)
    if there is None or not there.is_proved:
        return None
    _take_root(state, chain, head.name, condition)
    return there


def _is_bound_elsewhere(state: JudgingState, name: str, condition: Chain, chain: Chain) -> bool:
    """Tell whether more than the condition says what a letter is: d < 0, or another equation of it."""
    definitions, line = state.definitions, chain.lines[0]
    own = range(condition.lines[0], condition.lines[-1] + 1)
    others = any(name in p.names and p.line not in own for p in definitions.premises_at(line))
    return others or any(
        name in names(part) for each in definitions.ranges_at(line) for part in (each.left, each.right)
    )


def _has_unit(source: str) -> bool:
    return _UNIT.search(_COMMAND.sub(" ", source)) is not None


def _condition_of_root(state: JudgingState, chain: Chain, name: str) -> Chain | None:
    """Return the last relation above with a letter, where it fixes that letter alone; None if not."""
    above = (c for c in reversed(state.sections.in_order) if c.start < chain.start and name in c.letters)
    last = next(above, None)
    is_near = last is not None and chain.lines[0] - last.lines[-1] <= _NEAR
    if last is None or not is_near or isinstance(last.sides[0].node, Name):
        return None
    is_equation = all(relation.sign in "=≈" for relation in last.relations)
    others = frozenset[str]().union(*(names(side.node) for side in last.sides[1:]))
    return last if is_equation and not others and names(last.sides[0].node) == {name} else None


def _take_root(state: JudgingState, chain: Chain, name: str, condition: Chain) -> None:
    """Give a letter the root with its unit, in the place of what the condition's bare numbers make it."""
    definitions = state.definitions
    for line in (condition.lines[0], chain.lines[0]):
        definitions.forget_line(name, line)
    definitions.premises = [
        p for p in definitions.premises if p.line != condition.lines[0] or p.names != {name}
    ]
    state.given_numbers.end(frozenset({name}), 0)
    definitions.define(name, chain.sides[1].node, chain)
