"""Numbers that a clause below a display gives: F = m r ω² = 1974 N, and then "where m = 0.5 kg".

The number stands before what it is computed from. On one line these go first; below a display they are
looked for where the display is judged.
"""

from __future__ import annotations

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
    left, right, text = chain.sides[k].node, chain.sides[k + 1].node, state.document.text
    if names(right) or not names(left) or k + 2 != len(chain.sides):
        return knowledge
    values = {name: definition.node for name, definition in knowledge.definitions.items()}
    values |= dict(knowledge.meaning.values)
    behind = {*names(left), *names_behind(left, values)}
    open_letters = {n for n in behind if n not in values}
    found: dict[str, Definition] = {}
    end, between = chain.end, _CLAUSE
    for other in state.sections.chains_behind(chain.start) if open_letters else ():
        head = other.sides[0].node
        if other.start <= chain.start or between.fullmatch(text, end, other.start) is None:
            break
        if not isinstance(head, Name) or names(other.sides[-1].node) or other.relations[0].sign != "=":
            break
        if head.name in open_letters:
            found[head.name] = Definition(other.sides[-1].node, other.lines[0], numeric=True)
        end, between = other.end, _NEXT
    is_whole = open_letters <= found.keys()
    return replace(knowledge, definitions={**knowledge.definitions, **found}) if is_whole else knowledge
