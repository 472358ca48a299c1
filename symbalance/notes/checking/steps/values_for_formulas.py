"""Values given for a formula in letters: p_2 = p_1 (V_1/V_2)^κ, with V_1/V_2 = 10 p_2 = 25.1 bar.

Neither V_1 nor V_2 has a number, and yet what is computed from their ratio alone has one: with V_1 put in
as 10 V_2 the other letter cancels. A result that passes as given, or as a range, is judged so.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Derivative, Formula, Name, Number, names, walk
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.tree_values import sample_trees
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY, compare
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises import constraints
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import (
    CONTRADICTION,
    PREMISE,
    PROVED_WORDS,
    RANGE,
    UNDECIDED,
    Verdict,
)
from symbalance.notes.checking.words.cases_named import OF_ANOTHER_ENGINE
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain
from symbalance.text import lazy_patterns as re

_SENTENCE = re.compile(r"[.;:!?]\s|[。；：]|\n\s*\n")
_SIZES = (2, 7)
"""Numbers for the letters that cancel: what is computed has to be the same with both."""
_SAME = 1e-9
MOST_GIVEN = 12
"""Relations before a result among which a value for a formula is looked for."""


def unless_by_value_of_formula(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; what only passes as given is judged by the values of formulas before it."""
    sign, right = chain.relations[k].sign, chain.sides[k + 1]
    is_against = verdict.verdict in (REFUTED, CONTRADICTION)
    is_stale = verdict.verdict in PROVED_WORDS and _is_said_before_case(state, chain)
    is_open = is_against or is_stale or verdict.verdict in (PREMISE, RANGE, UNDECIDED)
    is_range = sign in SATISFIED_BY
    is_claim = is_range and (state.sections.is_consequence(chain) or _is_of_its_sentence(state, chain))
    is_claim = is_claim or (sign in "=≈" and not names(right.node))  # and not: required is σ < 100
    is_open = is_open and verdict.reason != OF_ANOTHER_ENGINE
    if not (is_open and is_claim) or state.sections.opens_case(chain):
        return verdict
    node = chain.sides[k].node if is_range else next(_formulas(state, chain, k), None)
    if node is None:
        return verdict
    known = [_with_ratios(state, chain, node, size) for size in _SIZES]
    if not _cancels(node, known):
        return verdict
    found: list[Decision] = []
    for knowledge in filter(None, known):
        left = replace(right, readings=(node,))
        by_size = compare(node, right.node, sign, knowledge) if is_range else None
        there = by_size if is_range else decide(left, right, sign, knowledge)
        if there is None or not (there.is_proved or there.status == REFUTED):
            return verdict
        found.append(there)
    is_one = len({each.is_proved for each in found}) == 1
    is_one = is_one and (found[0].is_proved or not is_against)
    proof = found[0] if found[0].is_proved else replace(found[0], reason="")
    return describe(state.document, chain, k, proof) if is_one else verdict


def _cancels(node: Formula, known: list[Knowledge | None]) -> bool:
    """Tell whether a formula comes to one number, whatever the size of the letters that are free."""
    numbers = []
    for each in known:
        number = None if each is None else _number(node, each)
        if number is None:
            return False
        numbers.append(number)
    return all(abs(each - numbers[0]) <= _SAME * max(1.0, abs(numbers[0])) for each in numbers)


def _number(node: Formula, knowledge: Knowledge) -> complex | None:
    """Return what a formula comes to by what is known, None where a letter is left."""
    values = {name: d.node for name, d in knowledge.definitions.items()}
    meaning = replace(knowledge.meaning, values={**knowledge.meaning.values, **values})
    try:
        rows = sample_trees([node], meaning, 1, tries=1)
    except (NoFormError, TooLargeError):
        return None
    return complex(rows[0][1][0]) if rows and not rows[0][0] else None


def _is_of_its_sentence(state: JudgingState, chain: Chain) -> bool:
    """Tell whether a relation stands in one sentence with the one before it."""
    last = state.sections.chain_before(chain.start)
    text = state.document.text
    return last is not None and _SENTENCE.search(text, last.end, chain.start) is None


