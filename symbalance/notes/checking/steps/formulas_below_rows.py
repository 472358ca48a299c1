"""Formulas that stand below the rows of numbers they are for: rows d = 80 mm, V = 452 cm³, then V = d² h.

The rows give the letter a number each, by the numbers of their own. The formula is what they agree with,
and no claim about the last of them; a row that it contradicts, where another agrees with it, is wrong.
"""

from __future__ import annotations

from symbalance.document.formula import Call, Formula, Name, names, parts_of_kind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.own_row import agrees, common_numbers, row_of
from symbalance.notes.checking.verdicts import (
    CONTRADICTION,
    DEFINITION,
    PREMISE,
    UNDECIDED,
    Verdict,
)
from symbalance.notes.checking.words.lists_of_data import sets_number
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.checking.words.table_cells import cells_of
from symbalance.notes.reading.equations import Chain

_MOST_ROWS, _MOST_LETTERS = 40, 4


def unless_at_odds_with_rows(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict on a number in a row by the formula below it, or on that formula by the rows."""
    head, value = chain.sides[0].node, chain.sides[1].node
    if k or not isinstance(head, Name) or chain.relations[0].sign not in "=≈":
        return verdict
    if names(value):
        return _on_formula(state, chain, head, value, verdict)
    if len(chain.relations) != 1 or verdict.verdict not in (DEFINITION, PREMISE):
        return verdict
    return _on_row(state, chain, head, verdict)


def _on_formula(
    state: JudgingState, chain: Chain, head: Name, formula: Formula, verdict: Verdict
) -> Verdict:
    """Return the verdict on a formula that the rows above have, if they have it."""
    if verdict.verdict not in (UNDECIDED, REFUTED, CONTRADICTION) or len(chain.relations) != 1:
        return verdict
    rows = [c for c in _rows(state, head, chain) if c.end <= chain.start]
    right = [c for c in rows if _fits(state, c, head, formula) is True]
    if not right:
        return verdict
    state.definitions.forget_all(head.name)
    state.definitions.define(head.name, formula, chain)
    lines = sorted({c.lines[0] for c in right})
    at = f"line{'s' if len(lines) > 1 else ''} {', '.join(map(str, lines))}"
    return describe(state.document, chain, 0, Decision(DEFINITION, f"what the numbers of {at} go with"))


def _on_row(state: JudgingState, chain: Chain, head: Name, verdict: Verdict) -> Verdict:
    """Return the verdict on a number in a row, refuted by a formula below that other rows go with."""
    if cells_of(state.document.text).at(chain.start) is None:
        return verdict
    below = [
        c
        for c in state.sections.chains_of(head)
        if c.start > chain.end
        and len(c.sides) > 1
        and names(c.sides[1].node)
        and c.relations[0].sign == "="
        and state.sections.same_section(c.lines[0], chain.lines[0])
    ]
    if len(below) != 1:
        return verdict
    formula = below[0].sides[1].node
    if _fits(state, chain, head, formula) is not False:
        return verdict
    others = [c for c in _rows(state, head, below[0]) if c is not chain]
    if not any(_fits(state, c, head, formula) is True for c in others):
        return verdict
    shown = f"{plain_text(head)} = {plain_text(formula)}"
    reason = f"not by the numbers of its own row and {shown} of line {below[0].lines[0]}"
    return describe(state.document, chain, 0, Decision(REFUTED, reason))


def _rows(state: JudgingState, head: Name, formula: Chain) -> list[Chain]:
    """Return the relations in rows of tables that give a letter a number, in a formula's section."""
    cells, line = cells_of(state.document.text), formula.lines[0]
    own = (c for c in state.sections.chains_of(head) if sets_number(c))
    near = [c for c in own if state.sections.same_section(c.lines[0], line) and cells.at(c.start)]
    return near if len(near) <= _MOST_ROWS else []


def _fits(state: JudgingState, row: Chain, head: Name, formula: Formula) -> bool | None:
    """Tell whether a number of a row is what a formula gives with the others of it; None if open."""
    if any(head.name in names(call) for call in parts_of_kind(formula, Call)):
        return None
    given = row_of(state, row)
    others = names(formula) - {head.name}
    values = {name: given[name] for name in others & given.keys()}
    if not values or len(others) > _MOST_LETTERS:
        return None
    values |= common_numbers(state, row, others - given.keys(), {*given, head.name})
    if values.keys() != others:
        return None
    return agrees(head, formula, {**values, head.name: row.sides[1].node}, head.name)
