"""The verdict on one relation of a chain: is it an inequality, a definition, a step, or given?"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Number,
    Product,
    Summation,
    names,
    walk,
)
from symbalance.document.letters import plain_letter
from symbalance.notes.checking.deciding.claimed_inequalities import decide_claimed, ranges_near
from symbalance.notes.checking.deciding.denied_conditions import decide_within_ranges
from symbalance.notes.checking.deciding.descriptions import describe
from symbalance.notes.checking.deciding.equality import (
    Decision,
    decide_equality,
    is_of_another_size,
)
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY, decide_inequality
from symbalance.notes.checking.deciding.knowledge import Knowledge, StatedRange
from symbalance.notes.checking.deciding.matrix_relations import is_of_matrices
from symbalance.notes.checking.deciding.relations import MEANT_ROUGHLY, decide
from symbalance.notes.checking.deciding.sign_of_letters import decide_with_signs
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.deciding.values_in_ranges import decide_where_values
from symbalance.notes.checking.judging.appeals import appeal, at_dead_centre
from symbalance.notes.checking.judging.lines_at_odds import note_other_case
from symbalance.notes.checking.meant.engine_speeds import decide_speed
from symbalance.notes.checking.meant.engines.balance_shafts import decide_half_of_a_swing
from symbalance.notes.checking.meant.engines.firing_intervals import (
    decide_firing_interval,
    decide_order_frequency,
    refute_repeated_interval,
)
from symbalance.notes.checking.meant.engines.lever_arms import refute_lever_arm
from symbalance.notes.checking.meant.given_numbers import number_given
from symbalance.notes.checking.meant.left_sides import head_of
from symbalance.notes.checking.meant.meant_extremes import decide_declared_extreme
from symbalance.notes.checking.meant.order_speeds import decide_order_speed
from symbalance.notes.checking.meant.parallel_axes import decide_parallel_axes
from symbalance.notes.checking.meant.sizes_of_round_shafts import decide_round_ratio
from symbalance.notes.checking.meant.two_discs import decide_two_discs
from symbalance.notes.checking.motions.action_and_reaction import against_reaction
from symbalance.notes.checking.motions.equations_of_motion import (
    EquationOfMotion,
    decide_motion,
    decide_natural_frequency,
    equation_of_motion,
)
from symbalance.notes.checking.motions.fourier_series import as_fourier_series, decide_fourier
from symbalance.notes.checking.motions.listed_values import decide_for_values
from symbalance.notes.checking.motions.matrix_equations_of_motion import rows_of_motion
from symbalance.notes.checking.motions.mean_values import decide_by_mean
from symbalance.notes.checking.motions.solutions_of_motion import decide_motion_solution
from symbalance.notes.checking.page.solutions import solution_below
from symbalance.notes.checking.premises.conditions_behind import values_behind
from symbalance.notes.checking.premises.constraints import Constraint
from symbalance.notes.checking.premises.letter_values import define_letter
from symbalance.notes.checking.premises.measured_values import MEASURED
from symbalance.notes.checking.premises.ranges_in_words import letters_without_sign
from symbalance.notes.checking.premises.rough_letters import decide_roughly
from symbalance.notes.checking.steps.angle_equations import as_angle_solved, as_equation_for_angle
from symbalance.notes.checking.steps.another_engine import as_new_extreme
from symbalance.notes.checking.steps.dead_centres import value_at_dead_centre
from symbalance.notes.checking.steps.derivatives_in_words import refute_named_rate
from symbalance.notes.checking.steps.derivatives_set_to_zero import as_zero_of_derivative
from symbalance.notes.checking.steps.differentiated_above import judge_derivative_of_above
from symbalance.notes.checking.steps.gravity import decide_with_gravity
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.listed_cases_of_letters import case_of_listed_values, case_of_run
from symbalance.notes.checking.steps.mean_piston_speed import mean_piston_speed
from symbalance.notes.checking.steps.much_larger import PLAIN, decide_much_larger, decide_where_larger
from symbalance.notes.checking.steps.named_roots import as_named_root, as_one_solution
from symbalance.notes.checking.steps.open_cases import case_of_a_letter, leave_range_of_case
from symbalance.notes.checking.steps.products_of_vectors import decide_products_of_vectors
from symbalance.notes.checking.steps.proportional import SIGN as PROPORTIONAL
from symbalance.notes.checking.steps.proportional import decide_proportional
from symbalance.notes.checking.steps.relation_fixes import add_fix_of_relation
from symbalance.notes.checking.steps.relative_motions import decide_relative_motion
from symbalance.notes.checking.steps.solved_balances import as_balance_solution
from symbalance.notes.checking.steps.solved_below import as_proved_solution, as_solved
from symbalance.notes.checking.steps.solved_waves import decide_solved_wave
from symbalance.notes.checking.steps.stated_matrices import no_relation_of_matrices
from symbalance.notes.checking.steps.static_values import without_values_at_rest
from symbalance.notes.checking.steps.steps_by_premises import unless_given, with_premises
from symbalance.notes.checking.steps.trial_motions import (
    decide_sum_of_equations,
    decide_trial_motion,
    without_trials,
)
from symbalance.notes.checking.steps.usual_ranges import is_usual_range
from symbalance.notes.checking.steps.values_at_places import value_at_named_place
from symbalance.notes.checking.units.conversions import decide_conversion
from symbalance.notes.checking.units.numbers_in_units import decide_after_units_left_out
from symbalance.notes.checking.units.printed_units import decide_by_printed_units
from symbalance.notes.checking.units.speeds_as_numbers import put_in_for_angular_speed, wrong_as_quantity
from symbalance.notes.checking.units.temperatures import decide_temperature
from symbalance.notes.checking.units.units_above import refuted_by_units_above
from symbalance.notes.checking.verdicts import (
    CONDITION,
    CONTRADICTION,
    DEFINITION,
    PREMISE,
    RANGE,
    REFUTED,
    STATED,
    UNDECIDED,
    Verdict,
)
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.reading.equations import Chain, Relation, Side
from symbalance.notes.reading.formulas.result_units import without_unit_of_result
from symbalance.text import lazy_patterns as re

FOLLOWS = "follows from the side before, which is refuted"
FROM_SOUND = "equal to what the chain begins with, but not to the side before, which is refuted"
"""Of a side that is right behind a wrong one, 3·4 = 13 = 12: the slip is blamed once, and said here."""
NEAR_NUMBER = 3
"""Lines below a formula in which the number of its letter goes with it."""
MOST_BESIDE = 4
"""Relations below an equation of motion among which the other equations of its system stand."""
NEAR_RANGE = 60
"""Characters between a range and an inequality that is said to follow from it."""


def judge_relation(
    state: JudgingState, chain: Chain, k: int, sound: int, bad: bool, knowledge: Knowledge
) -> Verdict | Decision:
    """Return the verdict on the k-th relation of a chain, or the decision that it only describes."""
    relation = chain.relations[k]
    left, right = chain.sides[k], chain.sides[k + 1]
    if relation.sign == PROPORTIONAL:
        return decide_proportional(state, chain, k, knowledge)
    of_matrices = is_of_matrices(left.node, right.node, knowledge)
    unjudged = decide_products_of_vectors(chain, k, state.document, knowledge)
    if (
        of_matrices
        and not unjudged
        and (fault := no_relation_of_matrices(relation.sign, left, right, knowledge))
    ):
        return Decision(UNDECIDED, fault)
    if relation.sign in PLAIN or relation.sign in SATISFIED_BY:
        return _judge_inequality(state, chain, k, knowledge)
    is_equality = relation.sign == "=" and not of_matrices
    if is_equality and (name := _meant_as_number(left.node, right.node, knowledge)):
        reason = f"true of the number {name}; here {name} is declared as a letter"
        return Decision(UNDECIDED, reason)
    kinds = (_by_rows_of_motion,) if of_matrices else (_by_fourier, _by_motion) if is_equality else ()
    for by_kind in kinds if unjudged is None else ():
        if (decision := by_kind(state, chain, k, knowledge)) is not None:
            return decision
    return unjudged or _judge_equality(state, chain, k, sound, bad, knowledge)


def _judge_inequality(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision:
    """Return the decision on <, >, ≤, ≥, ≠, ≪ or ≫."""
    if chain.relations[k].sign in PLAIN:
        decision = decide_much_larger(chain, k, knowledge)
        if decision.status == RANGE:
            state.much_larger.append(chain)
            if isinstance(chain.sides[k + 1].node, Number):  # η ≫ 1 is at least η > 1
                relations = list(chain.relations)
                relations[k] = replace(relations[k], sign=PLAIN[relations[k].sign])
                state.definitions.note_range(replace(chain, relations=tuple(relations)), k, decision)
        return decision
    if case_of_a_letter(state, chain, k, knowledge):
        return Decision(RANGE, "a case, whatever value the letter has above")
    if (listed := case_of_listed_values(state.document, chain)) is not None:
        return listed
    decision = decide_inequality(chain, k, knowledge)
    if decision.status == CONTRADICTION and leave_range_of_case(state, chain):
        knowledge = replace(knowledge, ranges=tuple(state.definitions.ranges_at(chain.lines[0])))
        decision = decide_inequality(chain, k, knowledge)
    if decision.status == REFUTED and is_usual_range(state, chain, k, knowledge):
        return Decision(RANGE, "what is usual, whatever the value is here")
    if decision.status != RANGE and (run := case_of_run(state.document, chain)) is not None:
        return run
    near = ranges_near(state.document, chain)
    decision = decide_claimed(chain, k, decision, state.general, near, knowledge)
    by_formula = _letters_behind_result(state, chain, k, knowledge)
    letters = by_formula or _bounded_before(state, chain)
    if decision.status == RANGE and letters:
        others = frozenset[str]() if by_formula else _letters_not_before(state, chain)
        positive = sorted(knowledge.meaning.positive & chain.letters) if others else ()
        signs = [StatedRange(Name(n), ">", Number(Fraction(0)), chain.lines[0]) for n in positive]
        claimed = decide_claimed(chain, k, decision, letters, (*near, *signs), knowledge)
        if claimed.status == REFUTED and others:
            shown = ", ".join(sorted(map(plain_letter, others)))
            reason = f"does not follow from the range before it for every {shown}"
            decision = Decision(UNDECIDED, reason)
        elif claimed.status == REFUTED and (
            by_formula or not _holds_of_sizes(chain, k, letters, near, knowledge)
        ):
            decision = replace(
                claimed,
                reason=claimed.reason if by_formula else "does not follow from the range before it",
            )
    state.definitions.note_range(chain, k, decision)
    return decision


def _bounded_before(state: JudgingState, chain: Chain) -> frozenset[str]:
    """Return the letters of an inequality that words draw from a range of the same letters before it.

    From -1 ≤ cos θ ≤ 1 it does not follow that -2 ≤ 3 cos θ ≤ 2.
    """
    if not state.sections.is_consequence(chain) or state.sections.opens_case(chain):
        return frozenset()
    last = max((c for c in state.document.chains if c.end <= chain.start), key=_end_of, default=None)
    is_range = last is not None and all(relation.sign in SATISFIED_BY for relation in last.relations)
    if last is None or not is_range or not last.relations:
        return frozenset()
    if not chain.letters <= last.letters:  # from x < y it does not follow that x z < y z
        is_near = chain.start - last.end <= NEAR_RANGE
        return chain.letters if is_near and last.letters < chain.letters else frozenset()
    has_waves = any(isinstance(part, Call) for side in chain.sides for part in walk(side.node))
    if not has_waves and all(isinstance(s.node, Name) or not names(s.node) for s in last.sides):
        return frozenset()  # of lone letters: judged as a range that follows
    return chain.letters if chain.start - last.end <= NEAR_RANGE else frozenset()


def _letters_not_before(state: JudgingState, chain: Chain) -> frozenset[str]:
    """Return the letters of a conclusion that the relation before it lacks."""
    last = state.sections.chain_before(chain.start)
    return frozenset() if last is None else frozenset(chain.letters - last.letters)


def _letters_behind_result(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> frozenset[str]:
    """Return the letters of a formula from which words draw a conclusion: y = x² + 1, so y > 0."""
    lone = [side.node for side in chain.sides[k : k + 2] if isinstance(side.node, Name)]
    is_of_number = any(not names(side.node) for side in chain.sides[k : k + 2])
    definition = knowledge.definitions.get(lone[0].name) if len(lone) == 1 and is_of_number else None
    if definition is None or not state.sections.is_consequence(chain) or state.sections.opens_case(chain):
        return frozenset()
    return frozenset(names(definition.node))


def _end_of(chain: Chain) -> int:
    return chain.end


def _judge_equality(
    state: JudgingState, chain: Chain, k: int, sound: int, bad: bool, knowledge: Knowledge
) -> Verdict | Decision:
    """Return the verdict on a relation = or ≈: a definition, a step, or something given."""
    if isinstance(chain.sides[k].node, Summation):
        of_engine = state.named_orders.judge(chain, k, knowledge, state.cranks_of)
        if of_engine is not None and not _is_left_open(of_engine):
            return of_engine
    definition = decide_temperature(chain, k, state.document) or _demanded(chain.relations[k])
    definition = definition or _denied(state, chain)
    definition = definition or _for_values(state, chain, k, knowledge)
    definition = definition or refute_named_rate(state, chain, k, knowledge)
    definition = definition or judge_derivative_of_above(state, chain, k, knowledge)
    definition = definition or as_balance_solution(state, chain, k)
    definition = definition or as_equation_for_angle(state, chain, k, knowledge)
    definition = definition or as_zero_of_derivative(state, chain, k, knowledge)
    definition = definition or as_new_extreme(state, chain, k, knowledge)
    definition = definition or as_proved_solution(state, chain, k)
    definition = definition or as_named_root(state, chain, k, knowledge)
    definition = definition or as_one_solution(state, chain, k)
    definition = definition or decide_solved_wave(state, chain, k, knowledge)
    definition = definition or value_at_named_place(state, chain, k, knowledge)
    definition = definition or _define(state, chain, k, knowledge)
    definition = definition or as_angle_solved(state, chain, k)
    definition = definition or decide_for_values(state.document, chain, k, knowledge)
    wrong = None if k else state.wrong_angles.get(chain.sides[0].span[0])
    definition = wrong or definition
    if definition is not None:
        return _as_meant(state, chain, k, definition, knowledge)
    return _slip_of_units(state, chain, k, knowledge) or _judge_step(
        state, chain, k, sound, bad, knowledge
    )


def _judge_step(
    state: JudgingState, chain: Chain, k: int, sound: int, bad: bool, knowledge: Knowledge
) -> Verdict | Decision:
    """Return the verdict on a relation that is no definition, as a step or as what is given."""
    left, right = chain.sides[k], chain.sides[k + 1]
    decision, against = _decide_step(state, chain, k, sound, bad, knowledge)
    decision = _with_signs(state, chain, k, decision, knowledge)
    by_special = decide_with_gravity(chain, k, decision, state.document.text, knowledge)
    by_special = by_special or decide_where_larger(state, chain, k, decision, knowledge)
    decision = by_special or decision
    is_settled = by_special is not None or is_of_another_size(left.node, right.node, decision)
    if by_special is not None and by_special.status == REFUTED:  # by the number that a letter was printed
        by_results = state.results.decide(chain, k, knowledge, state.definitions.given_anew)
        decision = by_results if by_results is not None and by_results.is_proved else decision
    if decision.status in (REFUTED, UNDECIDED) and not is_settled:
        below = None if k else solution_below(state.sections, chain, knowledge)
        solved = None if below is None else at_dead_centre(state, chain, k, knowledge)
        solved = solved or _by_mean(state, chain, k, knowledge)
        solved = solved or as_solved(state, chain, below, knowledge)
        refuted = replace(decision, status=REFUTED)
        decision = solved or unless_given(state, chain, k, against, decision, knowledge)

        def by_premises(first: Side, second: Side, _: Decision, known: Knowledge) -> Decision:
            return with_premises(state, first, second, "=", refuted, known)[0]

        text = state.document.text
        decision = decide_with_gravity(chain, k, decision, text, knowledge, by_premises) or decision
    if decision.status in STATED:
        by_words = value_at_dead_centre(state, chain, k, knowledge)
        by_words = by_words or decide_two_discs(chain, k, state.document)
        by_words = by_words or decide_round_ratio(chain, k, state.document)
        by_words = by_words or decide_half_of_a_swing(state.engine_resultants, chain, k, knowledge)
        by_words = by_words or _moment_by_name(state, chain, k, knowledge)
        by_words = by_words or _by_named_inverse(state, chain, k, knowledge)
        by_words = by_words or _as_named_anew(state, chain, k, knowledge)
        by_words = by_words or state.crank_motions.judge(chain, k, knowledge)
        return _unless_left_open(by_words, decision)
    if decision.status == CONTRADICTION:
        return decision
    if not is_settled:
        decision = appeal(state, chain, k, against, decision, knowledge)
    if decision.is_proved:
        by_units = wrong_as_quantity(chain, k, state.document, knowledge)
        by_units = by_units or refuted_by_units_above(
            chain, k, state.document, knowledge, state.refuted, is_behind_wrong=bad
        )
        if by_units is not None:
            return by_units
    by_name = _by_names(state, chain, k, decision, knowledge, is_special=by_special is not None)
    if by_name is not None and not _is_left_open(by_name):
        return by_name
    decision = _unless_by_form(state, chain, k, decision)
    verdict = describe(state.document, chain, k, decision)
    verdict = add_fix_of_relation(state, verdict, chain, k, against, decision, knowledge)
    verdict = note_other_case(state, chain, k, verdict, against, decision, knowledge)
    return _settled_by_name(state, chain, k, verdict, knowledge)


def _by_names(
    state: JudgingState,
    chain: Chain,
    k: int,
    decision: Decision,
    knowledge: Knowledge,
    *,
    is_special: bool,
) -> Verdict | Decision | None:
    """Return the verdict on a step by what its words and letters name, None where they name nothing."""
    by_name: Verdict | Decision | None = None
    if decision.is_proved:
        by_name = refute_repeated_interval(state.engine_resultants.claims, chain, k)
    by_name = by_name or _as_named_engine(state, chain, k, decision, knowledge)
    by_name = by_name or state.named.of_another(chain, k, knowledge)
    if by_name is None and decision.status in (REFUTED, UNDECIDED):
        by_name = _by_words_of_motion(state, chain, k, decision, knowledge)
    if by_name is None and decision.status == UNDECIDED:
        by_name = _as_anything_named(state, chain, k, knowledge)
    if by_name is None and decision.status == REFUTED and not is_special:
        by_name = _as_another_named(state, chain, k, knowledge)
    return by_name


def _settled_by_name(
    state: JudgingState, chain: Chain, k: int, verdict: Verdict, knowledge: Knowledge
) -> Verdict | Decision:
    """Return the verdict on what is at odds with lines above: by what its words name, if they do."""
    if verdict.decision is None or not verdict.decision.at_odds:
        return verdict
    by_name = _as_anything_named(state, chain, k, knowledge)
    return verdict if by_name is None or _is_left_open(by_name) else by_name


def _by_words_of_motion(
    state: JudgingState, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
) -> Verdict | Decision | None:
    """Return the verdict on what is no step by the motion that its words name, None if that is open."""
    largest = decide_declared_extreme(state.meant, chain, k, knowledge)
    by_motion = state.crank_motions
    again = by_motion.again if decision.status == REFUTED else by_motion.judge
    by_name = largest or again(chain, k, knowledge)
    return None if by_name is not None and _is_left_open(by_name) else by_name


def _as_anything_named(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Verdict | Decision | None:
    """Return the verdict on what words, letters or patterns name: engines, quantities, series."""
    by_name = state.engine_resultants.judge(chain, k, knowledge)
    by_name = by_name or state.named.judge(chain, k, knowledge)
    by_name = by_name or state.patterns.judge(chain, k, knowledge)
    by_name = by_name or state.bank_resultants.judge(chain, k, knowledge)
    return by_name or state.dead_centre_sizes.refute(chain, k, knowledge)


def _unless_by_form(state: JudgingState, chain: Chain, k: int, decision: Decision) -> Decision:
    """Return a decision, left open where it only says that a line above should be another by its form."""
    left, right = chain.sides[k].node, chain.sides[k + 1].node
    first = state.named.forms.refuted.get(left.name) if isinstance(left, Name) and not k else None
    is_of_form = first is not None and first < chain.start
    if not is_of_form or decision.status != REFUTED or not names(right):
        return decision
    reason = "at odds with what a line above should be by its form: another case, or wrong"
    return Decision(UNDECIDED, reason)


def _moment_by_name(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Verdict | Decision | None:
    """Return the verdict on a mass times its arm that words name, m_A r_A = λ m r/2; None for others.

    Nothing follows from one that is refuted.
    """
    left = chain.sides[k].node
    outcome = state.named.judge(chain, k, knowledge) if isinstance(left, Product) else None
    status = "" if outcome is None else getattr(outcome, "status", "") or getattr(outcome, "verdict", "")
    if status == REFUTED:
        for name in names(left):
            state.definitions.lapse(name)
    return outcome


def _as_another_named(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the proof that a letter's new formula is the standard one of what its own words name.

    A line above has another formula for it, of another shape or hypothesis: solid and hollow, Mises and
    Tresca.
    """
    outcome = state.named.judge(chain, k, knowledge)
    is_proved = isinstance(outcome, Decision) and outcome.is_proved
    return outcome if is_proved and isinstance(outcome, Decision) else None


