"""A number is judged by the numbers before it in its own row, list item or case: r = 50 mm, s = 80 mm.

Where a page goes through several engines, another number of a letter is a new case. But the row that
gives r, l and λ together gives one engine, and λ = r/l is to be true in it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import product

from symbalance.document.formula import (
    Call,
    Formula,
    Name,
    Number,
    names,
    parts_of_kind,
    with_parts_changed,
)
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.measured_values import is_measured
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import PREMISE, PROVED_WORDS, REFUTED, UNDECIDED, Verdict
from symbalance.notes.checking.words.lists_of_data import sets_number
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_ANOTHER = ("a new case", "of another")
"""How the reasons of a number begin that is taken for one of another case."""
_ROW = re.compile(r"[ \t]*\|")
_ITEM = re.compile(r"[ \t]*(?:[-*+•]|\(?[0-9a-h]{1,2}[.)]|\\item)[ \t]")
_MANY = 200
"""Relations of one letter on a page, beyond which no row is looked for."""
MOST = 4
"""Letters of a formula: the corners of more are not tried."""
FEWEST = 10
"""Units of its last place that a rounded whole number has at least: two digits count."""
CLEARLY = 0.005
"""By how much of it a number differs from its formula's value at least, to be refuted."""


def by_own_row(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a number of a letter is compared with what its own row gives it."""
    head, value = chain.sides[0].node, chain.sides[1].node
    if len(chain.relations) != 1 or not isinstance(head, Name) or names(value):
        return verdict
    is_new = verdict.verdict == PREMISE and verdict.reason.startswith(_ANOTHER)
    if not is_new and verdict.verdict not in PROVED_WORDS:
        return verdict
    givers = state.sections.chains_of(head)
    if len(givers) > _MANY:
        return verdict  # a page of thousands of numbers of one letter takes time in proportion
    is_alone = sum(map(sets_number, givers)) <= 1
    if (is_alone and not is_new) or is_measured(state.definitions, chain):
        return verdict
    row = {
        name: value for name, value in row_of(state, chain).items() if value.span < chain.sides[1].span
    }
    for left, formula in _equations(state, chain, head.name):
        if any(head.name in names(call) for call in parts_of_kind(formula, Call)):
            continue  # an angle is a place, at which something else is said
        others = (names(left) | names(formula)) - {head.name}
        given = {name: row[name] for name in others & row.keys()}
        if not given or len(others) > MOST:
            continue
        given |= common_numbers(state, chain, others - row.keys(), {*row, head.name})
        if given.keys() != others:
            continue
        known = state.knowledge(chain.lines[0]).definitions
        is_in_force = all(n in known and known[n].node == v for n, v in given.items())
        if not is_new and is_in_force:
            continue
        is_so = agrees(left, formula, {**given, head.name: value}, head.name)
        if is_so is False:
            status = REFUTED if is_new else UNDECIDED
            shown = " and ".join(f"{plain_text(Name(n))} = {plain_text(v)}" for n, v in given.items())
            equation = f"{plain_text(left)} = {plain_text(formula)}"
            reason = f"its own row has {shown}, with which {equation} is not so"
            return describe(state.document, chain, k, Decision(status, reason))
    return verdict


def row_of(state: JudgingState, chain: Chain) -> dict[str, Formula]:
    """Return the numbers that a relation's row of a table, list item or sentence gives letters."""
    sections, text, line = state.sections, state.document.text, chain.lines[0]
    head = chain.sides[0].node
    lines = sections.lines
    first = last = line
    if not _ROW.match(lines[line - 1]):
        while first > sections.paragraph_start(line) and not _ITEM.match(lines[first - 1]):
            first -= 1
    row = _numbers_on(state, range(first, last + 1))
    if _ROW.match(lines[line - 1]) and {c.sides[0].node for c in row} == {head}:
        while _ROW.match(lines[first - 2]):
            first -= 1
        while last < len(lines) and _ROW.match(lines[last]):
            last += 1
        column = _column(state, chain)
        return _values(
            [c for c in _numbers_on(state, range(first, last + 1)) if _column(state, c) == column]
        )
    before = [c for c in row if c.sides[0].node == head and c.start < chain.start]
    start = max((c.end for c in before), default=0)
    behind = [c for c in row if c.sides[0].node == head and c.start > chain.start]
    stop = min((c.start for c in behind), default=len(text)) if before or not behind else chain.start
    return _values([c for c in row if start <= c.start < stop])


def _column(state: JudgingState, chain: Chain) -> int:
    """Return the column of a table that a relation stands in, by the bars before it on its line."""
    line = state.sections.start_of_line(chain.lines[0])
    return state.document.text.count("|", line, chain.start)


def _numbers_on(state: JudgingState, lines: range) -> list[Chain]:
    """Return the relations on lines that give letters one number, in order."""
    chains = [c for line in lines for c in state.sections.chains_on(line)]
    chains += [c for c in state.data if c.lines[0] in lines]
    return sorted((c for c in chains if sets_number(c)), key=lambda c: c.start)


def _values(chains: list[Chain]) -> dict[str, Formula]:
    """Return the numbers of letters; none where a letter has several: they are of several things."""
    heads = [c.sides[0].node for c in chains]
    if len(set(heads)) < len(heads):
        return {}
    return {c.sides[0].node.name: c.sides[1].node for c in chains if isinstance(c.sides[0].node, Name)}


def common_numbers(
    state: JudgingState, chain: Chain, letters: frozenset[str], row: Iterable[str]
) -> dict[str, Formula]:
    """Return the numbers of letters that the page gives once, above a relation, apart from such rows."""
    common: dict[str, Formula] = {}
    sections, line = state.sections, chain.lines[0]
    starts = {
        sections.paragraph_start(c.lines[0])
        for name in row
        for c in sections.chains_of(Name(name))
        if c.lines[0] != line
    }
    for name in letters:
        every = [*sections.chains_of(Name(name)), *state.data]
        own = [c for c in every if c.sides[0].node == Name(name) and not names(c.sides[-1].node)]
        is_apart = own and sections.paragraph_start(own[0].lines[0]) not in starts
        if len(own) == 1 and is_apart and sets_number(own[0]) and own[0].end <= chain.start:
            common[name] = own[0].sides[1].node
    return common


def _equations(state: JudgingState, chain: Chain, name: str) -> Iterator[tuple[Formula, Formula]]:
    """Yield the equations of a letter: what declared letters are, and the formulas above."""
    for other, formula in state.knowledge(chain.lines[0]).meaning.values.items():
        if name in {other, *names(formula)}:
            yield Name(other), formula
    for each in state.sections.in_order:
        if each.end > chain.start:
            return
        is_formula = bool(each.relations) and each.relations[0].sign == "="
        left = each.sides[0].node
        if not is_formula or not isinstance(left, Name) or not names(each.sides[1].node):
            continue
        is_right = each.sides[1].span[0] not in state.refuted and each.lines[0] not in state.rough_lines
        if is_right and name in {left.name, *names(each.sides[1].node)}:
            yield left, each.sides[1].node


def agrees(left: Formula, right: Formula, values: dict[str, Formula], name: str) -> bool | None:
    """Tell whether numbers make an equation true, to the digits that they are printed with.

    None where the difference is too small to be sure, or cannot be worked out.
    """
    gaps: list[float] = []
    ends = {n: _ends(node, is_result=n == name) for n, node in values.items()}
    for corner in product(*(ends[n] for n in values)):
        sides = _put_in(left, right, dict(zip(values, corner, strict=True)))
        if sides is None:
            return None
        gaps.append(sides[0] - sides[1])
    nominal = _put_in(left, right, values)
    if nominal is None or not any(nominal):
        return None
    if min(gaps) <= 0 <= max(gaps):
        return True
    is_clear = abs(nominal[0] - nominal[1]) > CLEARLY * max(map(abs, nominal))
    return False if is_clear else None


def _put_in(left: Formula, right: Formula, values: dict[str, Formula]) -> tuple[float, float] | None:
    try:
        for name, value in values.items():
            left, right = substitute(left, name, value), substitute(right, name, value)
    except NoFormError:
        return None
    points = sample_trees([left, right], SymbolValue(), 1)
    return (float(points[0][1][0].real), float(points[0][1][1].real)) if points else None


def _ends(node: Formula, *, is_result: bool) -> tuple[Formula, ...]:
    """Return a number as printed, at both ends of what it may be rounded from; a whole one is exact."""
    digits = next((p for p in parts_of_kind(node, Number) if p.last_place or is_result), None)
    if digits is None:
        return (node,)
    place = digits.last_place or _last_place(digits)
    low, high = (Number(digits.value + sign * place / 2) for sign in (-1, 1))

    def with_end(part: Formula, end: Number) -> Formula:
        return end if part is digits else with_parts_changed(part, lambda each: with_end(each, end))

    return with_end(node, low), with_end(node, high)


def _last_place(digits: Number) -> Fraction:
    """Return the last place of a whole number that may be rounded to tens or hundreds: 1200, but not 80.

    >>> _last_place(Number(Fraction(1200))), _last_place(Number(Fraction(80)))
    (Fraction(100, 1), Fraction(1, 1))
    """
    place, value = Fraction(1), abs(digits.value)
    while value >= FEWEST * place * 10 and not value % (place * 10):
        place *= 10
    return place
