"""Letters that a relation says to change, dω/dt > 0, or to have another value where something is at rest.

A speed that the data give as one number is the mean one. Where a page goes on to how fast it changes, or
to the speed at which something is in resonance, that number is not what the relation is about: it does
not refute it.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from symbalance.document.formula import Derivative, Name, names, walk
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_RESONANCE = re.compile(
    r"(?<![A-Za-z])(?:resonan(?:ce|t)|critical\s+speed|Resonanz|kritische\s+Drehzahl)[^.;!?=]{0,50}"
    r"(?<![A-Za-z])(?:at|bei|is|ist)[\s$]*$|(?:共振|危険速度)[^。;=]{0,20}(?:は|で)[\s$]*$",
    re.IGNORECASE,
)


def changing_letters(state: JudgingState, chain: Chain, k: int) -> frozenset[str]:
    """Return the letters with a number above that a relation says to change, or to be another one."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    letters = {
        part.expression.name
        for part in walk(left)
        if isinstance(part, Derivative)
        and isinstance(part.expression, Name)
        and part.variable.name == "t"
    }
    if not k and isinstance(left, Name) and names(right):
        before = state.document.text[max(chain.start - 80, 0) : chain.start]
        letters |= {left.name} if _RESONANCE.search(before) else set()
    knowledge = state.knowledge(chain.lines[0])
    known, crank = knowledge.definitions, knowledge.crank
    steady = names(crank.omega) if crank is not None else frozenset[str]()
    return frozenset(n for n in letters if n in steady or (n in known and known[n].numeric))


@contextmanager
def without_numbers(state: JudgingState, letters: frozenset[str]) -> Iterator[None]:
    """Leave out for a while the numbers that letters have above, and the equations that give them."""
    definitions = state.definitions
    values, premises = dict(definitions.values), definitions.premises
    definitions.values = {n: e for n, e in values.items() if n not in letters}
    definitions.premises = [
        p for p in premises if not (isinstance(p.left, Name) and p.left.name in letters)
    ]
    try:
        yield
    finally:
        definitions.values, definitions.premises = values, premises
