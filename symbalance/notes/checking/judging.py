"""The class `Judge`: goes through a document's equations in order and gives each its verdict."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from functools import partial

from symbalance.budgets import Budget, OverBudgetError, run_within
from symbalance.document.formula import Formula, Name, Span, names
from symbalance.errors import SymbalanceError
from symbalance.notes.checking import assertions, constraints
from symbalance.notes.checking.deciding.cases import decide_numeric_case, decide_with_ratio, states_a_case
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Assumption, Knowledge
from symbalance.notes.checking.deciding.relations import decide, decide_inequality
from symbalance.notes.checking.definitions import Definitions
from symbalance.notes.checking.descriptions import (
    describe,
    undecided,
    undecided_by_fault,
    unreadable_verdict,
    with_fault,
)
from symbalance.notes.checking.engines import Sources
from symbalance.notes.checking.own_units import speeds_in_own_unit
from symbalance.notes.checking.repair.fixes import add_fix, is_proved_as_far
from symbalance.notes.checking.sidecar import Binding, Declarations
from symbalance.notes.checking.symbol_roles import MOVING, letters_by_role
from symbalance.notes.checking.symbols import meaning_of
from symbalance.notes.checking.verdicts import DEFINITION, REFUTED, UNDECIDED, Checked, Verdict
from symbalance.notes.reading import ReadingError, read_equation
from symbalance.notes.reading.equations import Chain, ReadNotes, Side

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

    def __post_init__(self) -> None:
        self.definitions = Definitions(self.declarations)
        self.start = time.monotonic()
        self.not_judged: dict[str, int] = {}
        """Letters that a relation may define which was not judged, with its line."""

    def check(self) -> Checked:
        """Return the document with its verdicts."""
        bindings = assertions.by_line(self.declarations.bindings)
        verdicts: list[Verdict] = [unreadable_verdict(self.document, u) for u in self.document.unreadable]
        for chain in sorted(self.document.chains, key=lambda c: (c.lines[0], not states_a_case(c))):
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
        symbols = self.declarations.symbols_at(line)
        meaning, crank = meaning_of(symbols, convention, self.sources.engines)
        definitions = self.definitions.at(line)
        letters = letters_by_role(symbols)
        universal = frozenset(n for m in UNIVERSAL for n in letters.get(m, ()))
        moving = frozenset(n for m in MOVING for n in letters.get(m, ()))
        angles = frozenset(n for m in ANGLES for n in letters.get(m, ()))
        letters_declared = frozenset(symbols)
        return Knowledge(
            meaning,
            crank,
            definitions,
            self.assumptions(line, letters_declared),
            letters_declared,
            moving,
            angles,
            universal,
        )

    def assumptions(self, line: int, letters: frozenset[str]) -> tuple[Assumption, ...]:
        """Return the assumptions at a line, each solved for a letter."""
        return tuple(
            read_assumption(text, letters, self.declarations.place)
            for text in self.declarations.assumptions_at(line)
        )

    def chain(self, chain: Chain, bindings: list[Binding]) -> list[Verdict]:
        """Return the verdicts on a chain's relations in order; none is lost by a fault of the checker."""
        verdicts: list[Verdict] = []
        chain = speeds_in_own_unit(chain, self.declarations.symbols_at(chain.lines[0]))
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
            if verdict.is_unjudged:
                self.not_judged |= dict.fromkeys(_lone_letters(chain, k), relation.line)
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
        """Return the verdict on the k-th relation of a chain."""
        knowledge = self.knowledge(chain.lines[0])
        relation = chain.relations[k]
        left, right = chain.sides[k], chain.sides[k + 1]
        if relation.sign in ("<", ">", "≤", "≥", "≠"):
            return describe(self.document, chain, k, decide_inequality(chain, k, knowledge))
        definition = self.definitions.define_by(chain, k, knowledge)
        if definition is not None:
            return describe(self.document, chain, k, definition)
        decision, against = decide(left, right, relation.sign, knowledge), left
        if bad and not decision.is_proved:
            from_sound = decide(chain.sides[sound], right, relation.sign, knowledge)
            if from_sound.is_proved or decision.status == REFUTED:
                decision, against = from_sound, chain.sides[sound]
        elif bad:
            decision = replace(decision, reason=FOLLOWS)
        head = chain.sides[0].node
        has_value = k and isinstance(head, Name) and head.name in knowledge.meaning.values
        if has_value and (relation.sign == "≈" or not decision.is_proved):
            decision, against = decide(chain.sides[0], right, "≈", knowledge), chain.sides[0]
        if decision.status in (REFUTED, UNDECIDED):
            constraint = constraints.constraint_of(chain, k, self.definitions.letters_in_use, knowledge)
            if constraint is not None:
                self.definitions.define(constraint.name, constraint.node, chain.lines[0])
                reason = f"read as what fixes {constraint.name}"
                return describe(self.document, chain, k, Decision(DEFINITION, reason))
        if decision.status == REFUTED:
            case = decide_numeric_case(chain, k, decision, knowledge)
            decision = case or decide_with_ratio(against.node, right.node, knowledge) or decision
        unknown = [name for name in self.not_judged if name in names(left.node) | names(right.node)]
        if decision.status == REFUTED and unknown:
            reason = f"may rest on line {self.not_judged[unknown[0]]}, which was not judged"
            decision = replace(decision, status=UNDECIDED, reason=reason)
        condition = self.definitions.condition_behind(decision, chain.lines[0])
        if decision.status == REFUTED and condition is not None:
            reason = f"may rest on line {condition}, which sets two quantities equal; give it in a scope"
            decision = replace(decision, status=UNDECIDED, reason=reason)
        return self.add_fix(
            describe(self.document, chain, k, decision), chain, k, against, decision, knowledge
        )

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

        lone = isinstance(left.node, Name)
        other = None if lone else (left, proves_left)
        return add_fix(verdict, self.document, right, decision, knowledge, proves_right, other)


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
