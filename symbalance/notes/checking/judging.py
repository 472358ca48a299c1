"""The class `Judge`: goes through a document's equations in order and gives each its verdict."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import partial
from itertools import product

from symbalance.budgets import Budget, OverBudgetError, run_within
from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Matrix,
    Name,
    Negative,
    Number,
    Product,
    Span,
    Sum,
    Summation,
    names,
    walk,
)
from symbalance.document.text_writer import formula_text
from symbalance.errors import SymbalanceError
from symbalance.notes.algebra.domain import NoFormError, TooLargeError
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking import assertions, constraints
from symbalance.notes.checking.carried_values import CarriedValues
from symbalance.notes.checking.case_words import is_case_behind
from symbalance.notes.checking.consequences import decide_consequence
from symbalance.notes.checking.constraints import Constraint
from symbalance.notes.checking.deciding.cases import decide_case, decide_with_ratio, states_a_case
from symbalance.notes.checking.deciding.equality import PROVED, Decision, decide_equality, without_dots
from symbalance.notes.checking.deciding.inequalities import SATISFIED_BY, decide_inequality, sample_ranges
from symbalance.notes.checking.deciding.knowledge import Assumption, Definition, Knowledge
from symbalance.notes.checking.deciding.matrix_relations import (
    is_of_matrices,
    matrix_constraint,
    meaningless,
)
from symbalance.notes.checking.deciding.numbers_put_in import printed_results
from symbalance.notes.checking.deciding.relations import decide, decide_at_value
from symbalance.notes.checking.deciding.remainders import is_remainder
from symbalance.notes.checking.deciding.sign_of_letters import decide_with_signs
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.definitions import Definitions
from symbalance.notes.checking.descriptions import (
    describe,
    undecided,
    undecided_by_fault,
    unreadable_verdict,
    with_fault,
)
from symbalance.notes.checking.dimensions import Dimensions, unit_text
from symbalance.notes.checking.engine_speeds import decide_speed, speeds_of
from symbalance.notes.checking.engines import Sources
from symbalance.notes.checking.extremes import decide_extreme, decide_place
from symbalance.notes.checking.given_numbers import GivenNumbers, number_given
from symbalance.notes.checking.impossible_values import number_of
from symbalance.notes.checking.letter_values import define_letter
from symbalance.notes.checking.letters_of_sections import numbers_of_this_section
from symbalance.notes.checking.meant_quantities import MeantQuantities
from symbalance.notes.checking.meant_words import MeantWords
from symbalance.notes.checking.numbers_in_units import decide_after_units_left_out, decide_in_units
from symbalance.notes.checking.open_cases import (
    cases_left_by,
    cases_replaced_by,
    end_cases,
    lines_of_numbers,
    past_cases,
    without_cases,
)
from symbalance.notes.checking.own_units import with_speeds
from symbalance.notes.checking.page_data import data_of
from symbalance.notes.checking.premise_branches import decide_on_branches
from symbalance.notes.checking.premise_decisions import decide_by_premises, must_follow
from symbalance.notes.checking.premises import Premise, implied, lines_of
from symbalance.notes.checking.repair.fixes import add_fix, is_proved_as_far
from symbalance.notes.checking.sections import Sections
from symbalance.notes.checking.series_coefficients import (
    coefficient_values,
    decide_coefficient,
    exact_value,
)
from symbalance.notes.checking.sidecar import Binding, Declarations
from symbalance.notes.checking.solutions import NEAR, chains_below, solution_behind_arrow, solution_below
from symbalance.notes.checking.solved_premises import concerns, solve_premises, solve_without_scope
from symbalance.notes.checking.symbol_roles import (
    KNOWN,
    MOVING,
    SMALL_WORD,
    letters_by_role,
    role_of,
    small_letters,
)
from symbalance.notes.checking.symbols import meaning_of
from symbalance.notes.checking.unit_or_letter import with_both_readings
from symbalance.notes.checking.verdicts import (
    CONDITION,
    CONTRADICTION,
    DEFINITION,
    PREMISE,
    PROVED_WORDS,
    REFUTED,
    STATED,
    UNDECIDED,
    Checked,
    Verdict,
)
from symbalance.notes.checking.witness_angles import holds_at_angles, refuted_at_angles
from symbalance.notes.reading import ReadingError, read_equation
from symbalance.notes.reading.equations import Chain, ReadNotes, Relation, Side

FOLLOWS = "follows from the side before, which is refuted"
ANGLES = ("crank angle", "rod angle", "time", "integer")
UNIVERSAL = (
    "crank angle",
    "rod angle",
    "time",
    "rod ratio l/r",
    "rod ratio l/s",
    "crank ratio r/l",
    "integer",
)
CLAUSES = 15
"""Lines below an equation in matrices that may still say what its letters are."""
PAGE = Budget(600, 4000)
"""What a whole document may take, where nobody says otherwise."""
RELATIONS, IN_MEMORY = 60, 4
"""A relation may take a 60th of the document's time, 10 s as a rule, and a quarter of its memory: one
that needs more is no line of a derivation, and the others are still to be judged."""


@dataclass
class Judge:
    """Judges one document, within its budget; the letters defined so far are its state."""

    document: ReadNotes
    declarations: Declarations
    sources: Sources = field(default_factory=Sources)
    budget: Budget = PAGE
    corrects: bool = True

    def __post_init__(self) -> None:
        symbols_at = self.declarations.symbols_at
        self.document = with_both_readings(self.document, symbols_at)
        data = data_of(self.document, symbols_at)
        chains = (*self.document.chains, *data)
        every = with_speeds(replace(self.document, chains=chains), symbols_at).chains
        self.document = replace(self.document, chains=every[: len(self.document.chains)])
        self.data = list(every[len(self.document.chains) :])
        """The page's data that stand in tables, lists and code, and have not been reached yet."""
        sections = Sections(self.document)
        self.definitions = Definitions(self.declarations, sections)
        self.meant = MeantQuantities(MeantWords(self.document, self.declarations, sections), self.sources)
        self.start = time.monotonic()
        self.small_letters = small_letters(self.document.text)
        self.counts = _counts(self.document)
        self.letters = {
            n for chain in self.document.chains for side in chain.sides for n in names(side.node)
        }
        self.printed = printed_results(self.document)
        self.carried = CarriedValues()
        self.given_numbers = GivenNumbers()
        self.speeds = speeds_of(self.document.text)
        self.not_judged: dict[str, int] = {}
        """Letters that a relation may define which was not judged, with its line."""
        self.solutions: dict[int, tuple[Premise, Decision]] = {}
        """Where an equation's solution stands: the equation, and whether the solution satisfies it."""
        self.general: frozenset[str] = frozenset()
        """Letters of all of whose values the relation in hand is claimed, whatever case stands before."""

    def check(self) -> Checked:
        """Return the document with its verdicts."""
        bindings = assertions.by_line(self.declarations.bindings)
        verdicts: list[Verdict] = [unreadable_verdict(self.document, u) for u in self.document.unreadable]
        for chain in self._in_turn():
            self._take_data(chain.lines[0])
            chain_binds = [b for line in chain.lines for b in bindings.pop(line, [])]
            verdicts += self.chain(chain, chain_binds)
        for binding in (b for rest in bindings.values() for b in rest):
            if not assertions.name_unreadable(verdicts, self.document, binding):
                missing_equation = partial(assertions.missing_equation, self.document, binding)
                verdicts.append(self.guard(missing_equation, (0, 0), binding.line))
        for binding in self.declarations.bindings:
            if binding.text:
                verdicts.append(self.guard(partial(self.piece, binding), (0, 0), binding.line))
        numbered = number_verdicts(verdicts)
        return Checked(
            self.document, tuple(replace(v, cell=self.document.cell_of(v.line)) for v in numbered)
        )

    def _take_data(self, line: int) -> None:
        """Define the letters of the tables, lists and code above a line; a formula's letter is left."""
        while self.data and self.data[0].lines[0] < line:
            datum = self.data.pop(0)
            name = next(iter(names(datum.sides[0].node)))
            earlier = self.knowledge(datum.lines[0]).definitions.get(name)
            if earlier is not None and not earlier.numeric:
                continue
            verdicts = self.chain(datum, [])
            if any(v.verdict in (REFUTED, CONTRADICTION, UNDECIDED) for v in verdicts):
                self.definitions.define(name, datum.sides[1].node, datum)  # another engine's table

    def _in_turn(self) -> list[Chain]:
        """Return the chains by lines, on one line first what states a case: x² = 4 for x = 2.

        A result is no case (so x = 2; v = 2 s n, v = 9), nor is the second value of a letter on one line,
        nor what stands behind that: r = 40, l = 160; r = 45, l = 150, λ = 0.3.
        """
        by_line: dict[int, list[Chain]] = {}
        for chain in self.document.chains:
            by_line.setdefault(chain.lines[0], []).append(chain)
        ordered: list[Chain] = []
        for line in sorted(by_line):
            first: dict[frozenset[str], Chain] = {}
            met: set[frozenset[str]] = set()
            is_second = False
            for chain in by_line[line]:
                own = names(chain.sides[0].node)
                is_second = is_second or (own in first and states_a_case(chain))
                is_result = self.definitions.sections.is_consequence(chain) or own in met or is_second
                is_result = is_result or any(relation.sign == "≈" for relation in chain.relations)
                if states_a_case(chain) and not is_result:
                    first[own] = chain
                if isinstance(chain.sides[0].node, Name) or not any(
                    names(s.node) for s in chain.sides[1:]
                ):
                    met.add(own)
            cases = list(first.values())
            others = [c for c in by_line[line] if all(c is not case for case in cases)]
            ordered += [*cases, *self._cases_before_claims(others)]
        return ordered

    def _cases_before_claims(self, chains: list[Chain]) -> list[Chain]:
        """Return the chains of a line, another case before the claim it stands behind: for θ = π."""
        ordered: list[Chain] = []
        for chain in chains:
            last = ordered[-1] if ordered else None
            first, end = chain.sides[0].span[0], chain.sides[-1].span[1]
            is_behind = last is not None and is_case_behind(
                self.document.text, last.sides[-1].span[1], first, end
            )
            ordered.insert(
                len(ordered) - 1 if is_behind and states_a_case(chain) else len(ordered), chain
            )
        return ordered

    def guard(self, verdict: Callable[[], Verdict], span: Span, line: int = 0) -> Verdict:
        """Return a verdict; one that takes too much, or a fault of the checker, is "undecided"."""
        at = line or self.document.line_of(span[0])
        left = self._time_left()
        if left is not None and left <= 0:
            reason = f"not judged: the document's budget of {self.budget} was spent before; see --budget"
            return undecided(self.document, span, at, reason)
        try:
            return run_within(self._budget_of_relation(left), verdict)
        except OverBudgetError as problem:
            reason = f"not judged within its budget of {problem.spent}; --budget gives it more"
            return undecided(self.document, span, at, reason)
        except MemoryError:
            return undecided(self.document, span, at, "not judged: it needs more memory than there is")
        except SymbalanceError:
            raise  # a declaration that cannot be used
        except Exception as problem:
            return undecided_by_fault(self.document, span, at, problem)

    def _time_left(self) -> float | None:
        """Return the seconds left of the document's budget, None where it has no end."""
        if self.budget.seconds is None:
            return None
        return self.budget.seconds - (time.monotonic() - self.start)

    def _budget_of_relation(self, left: float | None) -> Budget:
        seconds, memory = self.budget
        return Budget(
            None if seconds is None or left is None else min(seconds / RELATIONS, left),
            None if memory is None else memory / IN_MEMORY,
        )

    def piece(self, binding: Binding) -> Verdict:
        """Return the verdict on a piece of a line that is bound to a quantity."""
        span = assertions.span_of(self.document, binding)
        return self.guard(partial(self._piece, binding), span, binding.line)

    def _piece(self, binding: Binding) -> Verdict:
        knowledge = self.knowledge(binding.line, binding.convention)
        names_here = frozenset(self.declarations.symbols_at(binding.line))
        return assertions.piece_verdict(self.document, binding, knowledge, names_here, self.sources)

    def knowledge(self, line: int, convention: str = "") -> Knowledge:
        """Return what is known at a line."""
        symbols = {**self.counts, **self.declarations.symbols_at(line)}
        meaning, crank = meaning_of(symbols, convention, self.sources.engines)
        definitions = self.definitions.at(line)
        letters = letters_by_role(symbols)
        universal = frozenset(n for m in UNIVERSAL for n in letters.get(m, ()))
        moving = frozenset(n for m in MOVING for n in letters.get(m, ()))
        angles = frozenset(n for m in ANGLES for n in letters.get(m, ()))
        letters_declared = frozenset(symbols)
        ranges = self.definitions.ranges_at(line)
        meaning = replace(meaning, ranges={**meaning.ranges, **sample_ranges(ranges)})
        knowledge = Knowledge(
            meaning,
            crank,
            definitions,
            self.assumptions(line, letters_declared),
            letters_declared | self.document.own_letters,
            moving,
            angles,
            symbols,
            universal,
            corrects=self.corrects,
            ranges=tuple(ranges),
            printed=self.printed,
            small=frozenset(n for n, text in symbols.items() if SMALL_WORD.search(text))
            | self.small_letters,
        )
        return self.definitions.on_stated_branches(knowledge)

    def assumptions(self, line: int, letters: frozenset[str]) -> tuple[Assumption, ...]:
        """Return the assumptions at a line, each solved for a letter."""
        return tuple(
            read_assumption(text, letters, self.declarations.place)
            for text in self.declarations.assumptions_at(line)
        )

    def chain(self, chain: Chain, bindings: list[Binding]) -> list[Verdict]:
        """Return the verdicts on a chain's relations in order; none is lost by a fault of the checker."""
        verdicts: list[Verdict] = []
        try:
            self._judge(chain, bindings, verdicts)
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
            verdict = self.guard(partial(self.link, chain, k, sound, bad), span, relation.line)
            if k + 1 in bound:
                is_excused = bad or isinstance(chain.sides[k].node, Name)
                verdict = self.assertion(chain, k + 1, bound[k + 1], verdict, is_excused)
            verdicts.append(verdict)
            if verdict.verdict == REFUTED:
                self.carried.note(chain, k)
                self.definitions.forget_moment(chain.sides[k + 1].node)
            self.given_numbers.note(chain, k, verdict)
            if verdict.is_unjudged:
                self.not_judged |= dict.fromkeys(_lone_letters(chain, k), relation.line)
            if k and verdict.verdict in PROVED_WORDS and isinstance(chain.sides[0].node, Name):
                self.definitions.round(chain.sides[0].node.name, chain, chain.sides[k + 1].node)
            bad = verdict.verdict == REFUTED or (bad and verdict.reason == FOLLOWS)
            if not bad:
                sound = k + 1
        self.definitions.use(chain)

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
            knowledge = self.knowledge(chain.lines[0], binding.convention)
            return assertions.side_verdict(
                self.document, chain, index, binding, knowledge, self.sources, step, is_excused
            )

        line = chain.relations[index - 1].line if index else 0
        return self.guard(verdict, chain.sides[index].span, line)

    def link(self, chain: Chain, k: int, sound: int, bad: bool) -> Verdict:
        """Return the verdict on the k-th relation of a chain.

        What is said of all values does not rest on a case before, and one case takes another's place.
        """
        angles = self.knowledge(chain.lines[0]).angles if self.definitions.cases else frozenset[str]()
        left = cases_left_by(self.definitions, chain, angles)
        start = min(side.span[0] for side in chain.sides)
        own = {name for side in chain.sides for name in names(side.node)}
        spoken = dict.fromkeys(own, False)
        self.general = self.definitions.sections.spoken_of_generally(chain, spoken, named=True)
        examples = lines_of_numbers(self.definitions, self.general)
        if left or examples:
            free = frozenset(name for case in left for name in case.letters)
            self.general |= free
            lines = examples | {case.line for case in left}
            with without_cases(self.definitions, lines, self.general):
                verdict = self._link_in_scope(chain, k, sound, bad)
            end_cases(self.definitions, left, start)
            return verdict
        verdict = self._link_in_scope(chain, k, sound, bad)
        if verdict.verdict == CONTRADICTION and (others := cases_replaced_by(self.definitions, chain)):
            end_cases(self.definitions, others, start)
            return self._link_in_scope(chain, k, sound, bad)
        return verdict

    def _link_in_scope(self, chain: Chain, k: int, sound: int, bad: bool) -> Verdict:
        knowledge = self._with_clauses_below(chain, k, self.knowledge(chain.lines[0]))
        mismatch = self._mismatch(chain, k, sound if bad else k, knowledge)
        if mismatch is not None and (
            anew := numbers_of_this_section(self.definitions.sections, chain, knowledge)
        ):
            others = {n: d for n, d in knowledge.definitions.items() if n not in anew}
            freer = replace(knowledge, definitions=others)
            if self._mismatch(chain, k, sound if bad else k, freer) is None:
                mismatch, knowledge = None, freer
        left, right = chain.sides[k], chain.sides[k + 1]
        if is_remainder(left.node) or is_remainder(right.node):
            outcome: Verdict | Decision = decide(left, right, chain.relations[k].sign, knowledge)
        else:
            outcome = self._of_series(chain, k, knowledge) or self._link(chain, k, sound, bad, knowledge)
        angles, line = knowledge.angles, chain.lines[0]
        turning = angles | (_turned(left.node) & _turned(right.node))
        rests_on_case = bool(turning & names(left.node) & names(right.node)) and _is_proved(outcome)
        past = frozenset[int]()
        angles = turning if rests_on_case else angles
        if _is_refuted(outcome) or rests_on_case:
            past = past_cases(self.definitions, line, angles)
        if past:
            with without_cases(self.definitions, past, angles):
                freer = self._with_clauses_below(chain, k, self.knowledge(line))
                general = self._link(chain, k, sound, bad, freer)
            # a case that is past makes no relation true in which its angle stands
            if _is_refuted(general) or not (rests_on_case or _is_undecided(general)):
                outcome, knowledge = general, freer
        if k or chain.sides[0].span[0] not in self.solutions:
            outcome = self._as_consequence(chain, k, outcome, knowledge)
        verdict = describe(self.document, chain, k, outcome) if isinstance(outcome, Decision) else outcome
        if mismatch is None:
            return verdict
        if verdict.verdict == REFUTED:  # its witness and its correction say more
            return replace(verdict, reason=verdict.reason or mismatch.reason)
        return describe(self.document, chain, k, mismatch)

    def _as_consequence(
        self, chain: Chain, k: int, outcome: Verdict | Decision, knowledge: Knowledge
    ) -> Verdict | Decision:
        """Return the outcome of a relation that is said to follow from the one before, judged as that."""
        decision = outcome if isinstance(outcome, Decision) else outcome.decision
        if isinstance(outcome, Verdict) and outcome.verdict in PROVED_WORDS:
            decision = decision or Decision(PROVED)
        if k or decision is None or decision.status in (REFUTED, CONTRADICTION):
            return outcome
        known = replace(knowledge, ranges=tuple(self.definitions.ranges_at(chain.lines[0])))
        sections = self.definitions.sections
        judged = decide_consequence(self.document, sections, chain, decision, known)
        if judged is decision:
            return outcome
        if judged.status == REFUTED:
            self.definitions.forget_range(chain)
        return judged

    def _mismatch(self, chain: Chain, k: int, against: int, knowledge: Knowledge) -> Decision | None:
        """Refute a relation whose sides, or terms, are in different units."""
        line = chain.lines[0]
        values = {name: d.node for name, d in knowledge.definitions.items()}
        dimensions = Dimensions(self.declarations.symbols_at(line), values, self.document.text)
        left, right = chain.sides[against], chain.sides[k + 1]
        sources = (self.document.source(left.span), self.document.source(right.span))
        mismatches = [
            dimensions.mismatch(first, second, sources)
            for first, second in product(left.readings, right.readings)
        ]
        if not all(mismatches) or mismatches[0] is None:
            return None
        witness = {"left": unit_text(mismatches[0].left), "right": unit_text(mismatches[0].right)}
        return Decision(REFUTED, mismatches[0].reason, witness=witness)

    def _link(
        self, chain: Chain, k: int, sound: int, bad: bool, knowledge: Knowledge
    ) -> Verdict | Decision:
        """Return the verdict on the k-th relation of a chain, or the decision that it only describes."""
        relation = chain.relations[k]
        left, right = chain.sides[k], chain.sides[k + 1]
        of_matrices = is_of_matrices(left.node, right.node, knowledge)
        if of_matrices and (fault := _no_relation_of_matrices(relation.sign, left, right, knowledge)):
            return Decision(UNDECIDED, fault)
        if relation.sign in SATISFIED_BY:
            decision = decide_inequality(chain, k, knowledge)
            self.definitions.state_range(chain, k, decision)
            return decision
        is_equality = relation.sign == "=" and not of_matrices
        if is_equality and (name := _meant_as_number(left.node, right.node, knowledge)):
            reason = f"true of the number {name}; here {name} is declared as a letter"
            return Decision(UNDECIDED, reason)
        definition = _demanded(relation) or self._as_proved_solution(chain, k)
        definition = definition or self._define(chain, k, knowledge)
        if definition is not None:
            return self._as_meant(chain, k, definition, knowledge)
        decision, against = self._decide_step(chain, k, sound, bad, knowledge)
        decision = self._with_signs(left, right, relation.sign, decision, knowledge)
        if decision.status in (REFUTED, UNDECIDED):
            below = None if k else solution_below(self.definitions.sections, chain, knowledge)
            solved = self._as_solved(chain, below, knowledge)
            decision = solved or self._unless_given(chain, k, against, decision, knowledge)
        if decision.status in STATED or decision.status == CONTRADICTION:
            return decision
        decision = self._mended(chain, k, against, decision, knowledge)
        return self.add_fix(
            describe(self.document, chain, k, decision), chain, k, against, decision, knowledge
        )

    def _mended(
        self, chain: Chain, k: int, against: Side, decision: Decision, knowledge: Knowledge
    ) -> Decision:
        """Return the decision on a refuted relation by all that may be meant with it, in turn."""
        of_matrices = is_of_matrices(chain.sides[k].node, chain.sides[k + 1].node, knowledge)
        # cases and conditions are of numbers
        may_state = not of_matrices and not must_follow(self.definitions, chain, k) and not self.general
        if decision.status == REFUTED and may_state:
            decision = self._unless_stated(chain, k, against, decision, knowledge)
        if decision.status == REFUTED:
            decision = decide_in_units(chain, k, decision, self.document, knowledge)
        if decision.status == REFUTED:
            decision = self._with_wrong_results(chain, k, against, decision, knowledge)
        for mend in (self._at_stated_angle, self._with_letters_below, self._unless_open):
            if decision.status == REFUTED:
                decision = mend(chain, k, decision, knowledge)
        return decision

    def _define(self, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
        """Return the decision on a relation that gives a letter its value; None for other relations.

        A number that equations above give is judged by them; nothing rests on one that is wrong.
        """
        values = {name: list(entries) for name, entries in self.definitions.values.items()}
        premises = list(self.definitions.premises)
        definition = define_letter(self.definitions, chain, k, knowledge)
        pair, line, sections = number_given(chain, k), chain.lines[0], self.definitions.sections
        head = chain.sides[0].node
        if not k and definition is not None and definition.status in STATED and isinstance(head, Name):
            by_speed = decide_speed(head.name, chain.sides[1].node, self.speeds, knowledge)
            if by_speed is not None and chain.relations[0].sign == "=":
                return by_speed
        is_given = definition is not None and definition.status in (PREMISE, DEFINITION)
        if (
            pair is None
            or not is_given
            or pair[0] in knowledge.meaning.values
            or sections.opens_case(chain)
        ):
            return definition
        first = sections.paragraph_start(line)
        by_given = self.given_numbers.decide(*pair, line, first, knowledge)
        if by_given is not None and by_given.status == REFUTED:
            self.definitions.values, self.definitions.premises = values, premises
        return by_given or definition

    def _as_meant(
        self, chain: Chain, k: int, definition: Decision, knowledge: Knowledge
    ) -> Verdict | Decision:
        """Return the verdict on a definition, by the quantity that its letter is known to mean.

        One that is wrong by a slip is mended for the lines that follow.
        """
        if definition.status != DEFINITION:
            return self.meant.again(chain, k, knowledge) or definition
        outcome = self.meant.judge(chain, k, knowledge)
        name = chain.sides[k].node
        if isinstance(outcome, Verdict) and outcome.fix is not None and isinstance(name, Name):
            self.definitions.define(name.name, outcome.fix.node, chain)
            outcome = outcome if self.corrects else replace(outcome, fix=None)
        elif isinstance(outcome, Decision) and outcome.status == REFUTED and isinstance(name, Name):
            self.definitions.forget(name.name, chain.lines[0])
        return outcome or definition

    def _of_series(self, chain: Chain, k: int, knowledge: Knowledge) -> Verdict | None:
        """Return the verdict on a series with letters as its coefficients, or on what is said of one."""
        decision = self._by_coefficients(chain, k, knowledge)
        if decision is None and not k and chain.relations[0].sign in "=≈":
            extreme = decide_extreme(chain.sides[0], chain.sides[1], chain.relations[0].sign, knowledge)
            name, value = chain.sides[0].node, without_dots(chain.sides[1].node)[0]
            if extreme is not None and isinstance(name, Name):
                extreme = decide_place(extreme, chain, self.document, knowledge)
                self.definitions.define(name.name, value, chain)
                return describe(self.document, chain, k, extreme)
        if decision is None:
            return None
        described = describe(self.document, chain, k, decision)
        others = {n: d for n, d in knowledge.definitions.items() if not d.is_coefficient}
        left = Side((exact_value(decision),), chain.sides[k].span)
        return self.add_fix(described, chain, k, left, decision, replace(knowledge, definitions=others))

    def _by_coefficients(self, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
        """Return the decision on a series with letters as its coefficients, or on what is said of one.

        None for other relations.
        """
        left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
        of_matrices = is_of_matrices(left.node, right.node, knowledge)
        if chain.relations[k].is_demanded or sign not in "=≈" or of_matrices:
            return None
        if k == 0 and isinstance(left.node, Name):
            definition = knowledge.definitions.get(left.node.name)
            if definition is not None and definition.is_coefficient:
                return decide_coefficient(left, right, sign, knowledge)
        in_use = self.definitions.letters_before(chain.lines[0])
        is_rough, on_page = sign == "≈", self.letters
        fixed = coefficient_values(
            left.node, right.node, knowledge, in_use, on_page=on_page, is_rough=is_rough
        )
        if fixed is None:
            return self._another_series(chain, k, knowledge)
        texts = ", ".join(formula_text(Name(name), plain=True) for name in sorted(fixed))
        case = Decision(PREMISE, f"read as what fixes {texts}: the coefficients of the other side")
        refuted = Decision(REFUTED)
        by_lines_below = self._with_letters_below(chain, k, refuted, knowledge)
        self.definitions.fix_coefficients(fixed, chain)
        return by_lines_below if by_lines_below.is_proved else case

    def _another_series(self, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
        """Return the decision on a second series with the letters of an earlier one.

        In another section they are new ones.
        """
        left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
        own = names(left.node) | names(right.node)
        earlier = {n: d for n, d in knowledge.definitions.items() if d.is_coefficient and n in own}
        if not earlier or decide(left, right, sign, knowledge).is_proved:
            return None
        others = {n: d for n, d in knowledge.definitions.items() if n not in earlier}
        without = replace(knowledge, definitions=others)
        fixed = coefficient_values(
            left.node, right.node, without, on_page=self.letters, is_rough=sign == "≈"
        )
        if fixed is None:
            return None
        line = max(d.line for d in earlier.values())
        texts = ", ".join(formula_text(Name(name), plain=True) for name in sorted(earlier))
        if self.definitions.sections.same_section(line, chain.lines[0]):
            return Decision(
                UNDECIDED, f"{texts} are the coefficients of line {line}, or new ones: say so"
            )
        self.definitions.fix_coefficients(fixed, chain)
        return Decision(PREMISE, f"read as what fixes {texts} anew: the coefficients of the other side")

    def _with_signs(
        self, left: Side, right: Side, sign: str, decision: Decision, knowledge: Knowledge
    ) -> Decision:
        """Return the decision with the signs that are stated; |x| = x is not so for every x."""
        if not is_of_matrices(left.node, right.node, knowledge):
            decision = decide_with_signs(left, right, sign, decision, knowledge)
        texts = {f"{formula_text(Name(name), plain=True)} ≥ 0" for name in self.general}
        least = [text for text in decision.assumptions if text in texts]
        if not least or not decision.is_proved:
            return decision
        reason = f"said of all values, but it holds if {least[0]}"
        return replace(decision, status=REFUTED, assumptions=(), reason=reason)

    def _with_wrong_results(
        self, chain: Chain, k: int, against: Side, decision: Decision, knowledge: Knowledge
    ) -> Decision:
        """Return the proof of a relation from a number that is refuted where it was printed first."""

        def by(left: Side, right: Side, known: Knowledge) -> Decision:
            return decide(left, right, chain.relations[k].sign, known)

        def value_of(node: Formula) -> float | None:
            number = number_of(node, knowledge)
            return None if number is None else float(number)

        carried = self.carried.decide((against, chain.sides[k + 1]), knowledge, by, value_of)
        return carried or decision

    def _at_stated_angle(
        self, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
    ) -> Decision:
        """Return the proof of a relation at an angle its sentence names: at top dead centre, where θ = 0.

        An angle stays free where a line gives it a number; a relation without it may be meant there.
        """
        left, right, line = chain.sides[k], chain.sides[k + 1], chain.lines[0]
        stated: list[tuple[str, Formula]] = []
        for name in sorted(knowledge.angles):
            definition = knowledge.definitions.get(name)
            near = self.definitions.sections.paragraph_start(line) <= (
                definition.line if definition else 0
            )
            if definition is not None and definition.numeric and near:
                stated.append((name, definition.node))
        centre = self.definitions.sections.dead_centre(chain)
        if knowledge.crank is not None and isinstance(knowledge.crank.theta, Name) and centre is not None:
            angle = Constant("pi") if centre else Number(Fraction(0))
            stated.append((knowledge.crank.theta.name, angle))
        for name, value in stated:
            if name in names(right.node):
                continue
            assumption = f"{formula_text(Name(name), plain=True)} = {formula_text(value, plain=True)}"
            there = decide_at_value(left, right, chain.relations[k].sign, knowledge, name, value)
            if there.is_proved:
                return replace(there, assumptions=(*there.assumptions, assumption))
        return decision

    def _unless_given(
        self, chain: Chain, k: int, against: Side, decision: Decision, knowledge: Knowledge
    ) -> Decision:
        """Return the decision on what is no proved step: it may be given, or follow from what is."""
        left, right = chain.sides[k], chain.sides[k + 1]
        of_matrices = is_of_matrices(left.node, right.node, knowledge)
        premises = [] if of_matrices else must_follow(self.definitions, chain, k)
        if premises:
            return self._following(chain, k, premises, decision, knowledge)
        if not self.general:
            stated = (self._fixed_matrix if of_matrices else self._fixed)(chain, k, knowledge)
            if stated is not None:
                return stated
        sign = chain.relations[k].sign
        decision, is_open = self._with_premises(against, right, sign, decision, knowledge)
        if is_open and not of_matrices:
            refuted = replace(decision, status=REFUTED)
            case = self._unless_stated(chain, k, against, refuted, knowledge)
            return case if case.status in (*STATED, CONTRADICTION) else decision
        return decision

    def _decide_step(
        self, chain: Chain, k: int, sound: int, bad: bool, knowledge: Knowledge
    ) -> tuple[Decision, Side]:
        """Return the decision on a relation as a step, and the side its right one is compared with."""
        sign, left, right = chain.relations[k].sign, chain.sides[k], chain.sides[k + 1]
        decision, against = decide(left, right, sign, knowledge), left
        result = None
        if not names(left.node):
            result = decide_after_units_left_out(chain, k, self.document, knowledge)
        if result is not None:
            return result, chain.sides[k - 1]
        if bad and not decision.is_proved:
            from_sound = decide(chain.sides[sound], right, sign, knowledge)
            if from_sound.is_proved or decision.status == REFUTED:
                decision, against = from_sound, chain.sides[sound]
        elif bad:
            decision = replace(decision, reason=FOLLOWS)
        head = chain.sides[0].node
        has_value = k and isinstance(head, Name) and self._is_fixed(head.name, knowledge)
        if has_value and (sign == "≈" or not decision.is_proved):
            decision, against = decide(chain.sides[0], right, "≈", knowledge), chain.sides[0]
        if decision.status == REFUTED:
            decision = self.meant.again(chain, k, knowledge) or decision
        return decision, against

    @staticmethod
    def _is_fixed(name: str, knowledge: Knowledge) -> bool:
        """Tell whether a letter has its value by its meaning, or as a coefficient of a series."""
        definition = knowledge.definitions.get(name)
        is_coefficient = definition is not None and definition.is_coefficient
        return name in knowledge.meaning.values or is_coefficient

    def _following(
        self, chain: Chain, k: int, premises: list[Premise], decision: Decision, knowledge: Knowledge
    ) -> Decision:
        """Return the decision on what is said to follow, and does not: x + y = 2, therefore x = y.

        It is refuted if one line alone speaks of its letters; several, or a number for one of them, may
        rest on what stands in words.
        """
        left, right = chain.sides[k], chain.sides[k + 1]
        by_all, _ = self._with_premises(left, right, "=", decision, knowledge)
        statement = self.definitions.premise_of(chain, k)
        by_premises = decide_by_premises(self.definitions, statement, knowledge)
        if by_premises is not None and by_premises.status != PREMISE:
            return by_premises
        if by_all.status != REFUTED:
            return by_all
        reason = f"does not follow from {lines_of(premises)}"
        is_whole = bool(names(right.node)) and any(statement.names <= p.names for p in premises)
        return replace(by_all, status=REFUTED if is_whole else UNDECIDED, reason=by_all.reason or reason)

    def _unless_stated(
        self, chain: Chain, k: int, against: Side, decision: Decision, knowledge: Knowledge
    ) -> Decision:
        """Return the decision on a refuted relation that may be a premise, a condition or a case."""
        is_solved = self._is_solved(chain, k)
        case = decide_case(chain, k, decision, knowledge, is_solved=is_solved)
        if case is not None and case.status in STATED and chain.relations[k].sign == "=":
            case = self._state(chain, k, case, knowledge)
        if case is not None and case.status != REFUTED:
            return case
        with_ratio = decide_with_ratio(against.node, chain.sides[k + 1].node, knowledge)
        return with_ratio or case or decision

    def _is_solved(self, chain: Chain, k: int) -> bool:
        """Tell whether an equation is to be solved: by the words before it, or by a value right below.

        cos θ + λ cos 2θ = 0 may be a claim; behind "where", or with θ = 76° next, it is none.
        """
        if len(chain.relations) != 1:
            return False
        own = names(chain.sides[k].node) | names(chain.sides[k + 1].node)
        if self._is_solved_next(chain, own):
            return True
        if names(chain.sides[k].node) & names(chain.sides[k + 1].node) & self._angles(chain):
            return False  # sin 2θ = 2 sin θ claims that they are the same
        if self.definitions.sections.is_condition(chain):
            return True
        following = self._next(chain)
        if following is None or self._turns_to_angle(chain, following):
            return following is not None
        return (
            len(own) == 1
            and isinstance(following.sides[0].node, Name)
            and following.sides[0].node.name in own
            and not names(following.sides[1].node)
        )

    def _turns_to_angle(self, chain: Chain, following: Chain) -> bool:
        """Tell whether a motion that has some value gives the crank angle next: x = r, so θ = π/2."""
        head, angle = chain.sides[0].node, following.sides[0].node
        moving = self.knowledge(chain.lines[0]).moving
        return (
            isinstance(head, Name)
            and head.name in moving
            and isinstance(angle, Name)
            and angle.name in self._angles(chain)
            and not names(following.sides[1].node)
            and self.definitions.sections.is_consequence(following)
        )

    def _next(self, chain: Chain) -> Chain | None:
        """Return the chain that follows in the text, if it stands near."""
        return next(chains_below(self.document.chains, chain), None)

    def _is_solved_next(self, chain: Chain, own: frozenset[str]) -> bool:
        """Tell whether an equation is solved for a letter by what follows: 8U = 4m λ ⇒ U = m λ/2."""
        following = self._next(chain)
        if following is None or not self.definitions.sections.is_consequence(following):
            return False
        head = following.sides[0].node
        both = names(chain.sides[0].node) & names(chain.sides[1].node)
        if not isinstance(head, Name) or head.name not in own - both:
            return False
        is_open = not self.knowledge(chain.lines[0]).has_meaning(head.name)
        return is_open and names(following.sides[1].node) <= own - {head.name}

    def _angles(self, chain: Chain) -> set[str]:
        letters = letters_by_role(self.declarations.symbols_at(chain.lines[0]))
        return {name for meaning in ANGLES for name in letters.get(meaning, ())}

    def _unless_open(self, chain: Chain, k: int, decision: Decision, knowledge: Knowledge) -> Decision:
        """Return the decision on a refuted relation: undecided if it may rest on what is not known."""
        left, right, line = chain.sides[k].node, chain.sides[k + 1].node, chain.lines[0]
        behind = None if k else solution_behind_arrow(self.definitions.sections, chain, knowledge)
        solved = self._as_solved(chain, behind, knowledge) or self._as_solution(chain, k)
        if solved is not None:
            return solved
        if (as_rod_angle := self.meant.rod_angle(chain, k, knowledge)) is not None:
            return as_rod_angle
        letters_here = names(left) | names(right)
        free = set(self.document.free_letters) - set(self.declarations.symbols_at(line))
        reason = ""
        unknown = [name for name in self.not_judged if name in letters_here]
        condition = self.definitions.condition_behind(decision, line)
        if unknown:
            reason = f"may rest on line {self.not_judged[unknown[0]]}, which was not judged"
        elif condition is not None:
            reason = f"may rest on line {condition}, which sets two quantities equal; give it in a scope"
        elif chain.relations[k].sign == "≈" and free & letters_here and len(letters_here) > 1:
            reason = "nobody has said which letter is small: declare what they mean"
        elif letter := self._one_sided_letter(decision, line, knowledge):
            reason = f"{letter} stands on one side only: declare what it means"
        elif chain.relations[k].sign == "=":
            reason = self._missing_meaning(left, right, line, knowledge)
        is_value = k == 0 and isinstance(left, Name) and not names(right)
        if not reason and is_value and self.definitions.sections.is_supposed(chain):
            reason = "said of what would be in a case that stands in words"
        reason = reason or self._ended_premise(chain, k, knowledge)
        reason = reason or self._count_without_meaning(chain, k, decision, knowledge)
        return replace(decision, status=UNDECIDED, reason=reason) if reason else decision

    def _as_solved(self, chain: Chain, following: Chain | None, knowledge: Knowledge) -> Decision | None:
        """Return that an equation is solved below, for a letter that has a value already: c = (…)/4.

        The value is put into it: what it comes to is the verdict on the line that gives it.
        """
        if following is None:
            return None
        head, value = following.sides[0].node, following.sides[1].node
        assert isinstance(head, Name)
        at_value = decide_with(chain.sides[0], chain.sides[1], head.name, value, knowledge)
        self.solutions[following.sides[0].span[0]] = self.definitions.premise_of(chain, 0), at_value
        return Decision(CONDITION, f"solved for {formula_text(head, plain=True)} below")

    def _as_proved_solution(self, chain: Chain, k: int) -> Decision | None:
        decision = self._as_solution(chain, k)
        return decision if decision is not None and decision.is_proved else None

    def _as_solution(self, chain: Chain, k: int) -> Decision | None:
        """Return the decision on the solution of an equation above, None for other relations."""
        solution = None if k else self.solutions.get(chain.sides[0].span[0])
        if solution is None:
            return None
        equation, at_value = solution
        if at_value.is_proved:
            return replace(at_value, assumptions=(*at_value.assumptions, equation.text))
        reason = f"does not satisfy {equation.text} of line {equation.line}"
        return replace(at_value, reason=reason if at_value.status == REFUTED else at_value.reason)

    def _ended_premise(self, chain: Chain, k: int, knowledge: Knowledge) -> str:
        """Return which premise of a section above would make a relation true, "" for none."""
        left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
        solved = solve_without_scope(self.definitions, [left.node, right.node], chain.lines[0], knowledge)
        if solved is None:
            return ""
        by_all = decide(left, right, sign, solved.knowledge)
        is_true = by_all.is_proved or (
            bool(solved.leftover) and holds_at_angles(left, right, sign, solved)
        )
        if not is_true:
            return ""
        texts = " and ".join(p.text for p in solved.premises)
        where = lines_of(solved.premises)
        return f"true if {texts}, by {where}, which holds to the end of its section; say so again"

    def _one_sided_letter(self, decision: Decision, line: int, knowledge: Knowledge) -> str:
        """Return a letter whose meaning may make a refuted relation true, as it stands on one side only.

        x = r (1 - cos u) is wrong of any u but of the crank angle, which u may be; dx/dt = v is of any x
        but the one whose speed v is.
        """
        if decision.left is None or decision.right is None:
            return ""
        free = set(self.document.free_letters) - set(self.declarations.symbols_at(line))
        for name in sorted(set(letters(decision.left)) ^ set(letters(decision.right))):
            if name in free and not knowledge.knows(name):
                return f"{formula_text(Name(name), plain=True)} is not declared and"
            if "/d" in name:  # the derivative of what no line defines
                return name
        return ""

    def _count_without_meaning(
        self, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
    ) -> str:
        """Return a letter that a page explains in words and gives a number below: N turns per minute."""
        if decision.left is None or decision.right is None:
            return ""
        below = {
            c.sides[0].node.name
            for c in self.document.chains
            if isinstance(c.sides[0].node, Name)
            and c.lines[0] > chain.lines[0]
            and len(c.sides) > 1
            and not names(c.sides[1].node)
        }
        declared = self.declarations.symbols_at(chain.lines[0])
        for name in sorted(set(letters(decision.left)) ^ set(letters(decision.right))):
            if name in below and name not in declared and not knowledge.knows(name):
                text = formula_text(Name(name), plain=True)
                return f"{text} stands on one side only: declare what it means"
        return ""

    def _missing_meaning(self, left: Formula, right: Formula, line: int, knowledge: Knowledge) -> str:
        """Return for which size of the geometry a letter without a meaning makes a relation true.

        A letter declared by other words than the known ones is just a letter, and sin β = k sin θ would
        be refuted although k is r/l by its author's words.
        """
        declared = self.declarations.symbols_at(line)
        for name in sorted(names(left) | names(right)):
            if role_of(declared.get(name, KNOWN[0])) in KNOWN or knowledge.knows(name):
                continue
            if knowledge.meaning.values.keys().isdisjoint(names(left) | names(right)):
                continue
            size = constraints.size_of(left, right, name, knowledge)
            if size is not None:
                letter, text = (formula_text(node, plain=True) for node in (Name(name), size))
                return f"true if {letter} = {text}: declare what {letter} means"
        return ""

    def _fixed(self, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
        """Return the decision on a relation that is no step but fixes a letter; None for others."""
        in_use, used = self.definitions.letters_before(chain.lines[0]), self.definitions.first_lines
        in_use = in_use - self._explained_letter(chain, k)
        constraint = constraints.constraint_of(chain, k, in_use, used, knowledge)
        return None if constraint is None else self._fix(constraint, chain, k, knowledge)

    def _explained_letter(self, chain: Chain, k: int) -> frozenset[str]:
        """Return the letter that a relation says what it is right behind its first use.

        x = r (1 - cos θ) + l (1 - cos β), in which sin β = λ sin θ: β alone stands left, and nowhere else
        but in the formula before.
        """
        own = names(chain.sides[k].node)
        before = [c for c in self.document.chains if c.sides[0].span[0] < chain.sides[0].span[0]]
        if k or len(own) != 1 or not before:
            return frozenset()
        *earlier, last = sorted(before, key=lambda c: c.sides[0].span[0])
        is_first_use = not any(own <= _letters_of(c) for c in earlier)
        is_near = own <= _letters_of(last) and chain.lines[0] <= last.lines[-1] + NEAR
        return own if is_first_use and is_near and not self._is_declared(own, chain) else frozenset()

    def _is_declared(self, letters_here: frozenset[str], chain: Chain) -> bool:
        return bool(letters_here & self.declarations.symbols_at(chain.lines[0]).keys())

    def _fixed_matrix(self, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
        """Return the decision on a relation of matrices that fixes a letter, after defining it.

        It does not join the premises: those are solved as numbers are, whose products commute.
        """
        left, right = chain.sides[k].node, chain.sides[k + 1].node
        stated = matrix_constraint(left, right, self.definitions.letters_in_use, knowledge)
        if stated is None:
            entries = _new_entries(left, right, knowledge)
            for letter, value in entries:
                self.definitions.define(letter, value, chain)
            return Decision(CONDITION, "entry by entry") if entries else None
        name, _ = stated
        if name in knowledge.meaning.kinds.identities:
            if _is_commutator(left) or _is_commutator(right):
                return Decision(REFUTED, "the trace of AB - BA is 0, that of the identity is not")
            return Decision(CONDITION, f"{name} is the identity: a condition on the others")
        self.definitions.define(*stated, chain)
        return Decision(DEFINITION, f"read as what fixes {name}")

    def _fix(self, constraint: Constraint, chain: Chain, k: int, knowledge: Knowledge) -> Decision:
        """Return the decision on a relation that fixes a letter, after defining it."""
        by_premises = decide_by_premises(
            self.definitions, self.definitions.premise_of(chain, k), knowledge
        )
        if by_premises is not None and by_premises.status == CONTRADICTION:
            return by_premises
        if constraint.is_circular:
            as_step = decide(chain.sides[k], chain.sides[k + 1], "=", knowledge)
            sides = [form for form in (as_step.left, as_step.right) if form is not None]
            if (
                as_step.status == REFUTED
                and sides
                and all(constraint.name not in letters(f) for f in sides)
            ):
                return as_step  # the letter cancels: nothing is fixed
            self.definitions.state(chain, k)
            return Decision(DEFINITION, f"read as what fixes {constraint.name}, with an equation before")
        self.definitions.fix(constraint, chain)
        self.definitions.state(chain, k, constraint.name)
        if not names(chain.sides[k + 1].node) and len(names(chain.sides[k].node)) == 1:
            return Decision(CONDITION)
        as_rod_angle = self.meant.rod_angle(chain, k, knowledge)
        return as_rod_angle or Decision(DEFINITION, f"read as what fixes {constraint.name}")

    def _state(self, chain: Chain, k: int, case: Decision, knowledge: Knowledge) -> Decision:
        """Return the decision on a relation that is taken as given, after noting it."""
        by_premises = decide_by_premises(
            self.definitions, self.definitions.premise_of(chain, k), knowledge
        )
        if by_premises is not None and by_premises.status != PREMISE:
            return by_premises
        self.definitions.state(chain, k, angles=knowledge.angles)
        return case

    def _with_premises(
        self, left: Side, right: Side, sign: str, decision: Decision, knowledge: Knowledge
    ) -> tuple[Decision, bool]:
        """Return the decision with the premises solved together: a witness must satisfy them all.

        Also whether it is undecided for what could not be solved, and may be one more equation.
        """
        nodes = [left.node, right.node]
        solved = solve_premises(self.definitions, nodes, self.document.line_of(right.span[0]), knowledge)
        if solved is None:
            return decision, False
        by_all = decide(left, right, sign, solved.knowledge)
        if by_all.status != REFUTED or not solved.leftover:
            return by_all, False
        at_solution = refuted_at_angles(left, right, sign, solved)
        if at_solution is not None or not concerns(solved, by_all):
            return at_solution or by_all, False
        given = lines_of(solved.premises)
        answer = implied(solved.premises, left.node, right.node, knowledge) if sign == "=" else None
        if answer:
            texts = solved.knowledge.solved_from
            decided = Decision(PROVED, f"by {given}", assumptions=texts, level=by_all.level)
        elif answer is False:
            reason = f"no values satisfy it together with {given}"
            decided = replace(by_all, reason=reason, witness={})
        elif branched := decide_on_branches(left, right, sign, solved.leftover, knowledge):
            return branched, False
        else:
            reason = f"may rest on {lines_of(solved.leftover)}, which could not be solved for a letter"
            decided = replace(by_all, status=UNDECIDED, reason=reason)
        return decided, answer is None

    def _with_letters_below(
        self, chain: Chain, k: int, decision: Decision, knowledge: Knowledge
    ) -> Decision:
        """Return the decision with the new letters that the lines right below a relation explain.

        a = r ω²(cos θ + B_2 cos 2θ), where B_2 = λ + …: before that B_2 is a letter. Where it does not
        come out, one of those lines may be wrong as well: nothing is said.
        """
        left, right = chain.sides[k], chain.sides[k + 1]
        below = self._letters_below(chain, names(left.node) | names(right.node), knowledge)
        if not below:
            return decision
        known = replace(knowledge, definitions={**knowledge.definitions, **below})
        sign = chain.relations[k].sign
        with_all = decide(left, right, sign, known)
        if not with_all.is_proved:
            with_all = decide(left, right, "≈", known)
        if with_all.is_proved:
            return with_all
        if self._is_false_for_any(left.node, right.node, frozenset(below), decision, knowledge):
            return decision
        texts = ", ".join(formula_text(Name(name), plain=True) for name in sorted(below))
        reason = f"not true with {texts} as the lines below have it"
        return replace(decision, status=UNDECIDED, reason=reason)

    @staticmethod
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
        shown = {generators[g].content for power in powers for g, _ in power}
        return len(powers) == 1 and inner <= shown

    def _letters_below(
        self, chain: Chain, own: frozenset[str], knowledge: Knowledge
    ) -> dict[str, Definition]:
        """Return the new letters of a relation that the lines right below it define."""
        last, found = chain.lines[-1], dict[str, Definition]()
        before = self.definitions.letters_in_use
        for other in self.document.chains:
            head = other.sides[0].node
            is_after = (
                other.sides[0].span[0] > chain.sides[-1].span[0] and other.lines[0] <= last + CLAUSES
            )
            is_below = is_after and bool(other.relations)
            if not is_below or not isinstance(head, Name) or other.relations[0].sign not in "=≈":
                continue
            is_new = head.name in own - before and not knowledge.has_meaning(head.name)
            is_new = is_new and bool(names(other.sides[1].node))  # a number is an example's
            if is_new and head.name not in found and head.name not in names(other.sides[1].node):
                found[head.name] = Definition(without_dots(other.sides[1].node)[0], other.lines[0])
        return found

    def _with_clauses_below(self, chain: Chain, k: int, knowledge: Knowledge) -> Knowledge:
        """Return what is known with the new letters that the lines right below a relation explain.

        An equation in matrices stands first as a rule, what its letters are after it: "here M̃ = ΦᵗMΦ".
        """
        if not is_of_matrices(chain.sides[k].node, chain.sides[k + 1].node, knowledge):
            return knowledge
        last = chain.lines[-1]
        own = {name for side in chain.sides for name in names(side.node)}
        clauses = dict(knowledge.definitions)
        for other in self.document.chains:
            head = other.sides[0].node
            is_below = last < other.lines[0] <= last + CLAUSES and bool(other.relations)
            if not is_below or not isinstance(head, Name) or other.relations[0].sign != "=":
                continue
            is_new = head.name in own and not knowledge.knows(head.name)
            if is_new and head.name not in clauses and head.name not in names(other.sides[1].node):
                clauses[head.name] = Definition(other.sides[1].node, other.lines[0])
        return replace(knowledge, definitions=clauses)

    def add_fix(
        self, verdict: Verdict, chain: Chain, k: int, left: Side, decision: Decision, knowledge: Knowledge
    ) -> Verdict:
        """Return the verdict with the change that would make its relation true, on either side."""
        right, sign = chain.sides[k + 1], chain.relations[k].sign
        as_written = "≈" if left is not chain.sides[k] else sign

        def proves_right(node: Formula) -> bool:
            return is_proved_as_far(
                decide(left, Side((node,), right.span), as_written, knowledge), decision
            )

        def proves_left(node: Formula) -> bool:
            return is_proved_as_far(
                decide(Side((node,), left.span), right, as_written, knowledge), decision
            )

        # What stood right of the relation before was said there: the slip is in what is new.
        is_old = k > 0 or isinstance(left.node, Name)
        of_left = None if is_old else proves_left
        return add_fix(
            verdict, self.document, right, decision, knowledge, proves_right, chain.sides[k], of_left
        )


def _letters_of(chain: Chain) -> frozenset[str]:
    return frozenset(name for side in chain.sides for name in names(side.node))


def _new_entries(left: Formula, right: Formula, knowledge: Knowledge) -> list[tuple[str, Formula]]:
    """Return the letters without values that a vector of them gives numbers: (x, y) = (1, 2)."""
    if not isinstance(left, Matrix) or not isinstance(right, Matrix) or names(right):
        return []
    if [len(row) for row in left.rows] != [len(row) for row in right.rows]:
        return []
    first, second = (sum(m.rows, ()) for m in (left, right))
    own = [node.name for node in first if isinstance(node, Name) and not knowledge.has_meaning(node.name)]
    if not len(own) == len(first) == len(set(own)):
        return []
    return list(zip(own, second, strict=True))


def _is_commutator(node: Formula) -> bool:
    """Tell whether a formula is A B - B A."""
    if not isinstance(node, Sum) or len(node.terms) != 2 or not isinstance(node.terms[1], Negative):
        return False
    first, second = node.terms[0], node.terms[1].operand
    if not isinstance(first, Product) or not isinstance(second, Product):
        return False
    return len(first.factors) == 2 and first.factors == second.factors[::-1]


def _no_relation_of_matrices(sign: str, left: Side, right: Side, knowledge: Knowledge) -> str:
    """Return why a relation cannot be one between matrices, "" where it may be."""
    if sign in SATISFIED_BY:
        return "matrices are compared for equality only"
    return meaningless(left.node, right.node, knowledge)


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
            return "" if is_letter else ", ".join(formula_text(Constant(n), plain=True) for n in chosen)
    return ""


def _is_refuted(outcome: Verdict | Decision) -> bool:
    status = outcome.status if isinstance(outcome, Decision) else outcome.verdict
    return status in (REFUTED, CONTRADICTION)


def _is_proved(outcome: Verdict | Decision) -> bool:
    return outcome.is_proved if isinstance(outcome, Decision) else outcome.verdict in PROVED_WORDS


def _turned(node: Formula) -> frozenset[str]:
    """Return the letters within sines and cosines, angles though nobody has declared them."""
    calls = (part for part in walk(node) if isinstance(part, Call) and part.function in ("sin", "cos"))
    return frozenset(name for call in calls for name in names(call.argument))


def _is_undecided(outcome: Verdict | Decision) -> bool:
    status = outcome.status if isinstance(outcome, Decision) else outcome.verdict
    return status == UNDECIDED


def _counts(document: ReadNotes) -> dict[str, str]:
    """Return the letters that sums run to: integers, where nobody declared them anything else."""
    sums = (
        part
        for chain in document.chains
        for side in chain.sides
        for part in walk(side.node)
        if isinstance(part, Summation) and part.upper is not None
    )
    ends = {name for total in sums if total.upper is not None for name in names(total.upper)}
    return dict.fromkeys(sorted(ends), "integer")


def _lone_letters(chain: Chain, k: int) -> Iterator[str]:
    """Yield the letters that the k-th relation of a chain may define."""
    for side in (chain.sides[0], chain.sides[k], chain.sides[k + 1]):
        if isinstance(side.node, Name):
            yield side.node.name


def number_verdicts(verdicts: list[Verdict]) -> Iterator[Verdict]:
    """Yield the verdicts in the order of the text; `link` counts those on one line."""
    count, line = 0, 0
    for verdict in sorted(verdicts, key=lambda v: (v.line, bool(v.piece), v.span, v.link)):
        count = count + 1 if verdict.line == line else 1
        line = verdict.line
        yield replace(verdict, link=count)


def read_assumption(text: str, letters: frozenset[str], place: str) -> Assumption:
    """Return an assumption of the sidecar, solved for a letter."""
    try:
        chain = read_equation(text, letters)
    except ReadingError as problem:
        raise SymbalanceError(f"given = {text}", problem.what, problem.remedy, place) from None
    if len(chain.sides) == 2 and chain.relations[0].sign == "=":
        solution = constraints.solve(chain.sides[0].node, chain.sides[1].node)
        if solution is not None:
            return Assumption(text, *solution)
    raise SymbalanceError(
        f"given = {text}", "must be an equality that fixes a letter", 'write "α = π/6"', place
    )


def decide_with(left: Side, right: Side, name: str, value: Formula, knowledge: Knowledge) -> Decision:
    """Decide whether two sides are equal with a value put in for a letter."""
    try:
        sides = [
            replace(side, readings=tuple(substitute(node, name, value) for node in side.readings))
            for side in (left, right)
        ]
    except NoFormError as problem:
        return Decision(UNDECIDED, str(problem))
    return decide(sides[0], sides[1], "=", knowledge)


def _demanded(relation: Relation) -> Decision | None:
    """Return that a relation with an exclamation mark above only demands something."""
    return Decision(CONDITION, "demanded, to be solved") if relation.is_demanded else None
