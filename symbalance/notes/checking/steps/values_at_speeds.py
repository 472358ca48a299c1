"""Inertia forces at two speeds: F(2600) is a quarter of F(5200), as they go with the square of the speed.

The page has to show that it is such a force: a formula of it with ω² above. Numbers in brackets are then
speeds, in whatever unit both are given.
"""

from __future__ import annotations

from collections.abc import Iterator

from symbalance.document.formula import names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.reading import ReadingError, read_equation
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_UNIT = (
    r"(?:\s|\\,|~)*(?:\\(?:mathrm|text|unit|rm)\s*\{?)?\s*"
    r"(?:rpm|r/min|rev/min|U/min|tr/min|min\}?\s*\^\s*\{?-1\}?|/min)?\}?"
)
_AT_SPEED = re.compile(
    r"(?P<letter>(?:\\hat\s*\{?\s*)?(?<![\\A-Za-z])[A-Z][A-Za-z0-9]{0,3}\}?(?:_\{[^{}]{1,12}\}|_\w{1,8})?)"
    rf"\s*(?:\\left\s*)?\(\s*(?P<speed>[0-9]{{3,5}}){_UNIT}\s*(?:\\right\s*)?\)"
)
"""A force and a speed in brackets behind it: F_1(6500), \\hat F_{II}(2600)."""
_SQUARED = re.compile(
    r"(?:(?<![A-Za-z])(?:\\?[oO]mega|ω|Ω|om|w|n|N)|[0-9]{2,}(?:[.,][0-9]+)?\)?)\s*(?:\^\s*\{?\s*2(?![0-9])|²)"
)
"""A speed squared, as a letter or as a number of two digits or more."""
REASON = "it goes with the square of the speed"


def by_speed_in_brackets(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; one on a force at two speeds, by the square of what they are to each other."""
    start, end = chain.sides[k].span[0], chain.sides[k + 1].span[1]
    typed = state.document.text[start:end]
    found = [*_AT_SPEED.finditer(typed)]
    letters = {_plain(match["letter"]) for match in found}
    if len(found) < 2 or len(letters) > 1 or not _goes_with_square(state, letters.pop(), start):
        return verdict
    squares = _AT_SPEED.sub(lambda match: f"({match['speed']})^{{2}}", typed)
    try:
        squared = read_equation(squares, frozenset())
    except ReadingError:
        return verdict
    if len(squared.sides) != 2 or any(names(side.node) for side in squared.sides):
        return verdict
    first, second = squared.sides
    sign = chain.relations[k].sign
    decision = decide(first, second, sign, state.knowledge(chain.lines[0]))
    if decision.status not in (PROVED, REFUTED):
        return verdict
    return describe(state.document, chain, k, Decision(decision.status, REASON))


def _goes_with_square(state: JudgingState, letter: str, start: int) -> bool:
    """Tell whether a formula above gives a letter with a speed squared."""
    return any(_SQUARED.search(formula) for formula in _formulas_of(state, letter, start))


def _formulas_of(state: JudgingState, letter: str, start: int) -> Iterator[str]:
    """Yield, as typed, the relations above that a letter opens."""
    for above in state.document.chains:
        if above.start < start:
            first, last = above.sides[0], above.sides[-1]
            if _plain(state.document.source(first.span)) == letter:
                yield state.document.text[first.span[1] : last.span[1]]


def _plain(letter: str) -> str:
    """Return a letter as typed without its accent, braces and "max"."""
    return re.sub(r"\\hat|\\max|max|[\s{}\\,_]", "", letter)
