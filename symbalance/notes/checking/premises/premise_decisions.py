"""What earlier equations say of one more: it follows from them, contradicts them, or neither."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Number, PlusMinus, Quotient, names, walk
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.branches import with_sign
from symbalance.notes.checking.deciding.equality import PROVED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge, Level
from symbalance.notes.checking.deciding.matrix_relations import is_of_matrices
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises.definitions import Definitions
from symbalance.notes.checking.premises.system import (
    Elimination,
    Premise,
    eliminate,
    has_decimals,
    implied,
    lines_of,
    nonzero_texts,
    related,
)
from symbalance.notes.checking.premises.whole_degrees import decide_to_the_degree
from symbalance.notes.checking.verdicts import CONTRADICTION, PREMISE
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain

DOES_NOT_FIT = "does not fit"
FAR = 4
"""Lines: what does not fit an equation further up may be another engine's, or a new example's."""


def decide_by_premises(
    definitions: Definitions, statement: Premise, knowledge: Knowledge
) -> Decision | None:
    """Return what earlier premises say of a statement; None where they say nothing.

    It follows from them, it contradicts them, or it is one of several solutions. Of matrices they say
    nothing: they are solved as numbers are, whose products commute. An angle in whole degrees is one to
    the degree: after tan α = 4 it is 76°.
    """
    decision = _decide_exactly(definitions, statement, knowledge)
    if decision is None or decision.status != CONTRADICTION:
        return decision
    premises = related(
        definitions.premises_at(statement.line),
        [statement.left, statement.right],
        knowledge,
        rounded=True,
    )
    return decide_to_the_degree(premises, statement, knowledge) or decision


def is_refused(decision: Decision | None) -> bool:
    """Tell whether premises speak against a statement: those near contradict it, those far do not fit."""
    if decision is None:
        return False
    return decision.status == CONTRADICTION or decision.reason.startswith(DOES_NOT_FIT)


def _decide_exactly(
    definitions: Definitions, statement: Premise, knowledge: Knowledge
) -> Decision | None:
    """Return what earlier premises say of a statement as it stands."""
    nodes = [statement.left, statement.right]
    if any(isinstance(part, PlusMinus) for node in nodes for part in walk(node)):
        return _decide_both_signs(definitions, statement, knowledge)
    premises = related(definitions.premises_at(statement.line), nodes, knowledge, rounded=True)
    if not premises or is_of_matrices(statement.left, statement.right, knowledge):
        return None
    before = eliminate(premises, knowledge, rounded=True)
    if not before.is_consistent:
        return None  # said where the last of them stands
    after = eliminate([*premises, statement], knowledge, rounded=True)
    positive = knowledge.meaning.positive & knowledge.meanings.keys()
    refusal = _refusal_by(premises, before, after, statement, positive)
    if refusal is not None and refusal.status == CONTRADICTION:
        refusal = _with_right_value(refusal, before, statement, knowledge)
    return refusal or _support_by(premises, before, after, statement, knowledge)


def _decide_both_signs(
    definitions: Definitions, statement: Premise, knowledge: Knowledge
) -> Decision | None:
    """Return what earlier premises say of x = 2 ± 1: each of the two values has to satisfy them."""
    decisions: list[Decision | None] = []
    for sign in (1, -1):
        left, right = (with_sign(node, sign) for node in (statement.left, statement.right))
        one = replace(statement, left=left, right=right)
        decision = decide_by_premises(definitions, one, knowledge)
        if decision is not None and decision.status == CONTRADICTION:
            reason = f"with the {'upper' if sign > 0 else 'lower'} signs it {decision.reason}"
            return replace(decision, reason=reason)
        decisions.append(decision)
    return decisions[0] if None not in decisions else None


def _refusal_by(
    premises: list[Premise],
    before: Elimination,
    after: Elimination,
    statement: Premise,
    positive: frozenset[str],
) -> Decision | None:
    """Return why a statement cannot stand beside premises: it contradicts them, or makes a letter 0."""
    if not after.is_consistent:
        if after.nonzero:
            return None  # w x = w y does not contradict x ≠ y where w = 0
        others = [p for p in after.contradiction if p is not statement]
        if not others and after.residue is not None and letters(after.residue):
            return None  # of a motion, at some angle
        if others and statement.line - max(p.line for p in others) > FAR:
            reason = f"{DOES_NOT_FIT} {lines_of(others)}: another case, or wrong"
            return Decision(UNDECIDED, reason)
        reason = f"contradicts {lines_of(others)}" if others else "contradicts what is known"
        return Decision(CONTRADICTION, reason)
    zero = [name for name in after.vanishing if name not in before.vanishing]
    if zero and isinstance(statement.left, Name) and names(statement.right):
        reason = f"with {lines_of(premises)} it is true only for {plain_text(Name(zero[0]))} = 0"
        is_of_sizes = not positive.isdisjoint(zero)  # a mass, a radius: declared, and never 0
        return Decision(CONTRADICTION if is_of_sizes else UNDECIDED, reason)
    return None


def _with_right_value(
    refusal: Decision, before: Elimination, statement: Premise, knowledge: Knowledge
) -> Decision:
    """Return a contradiction of a letter's value with the value that the premises give the letter."""
    value = before.values.get(statement.left.name) if isinstance(statement.left, Name) else None
    if value is None:
        return refusal
    evaluator = knowledge.evaluator(list(knowledge.levels(value))[-1])
    try:
        right_one, claimed = evaluator.form(value), evaluator.form(statement.right)
    except (NoFormError, TooLargeError):
        return refusal
    return refusal if letters(right_one) else replace(refusal, left=right_one, right=claimed)