def _is_said_before_case(state: JudgingState, chain: Chain) -> bool:
    """Tell whether a formula was given a number since a letter had the value that is said of it again."""
    head, last = chain.sides[0].node, state.sections.chain_before(chain.start)
    above = state.sections.last_above(head, chain.start) if isinstance(head, Name) else None
    if last is None or above is None or names(above.sides[-1].node):
        return False
    return above.end <= last.start and _given_for_formula(state, last) is not None


def leave_value_of_formula(state: JudgingState, chain: Chain) -> None:
    """Forget the number of a formula where a case gives it another: V_1/V_2 = 10 …, for V_1/V_2 = 12 …

    A formula is no letter: its number is a premise, which the next one would contradict.
    """
    formula, number = chain.sides[0].node, chain.sides[-1].node
    is_value = len(chain.relations) == 1 and chain.relations[0].sign == "=" and not names(number)
    if not is_value or isinstance(formula, Name) or len(names(formula)) < 2:
        return
    if not state.sections.opens_case(chain):
        return
    definitions, above = state.definitions, state.sections.chains_above(formula, chain.start)
    others = [c for c in above if len(c.relations) == 1 and not names(c.sides[-1].node)]
    if not others or others[-1].sides[-1].node == number:
        return
    lines = {c.lines[0] for c in others}
    definitions.premises = [p for p in definitions.premises if p.left != formula]
    for name in names(formula) & definitions.values.keys():
        entries = definitions.values[name]
        solved = [e for e in entries if e.definition.solved and e.definition.line in lines]
        if solved:
            definitions.values[name] = [e for e in entries if e not in solved]


def _formulas(state: JudgingState, chain: Chain, k: int) -> Iterator[Formula]:
    """Yield the formula that a result is of: the side before it, or the one of its letter above."""
    left = chain.sides[k].node
    if not isinstance(left, Name):
        yield left
        return
    for above in reversed(state.sections.chains_above(left, chain.start)):
        if not state.sections.same_section(above.lines[0], chain.lines[0]):
            return
        if names(above.sides[1].node):
            yield above.sides[1].node
            return


def _with_ratios(state: JudgingState, chain: Chain, own: Formula, size: int) -> Knowledge | None:
    """Return what is known with the values given for formulas, None where none is, or a letter is left.

    The letters by which the formulas are solved are of one size.
    """
    knowledge, last, found = state.knowledge(chain.lines[0]), chain, False
    for _ in range(MOST_GIVEN):
        last = state.sections.chain_before(last.start)
        if last is None or not state.sections.same_section(last.lines[0], chain.lines[0]):
            break
        pair = _given_for_formula(state, last)
        if pair is None:
            continue
        formula, value = pair
        if names(formula) & knowledge.definitions.keys():
            continue
        solved = constraints.solve(formula, value)
        if solved is None or not _bears_on(own, names(formula), knowledge):
            continue
        name, node = solved
        if any(isinstance(part, Derivative) for part in walk(node)):
            continue  # of a rate no letter is a number
        for other in sorted(names(node)):
            node = substitute(node, other, Number(Fraction(size)))
            free = Definition(Number(Fraction(size)), last.lines[0])
            knowledge = knowledge.with_definition(other, free)
        text = f"{plain_text(formula)} = {plain_text(value)}"
        given = Definition(node, last.lines[0], assumption=text)
        knowledge, found = knowledge.with_definition(name, given), True
    values = {name: d.node for name, d in knowledge.definitions.items()}
    is_left = any(name not in values for name in names_behind(own, values))
    return knowledge if found and not is_left else None


def _given_for_formula(state: JudgingState, chain: Chain) -> tuple[Formula, Formula] | None:
    """Return a formula in letters and the number that a chain gives it, proved by nothing."""
    if len(chain.sides) < 2 or chain.relations[-1].sign != "=":
        return None
    formula, value = chain.sides[-2].node, chain.sides[-1].node
    is_stated = chain.sides[-1].span[0] in state.stated
    if isinstance(formula, Name) or names(value) or len(names(formula)) < 2 or not is_stated:
        return None
    return formula, value


def _bears_on(node: Formula, own: frozenset[str], knowledge: Knowledge) -> bool:
    """Tell whether a formula, or those of its letters, have the letters of another one."""
    values = {name: d.node for name, d in knowledge.definitions.items()}
    return own <= {*names_behind(node, values)}
