"""Letters that the lines right below a relation explain: a = r ω²(cos θ + B_2 cos 2θ), where B_2 = λ."""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Formula, Name, Negative, Sum, names
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.equality import Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.matrix_relations import is_of_matrices
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.motions.mean_values import decide_by_mean
from symbalance.notes.checking.steps.data_below import with_data_below
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.verdicts import UNDECIDED
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain

CLAUSES = 15
"""Lines below an equation in matrices that may still say what its letters are."""


def with_letters_below(
    state: JudgingState, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Return the decision with the new letters that the lines right below a relation explain.

    a = r ω²(cos θ + B_2 cos 2θ), where B_2 = λ + …: before that B_2 is a letter. Where it does not
    come out, one of those lines may be wrong as well: nothing is said.
    """
    left, right = chain.sides[k], chain.sides[k + 1]
    below = _letters_below(state, chain, names(left.node) | names(right.node), knowledge)
    if not below:
        return decision
    known = replace(knowledge, definitions={**knowledge.definitions, **below})
    sign = chain.relations[k].sign
    with_all = decide(left, right, sign, known)
    if not with_all.is_proved:
        with_all = decide(left, right, "≈", known)
    if not with_all.is_proved:
        with_all = decide_by_mean(chain, k, known) or with_all
    if with_all.is_proved:
        return with_all
    if _is_false_for_any(left.node, right.node, frozenset(below), decision, knowledge):
        return decision
    texts = ", ".join(plain_text(Name(name)) for name in sorted(below))
    reason = f"not true with {texts} as the lines below have it"
    return replace(decision, status=UNDECIDED, reason=reason)


def _letters_below(
    state: JudgingState, chain: Chain, own: frozenset[str], knowledge: Knowledge
) -> dict[str, Definition]:
    """Return the new letters of a relation that the lines right below it define."""
    last, below = chain.lines[-1], dict[str, Definition]()
    before = state.definitions.letters_in_use
    for other in state.document.chains:
        head = other.sides[0].node
        is_after = other.sides[0].span[0] > chain.sides[-1].span[0] and other.lines[0] <= last + CLAUSES
        is_below = is_after and bool(other.relations)
        if not is_below or not isinstance(head, Name) or other.relations[0].sign not in "=≈":
            continue
        is_new = head.name in own - before and not knowledge.has_meaning(head.name)
        is_new = is_new and bool(names(other.sides[1].node))  # a number is an example's
        if is_new and head.name not in below and head.name not in names(other.sides[1].node):
            below[head.name] = Definition(without_dots(other.sides[1].node)[0], other.lines[0])
    return below


def _is_false_for_any(
    left: Formula,
    right: Formula,
    unknown: frozenset[str],
    decision: Decision,
    knowledge: Knowledge,
) -> bool:
    """Tell whether two sides differ whatever letters are: they are a factor of all that is left."""
    try:
        gap = knowledge.evaluator(decision.level or list(knowledge.levels(left, right))[-1]).form(
            Sum((left, Negative(right)))
        )
    except (NoFormError, TooLargeError):
        return False
    generators = gap.domain.generators
    powers = {
        tuple(
            (g, e)
            for g, e in monomial
            if generators[g].kind == "symbol" and generators[g].content in unknown
        )
        for monomial in gap.numerator
    }
    inner = {n for n in letters(gap) if n in unknown}
    outer = {generators[g].content for power in powers for g, _ in power}
    return len(powers) == 1 and inner <= outer


def with_clauses_below(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Knowledge:
    """Return what is known with the new letters that the lines right below a relation explain.

    An equation in matrices stands first as a rule, what its letters are after it: "here M̃ = ΦᵗMΦ". So
    may a number stand before what it is computed from.
    """
    if not is_of_matrices(chain.sides[k].node, chain.sides[k + 1].node, knowledge):
        return with_data_below(state, chain, k, knowledge)
    last = chain.lines[-1]
    own = chain.letters
    clauses = dict(knowledge.definitions)
    for other in state.document.chains:
        head = other.sides[0].node
        is_below = last < other.lines[0] <= last + CLAUSES and bool(other.relations)
        if not is_below or not isinstance(head, Name) or other.relations[0].sign != "=":
            continue
        is_new = head.name in own and not knowledge.knows(head.name)
        if is_new and head.name not in clauses and head.name not in names(other.sides[1].node):
            clauses[head.name] = Definition(other.sides[1].node, other.lines[0])
    return replace(knowledge, definitions=clauses)
