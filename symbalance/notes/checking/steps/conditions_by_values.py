"""Conditions that fail for the numbers a page gives: √((a - b)²) = a - b, where a = 3 and b = 5.

What holds on the condition that something is not negative, a - b ≥ 0, is no conditional truth where
every letter has its number: it is true there or false. An angle's number is that of its case alone,
for θ = 150°, and what is said of all values of a letter rests on none of its numbers.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from symbalance.document.formula import Formula, Name, Number
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.letters_behind import letters_behind, names_behind
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision, digits
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import replace_part
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import CONDITIONAL, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain

_NOT_NEGATIVE = " ≥ 0"
_NEAR_LINES = 2
"""Lines around a relation in which a range is said of it."""
_APART = 1e-2
"""Relative difference from which two sides are not equal, whatever was rounded: a sign makes more."""


def unless_condition_fails(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a condition that the numbers of the page deny leaves nothing that holds."""
    conditions = [text for text in verdict.assumption.split("; ") if text.endswith(_NOT_NEGATIVE)]
    is_open = verdict.verdict == CONDITIONAL and bool(conditions) and chain.relations[k].sign in "=≈"
    if not is_open or _is_of_other_values(state, chain):
        return verdict
    knowledge = state.knowledge_of(chain, state.knowledge(chain.lines[0]))
    sides = (chain.sides[k].node, chain.sides[k + 1].node)
    known = _known_here(state, chain, knowledge)
    values = {**knowledge.meaning.values, **{name: d.node for name, d in known.items()}}
    behind = [known[name] for side in sides for name in names_behind(side, values) if name in known]
    is_sure = behind and not any(d.is_rough or d.alternatives for d in behind)
    if not is_sure or any(letters_behind(side, values) for side in sides):
        return verdict
    numbers = _values(sides, values, knowledge)
    if numbers is None or not _fails_as_printed(sides, values, knowledge):
        return verdict
    given = sorted(name for name, d in known.items() if d in behind and d.numeric)
    lines = sorted({known[name].line for name in given})
    shown = ", ".join(f"{plain_text(Name(n))} = {_as_typed(state, known[n].node)}" for n in given)
    at = f"line{'s' if len(lines) > 1 else ''} {', '.join(map(str, lines))}"
    reason = f"not for {shown} of {at}: it holds if {conditions[0]}"
    witness = {"left": digits(numbers[0]), "right": digits(numbers[1])}
    return describe(state.document, chain, k, Decision(REFUTED, reason, witness=witness))


def _as_typed(state: JudgingState, value: Formula) -> str:
    """Return a value as the page has it, 150°, or written out where it stands nowhere in its text."""
    return state.document.source(value.span) if value.span[1] > value.span[0] else plain_text(value)


def _is_of_other_values(state: JudgingState, chain: Chain) -> bool:
    """Tell whether words or a range right beside say for which values a relation is meant: for a ≥ b."""
    first, last = (state.sections.paragraph_start(chain.lines[0]), chain.lines[-1] + _NEAR_LINES)
    ranges = (
        other
        for other in state.document.chains
        if first - _NEAR_LINES <= other.lines[0] <= last and other.letters & chain.letters
    )
    if any(relation.sign in SATISFIED_BY for other in ranges for relation in other.relations):
        return True
    spoken = dict.fromkeys(chain.letters, False)
    return bool(state.sections.spoken_of_generally(chain, spoken))


def _known_here(state: JudgingState, chain: Chain, knowledge: Knowledge) -> dict[str, Definition]:
    """Return what letters stand for where a relation stands: an angle's number within its case only."""
    line, sections = chain.lines[0], state.sections
    turning = state.turned | knowledge.angles | knowledge.universal
    return {
        name: d
        for name, d in knowledge.definitions.items()
        if not (d.numeric and name in state.general)
        and not (d.numeric and name in turning and sections.case_end(d.line) < line)
        and not (d.numeric and not sections.same_section(d.line, line))
    }


def _fails_as_printed(
    sides: tuple[Formula, Formula], values: dict[str, Formula], knowledge: Knowledge
) -> bool:
    """Tell whether two sides differ, and do so however the printed decimals behind them were rounded."""
    behind = {name for side in sides for name in names_behind(side, values) if name in values}
    numbers = [n for node in (*sides, *(values[name] for name in sorted(behind))) for n in decimals(node)]
    moved = [(sides, values)]
    for number in numbers:
        assert number.last_place is not None
        for step in (number.last_place / 2, -number.last_place / 2):
            off = Number(number.value + step, number.last_place)
            there = {n: replace_part(v, number, off) if n in behind else v for n, v in values.items()}
            left, right = (replace_part(side, number, off) for side in sides)
            moved.append(((left, right), there))
    return all(_differ(_values(*each, knowledge)) for each in moved)


def _differ(numbers: tuple[Any, Any] | None) -> bool:
    if numbers is None:
        return False
    return bool(abs(numbers[0] - numbers[1]) > _APART * max(map(abs, numbers)))


def _values(
    sides: tuple[Formula, Formula], values: dict[str, Formula], knowledge: Knowledge
) -> tuple[Any, Any] | None:
    """Return the numbers of two sides, None where one has none that is real."""
    try:
        points = sample_trees(list(sides), replace(knowledge.meaning, values=values), 1, tries=1)
    except (NoFormError, TooLargeError):
        return None
    return (points[0][1][0], points[0][1][1]) if points else None
