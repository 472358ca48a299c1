"""Values that a letter has on one range of another: M = M₀ sin θ for 0 ≤ θ ≤ π, M = 0 for π < θ < 2π.

An integral over one of the ranges has the value of that one, and so has what is said at a place in it.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import inf
from typing import NamedTuple

from symbalance.document.formula import Formula, Integral, Name, names, walk
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain


class Range(NamedTuple):
    """A range of a letter between two numbers, and its words."""

    letter: str
    low: float
    high: float
    words: str


class OnRange(NamedTuple):
    """A value of a letter on a range."""

    value: Formula
    range: Range
    line: int


def value_on_own_range(
    state: JudgingState, chain: Chain, k: int, name: str, knowledge: Knowledge
) -> tuple[Formula | None, Range] | None:
    """Return the value that a letter has on the range a relation is about, and that range.

    None where lines above give the letter no values on ranges, or the one in force is of that range;
    no value where none of them is.
    """
    given = list(_given(state, chain, name, knowledge))
    letters = {each.range.letter for each in given}
    if len(given) <= 1 or len(letters) != 1:
        return None
    (letter,) = letters
    node = knowledge.definitions[name].node
    now = next((each for each in reversed(given) if each.value == node), None)
    if now is None:
        return None
    for low, high in _parts(state, chain, k, letter, knowledge):
        if now.range.low <= low and high <= now.range.high:
            continue
        within = [each for each in given if each.range.low <= low and high <= each.range.high]
        return (within[-1].value, within[-1].range) if within else (None, now.range)
    return None


def _parts(
    state: JudgingState, chain: Chain, k: int, letter: str, knowledge: Knowledge
) -> Iterator[tuple[float, float]]:
    """Yield the intervals of a letter over which a relation integrates, or where its line puts it."""
    for side in chain.sides[k : k + 2]:
        for part in walk(side.node):
            if isinstance(part, Integral) and part.variable == Name(letter):
                ends = [_number(end, knowledge) for end in (part.lower, part.upper) if end is not None]
                if len(ends) == len([part.lower, part.upper]) and None not in ends:
                    yield min(e for e in ends if e is not None), max(e for e in ends if e is not None)
    own = state.sections.chain_before(chain.start)
    if own is not None and own.lines[0] == chain.lines[0] and own.sides[0].node == Name(letter):
        is_value = len(own.relations) == 1 and own.relations[0].sign in "=≈"
        place = _number(own.sides[1].node, knowledge) if is_value else None
        if place is not None:
            yield place, place


def _given(state: JudgingState, chain: Chain, name: str, knowledge: Knowledge) -> Iterator[OnRange]:
    """Yield the values that lines above give a letter on ranges."""
    text = state.document.text
    for giver, ranges in state.ranges_beside.of(name):
        if giver.start >= chain.start:
            return
        where = next(filter(None, (_range(each, text, knowledge) for each in ranges)), None)
        if where is not None:
            yield OnRange(giver.sides[1].node, where, giver.lines[0])


def _range(chain: Chain, text: str, knowledge: Knowledge) -> Range | None:
    """Return a relation as a range of one letter between numbers; None for any other."""
    if len(chain.letters) != 1 or not chain.relations:
        return None
    (letter,) = chain.letters
    low, high = -inf, inf
    for k, relation in enumerate(chain.relations):
        left, right = (side.node for side in chain.sides[k : k + 2])
        if relation.sign not in SATISFIED_BY or Name(letter) not in (left, right):
            return None
        number = _number(right if left == Name(letter) else left, knowledge)
        if number is None:
            return None
        is_upper = (relation.sign in "<≤") == (left == Name(letter))
        low, high = (low, min(high, number)) if is_upper else (max(low, number), high)
    return Range(letter, low, high, text[chain.start : chain.end].strip(" $"))


def _number(node: Formula | None, knowledge: Knowledge) -> float | None:
    if node is None or names(node):
        return None
    number = number_of(node, knowledge)
    return None if number is None else float(number)