def _support_by(
    premises: list[Premise],
    before: Elimination,
    after: Elimination,
    statement: Premise,
    knowledge: Knowledge,
) -> Decision | None:
    """Return that a statement follows from premises, or is one of their solutions; None for neither."""
    is_implied = statement in after.following or (
        bool(before.leftover) and implied(premises, statement.left, statement.right, knowledge) is True
    )
    sizes = knowledge.meaning.positive & knowledge.meanings.keys()
    forced = _forced_to_vanish(premises, before, sizes) & (names(statement.left) | names(statement.right))
    if is_implied and forced:
        letter = plain_text(Name(min(forced)))
        return Decision(UNDECIDED, f"{lines_of(premises)} hold together only for {letter} = 0")
    pole = _without_value(premises, statement, knowledge) if is_implied else None
    if pole is not None:
        shown = f"{plain_text(statement.left)} = {plain_text(statement.right)}"
        return Decision(CONTRADICTION, f"line {pole.line} has no value for {shown}: it divides by 0")
    if is_implied:
        texts = (*dict.fromkeys(p.text for p in premises), *nonzero_texts(after))
        return Decision(PROVED, f"by {lines_of(premises)}", assumptions=texts)
    if _is_rods(statement.left, knowledge):
        return None  # the one solution that is meant is known
    if any(p in after.following for p in premises if p not in before.following):
        return Decision(PREMISE, f"satisfies {lines_of(premises)}")
    return None


def _without_value(premises: list[Premise], statement: Premise, knowledge: Knowledge) -> Premise | None:
    """Return a premise that divides by zero for a number: x = 1 solves no (x² - 1)/(x - 1) = 2."""
    head, value = statement.left, statement.right
    if not isinstance(head, Name) or names(value):
        return None
    for premise in premises:
        parts = [part for node in (premise.left, premise.right) for part in walk(node)]
        for part in parts:
            if not isinstance(part, Quotient) or names(part.denominator) != {head.name}:
                continue
            try:
                there = substitute(part.denominator, head.name, value)
                if knowledge.evaluator(Level({})).form(there).is_zero():
                    return premise
            except (NoFormError, TooLargeError):
                continue
    return None


def _forced_to_vanish(premises: list[Premise], before: Elimination, sizes: frozenset[str]) -> set[str]:
    """Return the letters that premises make zero together, though none of them says so.

    Whatever has such a letter as a factor would follow from them. One of a linear system may be zero; a
    size may not, nor what is so only where another letter is not, κ m = 0.
    """
    if not before.nonzero and sizes.isdisjoint(before.vanishing):
        return set()
    stated = {
        p.left.name for p in premises if isinstance(p.left, Name) and p.right == Number(Fraction(0))
    }
    return {*before.vanishing} - stated


def must_follow(definitions: Definitions, chain: Chain, k: int) -> list[Premise]:
    """Return the premises that a relation is said to follow from: therefore x = y.

    It is one if it stands behind such a word, and all its letters stand in what is taken as given.
    """
    own = names(chain.sides[k].node) | names(chain.sides[k + 1].node)
    if k or not own or chain.relations[k].sign != "=" or not definitions.sections.is_consequence(chain):
        return []
    premises = [
        p for p in definitions.premises_at(chain.lines[0]) if own & p.names and not has_decimals(p)
    ]
    return premises if own <= {name for p in premises for name in p.names} else []


def _is_rods(node: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a side is the angle of a connecting rod, which a line above fixes."""
    definition = knowledge.definitions.get(node.name) if isinstance(node, Name) else None
    return definition is not None and definition.is_rod_angle
