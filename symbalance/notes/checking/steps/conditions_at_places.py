"""Conditions on an angle that is said to be another one there: "at bottom dead centre cos θ = 1".

An equation for an angle is taken as given. Where its own sentence names the place of the crank, or where
it follows from a line that gives the angle, it can be tried.
"""

from __future__ import annotations

from typing import NamedTuple

from symbalance.document.formula import Call, Formula, Name, names, walk
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.values_of_moments import without_moments
from symbalance.notes.checking.verdicts import CONDITION, UNDECIDED, Verdict
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain

_LETTERS = ("theta", "vartheta", "alpha", "phi", "varphi", "psi")
"""The usual letters of a crank angle that nobody declares."""


def unless_otherwise_at_place(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; undecided for what fixes an angle otherwise than what is said of it.

    At bottom dead centre cos θ = 1, or "hence cos β = 0.866" behind β = 60°: it may be of another crank.
    """
    left, right = chain.sides[k], chain.sides[k + 1]
    has_wave = any(isinstance(part, Call) for part in walk(left.node))
    if verdict.verdict != CONDITION or not has_wave or names(right.node):
        return verdict
    own = names(left.node)
    where = _angle_said(state, chain, min(own)) if len(own) == 1 else None
    if where is None:
        return verdict
    knowledge = without_moments(chain, state.sections, state.knowledge(chain.lines[0]))
    if where.is_of_crank and crank_angle_of(left.node, knowledge) not in own:
        return verdict
    known = knowledge.with_definition(min(own), Definition(where.angle, chain.lines[0], True))
    if decide(left, right, chain.relations[k].sign, known).status != REFUTED:
        return verdict
    return describe(state.document, chain, k, Decision(UNDECIDED, where.reason))


class _AngleSaid(NamedTuple):
    """The angle at which a relation is said to be, and what to say of one that is not so there."""

    angle: Formula
    reason: str
    is_of_crank: bool


def _angle_said(state: JudgingState, chain: Chain, name: str) -> _AngleSaid | None:
    """Return the angle that a relation's sentence names, or that of the line it is a consequence of."""
    place = state.sections.place_named(chain)
    if place is not None:
        reason = f"not where its sentence says it is, at {place.degrees}°: of another angle, or wrong"
        return _AngleSaid(place.angle, reason, is_of_crank=True)
    if not state.sections.is_consequence(chain):
        return None
    above = state.sections.last_above(Name(name), chain.start)
    if above is None or names(above.sides[-1].node):
        return None
    if not state.sections.same_section(above.lines[0], chain.lines[0]):
        return None
    shown = f"{plain_text(Name(name))} = {state.document.source(above.sides[-1].span)}"
    reason = f"not with {shown} of line {above.lines[0]}: of another angle, or wrong"
    return _AngleSaid(above.sides[-1].node, reason, is_of_crank=False)


def crank_angle_of(node: Formula, knowledge: Knowledge) -> str | None:
    """Return the crank angle behind a formula, the one declared or the one angle that is usual."""
    values = {**knowledge.meaning.values, **{n: d.node for n, d in knowledge.definitions.items()}}
    behind = {*names(node), *names_behind(node, values)}
    crank = knowledge.crank
    if crank is not None and isinstance(crank.theta, Name) and crank.theta.name in behind:
        return crank.theta.name
    usual = [name for name in _LETTERS if name in behind]
    return usual[0] if len(usual) == 1 and not isinstance(node, Name) else None
