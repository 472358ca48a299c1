"""Rates of change that a line above gives a number: ẍ = 9381 m/s², and then F = -m ẍ = -6098 N.

A dot is the derivative of a letter, and no letter itself, so that its number defines nothing. A relation
between it and a number is judged with the number that was worked out last. So it is with J = J_1 + J_2
= 0.8 where nobody gives J_1 or J_2 a value: J stays that sum, and is 0.8 where J Ω² has a number.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from symbalance.document.formula import Derivative, Formula, Name, names, walk
from symbalance.notes.checking.deciding.substitution import replace_part, substitute
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain, Side
from symbalance.text import lazy_patterns as re

_CONDITION = re.compile(
    r"(?<![^\W\d_])(?:when|whenever|once|until|if|wenn|sobald|falls|bis|quand|lorsque|si|quando|se|cuando)[\s$\\(\[]*$",
    re.IGNORECASE,
)
"""Words right before an equation that is to be satisfied."""
_LONGEST = 16


def with_numbers_of_rates(state: JudgingState, chain: Chain, k: int) -> tuple[Chain, tuple[str, ...]]:
    """Return a chain with the numbers that lines above give its rates, and in words which they are.

    The chain as it is, and no words, where a rate has none in its section, or where the relation is not
    between a formula with a rate in it and a number.
    """
    rates = [part for part in walk(chain.sides[k].node) if isinstance(part, Derivative)]
    return _with_numbers(chain, k, {rate: _number_above(state, rate, chain) for rate in rates})


def with_numbers_of_open_letters(
    state: JudgingState, chain: Chain, k: int
) -> tuple[Chain, tuple[str, ...]]:
    """Return a chain with the numbers of letters whose formulas are of letters without values, so too."""
    if _CONDITION.search(state.document.text[max(0, chain.start - _LONGEST) : chain.start]):
        return chain, ()  # it lifts when B b ω² = 75 000: at another ω
    defined, given = state.definitions.at(chain.lines[0]), state.definitions.open_numbers
    numbers: dict[Derivative | Name, tuple[Formula, int] | None] = {
        Name(name): given[name]
        for name in sorted(names(chain.sides[k].node) & given.keys() & defined.keys())
        if defined[name].line == given[name][1] and not defined[name].numeric
    }
    return _with_numbers(chain, k, numbers)


def _with_numbers(
    chain: Chain, k: int, numbers: Mapping[Derivative | Name, tuple[Formula, int] | None]
) -> tuple[Chain, tuple[str, ...]]:
    left, right = chain.sides[k], chain.sides[k + 1]
    if names(right.node) or left.node in numbers or len(left.readings) > 1:
        return chain, ()
    side, words = left, tuple[str, ...]()
    for part, number in numbers.items():
        if number is None:
            return chain, ()
        value, line = number
        side = side.changed(lambda node, old=part, new=value: _replaced(node, old, new))
        words += (f"{plain_text(part)} = {plain_text(value)} of line {line}",)
    sides = (*chain.sides[:k], side, *chain.sides[k + 1 :])
    return (replace(chain, sides=sides), words) if words else (chain, ())


def _replaced(node: Formula, old: Derivative | Name, new: Formula) -> Formula:
    return substitute(node, old.name, new) if isinstance(old, Name) else replace_part(node, old, new)


def _number_above(state: JudgingState, rate: Derivative, chain: Chain) -> tuple[Formula, int] | None:
    """Return the number that a rate has last above a relation, in its section, with its line."""
    line = chain.lines[0]
    above = state.sections.chains_above(rate, chain.start)
    above = [c for c in above if state.sections.same_section(c.lines[0], line)]
    last = above[-1] if above else None
    if last is None or any(relation.sign not in "=≈" for relation in last.relations):
        return None
    value: Side = last.sides[-1]
    return None if names(value.node) or isinstance(value.node, Name) else (value.node, last.lines[0])
