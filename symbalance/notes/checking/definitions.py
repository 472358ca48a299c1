"""Letters that a document has defined so far, with their values, each as far as its scope reaches."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import pi
from typing import Any

from symbalance.document.formula import (
    Apply,
    Cases,
    Constant,
    Derivative,
    Evaluation,
    Extremum,
    Formula,
    Integral,
    Limit,
    Matrix,
    Name,
    Negative,
    Number,
    PlusMinus,
    Product,
    Sum,
    children,
    names,
    walk,
)
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import Domain, NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator, SymbolValue
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.algebra.tree_values import letters_behind, names_behind, sample_trees
from symbalance.notes.algebra.values import context, letters, sample
from symbalance.notes.checking.angles_at import changes_sign_nearby, is_round_angle, solves_as_printed
from symbalance.notes.checking.constraints import Constraint, letter_counts, solve_for
from symbalance.notes.checking.deciding.branches import with_sign
from symbalance.notes.checking.deciding.equality import (
    PROVED,
    REFUTED,
    UNDECIDED,
    Decision,
    decide_equality,
    without_dots,
)
from symbalance.notes.checking.deciding.inequalities import compare, possible_branches
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge, StatedRange
from symbalance.notes.checking.deciding.matrix_relations import is_of_matrices
from symbalance.notes.checking.deciding.relations import decide, written_out
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.checking.premises import (
    EVERYWHERE,
    Elimination,
    Premise,
    eliminate,
    has_decimals,
    implied,
    related,
)
from symbalance.notes.checking.sections import Sections
from symbalance.notes.checking.sidecar import Declarations
from symbalance.notes.checking.symbol_roles import CONSTANT, MOVING, role_of
from symbalance.notes.checking.verdicts import (
    CONDITION,
    CONTRADICTION,
    DEFINITION,
    PREMISE,
    RANGE,
    STATED,
)
from symbalance.notes.reading.equations import Chain, Side

NEARLY = 0.1
"""Relative difference: a second value closer to the first is a slip, not a new case."""
_OF_A_POINT = (Apply, Evaluation, Extremum, Integral, Limit)
"""Parts of a side that computes something of what is known, and is no value of a size."""
_OF_CRANK_ANGLE = (*MOVING, "rod angle")
"""What a condition such as v = 0 is solved for the crank angle with."""
WHOLE = 1e-15
"""Difference from an integer, or from 0, that is one of computing: numbers have more digits than that."""


@dataclass(frozen=True, slots=True)
class Entry:
    """A letter's definition, the scopes of the sidecar it stands in, and the last line it reaches."""

    definition: Definition
    scopes: tuple[int, ...]
    last_line: int | None = None


@dataclass(frozen=True, slots=True)
class Solved:
    """What is known with premises solved, and the premises that no letter could be solved from."""

    knowledge: Knowledge
    leftover: tuple[Premise, ...]
    premises: tuple[Premise, ...] = ()


@dataclass(frozen=True, slots=True)
class OpenCase:
    """A case that a relation opens (for θ = 0): its letters, its line, and its place in the text."""

    letters: frozenset[str]
    line: int
    start: int


