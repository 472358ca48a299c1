"""Results at the crank angle that words name: at 30° after top dead centre T = F r sin θ = 245 N m.

No relation gives θ a number there, or only one further up, of another place. The result is computed at
the angle of the words named last in its section: right to its digits, or wrong if one slip lies between.
Where it is neither, what was said of it stays.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

from symbalance.document.formula import Call, Constant, Formula, Name, Number, Product, names, walk
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import is_lone_number
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.slips_in_numbers import is_slip
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.values_of_moments import without_moments
from symbalance.notes.checking.verdicts import CONDITION, CONTRADICTION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.checking.words.crank_places import CrankPlace, crank_places
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain

_JUDGED = (CONDITION, PREMISE, UNDECIDED, REFUTED, CONTRADICTION)
_LETTERS = ("theta", "vartheta", "alpha", "phi", "varphi", "psi")
"""The usual letters of a crank angle that nobody declares."""


def at_crank_angle_in_words(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a result that is open or refuted is judged at the crank angle words name."""
    left, right = chain.sides[k], chain.sides[k + 1]
    if verdict.verdict not in _JUDGED or names(right.node) or not names(left.node):
        return verdict
    if (place := _place(state, chain)) is None:
        return unless_otherwise_at_place(state, chain, k, verdict)
    knowledge = without_moments(chain, state.sections, state.knowledge(chain.lines[0]))
    theta = _crank_angle(left.node, knowledge)
    if theta is None or _has_nearer_number(state, chain, theta, place.start):
        return verdict
    there = _decide_there(chain, k, theta, place, knowledge)
    is_open = verdict.verdict in (PREMISE, UNDECIDED)
    if there.is_proved or (is_open and there.status == REFUTED and there.reason):
        return describe(state.document, chain, k, there)
    return unless_otherwise_at_place(state, chain, k, verdict)


def unless_otherwise_at_place(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; undecided for what fixes an angle otherwise than what is said of it.

    At bottom dead centre cos θ = 1, or "hence cos β = 0.866" behind β = 60°: it may be of another crank.
    """
    left, right = chain.sides[k], chain.sides[k + 1]
    has_wave = any(isinstance(part, Call) for part in walk(left.node))
    if verdict.verdict != CONDITION or not has_wave or names(right.node):
        return verdict
    knowledge = without_moments(chain, state.sections, state.knowledge(chain.lines[0]))
    own = names(left.node)
    where = _angle_said(state, chain, min(own)) if len(own) == 1 else None
    if where is None or (where.is_of_crank and _crank_angle(left.node, knowledge) not in own):
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
    if above is None or names(above.sides[-1].node) or not _is_in_section(state, above, chain):
        return None
    shown = f"{plain_text(Name(name))} = {state.document.source(above.sides[-1].span)}"
    reason = f"not with {shown} of line {above.lines[0]}: of another angle, or wrong"
    return _AngleSaid(above.sides[-1].node, reason, is_of_crank=False)


def _is_in_section(state: JudgingState, above: Chain, chain: Chain) -> bool:
    return state.sections.same_section(above.lines[0], chain.lines[0])


def _decide_there(chain: Chain, k: int, theta: str, place: CrankPlace, knowledge: Knowledge) -> Decision:
    """Return the decision at the angle of a place, with the reason where one slip lies between."""
    left, right = chain.sides[k], chain.sides[k + 1]
    angle = Product((Number(place.degrees / 180), Constant("pi")))
    known = knowledge.with_definition(theta, Definition(angle, chain.lines[0], True))
    there = decide(left, right, chain.relations[k].sign, known)
    text = f"{plain_text(Name(theta))} = {plain_text(Number(place.degrees))}° (“{place.words}”)"
    if there.is_proved:
        return replace(there, assumptions=(*there.assumptions, text))
    typed, exact = number_of(right.node, known), number_of(left.node, known)
    if not typed or not exact or not is_lone_number(right.node):
        return Decision(UNDECIDED)
    if not is_slip(abs(float(typed)), abs(float(exact)), right.node):
        return Decision(UNDECIDED)
    return Decision(REFUTED, f"with {text} it is {float(exact):.4g} in SI units")


def _place(state: JudgingState, chain: Chain) -> CrankPlace | None:
    """Return the crank angle that words name last before a relation in its section; None for none."""
    sections, line = state.sections, chain.lines[0]
    before = [each for each in crank_places(state.document.text) if each.start < chain.start]
    if not before:
        return None
    is_here = sections.same_section(state.document.line_of(before[-1].start), line)
    return before[-1] if is_here else None


def _crank_angle(node: Formula, knowledge: Knowledge) -> str | None:
    """Return the crank angle behind a formula, the one declared or the one angle that is usual."""
    values = {**knowledge.meaning.values, **{n: d.node for n, d in knowledge.definitions.items()}}
    behind = {*names(node), *names_behind(node, values)}
    crank = knowledge.crank
    if crank is not None and isinstance(crank.theta, Name) and crank.theta.name in behind:
        return crank.theta.name
    usual = [name for name in _LETTERS if name in behind]
    return usual[0] if len(usual) == 1 and not isinstance(node, Name) else None


def _has_nearer_number(state: JudgingState, chain: Chain, theta: str, place: int) -> bool:
    """Tell whether a line between the words and a relation gives the angle another number."""
    above = state.sections.chains_above(Name(theta), chain.start)
    return any(c.start > place and not names(c.sides[-1].node) for c in above)
