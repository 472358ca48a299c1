"""Letters that a document has defined so far, with their values, each as far as its scope reaches."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction

from symbalance.document.formula import (
    Constant,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    names,
    walk,
    with_parts_changed,
)
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.equality import REFUTED, Decision, without_dots
from symbalance.notes.checking.deciding.inequalities import possible_branches
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge, StatedRange
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.declared.sidecar import Declarations
from symbalance.notes.checking.declared.symbol_roles import CONSTANT, MOVING, role_of
from symbalance.notes.checking.premises.constraints import Constraint
from symbalance.notes.checking.premises.roots_of_unity import order_of_root
from symbalance.notes.checking.premises.system import EVERYWHERE, Premise
from symbalance.notes.checking.verdicts import RANGE
from symbalance.notes.checking.words.case_words import is_said_generally
from symbalance.notes.checking.words.labelled_data import LabelledData
from symbalance.notes.checking.words.plain_formulas import plain_text
from symbalance.notes.checking.words.sections import Sections
from symbalance.notes.reading.equations import Chain
from symbalance.notes.reading.formulas.result_units import value_of
from symbalance.notes.reading.units import scale_of
from symbalance.text import lazy_patterns as re

ROUGHER = 0.01
"""What a number that is told again with fewer digits may be off by, as a part of it."""
_CALL_IT = re.compile(
    r"\$?(?:\s*[,;:–—-]\s*|\s+|\s*\()(?:(?:call\s+it|say|or(?:\s+about)?|about|roughly|i\.e\.|that\s+is|rounded(?:\s+to)?|also"
    r"|(?:also\s+)?rund|gerundet|d\.\s?h\.|etwa|soit(?:\s+environ)?|environ|cio[eè]|circa|unos|es\s+decir|すなわち|つまり|約)\s*)?"
    r"\$?(?P<number>[0-9]+(?:[.,][0-9]+)?)(?:[ ~]|\\[,;: ])?"
    r"(?:\\(?:mathrm|text)\{)?(?P<unit>[A-Za-z][A-Za-z/²³·]{0,6})"
)
"""Words right behind a result that tell it with fewer digits: 14437 N, call it 14.4 kN."""
_SAME_WAY = {">": ">≥", "≥": ">≥", "<": "<≤", "≤": "<≤"}
"""Signs of bounds on the same side as one with a sign."""
_OF_CRANK_ANGLE = (*MOVING, "rod angle")
"""What a condition such as v = 0 is solved for the crank angle with."""


@dataclass(frozen=True, slots=True)
class Entry:
    """A letter's definition, the scopes of the sidecar it stands in, and the last line it reaches."""

    definition: Definition
    scopes: tuple[int, ...]
    last_line: int | None = None
    is_mended: bool = False
    """Whether it is what a refuted relation should have said."""


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
    labelled_data: LabelledData
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
    open_numbers: dict[str, tuple[Formula, int]] = field(default_factory=dict)
    """Numbers of letters whose formulas are of letters without values, with their lines."""
    solved_from: dict[str, tuple[int, dict[str, Formula | None]]] = field(default_factory=dict)
    """Letters whose number was solved for, with the line and the values of the letters it rests on."""

    given_anew: dict[str, int] = field(default_factory=dict)
    """Where the relation begins that gave a letter another number than it had, the last one of each."""

    def at(self, line: int) -> dict[str, Definition]:
        """Return the definitions that reach a line, of the letters as declared there."""
        scopes_here, owner = set(self.declarations.scope_at(line)), self.declarations.owner
        has_scopes = bool(self.declarations.scopes)
        reaching: dict[str, Definition] = {}
        for name, entries in self.values.items():
            for entry in reversed(entries):
                if (
                    set(entry.scopes) <= scopes_here
                    and (entry.last_line is None or line <= entry.last_line)
                    and (not has_scopes or owner(name, entry.definition.line) == owner(name, line))
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
        is_root = order_of_root(node) > 0
        last_line = None if is_root else last_line
        is_zero = isinstance(node, Number) and not node.value
        # where a letter is 0 nearly all is true: what rests on that says so
        text = (
            f"{plain_text(Name(name))} = {plain_text(node)}" if last_line is not None or is_zero else ""
        )
        is_rough = chain.relations[0].sign == "≈" or any(without_dots(s.node)[1] for s in chain.sides)
        definition = Definition(node, line, not names(node), text, is_rough=is_rough)
        is_at_place = last_line is None and not names(node) and not is_root
        end = self.end_of_place(Name(name), line) if is_at_place else last_line
        if is_zero and name in self.letters_before(line):
            last = min(last or self.sections.section_end(line), self.sections.section_end(line))
        own = line if self.sections.is_labelled_item(line) else None
        end = min((n for n in (end, last, own) if n is not None), default=None)
        end = end if names(node) else self._within_place(line, end)
        end = self._within_moment(name, node, chain, end)
        scopes = self.declarations.scopes_of({name, *names(node)}, line)
        self._add(name, Entry(definition, scopes, end), chain.start)
        self._note_case(chain, frozenset({name}))
        return last_line is not None

    def mend(self, name: str, node: Formula, chain: Chain) -> None:
        """Define a letter as it should be, in the place of what a relation says it is: that is wrong."""
        own = {id(part) for side in chain.sides for part in (side.node, without_dots(side.node)[0])}
        entries = [e for e in self.values.pop(name, []) if id(e.definition.node) not in own]
        if entries:
            self.values[name] = entries
        self.define(name, node, chain)
        self.values[name][-1] = replace(self.values[name][-1], is_mended=True)

    def forget_mended(self, name: str, but: Collection[int]) -> None:
        """Forget what a relation should have said of a letter, but for the entries of those ids."""
        entries = [e for e in self.values.pop(name, []) if not e.is_mended or id(e) in but]
        if entries:
            self.values[name] = entries

    def fix(self, constraint: Constraint, chain: Chain, *, is_rod_angle: bool = False) -> None:
        """Define a letter that a relation fixes, perhaps on one branch of several."""
        line, node = chain.lines[0], constraint.node
        definition = Definition(
            node,
            line,
            not names(node),
            alternatives=constraint.alternatives,
            solved=True,
            branch=constraint.branch if constraint.alternatives else "",
            is_rod_angle=is_rod_angle,
            is_rough=chain.relations[0].sign == "≈",
        )
        scopes = self.declarations.scopes_of({constraint.name, *names(node)}, line)
        last_line = self.sections.premise_end(chain, is_number=not names(node))
        if not names(node):
            last_line = self._within_place(line, last_line)
        last_line = self._within_moment(constraint.name, node, chain, last_line)
        self._add(constraint.name, Entry(definition, scopes, last_line), chain.start)

    def mark_as_rough(self, name: str, line: int) -> None:
        """Note that what a line gave a letter is roughly true only, where it has = and means ≈."""
        self.values[name] = [
            replace(e, definition=replace(e.definition, is_rough=True))
            if e.definition.line == line
            else e
            for e in self.values.get(name, [])
        ]

    def forget(self, name: str, line: int) -> None:
        """Forget the value that a line gave a letter, which cannot be: what follows is of another one."""
        entries = [e for e in self.values.pop(name, []) if e.definition.line != line]
        if entries:
            self.values[name] = entries

    def forget_line(self, name: str, line: int) -> bool:
        """Forget what a line says a letter is, its value or an equation; tell if it said anything."""
        premises = [p for p in self.premises if p.line != line or p.left != Name(name)]
        lines = [e.definition.line for e in self.values.get(name, ())]
        is_known = line in lines or len(premises) < len(self.premises)
        for other, entries in list(self.values.items()):
            if any(e.definition.line == line and (other == name or e.definition.solved) for e in entries):
                self.forget(other, line)
        self.premises = premises
        return is_known

    def forget_number(self, name: str, line: int) -> bool:
        """Forget the number that a line gives a letter, or the letter's formula; tell if it gave any."""
        premises = [p for p in self.premises if p.line != line or names(p.right)]
        is_known = len(premises) < len(self.premises)
        self.premises = premises
        return self.forget_line(name, line) or is_known

    def forget_all(self, name: str) -> None:
        """Forget every value of a letter, and the equations of that letter alone."""
        self.values.pop(name, None)
        self.premises = [p for p in self.premises if p.fixes != name and p.names != {name}]

    def lapse(self, name: str) -> None:
        """Forget the formulas that fix a letter and the equations they came from: it is measured now."""
        self.values.pop(name, None)
        self.premises = [p for p in self.premises if p.fixes != name and p.right != Name(name)]

    def fix_coefficients(self, values: Mapping[str, Formula], chain: Chain) -> None:
        """Define the letters that a series has as its coefficients."""
        line = chain.lines[0]
        for name, node in values.items():
            definition = Definition(node, line, is_coefficient=True)
            scopes = self.declarations.scopes_of({name, *names(node)}, line)
            self._add(name, Entry(definition, scopes))

    def coefficients(self) -> dict[str, list[Entry]]:
        """Return the letters that series have as their coefficients."""
        of_series = {
            name: [e for e in entries if e.definition.is_coefficient]
            for name, entries in self.values.items()
        }
        return {name: entries for name, entries in of_series.items() if entries}

    def forget_coefficients(self, but: Mapping[str, list[Entry]]) -> dict[str, list[Entry]]:
        """Forget the coefficients of series but those given, and return them."""
        newer = {
            name: [e for e in entries if all(e is not other for other in but.get(name, ()))]
            for name, entries in self.coefficients().items()
        }
        newer = {name: entries for name, entries in newer.items() if entries}
        for name, entries in newer.items():
            rest = [e for e in self.values.pop(name) if all(e is not other for other in entries)]
            if rest:
                self.values[name] = rest
        return newer

    def put_back(self, entries_by_name: Mapping[str, list[Entry]]) -> None:
        """Define letters again as they were."""
        for name, entries in entries_by_name.items():
            for entry in entries:
                self._add(name, entry)

    def round(self, name: str, chain: Chain, node: Formula) -> None:
        """Note how a letter's value is printed: v = 2π·100 = 628.3, in the line that defines it.

        A complex number that a rule gives, M_1 of M_n, is printed where it is worked out first.
        """
        entries = self.values.get(name, [])
        if names(node) or not entries or not _may_be_printed(entries[-1].definition, node, chain):
            return
        node = self._told_rougher(node, chain) or node
        number = node.operand if isinstance(node, Negative) else node
        if isinstance(number, Number) and number.last_place is None:
            number = Number(number.value, Fraction(1), span=number.span)
            node = Negative(number) if isinstance(node, Negative) else number
        if isinstance(node, Product) and len(node.factors) == 2:
            number, unit = node.factors
            if isinstance(number, Number) and number.last_place is None and isinstance(unit, Number):
                node = replace(node, factors=(replace(number, last_place=Fraction(1)), unit))
        if decimals(node):
            definition = replace(entries[-1].definition, rounded=node)
            entries[-1] = replace(entries[-1], definition=definition)

    def _told_rougher(self, node: Formula, chain: Chain) -> Formula | None:
        """Return the number with fewer digits that words go on with: F = 14437 N, call it 14.4 kN."""
        match = _CALL_IT.match(self.sections.document.text, chain.end)
        scale = scale_of(match["unit"]) if match else None
        value = value_of(node)
        if match is None or scale is None or scale[1] or not value:
            return None
        digits = match["number"].replace(",", ".")
        number = Fraction(digits) * scale[0]
        place = Fraction(1, 10 ** len(digits.partition(".")[2])) * scale[0]
        return Number(number, place) if abs(float(number) / value - 1) <= ROUGHER else None

    def _add(self, name: str, entry: Entry, place: int = -1) -> None:
        if entry.definition.numeric:
            self._keep_rates_of(name)
            self._forget_results_of(name, entry.definition.node, place)
        self.values.setdefault(name, []).append(entry)

    def _forget_results_of(self, name: str, node: Formula, place: int) -> None:
        """Forget the numbers printed for formulas of a letter that now gets another number: φ = 60°."""
        former = self.values.get(name)
        if not former or not former[-1].definition.numeric or former[-1].definition.node == node:
            return
        self.given_anew[name] = place
        nodes = self._nodes()
        for other, entries in self.values.items():
            last = entries[-1].definition
            if last.rounded is not None and other != name and name in names_behind(last.node, nodes):
                entries[-1] = replace(entries[-1], definition=replace(last, rounded=None))

    def _keep_rates_of(self, name: str) -> None:
        """Keep v = dx/dt the rate of x as it moves, where x now gets the number of one moment."""
        before = self.values.get(name)
        moving = before[-1].definition.node if before else None
        if moving is None or not names(moving):
            return
        for entries in self.values.values():
            for place, entry in enumerate(entries):
                node = _with_rates_of(entry.definition.node, name, moving)
                if node is not entry.definition.node:
                    definition = replace(entry.definition, node=node)
                    entries[place] = replace(entry, definition=definition)

    def ranges_at(self, line: int) -> list[StatedRange]:
        """Return the ranges that reach a line."""
        return [
            r
            for r in self.ranges
            if self.reaches(r.line, line, names(r.left) | names(r.right))
            and (r.last_line is None or line <= r.last_line)
        ]

    def premises_at(self, line: int) -> list[Premise]:
        """Return the equations taken as given that reach a line."""
        return [p for p in self.premises if self.reaches(p.line, line, p.names) and line <= p.last_line]

    def note_range(self, chain: Chain, k: int, decision: Decision) -> None:
        """Note a range that a relation states; one that is empty, or only so in general, does not."""
        left, right = chain.sides[k].node, chain.sides[k + 1].node
        if decision.status == REFUTED:
            self.ranges = [r for r in self.ranges if r.right is not left]
        if decision.status == RANGE and not self._is_said_generally(chain):
            line, is_aside = chain.lines[0], self.sections.is_in_brackets(chain)
            is_only_if = self.sections.is_only_if(chain)
            last = max(chain.lines) if is_aside or is_only_if else None
            if self.sections.opens_case(chain):
                self._end_bounds_of_cases(chain, k)
            self.ranges.append(StatedRange(left, chain.relations[k].sign, right, line, last, is_only_if))
            self._note_case(chain, names(left) | names(right))

    def _is_said_generally(self, chain: Chain) -> bool:
        """Tell whether an inequality is said in general: a case behind may be its exception."""
        return is_said_generally(self.sections.sentence_before(chain))

    def _end_bounds_of_cases(self, chain: Chain, k: int) -> None:
        """End the bound that a case before gave a letter, where the next one gives another."""
        letter, sign = chain.sides[k].node, chain.relations[k].sign
        starts = {c.line: c.start for c in self.cases if c.letters == chain.letters}
        self.ranges = [
            r
            for r in self.ranges
            if r.left != letter
            or r.sign[0] not in _SAME_WAY.get(sign, "")
            or names(r.right)
            or r.line not in starts
            or self.sections.stands_in_clause(starts[r.line], chain)
        ]

    def forget_range(self, chain: Chain) -> None:
        """Forget the range that a relation stated, which is refuted."""
        left, right = chain.sides[0].node, chain.sides[-1].node
        self.ranges = [r for r in self.ranges if r.left is not left or r.right is not right]

    def note_premise(
        self, chain: Chain, k: int, fixes: str = "", angles: frozenset[str] = frozenset()
    ) -> None:
        """Note an equation that is taken as given, and the letter it fixes.

        On angles alone it says at which of them something is looked at (largest where cos 2θ = 1), and
        reaches to the end of its section; on one of them, cos θ + λ cos 2θ = 0, to that of its item.
        """
        premise = replace(self.premise_of(chain, k), fixes=fixes)
        if self.sections.is_labelled_item(premise.line):
            premise = replace(premise, last_line=premise.line)
        symbols = self.declarations.symbols_at(premise.line)
        roles = {role_of(symbols.get(n, "")) for n in premise.names}
        is_motion = bool(roles & {*_OF_CRANK_ANGLE}) and roles <= {*_OF_CRANK_ANGLE, *CONSTANT}
        behind = {n for side in (premise.left, premise.right) for n in names_behind(side, self._nodes())}
        is_moment = any(
            self.sections.running.is_of_a_moment(n, behind, chain.start) for n in premise.names
        ) or (
            len(premise.names & angles) == 1
            and (not names(premise.right) or self._is_at_crank_angle(premise, symbols))
            and roles <= {*_OF_CRANK_ANGLE, *CONSTANT, "crank angle"}
        )
        if is_moment or premise.names <= angles:
            end = (self.sections.moment_end if is_moment else self.sections.section_end)(premise.line)
            premise = replace(premise, last_line=min(premise.last_line, end))
        self.premises.append(premise)
        turned = [n for n, text in symbols.items() if is_motion and role_of(text) == "crank angle"]
        for name in {*(premise.names & angles), *turned}:
            self.open_conditions[name] = premise

    @staticmethod
    def _is_at_crank_angle(premise: Premise, symbols: Mapping[str, str]) -> bool:
        """Tell whether an equation says where a crank angle is, in letters of an engine: tan θ = l/r."""
        own = {n: role_of(symbols.get(n, "")) for n in premise.names}
        is_of_it = {own[n] for n in names(premise.left)} == {"crank angle"}
        return is_of_it and all(own[n] in CONSTANT for n in names(premise.right))

    def open_condition(self, name: str, line: int) -> Premise | None:
        """Return the condition on an angle that its value on a line would solve; None for none."""
        condition = self.open_conditions.get(name)
        end = None if condition is None else self._within_place(condition.line, condition.last_line)
        return None if end is None or line > end else condition

    def forget_moment(self, value: Formula) -> None:
        """Forget a refuted number that a relation gave what moves: no angle follows from it."""
        self.premises = [p for p in self.premises if p.right is not value]
        self.open_conditions = {n: p for n, p in self.open_conditions.items() if p.right is not value}

    def _note_case(self, chain: Chain, letters_of_it: frozenset[str]) -> None:
        if self.sections.opens_case(chain):
            start = chain.start
            self.cases.append(OpenCase(letters_of_it, chain.lines[0], start))

    def premise_of(self, chain: Chain, k: int) -> Premise:
        """Return a relation of a chain as a premise, with its reach."""
        left, right = chain.sides[k].node, chain.sides[k + 1].node
        last_line = self.sections.premise_end(chain, is_number=not names(right))
        if last_line is None and not names(right):
            last_line = self.end_of_place(left, chain.lines[0])
        if not (names(left) and names(right)):
            last_line = self._within_place(chain.lines[0], last_line)
        return Premise(left, right, chain.lines[0], EVERYWHERE if last_line is None else last_line)

    def _nodes(self) -> dict[str, Formula]:
        return {name: entries[-1].definition.node for name, entries in self.values.items()}

    def _within_moment(self, name: str, node: Formula, chain: Chain, last: int | None) -> int | None:
        """Return where a letter's value ends: that of an angle which runs ends with its section."""
        values = {n: value for n, value in self._nodes().items() if n != name}
        running = self.sections.running
        is_moment = (
            running.is_of_a_moment(name, {*names_behind(node, values)}, chain.start)
            if names(node)
            else running.is_at_place(chain)
        )
        if not is_moment:
            return last
        end = self.sections.section_end(chain.lines[0])
        return end if last is None else min(last, end)

    def _within_place(self, line: int, last_line: int | None) -> int | None:
        """Return where a number ends, which is no later than the section that an angle heads."""
        ends = [n for n in (last_line, self.sections.end_of_angle_headed(line)) if n is not None]
        return min(ends, default=None)

    def end_of_place(self, node: Formula, line: int) -> int | None:
        """Return where the angle ends at which a formula has a value: x = 6.71 at θ = 90° of item b)."""
        for name in {*names_behind(node, self._nodes())} & set(self.values):
            for entry in self.values[name]:
                first, last = entry.definition.line, entry.last_line
                if last is not None and first <= line <= last < self.sections.section_end(first):
                    return last
        return None

    def on_stated_branches(self, knowledge: Knowledge) -> Knowledge:
        """Return what is known where ranges have said on which branch a letter lies; each is kept."""
        for name, definition in knowledge.definitions.items():
            own_ranges = [r for r in knowledge.ranges if name in names(r.left) | names(r.right)]
            if definition.alternatives and own_ranges:
                key = (name, definition.line, len(own_ranges))
                if key not in self._branches:
                    self._branches[key] = possible_branches(name, definition, knowledge)
                knowledge = knowledge.with_definition(name, self._branches[key])
        return knowledge

    def reaches(self, own_line: int, line: int, letters_of_it: frozenset[str]) -> bool:
        """Tell whether what a line states is in scope at another, its letters being the same there."""
        declared = self.declarations
        if not declared.scopes:
            return True
        return set(declared.scopes_of(letters_of_it, own_line)) <= set(declared.scope_at(line)) and all(
            declared.owner(name, own_line) == declared.owner(name, line) for name in letters_of_it
        )

    def use(self, chain: Chain) -> None:
        """Note the letters of a chain; one on other letters ends the solving of a condition."""
        own = chain.letters
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

    def is_stale(self, letter: str, knowledge: Knowledge) -> bool:
        """Tell whether a letter's number was solved from another one that has changed since."""
        if letter not in self.solved_from:
            return False
        line, others = self.solved_from[letter]
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


def _may_be_printed(definition: Definition, node: Formula, chain: Chain) -> bool:
    """Tell whether a chain may print the value of a letter in its digits."""
    if definition.line == chain.lines[0]:
        return True
    return definition.rounded is None and not definition.numeric and Constant("i") in set(walk(node))


def _with_rates_of(node: Formula, name: str, value: Formula) -> Formula:
    """Return a formula with a letter's value put in where its rate stands."""
    if isinstance(node, Derivative) and node.expression == Name(name):
        return replace(node, expression=value)
    return with_parts_changed(node, lambda part: _with_rates_of(part, name, value))
