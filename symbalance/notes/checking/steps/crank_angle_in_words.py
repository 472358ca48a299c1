"""Results at the crank angle that words name: at 30° after top dead centre T = F r sin θ = 245 N m.

No relation gives θ a number there, or only one further up, of another place. The result is computed at
the angle of the words named last in its section: right to its digits, or wrong if one slip lies between.
Where it is neither, what was said of it stays.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Constant, Name, Number, Product, names
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import is_lone_number
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.slips_in_numbers import is_slip
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.steps.conditions_at_places import crank_angle_of, unless_otherwise_at_place
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.values_of_moments import without_moments
from symbalance.notes.checking.verdicts import CONDITION, CONTRADICTION, PREMISE, UNDECIDED, Verdict
from symbalance.notes.checking.words.crank_places import CrankPlace, crank_places
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain

_JUDGED = (CONDITION, PREMISE, UNDECIDED, REFUTED, CONTRADICTION)


def at_crank_angle_in_words(state: JudgingState, chain: Chain, k: int, verdict: Verdict) -> Verdict:
    """Return a verdict; a result that is open or refuted is judged at the crank angle words name."""
    left, right = chain.sides[k], chain.sides[k + 1]
    if verdict.verdict not in _JUDGED or names(right.node) or not names(left.node):
        return verdict
    if (place := _place(state, chain)) is None:
        return unless_otherwise_at_place(state, chain, k, verdict)
    knowledge = without_moments(chain, state.sections, state.knowledge(chain.lines[0]))
    theta = crank_angle_of(left.node, knowledge)
    if theta is None or _has_nearer_number(state, chain, theta, place.start):
        return verdict
    there = _decide_there(chain, k, theta, place, knowledge)
    is_open = verdict.verdict in (PREMISE, UNDECIDED)
    if there.is_proved or (is_open and there.status == REFUTED and there.reason):
        return describe(state.document, chain, k, there)
    return unless_otherwise_at_place(state, chain, k, verdict)


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


def _has_nearer_number(state: JudgingState, chain: Chain, theta: str, place: int) -> bool:
    """Tell whether a line between the words and a relation gives the angle another number."""
    above = state.sections.chains_above(Name(theta), chain.start)
    return any(c.start > place and not names(c.sides[-1].node) for c in above)
