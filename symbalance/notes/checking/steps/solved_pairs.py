"""Two equations and the two numbers that solve them: x - y = 1 and x + y = 9, so x = 5, y = 4.

The numbers behind the equations are what follows from them, and no data by which these are judged. Each
is put into one equation, which gives the other letter, and with that the second one has to be true.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from symbalance.document.formula import Formula, Name, Negative, Number, Sum, walk
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.tree_values import TreeValues
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import (
    CONDITION,
    CONTRADICTION,
    DEFINITION,
    PREMISE,
    PROVED_WORDS,
    UNDECIDED,
    Verdict,
)
from symbalance.notes.checking.words.lists_of_data import sets_number
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_GIVEN = re.compile(
    r"(?<![^\W\d_])(?:with|where|for|at|when|if|let|take|given|mit|wo|für|bei|wenn|falls|sei|avec|où|pour|si|soit|con|per|dove|se|para|donde|cuando)"
    r"(?![^\W\d_])|で(?:は)?|のとき",
    re.IGNORECASE,
)
"""Words before numbers by which they are given, and no solutions."""
_CONCLUDES = re.compile(
    r"(?<![^\W\d_])(?:so|hence|thus|then|therefore|gives?|get|obtain|find|solution|solutions|solving|also|daher|somit|damit|ergibt|folgt|lösung|lösungen"
    r"|donc|d'où|alors|solution|quindi|dunque|soluzione|luego|entonces|solución)(?![^\W\d_])|よって|ゆえに|解",
    re.IGNORECASE,
)
"""Words by which the numbers of the next sentence are solutions."""
_SENTENCE_END = re.compile(r"[.!?;](?=[\s$])|。|\n\s*\n")
_FAR, _PLACES, _NOTHING = 60, 3, 1e-9
"""Characters between a solution and what stands before it; values that tell a linear equation."""


class Solved(NamedTuple):
    """Two equations of two letters with a number of each behind them."""

    equations: tuple[Chain, Chain]
    numbers: tuple[Chain, Chain]


def unless_pair_is_wrong(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a number is refuted that solves no system, whose equations are conditions."""
    if k or len(chain.relations) != 1 or chain.relations[0].sign != "=":
        return verdict
    if sets_number(chain):
        judged = (*PROVED_WORDS, CONDITION, PREMISE, DEFINITION)
        solved = _solved_by(state, chain) if verdict.verdict in judged else None
        reason = "" if solved is None else _why_not(solved, chain)
        return describe(state.document, chain, k, Decision(REFUTED, reason)) if reason else verdict
    is_open = verdict.verdict in (REFUTED, CONTRADICTION, UNDECIDED) and len(chain.letters) == 2
    if not is_open or _solved_behind(state, chain) is None:
        return verdict
    return describe(state.document, chain, k, Decision(CONDITION, "one of two that are solved behind it"))


def _solved_behind(state: JudgingState, chain: Chain) -> Solved | None:
    """Return the system that an equation is one of the two equations of, None for most."""
    for count, other in enumerate(state.sections.chains_behind(chain.start), 1):
        if sets_number(other):
            solved = _solved_by(state, other)
            return solved if solved is not None and chain in solved.equations else None
        if count == 2:
            break
    return None


def _solved_by(state: JudgingState, chain: Chain) -> Solved | None:
    """Return the system of two equations whose solution a number is a part of, None for most."""
    row = [chain]
    before = state.sections.chain_before(chain.start)
    if before is not None and sets_number(before):
        row.insert(0, before)
    else:
        behind = next(state.sections.chains_behind(chain.end - 1), None)
        row += [] if behind is None else [behind]
    heads = {c.sides[0].node for c in row if sets_number(c)}
    if len(row) != 2 or len(heads) != 2:
        return None
    last = state.sections.chain_before(row[0].start)
    first = None if last is None else state.sections.chain_before(last.start)
    if last is None or first is None:
        return None
    letters = {c.sides[0].node.name for c in row if isinstance(c.sides[0].node, Name)}
    if not all(_is_equation(c, letters) for c in (first, last)) or first.sides == last.sides:
        return None
    if not _leads_on(state.document.text, (first, last, *row)):
        return None
    if any(
        c.start < first.start and sets_number(c)
        for n in letters
        for c in state.sections.chains_of(Name(n))[:1]
    ):
        return None  # numbers that were given before
    return Solved((first, last), (row[0], row[1]))


def _leads_on(text: str, every: tuple[Chain, ...]) -> bool:
    """Tell whether two equations lead to two numbers by the words between them."""
    if any(b.start - a.end > _FAR for a, b in pairwise(every)):
        return False
    _, last, number, other = every
    words = text[last.end : number.start]
    if _GIVEN.search(words) or _GIVEN.search(text, number.end, other.start):
        return False
    return _SENTENCE_END.search(words) is None or _CONCLUDES.search(words) is not None


def _is_equation(chain: Chain, letters: set[str]) -> bool:
    is_one = len(chain.relations) == 1 and chain.relations[0].sign == "="
    return is_one and chain.letters == letters


def _why_not(solved: Solved, chain: Chain) -> str:
    """Return why a number is no part of the solution of two equations, "" where nothing tells."""
    own = chain.sides[0].node
    if not isinstance(own, Name):
        return ""
    other = next(iter(solved.equations[0].letters - {own.name}))
    value = number_of(chain.sides[1].node, Knowledge())
    if value is None:
        return ""
    exact = Fraction(str(float(value)))
    size = _half_of_last_place(chain.sides[1].node, exact)
    for first, second in (solved.equations, solved.equations[::-1]):
        gaps = [
            _gap_with_other(first, second, own.name, other, exact + step) for step in (0, -size, size)
        ]
        if None in gaps:
            continue
        signs = {gap > 0 for gap in gaps if gap is not None}
        if abs(gaps[0] or 0.0) <= _NOTHING * max(1, abs(value)) or len(signs) > 1:
            return ""
        lines = sorted({c.lines[0] for c in solved.equations})
        shown = " and ".join(map(str, lines))
        where = f"line{'s' * (len(lines) > 1)} {shown}"
        return f"no {plain_text(Name(other))} satisfies both equations of {where} with it"
    return ""


def _gap_with_other(first: Chain, second: Chain, own: str, other: str, value: Fraction) -> float | None:
    """Return by how much the second equation fails, with the other letter by the first one, or None."""
    try:
        at = [_gap(first, {own: value, other: Fraction(place)}) for place in range(1, _PLACES + 1)]
        slope = at[1] - at[0]
        if abs(at[2] - at[1] - slope) > _NOTHING * max(map(abs, at)) or abs(slope) <= _NOTHING:
            return None
        solution = Fraction(1) - Fraction(str(at[0])) / Fraction(str(slope))
        return _gap(second, {own: value, other: solution})
    except (NoFormError, ArithmeticError, ValueError):
        return None


def _gap(equation: Chain, values: dict[str, Fraction]) -> float:
    left, right = (side.node for side in equation.sides)
    difference: Formula = Sum((left, Negative(right)))
    value = TreeValues(Knowledge().meaning, values).value(difference)
    return float(value.real)


def _half_of_last_place(node: Formula, value: Fraction) -> Fraction:
    """Return half of the last place of a number as it is printed, in its unit."""
    number = next((part for part in walk(node) if isinstance(part, Number) and part.value), None)
    if number is None:
        return Fraction(0)
    return abs((number.last_place or Fraction(1)) * value / number.value) / 2
