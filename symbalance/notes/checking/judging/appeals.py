"""Appeals of a relation that does not come out, heard one by one before its refutation stands."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Negative, Number, Product, names
from symbalance.notes.checking.deciding.complex_numbers import decide_as_complex
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.matrix_relations import is_of_matrices
from symbalance.notes.checking.deciding.relations import decide, decide_at_value
from symbalance.notes.checking.deciding.rounding import decimals, significant
from symbalance.notes.checking.deciding.sums_over_cylinders import NO_ANGLES
from symbalance.notes.checking.judging.open_reasons import unless_open, unless_solved_in_sentence
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.premises.premise_decisions import must_follow
from symbalance.notes.checking.steps.angle_equations import at_rough_angle
from symbalance.notes.checking.steps.dead_centres import angle_named, angle_there
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.letters_below import with_letters_below
from symbalance.notes.checking.steps.meant_roughly import decide_as_rough
from symbalance.notes.checking.steps.slips_at_places import says_direction
from symbalance.notes.checking.steps.stated_equations import unless_stated
from symbalance.notes.checking.units.numbers_in_units import decide_in_units
from symbalance.notes.checking.verdicts import REFUTED, UNDECIDED
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain, Side

FEWEST_DIGITS = 2
"""Of a number that stands for a letter where numbers are put in."""


def appeal(
    state: JudgingState, chain: Chain, k: int, against: Side, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Return the decision on a refuted relation by all that may be meant with it, in turn."""
    of_matrices = is_of_matrices(chain.sides[k].node, chain.sides[k + 1].node, knowledge)
    # cases and conditions are of numbers
    may_state = not of_matrices and not must_follow(state.definitions, chain, k) and not state.general
    if not of_matrices:
        sides = chain.sides[k], chain.sides[k + 1]
        decision = decide_as_complex(*sides, chain.relations[k].sign, decision, knowledge)
    if decision.status == REFUTED and may_state:
        decision = unless_stated(state, chain, k, against, decision, knowledge)
    if decision.status == REFUTED:
        decision = decide_in_units(chain, k, decision, state.document, knowledge)
    if decision.status == REFUTED:
        decision = _with_wrong_results(state, chain, k, against, decision, knowledge)
    for mend in (
        decide_as_rough,
        _at_stated_angle,
        _with_sign_of_values,
        unless_solved_in_sentence,
        with_letters_below,
        at_rough_angle,
        unless_open,
    ):
        if decision.status == REFUTED:
            decision = mend(state, chain, k, decision, knowledge)
    if decision.status == UNDECIDED and decision.reason == NO_ANGLES:  # Re(e^{jnθ} Z_n), Z_n below
        below = with_letters_below(state, chain, k, decision, knowledge)
        decision = below if below.is_proved else decision
    return decision


