"""Ratios that are data of the next question: r = 45 mm, l/r = 3.6, below a question with its own r and l.

A ratio of two letters, given behind a new number of one of them, gives the other one anew: the number
that another question has for it says nothing here. Where its own question gives both, it is a claim.
"""

from __future__ import annotations

from symbalance.document.formula import Name, Quotient, names
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.words.lists_of_data import stand_in_one_list
from symbalance.notes.reading.equations import Chain

_MOST_BETWEEN = 4
"""Data that may stand in a list between a letter's number and its ratio: r = 45 mm, m = 1 kg, l/r = 3."""


def leave_letters_of_ratio(state: JudgingState, chain: Chain, k: int) -> None:
    """Forget the numbers that another section gives a letter whose ratio to a new one is given."""
    ratio, line = chain.sides[0].node, chain.lines[0]
    if k or not _gives_ratio(chain) or not isinstance(ratio, Quotient):
        return
    anew = _given_in_list(state, chain)
    own = [part.name for part in (ratio.numerator, ratio.denominator) if isinstance(part, Name)]
    others = [name for name in own if name not in anew]
    if len(own) != len(others) + 1:
        return
    for name in (*others, *_letters_of_ratio(state, ratio)):
        entries = state.definitions.values.get(name, ())
        lines = {e.definition.line for e in entries if e.definition.numeric}
        if lines and not any(state.sections.same_section(each, line) for each in lines):
            for each in sorted(lines):
                state.definitions.forget_number(name, each)


def _letters_of_ratio(state: JudgingState, ratio: Quotient) -> list[str]:
    """Return the letters that the page has for a ratio, or for its inverse: n = l/r, λ = r/l."""
    both = (ratio, Quotient(ratio.denominator, ratio.numerator))
    return [
        name
        for name in sorted(state.definitions.values)
        if any(side.node in both for c in state.sections.chains_of(Name(name)) for side in c.sides[1:])
    ]


def _gives_ratio(chain: Chain) -> bool:
    """Tell whether a chain does nothing but give a quotient of two letters a number."""
    left = chain.sides[0].node
    is_ratio = isinstance(left, Quotient) and all(
        isinstance(part, Name) for part in (left.numerator, left.denominator)
    )
    is_plain = len(chain.relations) == 1 and chain.relations[0].sign == "="
    return is_ratio and is_plain and not names(chain.sides[1].node)


def _given_in_list(state: JudgingState, chain: Chain) -> frozenset[str]:
    """Return the letters that the data right before a relation, in one list with it, give numbers."""
    found: set[str] = set()
    after = chain
    for _ in range(_MOST_BETWEEN):
        before = state.sections.chain_before(after.start)
        if before is None or len(before.relations) != 1 or names(before.sides[1].node):
            break
        if not stand_in_one_list(before, after, state.document.text):
            break
        if isinstance(before.sides[0].node, Name):
            found.add(before.sides[0].node.name)
        after = before
    return frozenset(found)
