"""Numbers that a clause below a display gives: F = m r ω² = 1974 N, and then "where m = 0.5 kg".

The number stands before what it is computed from. On one line these go first; below a display they are
looked for where the display is judged.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from symbalance.document.formula import Name, names
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_END = r"[\s$,;.\]}]*(?:\\end\s*\{[A-Za-z]+\*?\}|\\\]|\$\$|</?p>)*\s*"
_CLAUSE = re.compile(
    rf"{_END}(?:where|with|in\s+which|here|for|wo|wobei|worin|mit|darin|dabei\s+(?:ist|sind)|où|avec|dans\s+laquelle"
    r"|dove|con|in\s+cui|donde|en\s+(?:la|el)\s+que|ここで|ただし)(?![^\W\d_])"
    r"(?:\s+(?:we\s+have|is|are|ist|sind|est|sono|son))?[\s$:,\\(]*",
    re.IGNORECASE,
)
"""Between a display and the first of its data."""
_NEXT = re.compile(r"[\s$,;、\\)(]*(?:(?:and|und|sowie|et|e|ed|y|さらに)\s)?[\s$\\(]*", re.IGNORECASE)


def with_data_below(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Knowledge:
    """Return what is known with the numbers that a clause right below gives letters without one."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    if names(right) or not names(left) or k + 2 != len(chain.sides):
        return knowledge
    given = dict(_data_below(state, chain))
    if not given:
        return knowledge
    values = {name: definition.node for name, definition in knowledge.definitions.items()}
    values |= dict(knowledge.meaning.values)
    open_letters = {*names(left), *names_behind(left, values)} - values.keys()
    if not open_letters <= given.keys():
        return knowledge
    own = {name: given[name] for name in open_letters}
    return replace(knowledge, definitions={**knowledge.definitions, **own})


def _data_below(state: JudgingState, chain: Chain) -> Iterator[tuple[str, Definition]]:
    """Yield the letters that a clause right below a relation gives a number, with these."""
    text, end, between = state.document.text, chain.end, _CLAUSE
    for other in state.sections.chains_behind(chain.start):
        head, value = other.sides[0].node, other.sides[-1].node
        if between.fullmatch(text, end, other.start) is None:
            return
        if not isinstance(head, Name) or names(value) or other.relations[0].sign != "=":
            return
        yield head.name, Definition(value, other.lines[0], numeric=True)
        end, between = other.end, _NEXT