def _by_named_inverse(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Verdict | Decision | None:
    """Return the verdict on ω² = …, 1/c = … or i n = 60 f by the quantity that words name.

    Nothing rests on a wrong one.
    """
    name = head_of(chain.sides[k].node)
    if k or isinstance(chain.sides[0].node, Name):
        return None
    outcome = state.named.judge(chain, k, knowledge)
    if isinstance(outcome, Verdict) and outcome.verdict == REFUTED:
        if name is not None:
            state.definitions.lapse(name)
        for letter in (
            () if name is not None else (*names(chain.sides[0].node), *names(chain.sides[1].node))
        ):
            state.definitions.forget_line(letter, chain.lines[0])
    return outcome


def _as_named_anew(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Verdict | Decision | None:
    """Return the verdict on a letter's further formula by the quantity that words name: disc, then rim.

    Such a formula may be what fixes another letter in it, R of J = m R²/2; a wrong one fixes none.
    """
    left = chain.sides[0].node
    if k or not isinstance(left, Name):
        return None
    outcome = state.named.judge(chain, k, knowledge)
    if isinstance(outcome, Verdict) and outcome.verdict == REFUTED:
        state.definitions.forget_line(left.name, chain.lines[0])
        state.definitions.lapse(left.name)
        return _remembered(state, chain, left, outcome, knowledge)
    return outcome


def _by_mean(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the proof of a relation by a mean value; a letter solved for goes on in its letters."""
    decision, head = decide_by_mean(chain, k, knowledge), chain.sides[k].node
    if decision is not None and not k and isinstance(head, Name):
        earlier = knowledge.definitions.get(head.name)
        if earlier is not None and earlier.solved:
            state.definitions.define(head.name, chain.sides[1].node, chain)
    return decision


def _holds_of_sizes(
    chain: Chain,
    k: int,
    letters: frozenset[str],
    near: Sequence[StatedRange],
    knowledge: Knowledge,
) -> bool:
    """Tell whether a range follows where all its letters, several, are positive, though nobody says so.

    T/d² ≤ s gives d ≥ √(T/s) of a shaft; of x alone the negative numbers count.
    """
    if len(chain.letters) <= 1:
        return False
    above = [
        StatedRange(Name(n), ">", Number(Fraction(0)), chain.lines[0]) for n in sorted(chain.letters)
    ]
    stated = Decision(RANGE)
    return decide_claimed(chain, k, stated, letters, (*near, *above), knowledge).status != REFUTED


def _slip_of_units(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the refutation of a datum converted wrongly, or of a speed per minute as an angular one."""
    converted = decide_conversion(chain, k, state.document)
    if converted is not None and converted.status == REFUTED:
        return converted
    return put_in_for_angular_speed(chain, k, knowledge, state.speeds)


def _meant_as_number(left: Formula, right: Formula, knowledge: Knowledge) -> str:
    """Return the declared letters among e, i, π that have to be those numbers for a relation to be true.

    One of them that is set to a number is given its value: e = 2.718.
    """
    own = [n for n in ("e", "i", "pi") if n in knowledge.letters and n in names(left) | names(right)]
    if not own or (isinstance(left, Name) and isinstance(right, Number)):
        return ""
    for chosen in [*([name] for name in own), own]:
        first, second = left, right
        for name in chosen:
            first, second = (substitute(node, name, Constant(name)) for node in (first, second))
        if decide_equality(first, second, knowledge).is_proved:
            is_letter = decide_equality(left, right, knowledge).is_proved
            return "" if is_letter else ", ".join(plain_text(Constant(n)) for n in chosen)
    return ""


def _by_rows_of_motion(
    state: JudgingState, chain: Chain, k: int, knowledge: Knowledge
) -> Decision | None:
    """Return that a relation of matrices is an equation of motion; None for others."""
    rows = rows_of_motion(chain, k, _differentiated(state, knowledge), knowledge)
    state.equations_of_motion += rows
    return Decision(CONDITION, "equation of motion") if rows else None


def _by_fourier(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a Fourier series without end, or on one of its coefficients."""
    if not state.has_sums:
        return None
    series = as_fourier_series(chain, k, state.fourier_series, knowledge)
    return series or decide_fourier(chain, k, state.fourier_series, knowledge)


def _differentiated(state: JudgingState, knowledge: Knowledge) -> set[str]:
    """Return the letters that the page differentiates by the time."""
    time = knowledge.crank.time if knowledge.crank else "t"
    return {each.name for each in state.motions.differentiated if each.variable == time}


def _by_motion(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the decision on an equation of motion, or on a natural frequency; None for others."""
    moving = without_values_at_rest(state, chain, k, without_trials(state, knowledge))
    equation = equation_of_motion(chain, k, _differentiated(state, moving), moving)
    above = state.equations_of_motion
    if equation is None:
        here = [e for e in above if state.sections.same_section(e.line, chain.lines[0])]
        leading = state.sections.sentence_leading_to(chain) if here else ""
        by_difference = decide_relative_motion(
            chain, k, _differentiated(state, moving), here, leading, moving
        )
        if by_difference is not None:
            return by_difference
        by_trial = decide_trial_motion(state, chain, k, here, knowledge)
        if by_trial is not None:
            return by_trial
        by_motion = decide_natural_frequency(chain, k, here, knowledge)
        head = chain.sides[0].node
        words = f"{leading} {state.sections.sentence_before(chain)}" if here else ""
        by_motion = by_motion or decide_motion_solution(chain, k, here, words, knowledge)
        if by_motion is not None and by_motion.is_proved and isinstance(head, Name):
            state.definitions.define(head.name, chain.sides[1].node, chain)
        return by_motion
    last = above[-1].line if above else 0
    follows = bool(above) and state.sections.stands_next(chain, last)
    follows = follows and state.sections.follows_at_once(chain)
    by_sum = decide_sum_of_equations(state, chain, equation, above)
    if by_sum is not None:
        return by_sum  # no equation of its own
    wrong = against_reaction(equation, _equations_beside(state, chain, moving))
    if wrong is not None:
        above.append(wrong[1])
        return wrong[0]
    decision = decide_motion(equation, above, knowledge, follows=follows)
    above.append(equation)
    if decision.status == CONDITION and equation.lone_rate is not None:
        state.definitions.fix(Constraint(*equation.lone_rate), chain)
    return decision


def _equations_beside(state: JudgingState, chain: Chain, knowledge: Knowledge) -> list[EquationOfMotion]:
    """Return the equations of motion above a relation in its section, and those right below it."""
    line, differentiated = chain.lines[0], _differentiated(state, knowledge)
    above = [e for e in state.equations_of_motion if state.sections.same_section(e.line, line)]
    below = [c for c in state.document.chains if c.start > chain.start][:MOST_BESIDE]
    here = [c for c in below if state.sections.same_section(c.lines[0], line)]
    read = [equation_of_motion(each, 0, differentiated, knowledge) for each in here if each.relations]
    return [*reversed(above), *(each for each in read if each is not None)]


def _for_values(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a relation said for listed values, which is no equation to be solved.

    One that does not hold may be an equation all the same, if other letters stand in it.
    """
    decision = decide_for_values(state.document, chain, k, knowledge)
    is_of_one = len(chain.letters) == 1
    return decision if decision is not None and (decision.is_proved or is_of_one) else None


def _demanded(relation: Relation) -> Decision | None:
    """Return that a relation with an exclamation mark above only demands something."""
    return Decision(CONDITION, "demanded, to be solved") if relation.is_demanded else None


def _denied(state: JudgingState, chain: Chain) -> Decision | None:
    """Return that a relation is a condition: by the words below it fails, or something else takes it."""
    is_one = len(chain.relations) == 1 and chain.relations[0].sign == "="
    if not is_one or not (names(chain.sides[0].node) and names(chain.sides[1].node)):
        return None
    if state.sections.is_only_if(chain):
        return Decision(CONDITION, "what something else takes, by the words before it")
    return Decision(CONDITION, "said to fail") if state.sections.is_said_to_fail(chain) else None


def _define(state: JudgingState, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Return the decision on a relation that gives a letter its value; None for other relations.

    A number that equations above give is judged by them; nothing rests on one that is wrong.
    """
    values = {name: list(entries) for name, entries in state.definitions.values.items()}
    premises = list(state.definitions.premises)
    definition = define_letter(state.definitions, chain, k, knowledge)
    pair, line, sections = number_given(chain, k), chain.lines[0], state.sections
    head = chain.sides[0].node
    if not k and definition is not None and (by_words := mean_piston_speed(state, chain)) is not None:
        return by_words
    if not k and definition is not None and definition.status in STATED and isinstance(head, Name):
        by_speed = decide_speed(head.name, chain.sides[1].node, state.speeds, knowledge)
        if by_speed is not None and chain.relations[0].sign == "=":
            return by_speed
    is_given = definition is not None and definition.status in (PREMISE, DEFINITION)
    is_given = is_given and not (definition and definition.reason.startswith(MEASURED))
    if pair is None or not is_given or sections.opens_case(chain):
        return definition
    first, is_known = sections.paragraph_start(line), pair[0] in knowledge.meaning.values
    by_given = state.given_numbers.decide(*pair, line, first, knowledge, of_it_alone=is_known)
    bare = without_unit_of_result(chain.sides[1])
    if by_given is not None and by_given.status == REFUTED and bare is not pair[1]:
        # M = 8250·0.042 is right, and the kN m that it was read in, by the result behind it, wrong
        as_typed = state.given_numbers.decide(pair[0], bare, line, first, knowledge)
        by_given = as_typed if as_typed is not None and as_typed.is_proved else by_given
        state.definitions.values, state.definitions.premises = values, premises
    elif by_given is not None and by_given.status == REFUTED:
        state.definitions.values, state.definitions.premises = values, premises
    return by_given or definition


def _as_meant(
    state: JudgingState, chain: Chain, k: int, definition: Decision, knowledge: Knowledge
) -> Verdict | Decision:
    """Return the verdict on a definition, by the quantity that its letter is known to mean.

    One that is wrong by a slip is mended for the lines that follow.
    """
    outcome: Verdict | Decision | None = _as_named_engine(state, chain, k, definition, knowledge)
    if definition.is_proved:
        outcome = refute_repeated_interval(state.engine_resultants.claims, chain, k)
    if definition.status in (DEFINITION, PREMISE):
        outcome = decide_half_of_a_swing(state.engine_resultants, chain, k, knowledge)
        outcome = outcome or state.engine_resultants.judge(chain, k, knowledge)
        outcome = outcome or decide_firing_interval(state.engine_resultants.claims, chain, k)
        outcome = outcome or decide_order_frequency(state.engine_resultants.claims, chain, k)
        outcome = outcome or refute_lever_arm(state.engine_resultants.claims, chain, k)
        outcome = outcome or state.cylinder_forces.judge(chain, k)
    if outcome is None and definition.status == DEFINITION:
        outcome = state.meant.judge(chain, k, knowledge)
    elif outcome is None:
        outcome = state.meant.again(chain, k, knowledge)
    if outcome is None and definition.status in STATED:
        outcome = value_at_dead_centre(state, chain, k, knowledge)
    if outcome is None and definition.status in (DEFINITION, PREMISE):
        outcome = state.named_orders.judge(chain, k, knowledge, state.cranks_of)
        outcome = outcome or decide_parallel_axes(chain, k, state.document)
        outcome = outcome or state.named.judge(chain, k, knowledge)
        outcome = outcome or state.named_numbers.judge(chain, k, knowledge)
        outcome = outcome or state.unbalances.judge(chain, k, knowledge)
        outcome = outcome or state.harmonics.judge(chain, k, knowledge)
        outcome = outcome or decide_two_discs(chain, k, state.document)
        outcome = outcome or decide_order_speed(chain, k, state.document, knowledge)
        outcome = outcome or state.crank_motions.judge(chain, k, knowledge)
        outcome = outcome or state.patterns.judge(chain, k, knowledge)
        outcome = outcome or state.bank_resultants.judge(chain, k, knowledge)
        outcome = outcome or state.dead_centre_sizes.refute(chain, k, knowledge)
        outcome = outcome or state.formulas_beside.judge(chain, k, knowledge)
        outcome = outcome or state.parity.judge(chain, k)
        outcome = outcome or state.meant.refute_by_usual_units(chain, k, knowledge)
        if outcome is not None and _is_left_open(outcome):
            return _unless_left_open(outcome, definition)
    if isinstance(outcome, Verdict) and outcome.verdict == UNDECIDED:
        by_motion = state.crank_motions.judge(chain, k, knowledge)
        by_motion = by_motion or state.patterns.judge(chain, k, knowledge)
        outcome = outcome if by_motion is None or _is_left_open(by_motion) else by_motion
    name = chain.sides[k].node
    outcome = _remembered(state, chain, name, outcome, knowledge) if isinstance(name, Name) else outcome
    return outcome or definition


def _remembered(
    state: JudgingState,
    chain: Chain,
    name: Name,
    outcome: Verdict | Decision | None,
    knowledge: Knowledge,
) -> Verdict | Decision | None:
    """Return the outcome on what a line says a letter is, and note what the letter is for later lines."""
    if isinstance(outcome, Verdict) and outcome.fix is not None:
        if _has_other_number_behind(state, chain, outcome.fix.node, knowledge):
            state.definitions.forget(name.name, chain.lines[0])  # the number goes with the wrong formula
        else:
            state.definitions.mend(name.name, outcome.fix.node, chain)
        outcome = outcome if state.corrects else replace(outcome, fix=None)
    elif isinstance(outcome, Decision) and outcome.status == REFUTED:
        state.definitions.forget(name.name, chain.lines[0])
    elif isinstance(outcome, Decision) and outcome.reason == MEANT_ROUGHLY:
        state.definitions.mark_as_rough(name.name, chain.lines[0])
    return outcome


def _has_other_number_behind(
    state: JudgingState, chain: Chain, mended: Formula, knowledge: Knowledge
) -> bool:
    """Tell whether a letter has a number on its line, or just below, that its mended formula lacks."""
    head, line = chain.sides[0].node, chain.lines[0]
    behind = [other for other in state.sections.chains_of(head) if other.start > chain.start]
    numbers = [
        other.sides[-1]
        for other in behind
        if len(other.sides) > 1
        and not names(other.sides[-1].node)
        and other.lines[0] - line <= NEAR_NUMBER
    ]
    left = Side((mended,), chain.sides[0].span)
    sizes = {n for n in names(mended) if not (known := knowledge.definitions.get(n)) or not known.numeric}
    return bool(sizes) and any(not decide(left, number, "≈", knowledge).is_proved for number in numbers)


def _as_named_engine(
    state: JudgingState, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
) -> Decision | None:
    """Return the proof of a formula that is at odds with another line by what words name; or None."""
    if k or decision.status not in (REFUTED, CONTRADICTION):
        return None
    by_engine = state.engine_resultants.judge(chain, k, knowledge)
    is_proof = isinstance(by_engine, Decision) and by_engine.is_proved
    return by_engine if is_proof and isinstance(by_engine, Decision) else None


def _is_left_open(outcome: Verdict | Decision) -> bool:
    """Tell whether the search for what words name was given up: a definition stays one, and says so."""
    return isinstance(outcome, Decision) and outcome.status == DEFINITION


def _unless_left_open(outcome: Verdict | Decision | None, statement: Decision) -> Verdict | Decision:
    """Return what words make of a statement, or the statement, which says if the search was given up."""
    if outcome is None:
        return statement
    if _is_left_open(outcome) and isinstance(outcome, Decision):
        return replace(statement, reason=outcome.reason)
    return outcome


def _decide_step(
    state: JudgingState, chain: Chain, k: int, sound: int, bad: bool, knowledge: Knowledge
) -> tuple[Decision, Side]:
    """Return the decision on a relation as a step, and the side its right one is compared with."""
    sign, left, right = chain.relations[k].sign, chain.sides[k], chain.sides[k + 1]
    decision, against = decide(left, right, sign, knowledge), left
    is_wrong_itself = decision.status == REFUTED
    result = None
    if not names(left.node):
        result = decide_after_units_left_out(chain, k, state.document, knowledge)
    if result is not None:
        return result, chain.sides[k - 1]
    if not names(left.node):
        decision = decide_by_printed_units(chain, k, state.document, knowledge) or decision
    if bad and not decision.is_proved and decision.status == REFUTED and names(left.node):
        by_premises, _ = with_premises(state, left, right, sign, decision, knowledge)
        decision = by_premises if by_premises.is_proved else decision  # W = 567 J is p V above
    if bad and not decision.is_proved:
        from_sound = decide(chain.sides[sound], right, sign, knowledge)
        if from_sound.is_proved or decision.status == REFUTED:
            decision, against = from_sound, chain.sides[sound]
    elif bad:
        decision = replace(decision, reason=FOLLOWS)
    head = chain.sides[0].node
    has_value = k and isinstance(head, Name) and _is_fixed(head.name, knowledge)
    if has_value and (sign == "≈" or not decision.is_proved):
        # a number behind = is rounded to its digits, and no closer or farther: 2r = 80 mm is no 81 mm
        by_value = sign if not names(right.node) else "≈"
        decision, against = decide(chain.sides[0], right, by_value, knowledge), chain.sides[0]
    if decision.status == REFUTED:
        decision = state.meant.again(chain, k, knowledge) or decision
    if sign == "=" and against is left:
        decision = decide_roughly(left, right, decision, knowledge)
    is_said_already = decision.reason == MEANT_ROUGHLY
    if bad and is_wrong_itself and against is not left and decision.is_proved and not is_said_already:
        decision = replace(decision, reason=FROM_SOUND)
    return decision, against


def _is_fixed(name: str, knowledge: Knowledge) -> bool:
    """Tell whether a letter has its value by its meaning, or as a coefficient of a series."""
    definition = knowledge.definitions.get(name)
    is_coefficient = definition is not None and definition.is_coefficient
    return name in knowledge.meaning.values or is_coefficient


def _with_signs(
    state: JudgingState, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
) -> Decision:
    """Return the decision with the signs that are stated; |x| = x is not so for every x."""
    left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
    if not is_of_matrices(left.node, right.node, knowledge):
        decision = decide_with_signs(left, right, sign, decision, knowledge)
        decision = decide_within_ranges(left, right, decision, knowledge, state.general)
        places = values_behind(chain, state.document)
        decision = decide_where_values(left, right, decision, knowledge, state.general, places)
    if decision.is_proved and (unsigned := letters_without_sign(chain, state.document)):
        plain = [plain_text(Name(name)) for name in sorted(unsigned)]
        signs = [t for t in decision.assumptions if t.endswith((" ≥ 0", " ≤ 0", " > 0"))]
        if any(re.search(rf"(?<!\w){re.escape(each)}(?!\w)", text) for each in plain for text in signs):
            reason = f"proved if {signs[0]}, and {plain[0]} is no real number by the words before it"
            return Decision(UNDECIDED, reason)
    apart = {plain_text(Name(name)) for name in state.general}
    least = [text for text in decision.assumptions if text.partition(" ≠ ")[0] in apart and "≠" in text]
    if not least or not decision.is_proved:
        return decision
    if not any(text.endswith(" ≠ 0") for text in least):
        reason = f"said of all values, and proved only if {', '.join(least)}"
        return Decision(UNDECIDED, reason)
    least = [text for text in least if text.endswith(" ≠ 0")]
    reason = f"said of all values, but it holds if {least[0]}"
    return replace(decision, status=REFUTED, assumptions=(), reason=reason)
