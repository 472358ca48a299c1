"""The class `Judge`: goes through a document's equations in order and gives each its verdict."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from itertools import product

from symbalance.budgets import Budget
from symbalance.document.formula import Formula, Name, Number, names
from symbalance.document.letters import plain_letter
from symbalance.errors import SymbalanceError
from symbalance.notes.algebra.letters_behind import letters_with_behind, names_behind
from symbalance.notes.algebra.letters_in_waves import letters_in_waves
from symbalance.notes.checking.deciding.cases import GIVE_IT, NUMBERS_PUT_IN
from symbalance.notes.checking.deciding.congruences import decide_congruence
from symbalance.notes.checking.deciding.descriptions import (
    describe,
    explained_verdict,
    unreadable_verdict,
    with_fault,
)
from symbalance.notes.checking.deciding.equality import PROVED, Decision
from symbalance.notes.checking.deciding.guarded_verdicts import PAGE, Guard
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import NO_VALUES_HERE, decide
from symbalance.notes.checking.deciding.remainders import is_remainder
from symbalance.notes.checking.declared.engines import Sources
from symbalance.notes.checking.declared.sidecar import Binding, Declarations
from symbalance.notes.checking.declared.symbol_roles import role_of
from symbalance.notes.checking.judging.bars_and_means import unless_under_bars
from symbalance.notes.checking.judging.by_own_words import unless_of_other_words
from symbalance.notes.checking.judging.denied_relations import SAID_WRONG, verdict_on_denied
from symbalance.notes.checking.judging.judging_order import chains_in_turn, number_verdicts
from symbalance.notes.checking.judging.labelled_cases import by_own_numbers
from symbalance.notes.checking.judging.lines_at_odds import unless_other_case
from symbalance.notes.checking.judging.numbers_by_label import by_data_of_label, by_datum_behind
from symbalance.notes.checking.judging.numbers_in_sentences import by_numbers_in_sentence
from symbalance.notes.checking.judging.offset_cranks import unless_offset
from symbalance.notes.checking.judging.one_relation import FOLLOWS, judge_relation
from symbalance.notes.checking.judging.units_of_results import blame_unit
from symbalance.notes.checking.judging.unknown_crank_angle import unless_angle_unknown
from symbalance.notes.checking.judging.vectors_and_matrices import unless_of_arrays
from symbalance.notes.checking.judging.worded_cases import by_numbers_spoken_of
from symbalance.notes.checking.meant.given_numbers import number_given, size_given
from symbalance.notes.checking.meant.meant_words import NOBODY
from symbalance.notes.checking.meant.motion_in_time import with_rates_of_rates
from symbalance.notes.checking.meant.offset_dead_centres import decide_offset_dead_centre
from symbalance.notes.checking.meant.ring_or_disc import decide_ring_or_disc
from symbalance.notes.checking.meant.steady_cranks import rate_assumed, with_steady_crank
from symbalance.notes.checking.page import assertions
from symbalance.notes.checking.page.consequences import decide_consequence
from symbalance.notes.checking.page.engine_blocks import EngineBlocks
from symbalance.notes.checking.page.letters_of_sections import numbers_of_this_section
from symbalance.notes.checking.page.own_exercises import OwnExercises
from symbalance.notes.checking.page.own_functions import with_own_functions
from symbalance.notes.checking.page.page_data import data_of
from symbalance.notes.checking.page.quotations import Quotations
from symbalance.notes.checking.page.table_rows import TableRows
from symbalance.notes.checking.premises.another_value import NO_WORDS
from symbalance.notes.checking.premises.carried_values import ONE_IS_WRONG
from symbalance.notes.checking.premises.results_as_cases import NO_RESULT
from symbalance.notes.checking.steps.amplitudes_of_two_parts import unless_of_two_parts
from symbalance.notes.checking.steps.angle_equations import lines_of_angles, unless_solved_for_wave
from symbalance.notes.checking.steps.angle_origins import letters_of_every_angle
from symbalance.notes.checking.steps.angular_speeds_by_turns import by_turns_counted
from symbalance.notes.checking.steps.another_angle import leave_angle_above, leave_number_at_angle
from symbalance.notes.checking.steps.another_body import (
    leave_body,
    leave_cycle,
    leave_product_given_anew,
    leave_product_made,
    leave_quotation,
)
from symbalance.notes.checking.steps.another_case import (
    as_case_of_multiple,
    leave_formula_of_opening,
    leave_named_case,
    leave_value_of_case,
)
from symbalance.notes.checking.steps.another_engine import leave_cranks, leave_engine, leave_premises
from symbalance.notes.checking.steps.another_engines_numbers import (
    as_number_in_words,
    as_number_of_another,
    as_supposed,
    leave_products_of_another,
    puts_another_engines_numbers_in,
)
from symbalance.notes.checking.steps.another_factor import (
    fixed_with_another_factor,
    put_in_with_another_factor,
)
from symbalance.notes.checking.steps.another_place import (
    is_multiple_of_angle,
    leave_condition_of_place,
    leave_number_of_place,
    leave_place,
)
from symbalance.notes.checking.steps.another_section import leave_angle_of_section
from symbalance.notes.checking.steps.bare_numbers import unless_of_bare_numbers
from symbalance.notes.checking.steps.both_signs import unless_neither_sign
from symbalance.notes.checking.steps.candidate_solutions import unless_candidate
from symbalance.notes.checking.steps.changing_letters import changing_letters, without_numbers
from symbalance.notes.checking.steps.chosen_sizes import leave_choice
from symbalance.notes.checking.steps.closed_orders import unless_closed
from symbalance.notes.checking.steps.compared_coefficients import unless_of_other_coefficients
from symbalance.notes.checking.steps.components_in_words import unless_another_component
from symbalance.notes.checking.steps.conditions_by_values import unless_condition_fails
from symbalance.notes.checking.steps.conditions_restated import unless_condition_again
from symbalance.notes.checking.steps.consequences_in_words import unless_no_consequence
from symbalance.notes.checking.steps.cosines_of_no_angle import unless_of_no_angle
from symbalance.notes.checking.steps.crank_angle_in_words import at_crank_angle_in_words
from symbalance.notes.checking.steps.data_lists import open_if_datum
from symbalance.notes.checking.steps.derivatives_set_to_zero import leave_extreme
from symbalance.notes.checking.steps.directions_of_motions import unless_against_direction
from symbalance.notes.checking.steps.divided_by_zero import unless_divided_by_zero
from symbalance.notes.checking.steps.ended_cases import (
    leave_ended_cases,
    letters_of_ended,
    turn_to_opposite_range,
    unless_of_ended_case,
)
from symbalance.notes.checking.steps.english_numbers import unless_in_english_units
from symbalance.notes.checking.steps.expanded_determinants import unless_another_polynomial
from symbalance.notes.checking.steps.extremal_values import unless_no_extreme
from symbalance.notes.checking.steps.extremes_by_index import unless_other_extreme
from symbalance.notes.checking.steps.extremes_in_numbers import unless_no_such_value
from symbalance.notes.checking.steps.finer_numbers import unless_finer_by_nothing
from symbalance.notes.checking.steps.fluctuations_by_tolerance import unless_half_fluctuation
from symbalance.notes.checking.steps.forced_motions import unless_no_forced_motion
from symbalance.notes.checking.steps.forces_in_prose import unless_against_forces
from symbalance.notes.checking.steps.formula_one_slip_away import (
    as_multiple_in_words,
    number_of_a_formula_one_slip_away,
)
from symbalance.notes.checking.steps.formulas_below_numbers import unless_it_fixes_letters
from symbalance.notes.checking.steps.formulas_below_rows import unless_at_odds_with_rows
from symbalance.notes.checking.steps.gravity import (
    GRAVITY_UNIT,
    has_unit_of_gravity,
    stands_for_gravity,
)
from symbalance.notes.checking.steps.impossible_ranges import unless_impossible
from symbalance.notes.checking.steps.invariants_in_words import unless_against_what_stays
from symbalance.notes.checking.steps.judging_state import JudgingState
from symbalance.notes.checking.steps.large_by_words import unless_large_by_words
from symbalance.notes.checking.steps.largest_of_waves import unless_plain_sum
from symbalance.notes.checking.steps.letters_below import with_clauses_below
from symbalance.notes.checking.steps.letters_of_two_meanings import unless_of_another_meaning
from symbalance.notes.checking.steps.letters_said_anew import (
    as_formula_of_others,
    leave_formula_of_condition,
    leave_letter_said_anew,
)
from symbalance.notes.checking.steps.letters_said_to_vary import unless_said_to_vary
from symbalance.notes.checking.steps.letters_set_in_motion import leave_letters_at_rest
from symbalance.notes.checking.steps.listed_roots import unless_wrong_in_list
from symbalance.notes.checking.steps.means_of_extremes import unless_mean_of_extremes
from symbalance.notes.checking.steps.named_case_again import return_to_case
from symbalance.notes.checking.steps.named_conditions import unless_named_otherwise
from symbalance.notes.checking.steps.nearest_equation import (
    by_nearest_equation,
    by_nearest_formulas,
    by_number_before,
    by_square_above,
)
from symbalance.notes.checking.steps.nearest_numbers import refuted_by_nearest, with_other_values
from symbalance.notes.checking.steps.needed_sizes import unless_size_fails
from symbalance.notes.checking.steps.numbers_by_formulas import unless_a_formula_gives_it
from symbalance.notes.checking.steps.numbers_of_their_units import unless_of_other_units
from symbalance.notes.checking.steps.numbers_said_again import unless_said_again
from symbalance.notes.checking.steps.only_solutions import unless_not_the_only
from symbalance.notes.checking.steps.open_against_lines import open_against_lines
from symbalance.notes.checking.steps.open_cases import (
    cases_left_by,
    cases_replaced_by,
    end_cases,
    letters_supposed,
    lines_of_numbers,
    past_cases,
    without_cases,
)
from symbalance.notes.checking.steps.orders_at_odds import unless_of_named_order
from symbalance.notes.checking.steps.own_row import by_own_row
from symbalance.notes.checking.steps.percentages import unless_percent_of_it
from symbalance.notes.checking.steps.places_in_words import unless_at_another_place
from symbalance.notes.checking.steps.products_in_prose import unless_other_part_of_product
from symbalance.notes.checking.steps.proportional import SIGN as PROPORTIONAL
from symbalance.notes.checking.steps.quantities_in_prose import unless_converted_from_prose
from symbalance.notes.checking.steps.rates_at_angles import unless_rate_at_angle
from symbalance.notes.checking.steps.rates_in_other_words import with_rates_said_again
from symbalance.notes.checking.steps.rates_of_ratios import unless_rate_of_ratio
from symbalance.notes.checking.steps.rates_with_numbers import (
    with_numbers_of_open_letters,
    with_numbers_of_rates,
)
from symbalance.notes.checking.steps.ratios_by_products_in_words import unless_of_other_product
from symbalance.notes.checking.steps.ratios_given_anew import leave_letters_of_ratio
from symbalance.notes.checking.steps.ratios_of_amplitudes import unless_other_ratio
from symbalance.notes.checking.steps.rearranged_line_before import by_line_before
from symbalance.notes.checking.steps.repeated_formulas import unless_repeated
from symbalance.notes.checking.steps.resultants_in_words import unless_perpendicular
from symbalance.notes.checking.steps.results_in_turn import unless_wrong_in_turn
from symbalance.notes.checking.steps.revolutions_by_the_minute import by_the_minute
from symbalance.notes.checking.steps.rival_cases import RivalCases
from symbalance.notes.checking.steps.roots_by_kind import unless_of_another_kind
from symbalance.notes.checking.steps.roots_left_out import with_root_left_out
from symbalance.notes.checking.steps.roots_of_conditions import unless_no_root
from symbalance.notes.checking.steps.roots_of_waves import unless_no_root_of_wave
from symbalance.notes.checking.steps.rough_premises import unless_roughly_known
from symbalance.notes.checking.steps.rough_rod_angles import unless_rough_in_rod_angle
from symbalance.notes.checking.steps.rounded_constants import unless_constant_is_rounded
from symbalance.notes.checking.steps.rounded_pi import unless_with_own_pi
from symbalance.notes.checking.steps.said_for_all import unless_said_for_all
from symbalance.notes.checking.steps.scaled_by_proportion import unless_scaled_against_proportion
from symbalance.notes.checking.steps.scaled_in_words import scaled_in_words
from symbalance.notes.checking.steps.scaled_numbers import unless_scaled_wrongly
from symbalance.notes.checking.steps.scales_of_diagrams import unless_scale
from symbalance.notes.checking.steps.series_out_of_reach import unless_series_out_of_reach
from symbalance.notes.checking.steps.series_relations import judge_series
from symbalance.notes.checking.steps.signs_denied import unless_sign_denied
from symbalance.notes.checking.steps.sizes_in_sentences import with_size_said
from symbalance.notes.checking.steps.sizes_without_letters import with_sizes_in_words
from symbalance.notes.checking.steps.slips_at_places import unless_wrong_at_place
from symbalance.notes.checking.steps.solutions_of_the_first import unless_added_by_squaring
from symbalance.notes.checking.steps.solved_exercises import SolvedExercises
from symbalance.notes.checking.steps.solved_pairs import unless_pair_is_wrong
from symbalance.notes.checking.steps.speeds_by_index import by_speed_of_one_index
from symbalance.notes.checking.steps.speeds_by_two_clocks import unless_by_the_minute
from symbalance.notes.checking.steps.speeds_for_omega import with_omega_of_speed
from symbalance.notes.checking.steps.speeds_in_words import at_speed_in_words
from symbalance.notes.checking.steps.sums_of_phases import unless_phases_remain
from symbalance.notes.checking.steps.sums_of_results import unless_sum_of_results
from symbalance.notes.checking.steps.supposed_in_prose import unless_supposed_otherwise
from symbalance.notes.checking.steps.supposed_numbers import SupposedNumbers
from symbalance.notes.checking.steps.systems_of_formulas import unless_of_a_system
from symbalance.notes.checking.steps.temperatures_in_degrees import unless_in_degrees
from symbalance.notes.checking.steps.trial_exponentials import unless_trial_exponential
from symbalance.notes.checking.steps.truncated_as_named import unless_of_lower_order
from symbalance.notes.checking.steps.turns_upside_down import unless_turns_upside_down
from symbalance.notes.checking.steps.units_in_brackets import unless_units_in_brackets
from symbalance.notes.checking.steps.units_of_roots import decide_root_with_unit
from symbalance.notes.checking.steps.units_said_once import unless_units_said_once
from symbalance.notes.checking.steps.values_at_multiples import unless_at_multiples
from symbalance.notes.checking.steps.values_at_numbers import unless_at_two_numbers
from symbalance.notes.checking.steps.values_at_speeds import by_speed_in_brackets
from symbalance.notes.checking.steps.values_converted import unless_converted_wrongly
from symbalance.notes.checking.steps.values_for_formulas import (
    leave_value_of_formula,
    unless_by_value_of_formula,
)
from symbalance.notes.checking.steps.values_in_rows import unless_wrong_in_row
from symbalance.notes.checking.steps.values_of_equations import unless_value_fails
from symbalance.notes.checking.steps.waves_of_one_angle import unless_of_one_angle
from symbalance.notes.checking.steps.what_stays_the_same import unless_other_things_change
from symbalance.notes.checking.steps.zeros_as_printed import unless_zero_as_printed
from symbalance.notes.checking.steps.zeros_in_cases import unless_false_zero
from symbalance.notes.checking.units.conversions import decide_conversion
from symbalance.notes.checking.units.dimensions import Dimensions, Mismatch, declared_dimension, unit_text
from symbalance.notes.checking.units.formulas_between_numbers import BETWEEN_NUMBERS
from symbalance.notes.checking.units.own_units import with_speeds
from symbalance.notes.checking.units.plain_letters import PlainLetters
from symbalance.notes.checking.units.rates_by_name import rate_dimension, turns_for_radians
from symbalance.notes.checking.units.speeds_as_numbers import without_minutes
from symbalance.notes.checking.units.temperatures import with_temperatures
from symbalance.notes.checking.units.turns_in_radians import with_turns
from symbalance.notes.checking.units.turns_of_results import refute_turns
from symbalance.notes.checking.units.unit_behind_formula import unit_behind_formula
from symbalance.notes.checking.units.unit_by_noun import is_label, unit_asked_for
from symbalance.notes.checking.units.units_for_all import result_in_unit_for_all
from symbalance.notes.checking.verdicts import (
    CONDITION,
    CONDITIONAL,
    CONTRADICTION,
    DECLARE_IT,
    DEFINITION,
    PREMISE,
    PROVED_WORDS,
    REFUTED,
    UNDECIDED,
    Checked,
    Verdict,
)
from symbalance.notes.checking.words.angles_of_time import with_angles_of_time
from symbalance.notes.checking.words.case_words import (
    LONGEST_PLACE,
    has_exception_behind,
    leads_to_claim,
    speaks_of_every,
)
from symbalance.notes.checking.words.columns_as_binomials import with_columns
from symbalance.notes.checking.words.means_under_bars import with_means_under_bars
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.checking.words.terms_of_a_kind import unlike_terms
from symbalance.notes.checking.words.unit_or_letter import with_both_readings
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.notes.reading.markup.unit_macros import with_units_shown
from symbalance.notes.reading.spellings.numerals import with_raised_points_lowered
from symbalance.text import lazy_patterns as re

_Look = Callable[[JudgingState, Chain, int, Verdict], Verdict]
_ONE_BY_ONE: tuple[_Look, ...] = (
    at_crank_angle_in_words,
    with_rates_said_again,
    unless_no_such_value,
    unless_plain_sum,
    unless_other_ratio,
    unless_false_zero,
    unless_zero_as_printed,
    unless_divided_by_zero,
    unless_said_for_all,
    unless_phases_remain,
    unless_of_one_angle,
    unless_condition_fails,
    unless_finer_by_nothing,
)
"""What looks at a verdict again, in turn: by the words, places and values around its relation."""
_LAST: tuple[_Look, ...] = (
    unless_it_fixes_letters,
    unless_said_to_vary,
    unless_of_ended_case,
    unless_no_extreme,
    unless_roughly_known,
    unless_impossible,
    unless_rate_of_ratio,
    unless_no_root,
    unless_of_no_angle,
    unless_candidate,
    unless_wrong_in_list,
    unless_wrong_in_row,
    unless_scaled_against_proportion,
    unless_no_forced_motion,
    unless_another_polynomial,
    unless_of_other_words,
    unless_in_degrees,
    unless_of_lower_order,
    unless_not_the_only,
    unless_added_by_squaring,
    unless_of_another_kind,
    unless_sign_denied,
    unless_of_a_system,
    unless_pair_is_wrong,
    unless_value_fails,
    unless_wrong_in_turn,
    unless_at_odds_with_rows,
    unless_of_arrays,
    unless_under_bars,
    unless_units_said_once,
    unless_large_by_words,
    unless_series_out_of_reach,
    with_root_left_out,
    unless_condition_again,
    by_turns_counted,
    by_speed_of_one_index,
    unless_scale,
    unless_trial_exponential,
    by_line_before,
    unless_other_things_change,
    with_omega_of_speed,
    unless_named_otherwise,
    unless_size_fails,
    unless_other_extreme,
    unless_with_own_pi,
    unless_in_english_units,
    unless_rough_in_rod_angle,
    unless_at_two_numbers,
    by_speed_in_brackets,
    unless_at_multiples,
    unless_constant_is_rounded,
    unless_no_root_of_wave,
    unless_rate_at_angle,
    unless_against_direction,
    unless_of_bare_numbers,
    unless_by_the_minute,
    unless_of_another_meaning,
    unless_percent_of_it,
    unless_by_value_of_formula,
    unless_converted_wrongly,
    unless_converted_from_prose,
    unless_of_other_units,
    unless_no_consequence,
    unless_against_what_stays,
    unless_of_other_coefficients,
    unless_against_forces,
    unless_other_part_of_product,
    unless_at_another_place,
    unless_supposed_otherwise,
    unless_perpendicular,
    unless_another_component,
    unless_of_named_order,
    unless_neither_sign,
    unless_half_fluctuation,
    unless_turns_upside_down,
    unless_units_in_brackets,
    unless_sum_of_results,
    unless_mean_of_extremes,
    unless_of_two_parts,
    unless_of_other_product,
)
"""What does so once a relation has been read in its case and its row."""


@dataclass
class Judge:
    """Judges one document, chain by chain, within its budget."""

    document: ReadNotes
    declarations: Declarations
    sources: Sources = field(default_factory=Sources)
    budget: Budget = PAGE
    corrects: bool = True
    _judged_last: tuple[tuple[int, int], set[int]] = field(default=((-1, 0), set()), init=False)
    """The relation judged last, and what its letters were before it."""
    _of_label: set[tuple[int, int]] = field(default_factory=set, init=False)
    """The relations that are judged by the data of their labels, or have been."""

    def __post_init__(self) -> None:
        symbols_at = self.declarations.symbols_at
        self.document = with_angles_of_time(with_both_readings(self.document, symbols_at))
        self.document = with_columns(with_means_under_bars(self.document))
        self.document = with_own_functions(self.document, self.declarations.symbols)
        text = self.document.text
        shown = with_raised_points_lowered(with_units_shown(text))
        self.document = replace(self.document, text=shown, as_typed=text)
        data = data_of(self.document, symbols_at)
        chains = (*self.document.chains, *data)
        in_kelvins = with_temperatures(replace(self.document, chains=chains))
        every = with_turns(with_speeds(in_kelvins, symbols_at)).chains
        self.document = replace(self.document, chains=every[: len(self.document.chains)])
        self.data = list(every[len(self.document.chains) :])
        """The page's data that stand in tables, lists and code, and have not been reached yet."""
        self.document, motions = with_rates_of_rates(
            self.document, self.declarations, self.sources.engines
        )
        motions = with_steady_crank(self.document, self.declarations, motions)
        self.state = JudgingState(
            self.document, self.declarations, self.sources, self.corrects, motions, tuple(self.data)
        )
        self.blocks = EngineBlocks(self.document.text, self.state.sections)
        self.exercises = OwnExercises(self.document)
        self.table_rows = TableRows(self.document)
        self.rivals = RivalCases(self.document)
        self.solved = SolvedExercises(self.state)
        self.supposed = SupposedNumbers()
        self.places_of_tables: dict[str, Formula] = {}
        """What tables and lists have given letters last: another one gives them another value."""
        self.guard = Guard(self.document, self.budget)
        self.quotations = Quotations(self.document)

    def check(self) -> Checked:
        """Return the document with its verdicts."""
        bindings = assertions.by_line(self.declarations.bindings)
        verdicts: list[Verdict] = [unreadable_verdict(self.document, u) for u in self.document.unreadable]
        verdicts += [explained_verdict(self.document, each) for each in self.document.explained]
        for chain in chains_in_turn(self.document, self.state.sections):
            self._take_data(chain)
            self.blocks.enter(chain.lines[0], self.state.definitions)
            self.exercises.enter(chain.lines[0], self.state.definitions, self.declarations)
            self.state.enter_case(chain.lines[0])
            return_to_case(self.state, chain)
            leave_ended_cases(self.state, chain)
            turn_to_opposite_range(self.state, chain)
            leave_value_of_formula(self.state, chain)
            chain_binds = [b for line in chain.lines for b in bindings.pop(line, [])]
            self.solved.enter(chain)
            self.rivals.enter(self.state, chain)
            self.supposed.enter(self.state, chain)
            verdicts += self.chain(chain, chain_binds)
            self.rivals.leave(self.state, chain)
        for binding in (b for rest in bindings.values() for b in rest):
            if not assertions.name_unreadable(verdicts, self.document, binding):
                missing_equation = partial(assertions.missing_equation, self.document, binding)
                verdicts.append(self.guard.verdict(missing_equation, (0, 0), binding.line))
        for binding in self.declarations.bindings:
            if binding.text:
                verdicts.append(self.guard.verdict(partial(self.piece, binding), (0, 0), binding.line))
        numbered = number_verdicts(verdicts)
        as_typed = replace(self.document, text=self.document.as_typed)
        return Checked(as_typed, tuple(replace(v, cell=self.document.cell_of(v.line)) for v in numbered))

    def _take_data(self, chain: Chain) -> None:
        """Define the letters of the tables, lists and code above a chain; a formula's letter is left."""
        line, start = chain.lines[0], chain.sides[0].span[0]
        while self.data and (
            self.data[0].lines[0] < line
            or (self.data[0].lines[0] == line and self.data[0].sides[-1].span[1] <= start)
        ):
            datum = self.data.pop(0)
            self.exercises.enter(datum.lines[0], self.state.definitions, self.declarations)
            self.state.enter_case(datum.lines[0])
            name = next(iter(names(datum.sides[0].node)))
            earlier = self.state.knowledge(datum.lines[0]).definitions.get(name)
            node = datum.sides[1].node
            if earlier is not None and not earlier.numeric:
                is_of_table = earlier.node == self.places_of_tables.get(name)  # z_1 = 2a, another table
                is_indexed = re.fullmatch(r"[^\W\d]+_\d+", name) is not None
                same_section = self.state.sections.same_section(earlier.line, datum.lines[0])
                if is_of_table or (is_indexed and not same_section):
                    self.state.definitions.define(name, node, datum)
                    self.places_of_tables[name] = node
                continue
            verdicts = self.chain(datum, [])
            self.places_of_tables[name] = node
            if any(v.verdict in (REFUTED, CONTRADICTION, UNDECIDED) for v in verdicts):
                self.state.definitions.define(name, datum.sides[1].node, datum)  # another engine's table

    def piece(self, binding: Binding) -> Verdict:
        """Return the verdict on a piece of a line that is bound to a quantity."""
        span = assertions.span_of(self.document, binding)
        return self.guard.verdict(partial(self._piece, binding), span, binding.line)

    def _piece(self, binding: Binding) -> Verdict:
        knowledge = self.state.knowledge(binding.line, binding.convention)
        names_here = frozenset(self.declarations.symbols_at(binding.line))
        return assertions.piece_verdict(self.document, binding, knowledge, names_here, self.sources)

    def chain(self, chain: Chain, bindings: list[Binding]) -> list[Verdict]:
        """Return the verdicts on a chain's relations in order; none is lost by a fault of the checker."""
        if not bindings and (quoted := self.quotations.verdicts(chain)) is not None:
            return quoted
        verdicts: list[Verdict] = []
        try:
            if not bindings and (denied := verdict_on_denied(self.state, chain)) is not None:
                if denied.verdict == REFUTED and self.quotations.repeats_stated(chain):
                    denied = describe(self.document, chain, 0, Decision(CONDITION, SAID_WRONG))
                return [denied]
            self._judge(chain, bindings, verdicts)
            if not bindings:
                verdicts = self.quotations.without_echoes(chain, verdicts)
            self.quotations.note(chain, verdicts)
        except SymbalanceError:
            raise  # a declaration that cannot be used
        except Exception as problem:
            return with_fault(self.document, chain, verdicts, problem)
        return verdicts

    def _judge(self, chain: Chain, bindings: list[Binding], verdicts: list[Verdict]) -> None:
        """Add the verdicts on a chain's relations, and define its letters."""
        sound, bad = 0, False
        bound = self._bound(chain, bindings)
        if not chain.relations:
            verdicts += [self.assertion(chain, 0, b, None) for b in bound.values()]
            return
        for k, relation in enumerate(chain.relations):
            if k == 0 and 0 in bound:
                verdicts.append(self.assertion(chain, 0, bound[0], None))
            span = chain.sides[k + 1].span
            verdict = self.guard.verdict(partial(self.link, chain, k, sound, bad), span, relation.line)
            if k + 1 in bound:
                is_excused = bad or isinstance(chain.sides[k].node, Name)
                verdict = self.assertion(chain, k + 1, bound[k + 1], verdict, is_excused)
            verdicts.append(verdict)
            self.state.note_verdict(span[0], verdict.verdict)
            self._note_wrong(chain, k, verdict)
            head = chain.sides[0].node
            other = self.state.named.read_otherwise.pop(chain.start, None)
            if other is not None and isinstance(head, Name):
                self.state.definitions.define(head.name, other, chain)
            if k and verdict.reason.endswith(NO_VALUES_HERE) and isinstance(head, Name):
                self.state.definitions.define(head.name, chain.sides[k + 1].node, chain)  # F = Σ F_i = …
            if _puts_numbers_in(chain, k, verdict) and isinstance(head, Name):
                number = chain.sides[k + 1].node
                self.state.definitions.open_numbers[head.name] = number, chain.lines[0]
            if not k and BETWEEN_NUMBERS in verdict.assumption and isinstance(head, Name):
                self.state.definitions.define(head.name, chain.sides[1].node, chain)
            self.state.given_numbers.note(chain, k, verdict)
            if verdict.is_unjudged:
                self.state.not_judged |= dict.fromkeys(_lone_letters(chain, k), relation.line)
            assumed = "; ".join(v.assumption for v in verdicts)
            result = result_in_unit_for_all(chain, k, self.document, assumed)
            is_as_printed = result is chain.sides[k + 1].node and not self.table_rows.has_judged(chain)
            if verdict.verdict in PROVED_WORDS and is_as_printed:
                self.state.results.note(chain, k, self.state.definitions.given_anew)
            if k and verdict.verdict in PROVED_WORDS and isinstance(chain.sides[0].node, Name):
                self.state.definitions.round(chain.sides[0].node.name, chain, result)
            bad = verdict.verdict == REFUTED or (bad and verdict.reason == FOLLOWS)
            if not bad:
                sound = k + 1
        blame_unit(self.state, chain, verdicts)
        self.state.definitions.use(chain)

    def _note_wrong(self, chain: Chain, k: int, verdict: Verdict) -> None:
        """Note a result that is refuted, or at odds with a line that nothing proves."""
        is_at_odds = verdict.verdict == UNDECIDED and verdict.reason.endswith(ONE_IS_WRONG)
        if verdict.verdict == REFUTED or is_at_odds:
            self.state.wrong_numbers.note(chain, k, is_open=is_at_odds)
        if verdict.verdict == REFUTED:
            self.state.definitions.forget_moment(chain.sides[k + 1].node)

    def _bound(self, chain: Chain, bindings: list[Binding]) -> dict[int, Binding]:
        """Return what each side is bound to; two bindings of one are refused: one would go unjudged."""
        bound: dict[int, Binding] = {}
        for binding in (b for b in bindings if not b.text):
            earlier = bound.setdefault(assertions.side_of(self.document, chain, binding), binding)
            if earlier is not binding:
                rule = f"is bound twice, as {earlier.title} and as {binding.title}"
                remedy = "keep one, or bind a piece of the line with text"
                raise SymbalanceError(f"line = {binding.line}", rule, remedy, f"{binding.place}: bind")
        return bound

    def assertion(
        self, chain: Chain, index: int, binding: Binding, step: Verdict | None, is_excused: bool = False
    ) -> Verdict:
        """Return the verdict on a side that is bound to a quantity; `step` is that of its relation.

        `is_excused` tells that the side before is known to be wrong, or only a name.
        """

        def verdict() -> Verdict:
            knowledge = self.state.knowledge(chain.lines[0], binding.convention)
            return assertions.side_verdict(
                self.document, chain, index, binding, knowledge, self.sources, step, is_excused
            )

        line = chain.relations[index - 1].line if index else 0
        return self.guard.verdict(verdict, chain.sides[index].span, line)

    def link(self, chain: Chain, k: int, sound: int, bad: bool) -> Verdict:
        """Return the verdict on the k-th relation of a chain."""
        scaled = scaled_in_words(self.state, chain, k)
        if scaled is None:
            return self._link(chain, k, sound, bad)
        definitions, head = self.state.definitions, next(iter(names(chain.sides[0].node)))
        values, premises = {n: [*own] for n, own in definitions.values.items()}, [*definitions.premises]
        verdict = self._link(chain, k, sound, bad)
        if scaled.status == UNDECIDED and verdict.verdict not in (REFUTED, CONTRADICTION):
            return verdict
        if scaled.status == REFUTED or values.get(head):  # what the letter is above is so again below
            definitions.values, definitions.premises = values, premises
        return verdict if verdict.verdict in PROVED_WORDS else describe(self.document, chain, k, scaled)

    def _link(self, chain: Chain, k: int, sound: int, bad: bool) -> Verdict:
        """Return the verdict on a relation of which no words say that something else is scaled."""
        leave_product_given_anew(self.state, chain, k)
        leave_letter_said_anew(self.state, chain, k)
        leave_letters_of_ratio(self.state, chain, k)
        leave_letters_at_rest(self.state, chain, k)
        verdict = with_size_said(self.state, chain, k, self._link_by_cases(chain, k, sound, bad))
        again = partial(self._link_in_scope, chain, k, k, bad=False)
        verdict = by_own_numbers(self.state, chain, k, verdict, again)
        with_sizes = partial(self._with_sizes, chain, k)
        verdict = by_numbers_spoken_of(self.state, chain, k, verdict, with_sizes)
        verdict = by_numbers_in_sentence(self.state, chain, k, verdict, again)
        verdict = unless_repeated(self.state, chain, k, verdict, again)
        verdict = self._unless_excepted(chain, k, verdict)
        verdict = self._as_one_of_listed(chain, k, verdict)
        verdict = unless_angle_unknown(self.state, chain, k, verdict)
        verdict = unless_offset(self.state, chain, k, verdict)
        verdict = self._unless_between_numbers(chain, k, verdict)
        verdict = unless_other_case(self.state, chain, k, verdict)
        verdict = self._with_numbers_of_rates(chain, k, verdict)
        verdict = self._unless_at_another_value(chain, k, verdict)
        verdict = self._unless_wrong_size(chain, k, verdict)
        verdict = self._unless_of_wrong_result(chain, k, verdict)
        verdict = unless_wrong_at_place(self.state, chain, k, verdict)
        verdict = unless_scaled_wrongly(self.state, chain, k, verdict)
        verdict = unless_a_formula_gives_it(self.state, chain, k, verdict)
        before, verdict = verdict, with_sizes_in_words(self.state, chain, k, verdict)
        if verdict is not before:
            verdict = by_numbers_spoken_of(self.state, chain, k, verdict, with_sizes)
        for look in _ONE_BY_ONE:
            verdict = look(self.state, chain, k, verdict)
        verdict = self._unless_its_own_premise(chain, k, self._of_its_case(chain, k, verdict))
        verdict = unless_solved_for_wave(self.state, chain, k, verdict)
        verdict = by_own_row(self.state, chain, k, verdict)
        verdict = unless_said_again(self.state, chain, k, verdict, again)
        if (chain.start, k) not in self._of_label:
            self._of_label.add((chain.start, k))
            judged_whole = partial(self._link, chain, k, sound, bad)
            verdict = by_datum_behind(self.state, chain, k, verdict, with_sizes)
            verdict = by_data_of_label(self.state, chain, k, verdict, with_sizes, judged_whole)
        if not self.rivals.are_beside(chain):
            verdict = unless_closed(self.state, chain, k, verdict)
        for look in _LAST:
            verdict = look(self.state, chain, k, verdict)
        return self._with_rate_assumed(chain, k, verdict)

    def _with_sizes(self, chain: Chain, k: int) -> Verdict:
        """Return the verdict on a relation by what is in scope and the sizes in the page's words."""
        return with_sizes_in_words(self.state, chain, k, self._link_in_scope(chain, k, k, bad=False))

    def _with_rate_assumed(self, chain: Chain, k: int, verdict: Verdict) -> Verdict:
        """Return a verdict that names the steady turning which it rests on and no line states."""
        is_shown = verdict.verdict in (*PROVED_WORDS, REFUTED)
        if not is_shown or NOBODY in verdict.assumption:
            return verdict
        values = {n: d.node for n, d in self.state.knowledge(chain.lines[0]).definitions.items()}
        sides = (chain.sides[k].node, chain.sides[k + 1].node)
        assumed = rate_assumed(sides, values, self.state.motions)
        if not assumed:
            return verdict
        if verdict.verdict == REFUTED:
            return replace(verdict, reason="; ".join(filter(None, (verdict.reason, f"if {assumed}"))))
        assumption = "; ".join(filter(None, (verdict.assumption, assumed)))
        return replace(verdict, verdict=CONDITIONAL, assumption=assumption)

    def _unless_its_own_premise(self, chain: Chain, k: int, verdict: Verdict) -> Verdict:
        """Return a verdict; what holds on the premise that it states is that premise once more."""
        head = chain.sides[0].node
        if verdict.verdict != CONDITIONAL or k:
            return verdict
        above = self.state.sections.chains_above(head, chain.start)
        if not any(len(c.sides) > 1 and c.sides[1].node == chain.sides[1].node for c in above):
            return verdict
        left, right = (plain_text(side.node) for side in chain.sides[k : k + 2])
        if not {f"{left} = {right}", f"{right} = {left}"} & {*re.split("[;,] ", verdict.assumption)}:
            return verdict
        return describe(self.document, chain, k, Decision(PREMISE, "as above"))

    def _as_one_of_listed(self, chain: Chain, k: int, verdict: Verdict) -> Verdict:
        """Return a verdict; S_1 = S_2 = 0 and k_1 = k_2 = k give each new letter the last."""
        if k + 2 != len(chain.sides):
            return verdict
        heads = [side.node for side in chain.sides[:-1]]
        head, line = chain.sides[k].node, chain.lines[0]
        is_list = all(isinstance(node, Name) for node in heads) and isinstance(
            chain.sides[-1].node, Name | Number
        )
        is_open = verdict.verdict in (REFUTED, UNDECIDED) and is_list and k > 0
        if not is_open or not isinstance(head, Name) or {r.sign for r in chain.relations} != {"="}:
            return verdict
        is_for_lack = not verdict.reason or verdict.reason.endswith(DECLARE_IT)
        if not is_for_lack or self.state.knowledge(line).knows(head.name):
            return verdict
        self.state.definitions.define(head.name, chain.sides[-1].node, chain)
        return describe(self.document, chain, k, Decision(DEFINITION))

    def _unless_wrong_size(self, chain: Chain, k: int, verdict: Verdict) -> Verdict:
        """Return a verdict; a size |K| = 4.98 is judged by what equations above give, as |K|² = 24.8."""
        pair = size_given(chain, k)
        if pair is None or verdict.verdict != CONDITION:
            return verdict
        line = chain.lines[0]
        first, knowledge = self.state.sections.paragraph_start(line), self.state.knowledge(line)
        by_given = self.state.given_numbers.decide(*pair, line, first, knowledge)
        return verdict if by_given is None else describe(self.document, chain, k, by_given)

    def _unless_of_wrong_result(self, chain: Chain, k: int, verdict: Verdict) -> Verdict:
        """Return a verdict; a refuted number may be what a refuted result above gives: no second slip."""
        pair = number_given(chain, k)
        if pair is None or verdict.verdict != REFUTED:
            return verdict
        knowledge = self.state.knowledge(chain.lines[0])
        carried = self.state.given_numbers.goes_on_with(*pair, knowledge)
        return verdict if carried is None else describe(self.document, chain, k, carried)

    def _with_numbers_of_rates(self, chain: Chain, k: int, verdict: Verdict) -> Verdict:
        """Return a verdict; one that is not proved is judged with the numbers that rates have above.

        So is one with the numbers of letters whose formulas have no values. These refute nothing that
        is open for more than the lack of values.
        """
        if verdict.verdict not in (REFUTED, UNDECIDED):
            return verdict
        is_for_lack = verdict.verdict == UNDECIDED and verdict.reason.endswith((GIVE_IT, DECLARE_IT))
        for with_numbers, is_sure in (
            (with_numbers_of_rates, True),
            (with_numbers_of_open_letters, is_for_lack),
        ):
            numbered, words = with_numbers(self.state, chain, k)
            there = self._link_in_scope(numbered, k, k, bad=False) if words else verdict
            if there.verdict in PROVED_WORDS:
                assumption = "; ".join(filter(None, (there.assumption, *words)))
                return replace(there, verdict=CONDITIONAL, assumption=assumption)
            verdict = there if is_sure else verdict
        return verdict

    def _of_its_case(self, chain: Chain, k: int, verdict: Verdict) -> Verdict:
        """Return a verdict; a number that replaces one of the case before is a premise of its case."""
        head = chain.sides[0].node
        if k or verdict.verdict != DEFINITION or not isinstance(head, Name):
            return verdict
        line = self.state.cases.line_replaced(head.name, chain.lines[0])
        if line is None:
            return verdict
        return replace(verdict, verdict=PREMISE, reason=f"a new case: line {line} has that of another")

    def _unless_excepted(self, chain: Chain, k: int, verdict: Verdict) -> Verdict:
        """Return a verdict, undecided where words behind say in which cases the relation fails."""
        is_last = k == len(chain.relations) - 1 and bool(chain.letters)
        if (
            verdict.verdict != REFUTED
            or not is_last
            or not has_exception_behind(self.document.text, chain.end)
        ):
            return verdict
        reason = "the words behind name cases in which it does not hold"
        return describe(self.document, chain, k, Decision(UNDECIDED, reason))

    def _with_numbers_of_minutes(self, chain: Chain, k: int, sound: int, bad: bool) -> Verdict:
        """Return the verdict on a relation; N² = 2.543·10⁸ has the number of revolutions per minute.

        So has d³ = 15.28 the number of the inches that its root d = 2.48 in is given in.
        """
        verdict = self._link_in_scope(chain, k, sound, bad)
        if verdict.verdict in (REFUTED, CONTRADICTION, UNDECIDED):
            known = self.state.knowledge(chain.lines[0])
            of_root = decide_root_with_unit(self.state, chain, k, known)
            if of_root is not None:
                return describe(self.document, chain, k, of_root)
        if verdict.verdict != CONTRADICTION or not (bare := without_minutes(chain, k, self.document)):
            return verdict
        counted = self._link_in_scope(bare, k, sound, bad)
        return verdict if counted.verdict in (REFUTED, CONTRADICTION, UNDECIDED) else counted

    def _link_by_cases(self, chain: Chain, k: int, sound: int, bad: bool) -> Verdict:
        """Return the verdict on the k-th relation of a chain, whatever its letters are declared to be.

        What is said of all values does not rest on a case before, and one case takes another's place.
        """
        angles = (
            self.state.knowledge(chain.lines[0]).angles
            if self.state.definitions.cases
            else frozenset[str]()
        )
        left = cases_left_by(self.state.definitions, chain, angles)
        symbols = self.state.declarations.symbols_at(chain.lines[0])
        turning = {name for name, text in symbols.items() if role_of(text) == "crank angle"}
        values = {n: d.node for n, d in self.state.definitions.at(chain.lines[0]).items()}
        behind = letters_with_behind(chain.letters, values)
        spoken = {name: name in turning for name in turning.union(behind)}
        self.state.general = self.state.sections.spoken_of_generally(chain, spoken, named=True)
        if self._is_of_all_values(chain, k):
            self.state.general |= letters_in_waves(chain.sides[k].node)
        self.state.general |= self._ranges_of_all_values(chain) | letters_of_ended(self.state, chain)
        self.state.general |= self._claimed_always(chain, k)
        self.state.general |= letters_supposed(self.state, chain)
        self.state.general |= letters_of_every_angle(self.state, chain, k)
        if not k and self.state.sections.is_called_identity(chain):
            self.state.general |= chain.letters
        examples = lines_of_numbers(self.state.definitions, self.state.general)
        if left or examples:
            free = frozenset(name for case in left for name in case.letters)
            self.state.general |= free
            lines = examples | {case.line for case in left}
            with without_cases(self.state.definitions, lines, self.state.general):
                verdict = self._link_in_scope(chain, k, sound, bad)
            end_cases(self.state.definitions, left, chain.start)
            return verdict
        verdict = self._with_numbers_of_minutes(chain, k, sound, bad)
        verdict = self._case_of_other_numbers(chain, k, verdict) or verdict
        is_open = verdict.verdict == UNDECIDED and (verdict.reason or "").startswith("with line")
        is_against = verdict.verdict in (REFUTED, CONTRADICTION)
        is_undecided = verdict.verdict == UNDECIDED
        is_for_lack = is_undecided and (verdict.reason or "").endswith(DECLARE_IT)
        if (
            ((is_against or is_open) and leave_cycle(self.state, chain, k))
            or (is_for_lack and leave_engine(self.state, chain, k))
            or ((is_against or is_undecided) and self._leave_quotation(chain, k, is_open=is_for_lack))
            or ((is_against or is_for_lack) and leave_formula_of_opening(self.state, chain, k))
            or ((is_against or is_for_lack) and leave_formula_of_condition(self.state, chain, k))
            or (
                is_against
                and (
                    leave_place(self.state, chain)
                    or leave_number_of_place(self.state, chain, k)
                    or leave_condition_of_place(self.state, chain)
                    or leave_body(self.state, chain, k)
                    or leave_product_made(self.state, chain, k)
                    or leave_choice(self.state, chain, k)
                    or leave_engine(self.state, chain, k)
                    or leave_cranks(self.state, chain, k)
                    or leave_named_case(self.state, chain, k)
                    or leave_products_of_another(self.state, chain, k)
                    or leave_angle_of_section(self.state, chain, k)
                    or leave_angle_above(self.state, chain, k)
                )
            )
        ):
            return self._anew(chain, k) or self._link_in_scope(chain, k, sound, bad)
        contradicts = is_against or (
            verdict.verdict == UNDECIDED
            and (verdict.reason or "").startswith(("contradicts", "does not fit"))
        )
        is_unsaid = verdict.verdict == UNDECIDED and (verdict.reason or "").endswith(NO_WORDS)
        is_left = (is_against or is_unsaid) and (
            leave_value_of_case(self.state, chain, k) or leave_number_at_angle(self.state, chain, k)
        )
        is_other = contradicts and (leave_extreme(self.state, chain) or leave_premises(self.state, chain))
        if is_left or is_other:
            return self._link_in_scope(chain, k, sound, bad)
        if verdict.verdict == REFUTED and (changing := changing_letters(self.state, chain, k)):
            return self._without_constant(chain, k, sound, bad, changing)
        if verdict.verdict == CONTRADICTION and (
            others := cases_replaced_by(self.state.definitions, chain)
        ):
            end_cases(self.state.definitions, others, chain.start)
            return self._link_in_scope(chain, k, sound, bad)
        return open_if_datum(self.state, chain, k, verdict)

    def _ranges_of_all_values(self, chain: Chain) -> frozenset[str]:
        """Return the letter of a range before a relation that is claimed of all of it: for all y > 0."""
        text, last = self.document.text, self.state.sections.chain_before(chain.start)
        if own := self._range_of_all_behind(chain):
            return own
        if last is None or len(last.letters) != 1 or not last.letters <= chain.letters:
            return frozenset()
        is_range = all(relation.sign in SATISFIED_BY for relation in last.relations)
        before = text[max(0, last.start - LONGEST_PLACE * 2) : last.start]
        is_of_all = is_range and speaks_of_every(before)
        return last.letters if is_of_all and leads_to_claim(text[last.end : chain.start]) else frozenset()

    def _range_of_all_behind(self, chain: Chain) -> frozenset[str]:
        """Return the letter of a range right behind what is claimed of all of it: for all x ≠ 0."""
        text, near = self.document.text, self.state.sections.chains_behind(chain.end - 1)
        behind = next(near, None)
        if behind is None or behind.start - chain.end > LONGEST_PLACE or len(behind.letters) != 1:
            return frozenset()
        is_range = all(relation.sign in SATISFIED_BY for relation in behind.relations)
        is_of_all = is_range and speaks_of_every(text[chain.end : behind.start])
        return behind.letters & chain.letters if is_of_all else frozenset()

    def _claimed_always(self, chain: Chain, k: int) -> frozenset[str]:
        """Return the letters of an inequality that is said to be so always: always y² ≥ 1.

        Of different letters on its sides it may be what a machine is built for: always l > 2r. A wave
        has all the values of its angle: r ω² (cos θ + λ cos 2θ) ≤ r ω².
        """
        left, right = (names(side.node) for side in chain.sides[k : k + 2])
        is_of_same = len(left | right) == 1 or left == right
        own = left | right if is_of_same else letters_in_waves(chain.sides[k].node) - right
        if chain.relations[k].sign not in SATISFIED_BY or not (is_of_same or right < left):
            return frozenset()
        return own if self.state.sections.is_said_always(chain) else frozenset()

    def _unless_between_numbers(self, chain: Chain, k: int, verdict: Verdict) -> Verdict:
        """Return a verdict on a formula by the units that words give its letters, where they differ."""
        if verdict.verdict not in (*PROVED_WORDS, DEFINITION, PREMISE):
            return verdict
        by_units = self.state.stated_units.decide(chain, k)
        by_units = by_units or decide_ring_or_disc(chain, k, self.document)
        symbols = self.declarations.symbols_at(chain.lines[0])
        by_units = by_units or decide_offset_dead_centre(chain, k, self.document, symbols)
        return verdict if by_units is None else describe(self.document, chain, k, by_units)

    def _case_of_other_numbers(self, chain: Chain, k: int, verdict: Verdict) -> Verdict | None:
        """Return what a relation that lines above refute says of a case of its own; None for most."""
        is_unsaid = verdict.verdict == UNDECIDED and (verdict.reason or "").endswith(NO_WORDS)
        if not is_unsaid and verdict.verdict not in (REFUTED, CONTRADICTION):
            return None
        if (verdict.reason or "").startswith(NO_RESULT):
            return None
        knowledge = self.state.knowledge(chain.lines[0])
        case = as_case_of_multiple(self.state, chain, k) or as_number_of_another(self.state, chain, k)
        case = case or as_number_in_words(self.state, chain, k)
        case = case or as_formula_of_others(self.state, chain, k)
        case = case or puts_another_engines_numbers_in(self.state, chain, k, knowledge)
        return None if case is None else describe(self.document, chain, k, case)

    def _unless_at_another_value(self, chain: Chain, k: int, verdict: Verdict) -> Verdict:
        """Return a verdict; what is refuted by one number of a letter may be true by another."""
        if verdict.verdict not in (*PROVED_WORDS, REFUTED, CONTRADICTION, UNDECIDED, CONDITION):
            return verdict
        is_of_units = verdict.verdict == REFUTED and (verdict.reason or "").startswith("dimensions: ")
        is_of_words = verdict.verdict == REFUTED and NOBODY in (verdict.reason or "")
        is_of_words = is_of_words and bool(names(chain.sides[k + 1].node))
        if is_of_units or is_of_words or self.table_rows.has_judged(chain):
            return verdict  # no other number has another unit, a row has its own, and a formula none
        knowledge = self.state.knowledge(chain.lines[0])
        if verdict.verdict in PROVED_WORDS:
            is_told = (chain.start, k) in self.state.told_by_words
            there = None if is_told else refuted_by_nearest(self.state, chain, k, knowledge)
        elif verdict.verdict in (REFUTED, CONTRADICTION):
            there = at_speed_in_words(self.state, chain, k, knowledge)
            there = there or by_the_minute(self.state, chain, k, knowledge)
            if (chain.start, k) not in self.state.told_by_words:
                there = there or with_other_values(self.state, chain, k, knowledge)
            there = there or by_number_before(self.state, chain, k, knowledge)
            there = there or by_nearest_equation(self.state, chain, k, knowledge)
            there = there or by_nearest_formulas(self.state, chain, k, knowledge)
            there = there or as_supposed(self.state, chain, k)
            there = there or as_multiple_in_words(self.state, chain, k, knowledge)
            there = there or open_against_lines(self.state, chain, k, knowledge)
            there = there or put_in_with_another_factor(self.state, chain, k, knowledge)
            there = there or number_of_a_formula_one_slip_away(self.state, chain, k, knowledge)
            there = there or fixed_with_another_factor(self.state, chain, k, knowledge)
        else:
            there = by_square_above(self.state, chain, k, knowledge)
            if verdict.verdict == UNDECIDED:
                there = there or by_nearest_formulas(self.state, chain, k, knowledge)
        return verdict if there is None else describe(self.document, chain, k, there)

    def _without_constant(
        self, chain: Chain, k: int, sound: int, bad: bool, changing: frozenset[str]
    ) -> Verdict:
        """Return the verdict on a relation without the numbers of letters that it lets change."""
        with without_numbers(self.state, changing):
            verdict = self._link_in_scope(chain, k, sound, bad)
        if verdict.verdict != REFUTED:
            return verdict
        shown = ", ".join(sorted(map(plain_letter, changing)))
        reason = f"{shown} is taken as constant above, and this is about another one or its change"
        return describe(self.document, chain, k, Decision(UNDECIDED, reason))

    def _leave_quotation(self, chain: Chain, k: int, *, is_open: bool) -> bool:
        """Forget what another hand, quoted above, said of a letter; tell of any."""
        return leave_quotation(self.state, chain, k, self.quotations.is_quoted, is_open=is_open)

    def _anew(self, chain: Chain, k: int) -> Verdict | None:
        """Define F_2 of F_1 = F_2 = 0 anew, where nothing is known of it any more; None for others.

        What gives 2θ another value (largest at 2θ = 127°) is a condition on another place.
        """
        left, right, line = chain.sides[k].node, chain.sides[k + 1].node, chain.lines[0]
        if is_multiple_of_angle(chain):
            return describe(self.document, chain, k, Decision(CONDITION, "at another angle"))
        if not k or not isinstance(left, Name) or names(right):
            return None
        if self.state.definitions.values.get(left.name):
            return None
        self.state.definitions.define(left.name, right, chain)
        anew = Decision(DEFINITION, f"anew: above line {line} it was another one's")
        return describe(self.document, chain, k, anew)

    def _is_of_all_values(self, chain: Chain, k: int) -> bool:
        """Tell whether a relation says that two sides are identical, or that one is constant."""
        if any(isinstance(chain.sides[n].node, Name) for n in (k, k + 1)):
            return False
        is_identity = chain.relations[k].sign == "≡"
        return is_identity or (not k and self.state.sections.is_said_to_be_constant(chain))

    def _of_its_own_kind(
        self, chain: Chain, k: int, mismatch: Decision | None, knowledge: Knowledge
    ) -> Decision | None:
        """Return the decision on a congruence, or on a row of a table; None for all others."""
        congruent = decide_congruence(self.document.text, chain, k, knowledge)
        in_row = None if congruent else self.table_rows.judge(chain, k, knowledge)
        if in_row is not None and in_row.status != REFUTED:
            return mismatch or in_row
        return congruent or in_row

    def _undo_own(self, chain: Chain, k: int) -> None:
        """Forget what a relation that is judged again was taken to define: it would prove itself."""
        definitions, key = self.state.definitions, (chain.start, k)
        entries = {name: definitions.values.get(name, []) for name in chain.letters}
        if self._judged_last[0] != key:
            self._judged_last = key, {id(e) for each in entries.values() for e in each}
            return
        for name, each in entries.items():
            definitions.forget_mended(name, self._judged_last[1])
            own = [e for e in each if e.definition.solved and e.definition.line in chain.lines]
            if any(id(e) not in self._judged_last[1] for e in own):
                definitions.forget(name, chain.lines[0])

    def _link_in_scope(self, chain: Chain, k: int, sound: int, bad: bool) -> Verdict:
        """Return the verdict on a relation by what is in scope there; a case that is past may be left."""
        self._undo_own(chain, k)
        if (by_place := self._decide_by_place(chain, k)) is not None:
            return describe(self.document, chain, k, by_place)
        here = with_clauses_below(self.state, chain, k, self.state.knowledge(chain.lines[0]))
        knowledge = self.state.knowledge_of(chain, here)
        of_any_units = chain.relations[k].sign == PROPORTIONAL
        mismatch = None if of_any_units else self._mismatch(chain, k, sound if bad else k, knowledge)
        if (own := self._of_its_own_kind(chain, k, mismatch, knowledge)) is not None:
            return describe(self.document, chain, k, own)
        if mismatch is not None and (
            anew := numbers_of_this_section(self.state.sections, chain, knowledge)
        ):
            others = {n: d for n, d in knowledge.definitions.items() if n not in anew}
            freer = replace(knowledge, definitions=others)
            if self._mismatch(chain, k, sound if bad else k, freer) is None:
                mismatch, knowledge = None, freer
        if mismatch is None:
            chain = self._in_fitting_units(chain, k, sound if bad else k, knowledge)
        left, right = chain.sides[k], chain.sides[k + 1]
        general_proof = self._for_all_values(chain, k) if mismatch is None else None
        before = self.state.definitions.coefficients()
        if general_proof is not None:
            outcome: Verdict | Decision = general_proof[0]
            knowledge = general_proof[1]
        else:
            outcome = self._by_kind(chain, k, sound, bad, knowledge)
        angles, line = knowledge.angles, chain.lines[0]
        turning = angles | (letters_in_waves(left.node) & letters_in_waves(right.node))
        again = self.state.sections.numbers_given_again(line)
        turned = (letters_in_waves(left.node) | letters_in_waves(right.node)) - again
        values = {name: d.node for name, d in knowledge.definitions.items()}
        behind = names(left.node) if k else {*names_behind(left.node, values)}
        on_both_sides = (turning | turned) & behind & names(right.node)
        rests_on_case = bool(on_both_sides) and _is_proved(outcome)
        past = frozenset[int]()
        angles = on_both_sides if rests_on_case else angles
        if _word(outcome) in (REFUTED, CONTRADICTION) or rests_on_case:
            past = past_cases(self.state.definitions, line, angles, turned)
        if past:
            fixed = self.state.definitions.forget_coefficients(but=before)
            self._undo_own(chain, k)
            with without_cases(self.state.definitions, past, angles | turned):
                freer = with_clauses_below(self.state, chain, k, self.state.knowledge(line))
                freer = self.state.knowledge_of(chain, freer)
                # a series that has just fixed its letters is read anew: it is no claim about their values
                judge = self._by_kind if fixed else partial(judge_relation, self.state)
                general = judge(chain, k, sound, bad, freer)
            # a case that is past makes no relation true in which its angle stands
            is_open = rests_on_case or _word(general) == UNDECIDED
            if _word(general) in (REFUTED, CONTRADICTION) or not is_open:
                outcome, knowledge, fixed = general, freer, {}
            self.state.definitions.put_back(fixed)
        if k or chain.sides[0].span[0] not in self.state.solutions:
            outcome = self._as_consequence(chain, k, outcome, knowledge)
        verdict = describe(self.document, chain, k, outcome) if isinstance(outcome, Decision) else outcome
        return (
            verdict if mismatch is None else self._with_mismatch(chain, k, verdict, mismatch, knowledge)
        )

    def _with_mismatch(
        self, chain: Chain, k: int, verdict: Verdict, mismatch: Decision, knowledge: Knowledge
    ) -> Verdict:
        """Return the verdict on sides that differ in their units; a refutation's own words say more.

        Where the sides differ by what their own section says of their letters, and by the units of the
        page's data, no other case is meant.
        """
        if verdict.verdict != REFUTED:
            if not k and isinstance(head := chain.sides[0].node, Name):
                self.state.definitions.forget(head.name, chain.lines[0])  # numbers below may be right
            return describe(self.document, chain, k, mismatch)
        decision, line = verdict.decision, chain.lines[0]
        if decision is not None and decision.at_odds:
            same_section, all_of_it = self.state.sections.same_section, knowledge.definitions.items()
            near = {n: d for n, d in all_of_it if same_section(d.line, line) or not names(d.node)}
            if self._mismatch(chain, k, k, replace(knowledge, definitions=near)) is not None:
                return describe(self.document, chain, k, mismatch)
        return replace(verdict, reason=verdict.reason or mismatch.reason)

    def _decide_by_place(self, chain: Chain, k: int) -> Decision | None:
        """Return the decision on a relation by the place where it stands, None for most."""
        if chain.sides[0].span[0] in self.state.conditions:
            return Decision(CONDITION, "of the relation before it")
        varying = self.state.varying_speed
        place = chain.sides[k].span, chain.sides[k + 1].span
        if place in self.state.motions.places or (varying is not None and place == varying.place):
            return Decision(DEFINITION, "how it changes with the time")
        return None

    def _by_kind(
        self, chain: Chain, k: int, sound: int, bad: bool, knowledge: Knowledge
    ) -> Verdict | Decision:
        """Return the verdict on a relation as one of a remainder, of a series, or as any other."""
        left, right = chain.sides[k], chain.sides[k + 1]
        if is_remainder(left.node) or is_remainder(right.node):
            return decide(left, right, chain.relations[k].sign, knowledge)
        by_series = judge_series(self.state, chain, k, knowledge)
        return by_series or judge_relation(self.state, chain, k, sound, bad, knowledge)

    def _for_all_values(self, chain: Chain, k: int) -> tuple[Decision, Knowledge] | None:
        """Return the proof of a relation for all values of its angles, and what is known without them.

        None where no line above has put one in, or where it takes their values to make it true.
        """
        left, right, line = chain.sides[k], chain.sides[k + 1], chain.lines[0]
        if isinstance(left.node, Name) or chain.relations[k].sign not in "=≈":
            return None
        cases, own = lines_of_angles(self.state, chain, k, self.state.knowledge(line))
        if not cases:
            return None
        with without_cases(self.state.definitions, cases, own):
            freer = with_clauses_below(self.state, chain, k, self.state.knowledge(line))
            decision = decide(left, right, chain.relations[k].sign, freer)
        return (decision, freer) if decision.is_proved else None

    def _as_consequence(
        self, chain: Chain, k: int, outcome: Verdict | Decision, knowledge: Knowledge
    ) -> Verdict | Decision:
        """Return the outcome of a relation that is said to follow from the one before, judged as that."""
        decision = outcome if isinstance(outcome, Decision) else outcome.decision
        if isinstance(outcome, Verdict) and outcome.verdict in PROVED_WORDS:
            decision = decision or Decision(PROVED)
        is_later = k and not all(relation.sign in SATISFIED_BY for relation in chain.relations)
        if is_later or decision is None or decision.status in (REFUTED, CONTRADICTION):
            return outcome
        known = replace(knowledge, ranges=tuple(self.state.definitions.ranges_at(chain.lines[0])))
        sections = self.state.sections
        judged = decide_consequence(self.document, sections, chain, decision, known, k)
        if judged is decision:
            return outcome
        if judged.status == REFUTED:
            self.state.definitions.forget_range(chain)
        return judged

    def _in_fitting_units(self, chain: Chain, k: int, against: int, knowledge: Knowledge) -> Chain:
        """Return a chain without the readings whose units fit none of the other side."""
        left, right = chain.sides[against], chain.sides[k + 1]
        if len(left.readings) == len(right.readings) == 1:
            return chain
        mismatches = self._mismatches(chain, k, against, knowledge)
        fitting = [pair for pair, mismatch in mismatches.items() if mismatch is None]
        sides = list(chain.sides)
        for place, side, which in ((against, left, 0), (k + 1, right, 1)):
            places = {pair[which] for pair in fitting}
            readings = tuple(node for n, node in enumerate(side.readings) if n in places)
            sides[place] = replace(side, readings=readings)
        return replace(chain, sides=tuple(sides))

    def _mismatches(
        self, chain: Chain, k: int, against: int, knowledge: Knowledge
    ) -> dict[tuple[int, int], Mismatch | None]:
        """Return for each two readings of two sides where their units differ, None where they do not."""
        dimensions = self._dimensions(chain, k, knowledge)
        left, right = chain.sides[against], chain.sides[k + 1]
        sources = (self.document.source(left.span), self.document.source(right.span))
        return {
            (m, n): dimensions.mismatch(first, second, sources)
            for (m, first), (n, second) in product(enumerate(left.readings), enumerate(right.readings))
        }

    def _dimensions(self, chain: Chain, k: int, knowledge: Knowledge) -> Dimensions:
        """Return the dimensions of the letters at a relation."""
        values = {name: _value_with_units(d) for name, d in knowledge.definitions.items()}
        symbols = self.declarations.symbols_at(chain.lines[0])
        if stands_for_gravity(chain, k, knowledge):
            symbols = {**symbols, "g": GRAVITY_UNIT}
        elif has_unit_of_gravity(chain, self.document.text, knowledge):
            symbols = {**symbols, "g": GRAVITY_UNIT}
            values = {name: value for name, value in values.items() if name != "g"}
        rounded = {n: d.rounded for n, d in knowledge.definitions.items() if d.rounded is not None}
        for name in knowledge.definitions.keys() & self.state.definitions.values.keys() - rounded.keys():
            numbers = [e.definition.node for e in self.state.definitions.values[name]]
            numbers = [node for node in numbers if not names(node)]
            if numbers and names(knowledge.definitions[name].node):  # T = 0.72 s, then a formula of T
                rounded[name] = numbers[-1]
        plain = self._plain_letters.at(chain.lines[0])
        return Dimensions(symbols, values, self.document.text, rounded, plain)

    def _unlike_unit_behind(self, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
        """Refute a formula that words behind it say to be in another unit: √(g/δ) in m/s."""
        right = chain.sides[k + 1]
        if k + 1 < len(chain.relations) or not names(right.node) or chain.relations[k].sign not in "=≈":
            return None
        named = unit_behind_formula(self.document.text, chain.end)
        if named is None:
            return None
        own = self._dimensions(chain, k, knowledge).side(right.node, self.document.source(right.span))
        if own is None or own == named:
            return None
        mismatch = Mismatch("the formula is in", own, named)
        witness = {"left": unit_text(own), "right": unit_text(named)}
        return Decision(REFUTED, mismatch.reason, witness=witness)

    def _mismatch(self, chain: Chain, k: int, against: int, knowledge: Knowledge) -> Decision | None:
        """Refute a relation whose sides, or terms, are in different units."""
        unlike = [unlike_terms(node) for node in chain.sides[k + 1].readings]
        if all(unlike) and chain.relations[k].sign in "=≈":
            return Decision(REFUTED, unlike[0])
        of_rate = self._unlike_unit(chain, k)
        if (of_rate := of_rate or self._turned_wrongly(chain, k, knowledge)) is not None:
            return of_rate
        if against == k and (by_words := self._unlike_unit_behind(chain, k, knowledge)) is not None:
            return by_words
        converted = decide_conversion(chain, k, self.document) if against == k else None
        if converted is not None and converted.is_proved:
            return None  # 17.9 lb.-in. is 206 kg mm, or a moment
        lettered = [against]
        has_letters = bool(names(chain.sides[against].node))
        if against and has_letters and self._is_quantity(chain.sides[k + 1]):
            lettered.append(0)
        if against and not has_letters:  # m = 0.44 + 0.18 = 0.62 m is no mass
            symbols = self.declarations.symbols_at(chain.lines[0])
            heads = ((n, chain.sides[n].node) for n in range(against))
            lettered += [
                n
                for n, head in heads
                if isinstance(head, Name)
                and (_has_dimension(head, symbols) or _has_formula(head, knowledge))
            ]
            formulas = (n for n in range(against - 1, 0, -1) if names(chain.sides[n].node))
            lettered += [n for n in formulas if n not in lettered][:1]  # m r ω² = 0.7·0.045·314² = 3110 J
        for place in lettered:
            mismatches = list(self._mismatches(chain, k, place, knowledge).values())
            if all(mismatches) and mismatches[0] is not None:
                witness = {"left": unit_text(mismatches[0].left), "right": unit_text(mismatches[0].right)}
                return Decision(REFUTED, mismatches[0].reason, witness=witness)
        return None

    def _turned_wrongly(self, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
        """Refute radians by the second in a unit of turns, and turns in one of radians."""
        dimensions_of = partial(self._dimensions, chain, k, knowledge)
        return refute_turns(chain, k, self.document, dimensions_of, knowledge)

    def _is_quantity(self, side: Side) -> bool:
        """Tell whether a side is a number with a unit behind it."""
        return Dimensions({}, {}, self.document.text).of_numbers(side.node) is not None

    @cached_property
    def _plain_letters(self) -> PlainLetters:
        return PlainLetters(self.document, self.state.sections)

    def _unlike_unit(self, chain: Chain, k: int) -> Decision | None:
        """Refute a result in a unit that the letter at the head of its chain cannot have: ω̇ in rad/s.

        Its dots say so, or the noun right before it: "the torque is M = 50 N".
        """
        if turns := turns_for_radians(chain, k, self.document):
            return Decision(REFUTED, turns)
        head, right = chain.sides[0].node, chain.sides[k + 1].node
        own = Dimensions({}, {}, self.document.text).of_numbers(right)
        if own is None or _UNIT_GOES_ON.match(self.document.text, right.span[1]):
            return None
        expected, what = rate_dimension(head), "the left side"
        symbols = self.declarations.symbols_at(chain.lines[0])
        if expected is None and isinstance(head, Name) and head.name not in symbols:
            sentence = self.state.sections.sentence_leading_to(chain)
            named = unit_asked_for(chain, sentence, self.document.source(chain.sides[k + 1].span))
            heads_several = is_label(sentence) and len(self.state.sections.chains_on(chain.lines[0])) > 1
            if named is not None and not heads_several:  # "Gas force: p = 55 bar, F = p A"
                what, expected = f"“{named[0]}”", named[1]
        if expected is None or own == expected:
            return None
        mismatch = Mismatch(f"{what} is in", expected, own)
        witness = {"left": unit_text(expected), "right": unit_text(own)}
        return Decision(REFUTED, mismatch.reason, witness=witness)


_UNIT_GOES_ON = re.compile(
    r"[\s$)\]]{0,6}(?:per|pro|par|por|al)\s(?:second|minute|min|s|sec|hour|metre|meter|m)\w*"
)
"""Behind a unit of which a line has but the beginning: 27.08 radians, per second in the next."""


def _has_dimension(letter: Name, symbols: Mapping[str, str]) -> bool:
    return declared_dimension(symbols.get(letter.name, "")) is not None


def _has_formula(letter: Name, knowledge: Knowledge) -> bool:
    """Tell whether a line above has a formula for a letter: after E = J ω²/2 it is an energy."""
    definition = knowledge.definitions.get(letter.name)
    return definition is not None and bool(names(_value_with_units(definition)))


def _value_with_units(definition: Definition) -> Formula:
    """Return the value that says most of a letter's unit: its formula, before the numbers put into it.

    A number of a single unit says it itself, an arithmetic of bare numbers does not.
    """
    node, formula = definition.node, definition.formula
    is_arithmetic = definition.numeric and not isinstance(node, Number)
    return formula if formula is not None and is_arithmetic and definition.rounded is None else node


def _word(outcome: Verdict | Decision) -> str:
    return outcome.status if isinstance(outcome, Decision) else outcome.verdict


def _is_proved(outcome: Verdict | Decision) -> bool:
    return outcome.is_proved if isinstance(outcome, Decision) else outcome.verdict in PROVED_WORDS


def _puts_numbers_in(chain: Chain, k: int, verdict: Verdict) -> bool:
    """Tell whether a letter's formula gets a number that no line gives the letters in it."""
    is_premise = verdict.verdict == PREMISE and verdict.reason.startswith(NUMBERS_PUT_IN)
    is_open = verdict.verdict == UNDECIDED and verdict.reason.endswith(GIVE_IT)
    return k > 0 and not names(chain.sides[k + 1].node) and (is_premise or is_open)


def _lone_letters(chain: Chain, k: int) -> Iterator[str]:
    """Yield the letters that the k-th relation of a chain may define."""
    for side in (chain.sides[0], chain.sides[k], chain.sides[k + 1]):
        if isinstance(side.node, Name):
            yield side.node.name