def _with_wrong_results(
    state: JudgingState, chain: Chain, k: int, against: Side, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Return the proof of a relation from a number that is refuted where it was printed first."""

    def by(left: Side, right: Side, known: Knowledge) -> Decision:
        return decide(left, right, chain.relations[k].sign, known)

    def value_of(node: Formula) -> float | None:
        number = number_of(node, knowledge)
        return None if number is None else float(number)

    by_wrong_number = state.wrong_numbers.decide((against, chain.sides[k + 1]), knowledge, by, value_of)
    return by_wrong_number or decision


def _at_stated_angle(
    state: JudgingState, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Return the proof of a relation at an angle its sentence names: at top dead centre, where θ = 0.

    So too where it says "at 90°" and no letter, or where the heading gives the angle.

    An angle stays free where a line gives it a number; a relation without it may be meant there. One
    that is wrong there too is refuted there, where its line gives the angle. Between numbers no angle
    counts: what refutes them is the formula before, or its unit.
    """
    left, right, line = chain.sides[k], chain.sides[k + 1], chain.lines[0]
    if not names(left.node) and not names(right.node):
        return decision
    angles: list[tuple[str, Formula]] = []
    for name in sorted(knowledge.angles):
        definition = knowledge.definitions.get(name)
        if definition is None or not definition.numeric:
            continue
        is_here = state.sections.paragraph_start(line) <= definition.line
        is_here = is_here or state.sections.looks_back(chain, definition.line)
        is_here = is_here or line <= (state.sections.end_of_angle_headed(definition.line) or 0)
        if is_here or line <= state.sections.case_end(definition.line):
            angles.append((name, definition.node))
    if (there := at_dead_centre(state, chain, k, knowledge)) is not None:
        return there
    at_centre = angle_there(state, chain, k, knowledge)
    if at_centre is None and (named := angle_named(state, chain, knowledge)) is not None:
        angles.append(named)
    refuted_there = decision
    for name, value in angles:
        if name in names(right.node):
            continue
        assumption = f"{plain_text(Name(name))} = {plain_text(value)}"
        there = decide_at_value(left, right, chain.relations[k].sign, knowledge, name, value)
        if not there.is_proved and not names(right.node):
            by_printed = _with_numbers_of(right.node, knowledge)
            there_printed = decide_at_value(left, right, chain.relations[k].sign, by_printed, name, value)
            there = there_printed if there_printed.is_proved else there
        if there.is_proved:
            return replace(there, assumptions=(*there.assumptions, assumption))
        own = knowledge.definitions.get(name)
        is_stated = own is not None and own.line in chain.lines and not k
        if there.status == REFUTED and is_stated and name not in names(left.node):
            refuted_there = replace(there, reason=there.reason or f"at {assumption}")
    return refuted_there


def at_dead_centre(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the proof of a relation at the dead centre its sentence names, None for none.

    Where words say the direction apart, numerically F = F₁ (1 - λ), the value may have the other sign.
    """
    left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
    place = angle_there(state, chain, k, knowledge)
    if place is None or place[0] in names(right.node):
        return None
    name, value = place
    assumptions = [f"{plain_text(Name(name))} = {plain_text(value)}"]
    there = decide_at_value(left, right, sign, knowledge, name, value)
    if not there.is_proved and not names(right.node):
        by_printed = _with_numbers_of(right.node, knowledge)
        there = decide_at_value(left, right, sign, by_printed, name, value)
    if not there.is_proved and says_direction(state, chain):
        opposite = Side((Negative(left.node),), left.span)
        there = decide_at_value(opposite, right, sign, knowledge, name, value)
        assumptions.append("the size is meant, whose direction words say")
    return replace(there, assumptions=(*there.assumptions, *assumptions)) if there.is_proved else None


def _with_sign_of_values(
    state: JudgingState, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Return the proof of √(1 - k)² = 1 - k where the page has k = 0.5 and 0.65, and no value above 1.

    The squares are the same for every k, the sides where the letter has one of the page's numbers.
    """
    left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
    given = {
        name: values
        for name in sorted(names(right.node) - knowledge.definitions.keys() - knowledge.angles)
        if (values := _numbers_given(state, name))
    }
    if sign != "=" or len(given) != 1:
        return decision
    first, second = (Side((Product((side.node, side.node)),), side.span) for side in (left, right))
    if not decide(first, second, sign, knowledge).is_proved:
        return decision
    ((name, values),) = given.items()
    there = [decide_at_value(left, right, sign, knowledge, name, Number(value)) for value in values]
    proofs = [each for each in there if each.is_proved]
    if not proofs or any(each.status == REFUTED for each in there):
        return decision
    return replace(proofs[0], assumptions=(*proofs[0].assumptions, f"{plain_text(right.node)} ≥ 0"))


def _numbers_given(state: JudgingState, name: str) -> list[Fraction]:
    """Return the numbers that the page has given a letter so far."""
    nodes = [entry.definition.node for entry in state.definitions.values.get(name, [])]
    return [node.value for node in nodes if isinstance(node, Number)]


def _with_numbers_of(right: Formula, knowledge: Knowledge) -> Knowledge:
    """Return what is known with letters at the digits that an arithmetic puts in: λ = 0.2903 as 0.29."""
    put_in = [n for n in decimals(right) if significant(n) >= FEWEST_DIGITS and n.last_place is not None]
    definitions = dict(knowledge.definitions)
    for name, definition in knowledge.definitions.items():
        value = None if name in knowledge.angles else number_of(definition.node, knowledge)
        for number in put_in if value is not None else ():
            assert value is not None
            assert number.last_place is not None
            if abs(float(value) - float(number.value)) <= float(number.last_place) / 2:
                definitions[name] = replace(definition, node=Number(number.value), numeric=True)
    return replace(knowledge, definitions=definitions)
