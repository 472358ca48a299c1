"""Relations that no step proves: they follow from what a page takes as given, or join it."""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Name, names
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.equality import PROVED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.matrix_relations import is_of_matrices
from symbalance.notes.checking.deciding.numbers_put_in import is_lone_number
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.premises.leftover_premises import decide_with_sizes
from symbalance.notes.checking.premises.premise_branches import decide_on_branches
from symbalance.notes.checking.premises.premise_decisions import decide_by_premises, must_follow
from symbalance.notes.checking.premises.solved_premises import concerns, solve_premises
from symbalance.notes.checking.premises.system import Premise, implied, lines_of
from symbalance.notes.checking.premises.witness_angles import refuted_at_angles
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.other_quantities import by_other_quantities
from symbalance.notes.checking.steps.stated_equations import fix_letter, unless_stated
from symbalance.notes.checking.steps.stated_matrices import fix_matrix
from symbalance.notes.checking.verdicts import CONTRADICTION, PREMISE, REFUTED, STATED, UNDECIDED
from symbalance.notes.reading.equations import Chain, Side

_NEAR = 200
"""Characters of a sentence before a relation in which another one may have said what is wrong."""


def unless_given(
    state: JudgingState, chain: Chain, k: int, against: Side, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Return the decision on what is no proved step: it may be given, or follow from what is."""
    outcome = _unless_given(state, chain, k, against, decision, knowledge)
    return by_other_quantities(state, chain, k, outcome, knowledge) or outcome


def _unless_given(
    state: JudgingState, chain: Chain, k: int, against: Side, decision: Decision, knowledge: Knowledge
) -> Decision:
    left, right = chain.sides[k], chain.sides[k + 1]
    of_matrices = is_of_matrices(left.node, right.node, knowledge)
    premises = [] if of_matrices else must_follow(state.definitions, chain, k)
    if premises:
        return _following(state, chain, k, premises, decision, knowledge)
    if not of_matrices or not state.general:
        as_statement = (fix_matrix if of_matrices else fix_letter)(state, chain, k, knowledge)
        if as_statement is not None:
            return _with_what_it_should_be(state, chain, k, as_statement, decision, knowledge)
    sign = chain.relations[k].sign
    if _is_of_known_numbers(left, right, decision, knowledge):
        return decision
    decision, is_open = with_premises(state, against, right, sign, decision, knowledge)
    if is_open and not of_matrices:
        refuted = replace(decision, status=REFUTED)
        case = unless_stated(state, chain, k, against, refuted, knowledge)
        return case if case.status in (*STATED, CONTRADICTION) else decision
    return decision


def _is_of_known_numbers(left: Side, right: Side, decision: Decision, knowledge: Knowledge) -> bool:
    """Tell whether a result is refuted by letters that all have numbers: nothing can be added."""
    if decision.status != REFUTED or not names(left.node) or names(right.node):
        return False
    if (
        names(left.node) & knowledge.angles
        or isinstance(left.node, Name)
        or not is_lone_number(right.node)
    ):
        return False
    return number_of(left.node, knowledge) is not None


def _following(
    state: JudgingState,
    chain: Chain,
    k: int,
    premises: list[Premise],
    decision: Decision,
    knowledge: Knowledge,
) -> Decision:
    """Return the decision on what is said to follow, and does not: x + y = 2, therefore x = y.

    It is refuted if one line alone speaks of its letters; several, or a number for one of them, may
    rest on what stands in words.
    """
    left, right = chain.sides[k], chain.sides[k + 1]
    by_all, _ = with_premises(state, left, right, "=", decision, knowledge)
    statement = state.definitions.premise_of(chain, k)
    by_premises = decide_by_premises(state.definitions, statement, knowledge)
    if by_premises is not None and by_premises.status != PREMISE:
        return _with_what_it_should_be(state, chain, k, by_premises, decision, knowledge)
    if by_all.status != REFUTED:
        return by_all
    reason = f"does not follow from {lines_of(premises)}"
    is_whole = bool(names(right.node)) and any(statement.names <= p.names for p in premises)
    return replace(by_all, status=REFUTED if is_whole else UNDECIDED, reason=by_all.reason or reason)


def _with_what_it_should_be(
    state: JudgingState,
    chain: Chain,
    k: int,
    as_statement: Decision,
    decision: Decision,
    knowledge: Knowledge,
) -> Decision:
    """Return a contradiction between formulas as the refutation that it is, which can be mended.

    After 8 m_b r_b ω² = 4 λ m r ω² the line m_b r_b = λ m r is wrong by a factor 1/2.
    """
    left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
    if as_statement.status != CONTRADICTION or not names(left.node) or not names(right.node):
        return as_statement
    formulas = {n: d for n, d in knowledge.definitions.items() if names(d.node)}
    general = replace(knowledge, definitions=formulas)  # without the example's numbers
    step, is_open = with_premises(state, left, right, sign, decision, general)
    if is_open or step.status != REFUTED or step.left is None or step.right is None:
        return as_statement
    if not letters(step.left) or {*letters(step.left)} != {*letters(step.right)}:
        return as_statement
    return replace(step, reason=as_statement.reason)


def _by_solved_letters(
    state: JudgingState, left: Side, right: Side, sign: str, by_all: Decision, knowledge: Knowledge
) -> Decision:
    """Return a decision; a refutation is one in the letters that premises leave free.

    After m_A + m_B = m and m_A a = m_B b the line m_A = m a/(a + b) differs from m b/(a + b), whatever
    m_B is. Where the page's sizes a and b make it wrong too, it is at odds with those lines.
    """
    forms = [form for form in (by_all.left, by_all.right) if form is not None]
    if by_all.status != REFUTED or not any(knowledge.solved.keys() & letters(form) for form in forms):
        return by_all
    formulas = {n: d for n, d in knowledge.definitions.items() if names(d.node)}
    general = replace(knowledge, definitions=formulas, solved={}, solved_from=())
    line = state.document.line_of(right.span[0])
    solved = solve_premises(state.definitions, [left.node, right.node], line, general)
    if solved is None or solved.leftover:
        return by_all
    values = {n: Definition(node, line) for n, node in solved.knowledge.solved.items()}
    decision = decide(left, right, sign, replace(general, definitions={**formulas, **values}))
    if decision.status != REFUTED:
        return by_all
    with_numbers = replace(knowledge, solved={}, solved_from=())
    by_numbers = decide_by_premises(state.definitions, Premise(left.node, right.node, line), with_numbers)
    is_against = by_numbers is not None and by_numbers.status == CONTRADICTION
    return replace(decision, reason=by_numbers.reason) if by_numbers and is_against else decision


def _is_contradicted_above(state: JudgingState, start: int) -> bool:
    """Tell whether another relation is refuted in the sentence of a place, before it.

    tan A = r/l, "so A = 71.6° and x = …": which of them is wrong is not known, and one has said it.
    """
    first = max(state.document.text.rfind(". ", 0, start), start - _NEAR)
    return any(first < place < start for place in state.refuted)


def with_premises(
    state: JudgingState, left: Side, right: Side, sign: str, decision: Decision, knowledge: Knowledge
) -> tuple[Decision, bool]:
    """Return the decision with the premises solved together: a witness must satisfy them all.

    Also whether it is undecided for what could not be solved, and may be one more equation.
    """
    nodes = [left.node, right.node]
    solved = solve_premises(state.definitions, nodes, state.document.line_of(right.span[0]), knowledge)
    if solved is None:
        return decision, False
    by_all = decide(left, right, sign, solved.knowledge)
    if by_all.status != REFUTED or not solved.leftover:
        return _by_solved_letters(state, left, right, sign, by_all, solved.knowledge), False
    at_solution = refuted_at_angles(left, right, sign, solved)
    if at_solution is not None or not concerns(solved, by_all):
        return at_solution or by_all, False
    lines = lines_of(solved.premises)
    answer = implied(solved.premises, left.node, right.node, knowledge) if sign == "=" else None
    if answer:
        texts = solved.knowledge.solved_from
        outcome = Decision(PROVED, f"by {lines}", assumptions=texts, level=by_all.level)
    elif answer is False:
        reason = f"no values satisfy it together with {lines}"
        is_sure = not _is_contradicted_above(state, right.span[0])
        outcome = replace(by_all, reason=reason, witness={}, status=REFUTED if is_sure else UNDECIDED)
    elif branched := decide_on_branches(left, right, sign, solved.leftover, knowledge):
        return branched, False
    elif (with_sizes := decide_with_sizes(left, right, sign, solved)) is not None:
        return with_sizes, False
    else:
        reason = f"may rest on {lines_of(solved.leftover)}, which could not be solved for a letter"
        outcome = replace(by_all, status=UNDECIDED, reason=reason)
    return outcome, answer is None