@dataclass
class Definitions:
    """The letters a document has given values, those it has used at all, and what it takes as given."""

    declarations: Declarations
    sections: Sections
    values: dict[str, list[Entry]] = field(default_factory=dict)
    first_lines: dict[str, int] = field(default_factory=dict)
    """The letters in use, each with the line on which it first stands."""
    conditions: dict[int, frozenset[str]] = field(default_factory=dict)
    """Lines that set two known quantities equal, with the letters these come down to."""
    ranges: list[StatedRange] = field(default_factory=list)
    premises: list[Premise] = field(default_factory=list)
    cases: list[OpenCase] = field(default_factory=list)
    open_conditions: dict[str, Premise] = field(default_factory=dict)
    """Conditions on one angle that were stated last: a value given to it next is their solution."""
    _branches: dict[tuple[str, int, int], Definition] = field(default_factory=dict)
    _solved_from: dict[str, tuple[int, dict[str, Formula | None]]] = field(default_factory=dict)
    """Letters whose number was solved for, with the line and the values of the letters it rests on."""

    def at(self, line: int) -> dict[str, Definition]:
        """Return the definitions that reach a line, of the letters as declared there."""
        scopes_here, owner = set(self.declarations.scope_at(line)), self.declarations.owner
        reaching: dict[str, Definition] = {}
        for name, entries in self.values.items():
            for entry in reversed(entries):
                if (
                    set(entry.scopes) <= scopes_here
                    and (entry.last_line is None or line <= entry.last_line)
                    and owner(name, entry.definition.line) == owner(name, line)
                ):
                    last = reaching.setdefault(name, entry.definition)
                    if not last.numeric:
                        break
                    if not entry.definition.numeric:
                        reaching[name] = replace(last, formula=entry.definition.node)
                        break
        return reaching

    def define(self, name: str, node: Formula, chain: Chain, last: int | None = None) -> bool:
        """Define a letter's value from here on; tell whether its sentence makes it a premise.

        "Take r = 1" reaches its section, and what rests on it is conditional. No value reaches
        further than the line `last`.
        """
        line, last_line = chain.lines[0], self.sections.premise_end(chain, is_number=not names(node))
        is_zero = isinstance(node, Number) and not node.value
        # where a letter is 0 nearly all is true: what rests on that says so
        text = f"{plain(Name(name))} = {plain(node)}" if last_line is not None or is_zero else ""
        is_rough = chain.relations[0].sign == "≈" or any(without_dots(s.node)[1] for s in chain.sides)
        definition = Definition(node, line, not names(node), text, is_rough=is_rough)
        end = self._end_of_place(Name(name), line) if last_line is None and not names(node) else last_line
        if is_zero and name in self.letters_before(line):
            last = min(last or self.sections.section_end(line), self.sections.section_end(line))
        end = min((n for n in (end, last) if n is not None), default=None)
        self._add(name, Entry(definition, self.declarations.scope_at(line), end))
        self._note_case(chain, frozenset({name}))
        return last_line is not None

    def fix(self, constraint: Constraint, chain: Chain) -> None:
        """Define a letter that a relation fixes, perhaps on one branch of several."""
        line, node = chain.lines[0], constraint.node
        definition = Definition(
            node,
            line,
            not names(node),
            alternatives=constraint.alternatives,
            solved=True,
            branch=constraint.branch if constraint.alternatives else "",
        )
        scopes = self.declarations.scope_at(line)
        last_line = self.sections.premise_end(chain, is_number=not names(node))
        self._add(constraint.name, Entry(definition, scopes, last_line))

    def forget(self, name: str, line: int) -> None:
        """Forget the value that a line gave a letter, which cannot be: what follows is of another one."""
        entries = [e for e in self.values.pop(name, []) if e.definition.line != line]
        if entries:
            self.values[name] = entries

    def fix_coefficients(self, values: Mapping[str, Formula], chain: Chain) -> None:
        """Define the letters that a series has as its coefficients."""
        line = chain.lines[0]
        for name, node in values.items():
            definition = Definition(node, line, is_coefficient=True)
            self._add(name, Entry(definition, self.declarations.scope_at(line)))

    def round(self, name: str, chain: Chain, node: Formula) -> None:
        """Note how a letter's value is printed in the line that defines it: v = 2π·100 = 628.3."""
        entries = self.values.get(name, [])
        if names(node) or not entries or entries[-1].definition.line != chain.lines[0]:
            return
        number = node.operand if isinstance(node, Negative) else node
        if isinstance(number, Number) and number.last_place is None:
            number = Number(number.value, Fraction(1), span=number.span)
            node = Negative(number) if isinstance(node, Negative) else number
        if decimals(node):
            definition = replace(entries[-1].definition, rounded=node)
            entries[-1] = replace(entries[-1], definition=definition)

    def _add(self, name: str, entry: Entry) -> None:
        self.values.setdefault(name, []).append(entry)

    def ranges_at(self, line: int) -> list[StatedRange]:
        """Return the ranges that reach a line."""
        return [
            r
            for r in self.ranges
            if self._reaches(r.line, line, names(r.left) | names(r.right))
            and (r.last_line is None or line <= r.last_line)
        ]

    def premises_at(self, line: int) -> list[Premise]:
        """Return the equations taken as given that reach a line."""
        return [p for p in self.premises if self._reaches(p.line, line, p.names) and line <= p.last_line]

    def state_range(self, chain: Chain, k: int, decision: Decision) -> None:
        """Note a range that a relation states; one that is empty states nothing."""
        left, right = chain.sides[k].node, chain.sides[k + 1].node
        if decision.status == REFUTED:
            self.ranges = [r for r in self.ranges if r.right is not left]
        if decision.status == RANGE:
            line, is_aside = chain.lines[0], self.sections.is_in_brackets(chain)
            last = max(chain.lines) if is_aside else None
            self.ranges.append(StatedRange(left, chain.relations[k].sign, right, line, last))
            self._note_case(chain, names(left) | names(right))

    def forget_range(self, chain: Chain) -> None:
        """Forget the range that a relation stated, which is refuted."""
        left, right = chain.sides[0].node, chain.sides[-1].node
        self.ranges = [r for r in self.ranges if r.left is not left or r.right is not right]

    def state(self, chain: Chain, k: int, fixes: str = "", angles: frozenset[str] = frozenset()) -> None:
        """Note an equation that is taken as given, and the letter it fixes.

        On angles alone it says at which of them something is looked at (largest where cos 2θ = 1), and
        reaches to the end of its section; on one of them, cos θ + λ cos 2θ = 0, to that of its item.
        """
        premise = replace(self.premise_of(chain, k), fixes=fixes)
        symbols = self.declarations.symbols_at(premise.line)
        roles = {role_of(symbols.get(n, "")) for n in premise.names}
        is_motion = bool(roles & {*_OF_CRANK_ANGLE}) and roles <= {*_OF_CRANK_ANGLE, *CONSTANT}
        is_moment = (
            len(premise.names & angles) == 1
            and not names(premise.right)
            and roles <= {*_OF_CRANK_ANGLE, *CONSTANT, "crank angle"}
        )
        if is_moment or premise.names <= angles:
            end = (self.sections.moment_end if is_moment else self.sections.section_end)(premise.line)
            premise = replace(premise, last_line=min(premise.last_line, end))
        self.premises.append(premise)
        turned = [n for n, text in symbols.items() if is_motion and role_of(text) == "crank angle"]
        for name in {*(premise.names & angles), *turned}:
            self.open_conditions[name] = premise

    def forget_moment(self, value: Formula) -> None:
        """Forget a refuted number that a relation gave what moves: no angle follows from it."""
        self.premises = [p for p in self.premises if p.right is not value]
        self.open_conditions = {n: p for n, p in self.open_conditions.items() if p.right is not value}

    def past_cases(self, line: int, angles: frozenset[str]) -> frozenset[int]:
        """Return the lines that put an angle in, θ = 90°, whose paragraph ends before a line."""
        entries = (e.definition for name in angles for e in self.values.get(name, ()))
        lines = {d.line for d in entries if d.assumption or d.numeric}
        lines |= {p.line for p in self.premises if p.names <= angles}
        return frozenset(case for case in lines if self.sections.case_end(case) < line)

    def _note_case(self, chain: Chain, letters_of_it: frozenset[str]) -> None:
        if self.sections.opens_case(chain):
            start = min(side.span[0] for side in chain.sides)
            self.cases.append(OpenCase(letters_of_it, chain.lines[0], start))

    def cases_left_by(self, chain: Chain, angles: frozenset[str]) -> list[OpenCase]:
        """Return the cases that a relation is claimed beyond, which is said to be true of all values."""
        if not self.cases:
            return []
        letters_of_cases = {name: name in angles for case in self.cases for name in case.letters}
        spoken = self.sections.spoken_of_generally(chain, letters_of_cases)
        return [
            case
            for case in self.cases
            if case.letters & spoken and not self.sections.stands_in_clause(case.start, chain)
        ]

    def lines_of_numbers(self, letters_of_all: frozenset[str]) -> frozenset[int]:
        """Return the lines that give letters numbers; what is said of all their values rests on none."""
        entries = (entry.definition for name in letters_of_all for entry in self.values.get(name, ()))
        return frozenset(definition.line for definition in entries if definition.numeric)

    def cases_replaced_by(self, chain: Chain) -> list[OpenCase]:
        """Return the earlier cases of the letters of a relation that opens a case of its own."""
        own = {name for side in chain.sides for name in names(side.node)}
        start = min(side.span[0] for side in chain.sides)
        if not self.sections.opens_case(chain):
            return []
        return [case for case in self.cases if case.start < start and case.letters & own]

    def end_cases(self, ended: list[OpenCase], start: int) -> None:
        """Forget for good the cases among these that were opened before a place in the text."""
        for case in ended:
            if case.start >= start:
                continue
            self.cases.remove(case)
            self.premises = [
                p for p in self.premises if not (p.line == case.line and p.names <= case.letters)
            ]
            self.ranges = [
                r
                for r in self.ranges
                if not (r.line == case.line and names(r.left) | names(r.right) <= case.letters)
            ]
            for name in case.letters & self.values.keys():
                self.values[name] = [
                    e
                    for e in self.values[name]
                    if e.definition.line != case.line or not e.definition.assumption
                ]
                if not self.values[name]:
                    del self.values[name]

    @contextmanager
    def without_cases(self, lines: frozenset[int], angles: frozenset[str]) -> Iterator[None]:
        """Leave out for a while what lines say of angles: a reader may have left the case."""
        apart = [p for p in self.premises if p.line in lines and p.names <= angles]
        self.premises = [p for p in self.premises if p not in apart]
        ranges = self.ranges
        self.ranges = [
            r for r in ranges if r.line not in lines or not names(r.left) | names(r.right) <= angles
        ]
        hidden: dict[str, list[Entry]] = {}
        for name in angles & self.values.keys():
            entries = self.values.pop(name)
            hidden[name] = [e for e in entries if e.definition.line in lines]
            if rest := [e for e in entries if e.definition.line not in lines]:
                self.values[name] = rest
        fewer = list(self.ranges)
        try:
            yield
        finally:
            new = [r for r in self.ranges if all(r is not other for other in fewer)]
            self.ranges = [r for r in ranges if r in self.ranges or r not in fewer] + new
            self.premises = sorted([*apart, *self.premises], key=lambda premise: premise.line)
            for name, entries in hidden.items():
                whole = [*entries, *self.values.get(name, [])]
                if whole:
                    self.values[name] = sorted(whole, key=lambda entry: entry.definition.line)

    def premise_of(self, chain: Chain, k: int) -> Premise:
        """Return a relation of a chain as a premise, with its reach."""
        left, right = chain.sides[k].node, chain.sides[k + 1].node
        last_line = self.sections.premise_end(chain, is_number=not names(right))
        if last_line is None and not names(right):
            last_line = self._end_of_place(left, chain.lines[0])
        return Premise(left, right, chain.lines[0], EVERYWHERE if last_line is None else last_line)

    def _end_of_place(self, node: Formula, line: int) -> int | None:
        """Return where the angle ends at which a formula has a value: x = 6.71 at θ = 90° of item b)."""
        values = {name: entries[-1].definition.node for name, entries in self.values.items()}
        for name in {*names(node), *names_behind(node, values)} & set(self.values):
            for entry in self.values[name]:
                first, last = entry.definition.line, entry.last_line
                if last is not None and first <= line <= last < self.sections.section_end(first):
                    return last
        return None

    def on_stated_branches(self, knowledge: Knowledge) -> Knowledge:
        """Return what is known where ranges have said on which branch a letter lies; each is kept."""
        for name, definition in knowledge.definitions.items():
            concerned = [r for r in knowledge.ranges if name in names(r.left) | names(r.right)]
            if definition.alternatives and concerned:
                key = (name, definition.line, len(concerned))
                if key not in self._branches:
                    self._branches[key] = possible_branches(name, definition, knowledge)
                knowledge = knowledge.with_definition(name, self._branches[key])
        return knowledge

    def _reaches(self, own_line: int, line: int, letters_of_it: frozenset[str]) -> bool:
        """Tell whether what a line states is in scope at another, its letters being the same there."""
        declared = self.declarations
        return set(declared.scope_at(own_line)) <= set(declared.scope_at(line)) and all(
            declared.owner(name, own_line) == declared.owner(name, line) for name in letters_of_it
        )

    def use(self, chain: Chain) -> None:
        """Note the letters of a chain; one on other letters ends the solving of a condition."""
        own = {name for side in chain.sides for name in names(side.node)}
        for name in own:
            self.first_lines.setdefault(name, chain.lines[0])
        line = chain.lines[0]
        self.open_conditions = {
            name: premise
            for name, premise in self.open_conditions.items()
            if (premise.line == line or own == {name}) and line <= premise.last_line
        }

    @property
    def letters_in_use(self) -> set[str]:
        """The letters that stand in the document so far."""
        return set(self.first_lines)

    def letters_before(self, line: int) -> set[str]:
        """Return the letters in use before a line's paragraph: equations of one display are a system."""
        start = self.sections.paragraph_start(line)
        return {name for name, first in self.first_lines.items() if first < start}

    def condition_behind(self, decision: Decision, line: int) -> int | None:
        """Return the line of a condition that a refuted relation may rest on: it shares two letters."""
        if decision.left is None or decision.right is None:
            return None
        own_letters = {*letters(decision.left), *letters(decision.right)}
        lines = [
            n
            for n, condition_letters in self.conditions.items()
            if n < line and len(own_letters & condition_letters) > 1
        ]
        return lines[-1] if lines else None

    def define_by(self, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
        """Return the decision on a relation that gives a letter its value, after defining it."""
        pair = self._letter_defined(chain, k)
        if pair is None or knowledge.assumes(pair[0]):
            return None
        name, value = pair
        if k == 0 and chain.inline and not names(value) and self.sections.is_denied(chain):
            return Decision(CONDITION, "named as what is left out")
        is_result = chain.sides[k].node is value
        is_of_point = is_result and knowledge.measures(name) and _is_at_a_point(value)
        if is_of_point or name in knowledge.meaning.kinds.identities:
            return None  # min x = r claims something
        outside = outside_meaning(name, value, knowledge, is_result=is_result)
        if outside is not None and chain.relations[k].sign == "=":
            return outside
        if name in knowledge.meaning.values:
            contradiction = self._against_law(name, value, chain, knowledge)
            return contradiction or self._define_size(name, value, chain, knowledge)
        solution = self._solves_condition(name, value, chain, k, knowledge)
        is_settled = solution is not None or self._may_be_wrong(name, value, chain, k, knowledge)
        return solution if is_settled else self._define(name, value, chain, k, knowledge)

    def _solves_condition(
        self, name: str, value: Formula, chain: Chain, k: int, knowledge: Knowledge
    ) -> Decision | None:
        """Return the decision on an angle that is said to follow from the condition right before it.

        cos θ = 0.25, so θ = 75.5°: it is one of the solutions to the digits printed, or it is none.
        """
        condition = self.open_conditions.get(name)
        if condition is None or k or names(value) or not self.sections.is_consequence(chain):
            return None
        violated = self._no_solution(name, value, chain, k, knowledge)
        is_solution = solves_as_printed(condition, name, value, knowledge)
        text = f"{plain(condition.left)} = {plain(condition.right)} of line {condition.line}"
        if violated is not None or is_solution is None:
            return violated
        if is_solution:
            return Decision(CONDITION, f"solves {text}")
        if decimals(value) and chain.relations[0].sign == "=":
            return Decision(UNDECIDED, f"near a solution of {text}, but none to the digits printed")
        return None  # 76° is said of 75.96°

    def _against_law(
        self, name: str, value: Formula, chain: Chain, knowledge: Knowledge
    ) -> Decision | None:
        """Return the contradiction between a number and what premises give by a letter's law: λ = r/l."""
        if names(value) or self.sections.opens_case(chain):
            return None
        statement = Premise(knowledge.meaning.values[name], value, chain.lines[0])
        decision = self.decide_by_premises(statement, knowledge)
        return decision if decision is not None and decision.status == CONTRADICTION else None

    def _may_be_wrong(
        self, name: str, value: Formula, chain: Chain, k: int, knowledge: Knowledge
    ) -> bool:
        """Tell whether a relation between a letter and a value is a claim, not its definition."""
        # λ = 2l/r says something of the geometry, and x = y, y = x + 1 nothing new: both may be wrong.
        says_of_geometry = knowledge.measures(name) and name in _letters_of(value, knowledge)
        if says_of_geometry or self._is_circular(name, value, chain.lines[0], knowledge):
            return True
        if not self.must_follow(chain, k):
            return False
        by_premises = self.decide_by_premises(self.premise_of(chain, k), knowledge)
        return by_premises is None or by_premises.status != PREMISE

    def _define(
        self, name: str, value: Formula, chain: Chain, k: int, knowledge: Knowledge
    ) -> Decision | None:
        """Return the decision on a letter's value: of a condition, another one, or its first."""
        violated = self._no_solution(name, value, chain, k, knowledge) if knowledge.angles else None
        if violated is not None:
            return violated
        if name in knowledge.definitions:
            return self._redefine(name, value, chain, k, knowledge)
        return refuse_value(name, value, knowledge) or self._define_first(name, value, chain, knowledge)

    def must_follow(self, chain: Chain, k: int) -> list[Premise]:
        """Return the premises that a relation is said to follow from: therefore x = y.

        It is one if it stands behind such a word, and all its letters stand in what is taken as given.
        """
        own = names(chain.sides[k].node) | names(chain.sides[k + 1].node)
        if k or not own or chain.relations[k].sign != "=" or not self.sections.is_consequence(chain):
            return []
        given = [p for p in self.premises_at(chain.lines[0]) if own & p.names and not has_decimals(p)]
        return given if own <= {name for p in given for name in p.names} else []

    def _no_solution(
        self, name: str, value: Formula, chain: Chain, k: int, knowledge: Knowledge
    ) -> Decision | None:
        """Return the contradiction between the value of an angle and the condition solved by it."""
        condition = self.open_conditions.get(name)
        line = chain.lines[0]
        if condition is None or names(value) - names(condition.left) - names(condition.right):
            return None
        if condition.line > line or self.sections.premise_end(chain, is_number=True) is not None:
            return None
        sides = condition.left, condition.right
        try:
            if name not in condition.names:
                sides = tuple(written_out(node, knowledge, name) for node in sides)
            at_value = [substitute(node, name, value) for node in sides]
        except (NoFormError, TooLargeError):
            return None
        written = replace(condition, left=sides[0], right=sides[1])
        decision = decide(_side(at_value[0]), _side(at_value[1]), "=", knowledge)
        if decision.status != REFUTED:
            return None
        is_rounded = chain.relations[k].sign == "≈" or bool(decimals(value)) or not is_round_angle(value)
        # x = r at θ = π/2, but for what the rod's length adds
        is_nearly = name not in condition.names and bool(names(condition.right))
        if (is_rounded and changes_sign_nearby(written, name, value, knowledge)) or (
            is_nearly and decide(_side(at_value[0]), _side(at_value[1]), "≈", knowledge).is_proved
        ):
            return None
        text = f"{plain(condition.left)} = {plain(condition.right)}"
        reason = f"does not satisfy {text} of line {condition.line}"
        return replace(decision, status=REFUTED, reason=reason)

    def _define_first(self, name: str, value: Formula, chain: Chain, knowledge: Knowledge) -> Decision:
        """Return the decision on a letter's first value, which premises and ranges may contradict."""
        bare, line = without_dots(value)[0], chain.lines[0]
        by_premises = self.decide_by_premises(Premise(Name(name), bare, line), knowledge)
        if by_premises is not None and by_premises.status not in STATED:
            return by_premises
        contradiction = self._outside_range(name, bare, line, knowledge)
        if contradiction is not None:
            return contradiction
        is_premise = self.define(name, bare, chain)
        return by_premises or Decision(PREMISE if is_premise else DEFINITION)

    def _is_circular(self, name: str, value: Formula, line: int, knowledge: Knowledge) -> bool:
        """Tell whether a value comes down to its own letter, by what was defined before.

        What was defined where the letter was declared as another one does not hold this one.
        """
        owner = self.declarations.owner
        values = {
            n: d.node
            for n, d in knowledge.definitions.items()
            if n != name and not (name in names(d.node) and owner(name, d.line) != owner(name, line))
        }
        return name in names_behind(value, values)

    def decide_by_premises(self, statement: Premise, knowledge: Knowledge) -> Decision | None:
        """Return what earlier premises say of a statement; None where they say nothing.

        It follows from them, it contradicts them, or it is one of several solutions. Of matrices they say
        nothing: they are solved as numbers are, whose products commute.
        """
        nodes = [statement.left, statement.right]
        if any(isinstance(part, PlusMinus) for node in nodes for part in walk(node)):
            return self._decide_both_signs(statement, knowledge)
        given = related(self.premises_at(statement.line), nodes, knowledge, rounded=True)
        if not given or is_of_matrices(statement.left, statement.right, knowledge):
            return None
        before = eliminate(given, knowledge, rounded=True)
        if not before.is_consistent:
            return None  # said where the last of them stands
        after = eliminate([*given, statement], knowledge, rounded=True)
        refusal = _refusal_by(given, before, after, statement, knowledge)
        return refusal or _support_by(given, before, after, statement, knowledge)

    def _decide_both_signs(self, statement: Premise, knowledge: Knowledge) -> Decision | None:
        """Return what earlier premises say of x = 2 ± 1: each of the two values has to satisfy them."""
        decisions: list[Decision | None] = []
        for sign in (1, -1):
            left, right = (with_sign(node, sign) for node in (statement.left, statement.right))
            one = replace(statement, left=left, right=right)
            decision = self.decide_by_premises(one, knowledge)
            if decision is not None and decision.status == CONTRADICTION:
                reason = f"with the {'upper' if sign > 0 else 'lower'} signs it {decision.reason}"
                return replace(decision, reason=reason)
            decisions.append(decision)
        return decisions[0] if None not in decisions else None

    def solved(self, nodes: Sequence[Formula], line: int, knowledge: Knowledge) -> Solved | None:
        """Return what is known with the premises that formulas are connected with solved together.

        None where there are none beside those that fix a letter each, or they contradict each other.
        """
        given = related(self.premises_at(line), nodes, knowledge)
        if all(p.fixes and self._is_in_effect(p, knowledge) for p in given):
            return None
        result = eliminate(given, knowledge)
        if not result.is_consistent:
            return None
        texts = (*dict.fromkeys(p.text for p in given), *_nonzero_texts(result))
        known = replace(knowledge, solved=result.values, solved_from=texts)
        return Solved(known, result.leftover, tuple(given))

    @staticmethod
    def concerns(solved: Solved, decision: Decision) -> bool:
        """Tell whether what could not be solved has letters of the two sides that were compared.

        An angle is free in what has other letters too, and what a letter of its own satisfies, T_i in
        T_i ω = -m a v, says nothing of the others.
        """
        if decision.left is None or decision.right is None:
            return True
        own = {*letters(decision.left), *letters(decision.right)}
        values = {n: d.node for n, d in solved.knowledge.definitions.items()}
        values = {**values, **solved.knowledge.meaning.values, **solved.knowledge.solved}
        free = solved.knowledge.universal
        for p in solved.leftover:
            reached = {name for node in (p.left, p.right) for name in letters_behind(node, values)}
            if not reached <= free:
                reached -= free
            others = {n for other in solved.premises if other is not p for n in other.names}
            private = p.names - others - own - free - solved.knowledge.meaning.values.keys()
            if own & reached and not any(_is_factor_once(p, name) for name in private):
                return True
        return False

    @staticmethod
    def _is_in_effect(premise: Premise, knowledge: Knowledge) -> bool:
        """Tell whether the letter that a premise fixes still has its value from there."""
        definition = knowledge.definitions.get(premise.fixes)
        return definition is not None and definition.line == premise.line

    def without_scope(self, nodes: Sequence[Formula], line: int, knowledge: Knowledge) -> Solved | None:
        """Return what would be known if what holds to the end of its section held further.

        A line below the next heading may still rest on it: it is not refuted then.
        """
        ended = [
            p
            for p in self.premises
            if p.last_line < line and self._reaches(p.line, line, p.names) and not has_decimals(p)
        ]
        for name, entries in self.values.items():
            last = entries[-1]
            is_ended = last.last_line is not None and last.last_line < line
            if is_ended and self.sections.section_end(last.definition.line) >= line:
                continue  # the item ended that looked at one angle
            if is_ended and not decimals(last.definition.node) and name not in knowledge.definitions:
                own = last.definition
                ended.append(Premise(Name(name), own.node, own.line, last.last_line or EVERYWHERE))
        connected = related(ended, nodes, knowledge)
        if not connected:
            return None
        given = related([*self.premises_at(line), *connected], nodes, knowledge)
        result = eliminate(given, knowledge)
        if not result.is_consistent:
            return None
        texts = tuple(dict.fromkeys(p.text for p in given))
        known = replace(knowledge, solved=result.values, solved_from=texts)
        return Solved(known, result.leftover, tuple(p for p in given if p in connected))

    def _outside_range(
        self, name: str, value: Formula, line: int, knowledge: Knowledge
    ) -> Decision | None:
        """Return the contradiction between a letter's value and a range stated before."""
        with_value = knowledge.with_definition(name, Definition(value, line, not names(value)))
        for stated in self.ranges_at(line):
            if name in names(stated.left) | names(stated.right):
                decision = compare(stated.left, stated.right, stated.sign, with_value)
                if decision is not None and decision.status == REFUTED:
                    reason = f"contradicts {stated.text} of line {stated.line}"
                    return Decision(CONTRADICTION, reason, witness=decision.witness)
        return None

    def _redefine(
        self, name: str, value: Formula, chain: Chain, k: int, knowledge: Knowledge
    ) -> Decision | None:
        """Return the decision on another value of a defined letter: a new case, a condition, or None."""
        earlier, line = knowledge.definitions[name], chain.lines[0]
        by_premises = self.decide_by_premises(Premise(Name(name), value, line), knowledge)
        if by_premises is not None:
            outside = self._outside_range(name, value, line, knowledge)
            if by_premises.status == PREMISE and outside is None:
                self.define(name, value, chain)
            return outside or by_premises
        if earlier.solved and _each_has_own_letters(earlier.node, value, knowledge):
            contradiction = self._outside_range(name, value, line, knowledge)
            if contradiction is None:
                self.define(name, without_dots(value)[0], chain)
            return contradiction or Decision(PREMISE, f"beside line {earlier.line}")
        is_numbered = name.endswith(")") and not self.sections.same_section(earlier.line, line)
        reason = ""
        if is_numbered or (names(earlier.node) and names(value) and self._is_anew(earlier, chain)):
            reason = f"anew: in line {earlier.line} it was another one's"
        elif self._is_exact_form(name, value, earlier, chain, k, knowledge):
            reason = f"exactly what line {earlier.line} has approximately"
        if reason:
            self.define(name, without_dots(value)[0], chain)
            return Decision(DEFINITION, reason)
        if chain.relations[k].sign == "≈" and not k and names(earlier.node) and not names(value):
            condition = Premise(earlier.node, value, line, self.sections.case_end(line))
            turning = self._turning_behind(name, earlier.node, knowledge)
            self.open_conditions |= dict.fromkeys(turning, condition)  # c ≈ 0.25, so θ ≈ 75.5°
        is_put_in = not names(value) and self._has_number_put_in(earlier, line, knowledge)
        if is_put_in or not _new_case(earlier, value, chain.relations[k].sign, knowledge):
            return None
        return self._define_case_anew(name, value, earlier, chain, knowledge)

    @staticmethod
    def _is_exact_form(
        name: str, value: Formula, earlier: Definition, chain: Chain, k: int, knowledge: Knowledge
    ) -> bool:
        """Tell whether a formula is what an earlier line gave a letter with ≈, cut off at some order."""
        if k or not earlier.is_rough or chain.relations[0].sign != "=" or not names(value):
            return False
        lettered = {n: d for n, d in knowledge.definitions.items() if n != name and not d.numeric}
        known = replace(knowledge, definitions=lettered)
        return bool(names(earlier.node)) and (
            decide(_side(value), _side(earlier.node), "≈", known).is_proved
            and not decide(_side(earlier.node), _side(value), "=", known).is_proved
        )

    def _define_case_anew(
        self, name: str, value: Formula, earlier: Definition, chain: Chain, knowledge: Knowledge
    ) -> Decision:
        """Return the decision on a value that may start a new case, after defining it."""
        line = chain.lines[0]
        if isinstance(value, Name) and value.name in knowledge.definitions:
            self.conditions[line] = frozenset(_letters_behind([earlier.node, value], knowledge))
            return Decision(CONDITION, "sets two quantities equal")
        refusal = self._refuse_case(name, value, earlier, chain, knowledge)
        if refusal is None and self._is_no_other_root(name, value, chain, knowledge):
            refusal = Decision(CONTRADICTION, "no solution of the equation that the other value solves")
        if refusal is not None:
            return refusal
        bare = without_dots(value)[0]
        end: int | None = None
        if not names(bare) and names(earlier.node) and name not in knowledge.angles:
            end = self.sections.section_end(line)  # u = 2v, then u = 6: 2v is 6 here
            end = min(end, self._end_of_place(earlier.node, line) or end)
            if turning := self._turning_behind(name, earlier.node, knowledge):
                end = min(end, self.sections.case_end(line))  # v = 0 at one moment, and not below
            premise = Premise(earlier.node, bare, line, end)
            self.premises.append(premise)
            self.open_conditions |= dict.fromkeys(turning, premise)
            end = end if turning else None
        self.define(name, bare, chain, end)
        return Decision(PREMISE, f"a new case: line {earlier.line} had another value")

    @staticmethod
    def _turning_behind(name: str, node: Formula, knowledge: Knowledge) -> frozenset[str]:
        """Return the angles that a letter's value turns with: it has a number at a moment only."""
        values = {n: d.node for n, d in knowledge.definitions.items() if n != name}
        behind = {*names(node), *names_behind(node, {**values, **knowledge.meaning.values})}
        roles = knowledge.meanings
        return frozenset(n for n in behind if role_of(roles.get(n, "")) in ("crank angle", "rod angle"))

    def _is_anew(self, earlier: Definition, chain: Chain) -> bool:
        """Tell whether a second formula of a letter is of another engine, or in another exercise."""
        is_tied = self.sections.is_consequence(chain)
        return not is_tied and self.sections.is_of_another_engine(chain, earlier.line)

    def _refuse_case(
        self, name: str, value: Formula, earlier: Definition, chain: Chain, knowledge: Knowledge
    ) -> Decision | None:
        """Return why another value of a letter is no new case: it contradicts the earlier one, or may.

        In prose a new case is said to be one, or stands in a section of its own.
        """
        line, text = chain.lines[0], f"{plain(Name(name))} = {plain(earlier.node)}"
        if name in knowledge.angles or self._is_stale(name, knowledge):
            return None
        if self.sections.premise_end(chain, is_number=not names(value)) is not None:
            return None
        if chain.inline and self.sections.is_denied(chain):
            return Decision(CONDITION, f"said not to be so: {text} in line {earlier.line}")
        is_case = self._says_new_case(name, earlier, chain)
        is_excluded = is_case is not True and _excludes(earlier.node, value, knowledge)
        if not is_excluded or self._is_another_solution(name, value, line, knowledge):
            return None
        if is_case is None:
            reason = f"not {text} of line {earlier.line}, and no words say that it is another case"
            return Decision(UNDECIDED, reason)
        return Decision(CONTRADICTION, f"contradicts {text} of line {earlier.line}")

    def _says_new_case(self, name: str, earlier: Definition, chain: Chain) -> bool | None:
        """Tell whether what stands around another value makes it a new case; None where it may."""
        line, near = chain.lines[0], self.sections.paragraph_start(chain.lines[0])
        same_section = self.sections.same_section(earlier.line, line)
        if not same_section or (chain.inline and near > earlier.line):
            follows_at_once = self.sections.stands_next(chain, earlier.line)
            return not (self.sections.is_consequence(chain) and follows_at_once)
        if not chain.inline:
            return bool(earlier.assumption) and near > earlier.line
        return self.sections.starts_new_case(chain, earlier.line, name)

    def _is_another_solution(self, name: str, value: Formula, line: int, knowledge: Knowledge) -> bool:
        """Tell whether a second value solves an equation too that a letter's first one solves."""
        others = {n: d for n, d in knowledge.definitions.items() if n != name}
        without = replace(knowledge, definitions=others)
        if not any(name in p.names and not p.fixes for p in self.premises_at(line)):
            return False
        decision = self.decide_by_premises(Premise(Name(name), value, line), without)
        return decision is not None and decision.status == PREMISE

    def _has_number_put_in(self, earlier: Definition, line: int, knowledge: Knowledge) -> bool:
        """Tell whether a line gives a formula its value, by its letters' numbers: λ = 3.5, F = 648."""
        behind = (knowledge.definitions.get(n) for n in names(earlier.node) - knowledge.angles)
        is_here = any(d is not None and d.numeric and d.line == line for d in behind)
        return is_here and _comes_to_a_number(earlier.node, knowledge, Number(Fraction(0)))

    def _is_no_other_root(self, name: str, value: Formula, chain: Chain, knowledge: Knowledge) -> bool:
        """Tell whether a second value is said to solve what the first does, and does not: or x = 4."""
        if not self.sections.is_one_of_several(chain):
            return False
        for premise in self.premises_at(chain.lines[0]):
            if premise.names == {name}:
                left, right = (_side(substitute(n, name, value)) for n in (premise.left, premise.right))
                if decide(left, right, "=", knowledge).status == REFUTED:
                    return True
        return False

    def _define_size(
        self, name: str, value: Formula, chain: Chain, knowledge: Knowledge
    ) -> Decision | None:
        """Return the decision on a size that is fixed by itself, such as l = 4r: a case, λ = 4."""
        if knowledge.crank is None or knowledge.crank.small is None or name in knowledge.moving:
            return None
        by_numbers = self._define_by_number(name, value, chain, knowledge)
        if by_numbers is not None:
            return by_numbers
        small, evaluator = knowledge.crank.small[0], FormEvaluator(Domain(), knowledge.meaning)
        try:
            ratio = evaluator.letter(name).over(evaluator.form(value))
        except (NoFormError, TooLargeError):
            return None
        if not ratio.is_polynomial or len(ratio.numerator) != 1 or letters(ratio) != [small]:
            return None
        ((monomial, coefficient),) = ratio.numerator.items()
        if [abs(exponent) for _, exponent in monomial] != [1]:
            return None
        number = 1 / coefficient if monomial[0][1] > 0 else coefficient
        return self._define_case(small, rational_node(number), chain, knowledge)

    def _define_by_number(
        self, name: str, value: Formula, chain: Chain, knowledge: Knowledge
    ) -> Decision | None:
        """Return the decision on a size with a number: s = 2r = 87 gives r, l = 160 after r = 40 gives λ.

        A letter that has a number, and what was solved from it, keeps it within the section.
        """
        node, line, reasons = knowledge.meaning.values[name], chain.lines[0], list[str]()
        if names(value):
            return None
        for letter in sorted(names(node)):
            known = knowledge.definitions.get(letter)
            is_other = len(names(node)) > 1
            if known is None or not known.numeric or not is_other or letter in knowledge.angles:
                continue
            if not self._is_stale(letter, knowledge):
                node = substitute(node, letter, known.node)
                reasons.append(f"{plain(Name(letter))} = {plain(known.node)}")
        base = _solve_for_one_letter(node, value)
        if base is None:
            return None
        letter, solution = base
        earlier = knowledge.definitions.get(letter)
        if earlier is not None and earlier.numeric and not self._is_stale(letter, knowledge):
            again = decide(_side(solution), _side(earlier.node), "=", knowledge)
            if again.is_proved:
                return None  # said before: it is decided by numbers
            if self._agrees_in_another_letter(name, value, knowledge):
                return Decision(PROVED, order="the digits printed")
            refusal = self._refuse_case(letter, solution, earlier, chain, knowledge)
            if refusal is not None:
                return refusal
        word = PREMISE if self.define(letter, solution, chain) else DEFINITION
        text = f"{plain(Name(letter))} = {plain(solution)}"
        if reasons:
            behind = [(n, knowledge.definitions.get(n)) for n in names(knowledge.meaning.values[name])]
            self._solved_from[letter] = (line, {n: d and d.node for n, d in behind if n != letter})
        return Decision(word, f"with {' and '.join(reasons)} a case: {text}" if reasons else "")

    def _agrees_in_another_letter(self, name: str, value: Formula, knowledge: Knowledge) -> bool:
        """Tell whether a size agrees with the digits printed of a letter it rests on.

        After r = 43, λ = 0.3 the rod's length 145 gives r = 43.5, but λ = 0.297, which is 0.3.
        """
        node = knowledge.meaning.values[name]
        known = {n: d.node for n in names(node) if (d := knowledge.definitions.get(n)) and d.numeric}
        for letter, earlier in known.items():
            rest = node
            for other, number in known.items():
                rest = substitute(rest, other, number) if other != letter else rest
            base = _solve_for_one_letter(rest, value)
            if base and decide(_side(base[1]), _side(earlier), "=", knowledge).is_proved:
                return True
        return False

    def _is_stale(self, letter: str, knowledge: Knowledge) -> bool:
        """Tell whether a letter's number was solved from another one that has changed since."""
        if letter not in self._solved_from:
            return False
        line, others = self._solved_from[letter]
        own = knowledge.definitions.get(letter)
        return (
            own is not None
            and own.line == line
            and any(
                n in knowledge.definitions
                and (knowledge.definitions[n].line > line or knowledge.definitions[n].node != node)
                for n, node in others.items()
            )
        )

    def _define_case(self, small: str, number: Formula, chain: Chain, knowledge: Knowledge) -> Decision:
        """Return the decision on a size that gives the ratio a number: a case, or a contradiction."""
        earlier = knowledge.definitions.get(small)
        if earlier is not None and earlier.numeric:
            again = decide(_side(number), _side(earlier.node), "=", knowledge)
            if not again.is_proved:
                refusal = self._refuse_case(small, number, earlier, chain, knowledge)
                if refusal is not None:
                    return refusal
        word = PREMISE if self.define(small, number, chain) else DEFINITION
        return Decision(word, f"a case: {plain(Name(small))} = {plain(number)}")

    def _letter_defined(self, chain: Chain, k: int) -> tuple[str, Formula] | None:
        """Return the letter a relation may define, and its value."""
        left, right = chain.sides[k].node, chain.sides[k + 1].node
        is_new = isinstance(right, Name) and right.name not in names(left) | self.letters_in_use
        if k == 0 and isinstance(left, Name) and left.name not in names(right):
            has_number = any(e.definition.numeric for e in self.values.get(left.name, [])[-1:])
            if not (has_number and is_new):  # u = 3, then u = v: that is what v is
                return left.name, right
        if isinstance(right, Name) and right.name not in names(left) | self.letters_in_use:
            return right.name, left
        return None


def _solve_for_one_letter(node: Formula, value: Formula) -> tuple[str, Formula] | None:
    """Return the one letter a size is written in, and its value if the size has a number: s = 2r = 87."""
    counts = letter_counts(node)
    if names(value) or list(counts.values()) != [1]:
        return None
    (letter,) = counts
    solution = solve_for(node, value, letter)
    return None if solution is None else (letter, solution)


def _each_has_own_letters(earlier: Formula, value: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a second value fixes another letter: F_1 = -F_2, then F_1 = cos θ; or is a number."""
    first, second = (set(_letters_behind([node], knowledge)) for node in (earlier, value))
    return not second or bool(first - second and second - first)


def _refusal_by(
    given: list[Premise],
    before: Elimination,
    after: Elimination,
    statement: Premise,
    knowledge: Knowledge,
) -> Decision | None:
    """Return why a statement cannot stand beside premises: it contradicts them, or makes a letter 0."""
    if not after.is_consistent:
        if after.nonzero:
            return None  # w x = w y does not contradict x ≠ y where w = 0
        others = [p for p in after.contradiction if p is not statement]
        if not others and after.residue is not None and letters(after.residue):
            return None  # of a motion, at some angle
        reason = f"contradicts {lines_of(others)}" if others else "contradicts what is known"
        return Decision(CONTRADICTION, reason)
    zero = [name for name in after.vanishing if name not in before.vanishing]
    if zero and isinstance(statement.left, Name) and names(statement.right):
        reason = f"with {lines_of(given)} it is true only for {plain(Name(zero[0]))} = 0"
        return Decision(UNDECIDED, reason)
    return None


def _support_by(
    given: list[Premise],
    before: Elimination,
    after: Elimination,
    statement: Premise,
    knowledge: Knowledge,
) -> Decision | None:
    """Return that a statement follows from premises, or is one of their solutions; None for neither."""
    is_implied = statement in after.following or (
        bool(before.leftover) and implied(given, statement.left, statement.right, knowledge) is True
    )
    if is_implied:
        texts = (*dict.fromkeys(p.text for p in given), *_nonzero_texts(after))
        return Decision(PROVED, f"by {lines_of(given)}", assumptions=texts)
    if any(p in after.following for p in given if p not in before.following):
        return Decision(PREMISE, f"satisfies {lines_of(given)}")
    return None


def _is_factor_once(premise: Premise, name: str) -> bool:
    """Tell whether a letter stands once in an equation, in a product or sum: it can always satisfy it."""
    node = premise.left if name in names(premise.left) else premise.right
    if letter_counts(premise.left)[name] + letter_counts(premise.right)[name] != 1:
        return False
    while isinstance(node, Product | Sum | Negative):
        node = next(part for part in children(node) if name in names(part))
    return isinstance(node, Name)


def _nonzero_texts(result: Elimination) -> tuple[str, ...]:
    return tuple(f"{plain(Name(name))} ≠ 0" for name in result.nonzero)


def _side(node: Formula) -> Side:
    return Side((node,), (0, 0))


def plain(node: Formula) -> str:
    """Return a formula as plain text."""
    return formula_text(node, plain=True)


def lines_of(premises: Sequence[Premise]) -> str:
    """Return the lines of premises, as `lines 1 and 3`."""
    numbers = [str(n) for n in sorted({p.line for p in premises})]
    *others, last = numbers
    return f"lines {', '.join(others)} and {last}" if others else f"line {last}"


def refuted_at_angles(left: Side, right: Side, sign: str, solved: Solved) -> Decision | None:
    """Return the refutation at an angle that satisfies what could not be solved, such as cos 2θ = 1.

    None where that is more than equations for one angle, or no multiple of 15 degrees is such a witness.
    """
    for twelfths, letter, decision in _at_angles(left, right, sign, solved):
        if decision.status == REFUTED:
            reason = f"also at {plain(Name(letter))} = {15 * twelfths}°, by {lines_of(solved.leftover)}"
            witness = {letter: f"{twelfths * pi / 12:.12g}", **decision.witness}
            return replace(decision, reason=decision.reason or reason, witness=witness)
    return None


def holds_at_angles(left: Side, right: Side, sign: str, solved: Solved) -> bool:
    """Tell whether a relation holds at each multiple of 15 degrees that satisfies what is left over.

    0 = 0 does not count: there sin³θ is whatever has a factor sin θ.
    """
    decisions = [decision for _, _, decision in _at_angles(left, right, sign, solved)]
    is_trivial = names(right.node) and any(d.left is not None and d.left.is_zero() for d in decisions)
    return bool(decisions) and not is_trivial and all(decision.is_proved for decision in decisions)


def _at_angles(left: Side, right: Side, sign: str, solved: Solved) -> Iterator[tuple[int, str, Decision]]:
    """Yield the decisions at the multiples of 15 degrees that satisfy premises on one angle."""
    concerned = {name for premise in solved.leftover for name in premise.names}
    if len(concerned) != 1 or not concerned <= solved.knowledge.angles:
        return
    (letter,) = concerned
    for twelfths in range(24):
        angle = Product((rational_node(Fraction(twelfths, 12)), Constant("pi")))

        def at_angle(node: Formula, angle: Formula = angle) -> Formula:
            return substitute(node, letter, angle)

        try:
            satisfies = all(
                decide_equality(at_angle(p.left), at_angle(p.right), solved.knowledge).is_proved
                for p in solved.leftover
            )
            if not satisfies:
                continue
            first, second = (replace(s, readings=tuple(map(at_angle, s.readings))) for s in (left, right))
        except NoFormError:  # a derivative by the angle: it has no value there
            return
        yield twelfths, letter, decide(first, second, sign, solved.knowledge)


_TWO_INDICES = re.compile(r"delta_\{?([A-Za-z0-9])([A-Za-z0-9])\}?$")


def _refuse_by_name(name: str, value: Formula, knowledge: Knowledge) -> Decision | None:
    """Return why a value does not suit how its letter is written: δ_nn = 0, S = Sᵀ, y' after y = x²."""
    text = plain(Name(name))
    indices = _TWO_INDICES.match(name)
    if indices and name not in knowledge.letters and isinstance(value, Number):
        if indices[1] == indices[2] and value.value == 0:
            return Decision(UNDECIDED, f"{text} is 1 if it is Kronecker's; if not, declare it")
        if indices[1] != indices[2] and value.value == 1:
            return Decision(
                UNDECIDED, f"{text} is 1 for equal indices only; if it is a letter, declare it"
            )
    if name in knowledge.meaning.kinds.symmetric and isinstance(value, Matrix):
        for i, row in enumerate(value.rows):
            for j, entry in enumerate(row[:i]):
                mirrored = value.rows[j][i] if i < len(value.rows[j]) else entry
                if decide(_side(entry), _side(mirrored), "=", knowledge).status == REFUTED:
                    reason = (
                        f"{text} is declared symmetric, entries ({i + 1}, {j + 1}) and mirrored differ"
                    )
                    return Decision(CONTRADICTION, reason)
    bare = name.rstrip("'")
    base = knowledge.definitions.get(bare)
    if bare != name and name not in knowledge.letters and base is not None and len(names(base.node)) == 1:
        (variable,) = names(base.node)
        slope = Derivative(base.node, Name(variable), len(name) - len(bare))
        if decide(_side(slope), _side(value), "=", knowledge).status == REFUTED:
            reason = (
                f"not the derivative of {bare} by {plain(Name(variable))}; if {text} is another letter"
            )
            return Decision(UNDECIDED, f"{reason}, declare it")
    return None


def refuse_value(name: str, value: Formula, knowledge: Knowledge) -> Decision | None:
    """Return why a first value is none: it has no value, or looks like a slip of the pen."""
    by_name = _refuse_by_name(name, value, knowledge)
    if by_name is not None:
        return by_name
    if isinstance(value, Sum):
        terms = [t for t in value.terms if names(t)]
        double = next((t for n, t in enumerate(terms) if isinstance(t, Name) and t in terms[:n]), None)
        if double is not None and double.name[-1:].isdecimal():
            letter = plain(double)
            reason = f"{letter} stands twice in the sum: another letter is meant, or 2 {letter}"
            return Decision(UNDECIDED, reason)
    if has_no_value(value, knowledge):
        return Decision(UNDECIDED, "the right side has no value")
    if name in ("e", "pi", "i") and name not in knowledge.letters and not names(value):
        return Decision(UNDECIDED, f"{plain(Name(name))} is a number of its own, unless it is declared")
    return None


def has_no_value(node: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a formula is a division by zero, infinite, or a number outside a function's range."""
    if is_of_matrices(node, node, knowledge):
        return False
    level = list(knowledge.levels(node))[-1]
    evaluator = knowledge.evaluator(level)
    try:
        form = evaluator.form(node)
    except NoFormError as problem:
        return str(problem) in ("a division by zero", "infinity")
    except TooLargeError:
        return False
    if letters(form):
        return False
    points = sample([form], 1)
    return not points or not context().isfinite(points[0][1][0])


def _is_at_a_point(value: Formula) -> bool:
    return any(isinstance(part, _OF_A_POINT) for part in walk(value))


def outside_meaning(
    name: str, value: Formula, knowledge: Knowledge, *, is_result: bool
) -> Decision | None:
    """Return the contradiction between a letter's value and its meaning: an integer that is 1/2.

    What is positive by its meaning may be taken as 0, a rod ratio of an endless rod; but 0 is no way to
    write a crank radius (`is_result`: the letter stands behind what gives it its value).
    """
    is_positive, is_whole = name in knowledge.meaning.positive, name in knowledge.meaning.integer
    number = number_of(value, knowledge) if is_positive or is_whole else None
    if number is None:
        return None
    shown = "0" if abs(number) < WHOLE else context().nstr(number, 6)
    if is_whole and abs(number - context().nint(number)) > WHOLE:
        return Decision(CONTRADICTION, f"{plain(Name(name))} is declared an integer, not {shown}")
    may_be_zero = not is_result and role_of(knowledge.meanings.get(name, "")) != "positive"
    if is_positive and (number < -WHOLE or (shown == "0" and not may_be_zero)):
        return Decision(CONTRADICTION, f"{plain(Name(name))} is positive by its meaning, not {shown}")
    return None


def number_of(value: Formula, knowledge: Knowledge) -> Any:
    """Return the real number that a formula comes down to by all that is known, None for none."""
    level = list(knowledge.levels(value))[-1]
    try:
        form = knowledge.evaluator(level).form(value)
    except (NoFormError, TooLargeError):
        return None
    if letters(form):
        return None
    points = sample([form], 1)
    if not points or not context().isfinite(points[0][1][0]):
        return None
    number = points[0][1][0]
    return number.real if abs(number.imag) < WHOLE else None


def _letters_behind(nodes: list[Formula], knowledge: Knowledge) -> list[str]:
    values = {name: d.node for name, d in knowledge.definitions.items()}
    return [name for node in nodes for name in letters_behind(node, values)]


def _comes_to_a_number(node: Formula, knowledge: Knowledge, *beside: Formula) -> bool:
    """Tell whether a formula has a number by all that is known: another one then contradicts it."""
    level = list(knowledge.levels(node, *beside))[-1]
    try:
        return not letters(knowledge.evaluator(level).form(node))
    except (NoFormError, TooLargeError):
        return False


def _letters_of(value: Formula, knowledge: Knowledge) -> list[str]:
    """Return the letters a formula comes down to by the meanings alone."""
    try:
        return letters(FormEvaluator(Domain(), knowledge.meaning).form(value))
    except (NoFormError, TooLargeError):
        return []


def _excludes(earlier: Formula, value: Formula, knowledge: Knowledge) -> bool:
    """Tell whether no values of their letters make two values of one letter the same.

    Two numbers, values that differ by a number, or a number that no case of the earlier one gives.
    """
    if isinstance(earlier, Cases) and not names(value):
        return not any(names(v) for v in earlier.values) and all(
            decide(_side(v), _side(value), "=", knowledge).status == REFUTED for v in earlier.values
        )
    if not names(earlier) and not names(value):
        return True
    level = list(knowledge.levels(earlier, value))[-1]
    try:
        gap = knowledge.evaluator(level).form(Sum((earlier, Negative(value))))
    except (NoFormError, TooLargeError):
        return False
    return not letters(gap) and not gap.is_zero()


def _new_case(earlier: Definition, value: Formula, sign: str, knowledge: Knowledge) -> bool:
    """Tell whether another value of a letter starts a new case, and is not a slip.

    It does between lone letters or numbers (θ = 0, then θ = π/2), unless two numbers nearly agree.
    """
    old = Side((earlier.node,), (0, 0))
    if sign == "≈" or decide(old, Side((value,), (0, 0)), sign, knowledge).is_proved:
        return False
    if names(earlier.node) and names(value):
        return isinstance(value, Name)
    if names(earlier.node) or names(value):
        return not _comes_to_a_number(earlier.node, knowledge)
    points = sample_trees([earlier.node, value], SymbolValue(), 1)
    if not points:
        return True
    old_value, new_value = points[0][1]
    return abs(old_value - new_value) > NEARLY * max(abs(old_value), abs(new_value))
