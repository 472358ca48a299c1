"""Letters that a document has defined so far, with their values, each as far as its scope reaches."""

from __future__ import annotations

from dataclasses import dataclass, field

from symbalance.document.formula import Formula, Name, names
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import Domain, NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator, SymbolValue
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.algebra.tree_values import letters_behind, sample_trees
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.constraints import letter_counts, solve_for
from symbalance.notes.checking.deciding.equality import Decision, without_dots
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.sidecar import Declarations
from symbalance.notes.checking.verdicts import DEFINITION
from symbalance.notes.reading.equations import Chain, Side

NEARLY = 0.1
"""Relative difference: a second value closer to the first is a slip, not a new case."""


@dataclass
class Definitions:
    """The letters a document has given values, and those it has used at all."""

    declarations: Declarations
    values: dict[str, tuple[Definition, tuple[int, ...]]] = field(default_factory=dict)
    letters_in_use: set[str] = field(default_factory=set)
    conditions: dict[int, frozenset[str]] = field(default_factory=dict)
    """Lines that set two known quantities equal, with the letters these come down to."""

    def at(self, line: int) -> dict[str, Definition]:
        """Return the definitions that reach a line, of the letters as declared there."""
        scopes_here, owner = set(self.declarations.scope_at(line)), self.declarations.owner
        return {
            name: definition
            for name, (definition, scopes) in self.values.items()
            if set(scopes) <= scopes_here and owner(name, definition.line) == owner(name, line)
        }

    def define(self, name: str, node: Formula, line: int) -> None:
        """Define a letter's value from here on."""
        scopes = self.declarations.scope_at(line)
        self.values[name] = (Definition(node, line, not names(node)), scopes)

    def use(self, chain: Chain) -> None:
        """Note the letters of a chain."""
        self.letters_in_use |= {name for side in chain.sides for name in names(side.node)}

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
        if name in knowledge.meaning.kinds.identities:
            return None
        line = chain.lines[0]
        if name in knowledge.meaning.values:
            return self._define_size(name, value, line, knowledge)
        if knowledge.measures(name) and name in _letters_of(value, knowledge):
            return None  # λ = 2l/r: it says something of the geometry, and may be wrong
        if name in knowledge.definitions:
            return self._redefine(name, value, chain.relations[k].sign, line, knowledge)
        self.define(name, without_dots(value)[0], line)
        return Decision(DEFINITION)

    def _redefine(
        self, name: str, value: Formula, sign: str, line: int, knowledge: Knowledge
    ) -> Decision | None:
        """Return the decision on another value of a defined letter: a new case, a condition, or None."""
        earlier = knowledge.definitions[name]
        if not _new_case(earlier, value, sign, knowledge):
            return None
        if isinstance(value, Name) and value.name in knowledge.definitions:
            self.conditions[line] = frozenset(_letters_behind([earlier.node, value], knowledge))
            return Decision(DEFINITION, "a condition")
        self.define(name, without_dots(value)[0], line)
        return Decision(DEFINITION, f"a new case: line {earlier.line} had another value")

    def _define_size(self, name: str, value: Formula, line: int, knowledge: Knowledge) -> Decision | None:
        """Return the decision on a size that is fixed by itself, such as l = 4r: a case, λ = 4."""
        if knowledge.crank is None or knowledge.crank.small is None or name in knowledge.moving:
            return None
        base = _solve_for_one_letter(knowledge.meaning.values[name], value)
        if base is not None:
            self.define(*base, line)
            return Decision(DEFINITION)
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
        self.define(small, rational_node(number), line)
        return Decision(DEFINITION, f"a case: {formula_text(Name(small), plain=True)} = {number}")

    def _letter_defined(self, chain: Chain, k: int) -> tuple[str, Formula] | None:
        """Return the letter a relation may define, and its value."""
        left, right = chain.sides[k].node, chain.sides[k + 1].node
        if k == 0 and isinstance(left, Name) and left.name not in names(right):
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


def _letters_behind(nodes: list[Formula], knowledge: Knowledge) -> list[str]:
    values = {name: d.node for name, d in knowledge.definitions.items()}
    return [name for node in nodes for name in letters_behind(node, values)]


def _comes_to_a_number(node: Formula, knowledge: Knowledge) -> bool:
    """Tell whether a formula has a number by all that is known: another one then contradicts it."""
    level = list(knowledge.levels(node))[-1]
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
