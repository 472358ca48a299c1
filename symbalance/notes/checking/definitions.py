"""What a document has defined so far: letters with their values, each as far as its scope reaches."""

from __future__ import annotations

from dataclasses import dataclass, field

from symbalance.document.formula import Formula, Name, names
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import Domain, NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import Evaluator, Meaning
from symbalance.notes.algebra.numbers import rational_node
from symbalance.notes.algebra.trees import letters_behind, sample_trees
from symbalance.notes.algebra.values import letters
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.relations import judged
from symbalance.notes.checking.deciding.steps import Answer, without_dots
from symbalance.notes.checking.premises import counts, undone
from symbalance.notes.checking.sidecar import Declarations
from symbalance.notes.checking.verdicts import DEFINITION
from symbalance.notes.reading.equations import Chain, Side

NEARLY = 0.1


@dataclass
class Definitions:
    """The letters a document has given values, and those it has used at all."""

    declarations: Declarations
    known: dict[str, tuple[Definition, tuple[int, ...]]] = field(default_factory=dict)
    seen: set[str] = field(default_factory=set)
    conditions: dict[int, frozenset[str]] = field(default_factory=dict)
    """Lines that set two known quantities equal, with the letters these come down to."""

    def at(self, line: int) -> dict[str, Definition]:
        """Return the definitions that reach a line, of the letters as declared there."""
        here, owner = set(self.declarations.scope_at(line)), self.declarations.owner
        return {
            name: definition
            for name, (definition, scopes) in self.known.items()
            if set(scopes) <= here and owner(name, definition.line) == owner(name, line)
        }

    def learn(self, name: str, node: Formula, line: int) -> None:
        """Keep a letter's value from here on."""
        scopes = self.declarations.scope_at(line)
        self.known[name] = (Definition(node, line, not names(node)), scopes)

    def use(self, chain: Chain) -> None:
        """Note the letters of a chain."""
        self.seen |= {name for side in chain.sides for name in names(side.node)}

    def condition_behind(self, answer: Answer, line: int) -> int | None:
        """Return the line of a condition that a refuted relation may rest on: it shares two letters."""
        if answer.left is None or answer.right is None:
            return None
        mine = {*letters(answer.left), *letters(answer.right)}
        found = [n for n, others in self.conditions.items() if n < line and len(mine & others) > 1]
        return found[-1] if found else None

    def stated(self, chain: Chain, k: int, knowledge: Knowledge) -> Answer | None:
        """Return the answer for a relation that gives a letter its value, after learning it."""
        found = self._letter(chain, k)
        if found is None or knowledge.assumes(found[0]):
            return None
        name, value = found
        line = chain.lines[0]
        if name in knowledge.meaning.values:
            return self._size(name, value, line, knowledge)
        if knowledge.measures(name) and name in _letters_of(value, knowledge):
            return None  # λ = 2l/r: it says something of the geometry, and may be wrong
        if name in knowledge.definitions:
            return self._again(name, value, chain.relations[k].sign, line, knowledge)
        self.learn(name, without_dots(value)[0], line)
        return Answer(DEFINITION)

    def _again(
        self, name: str, value: Formula, sign: str, line: int, knowledge: Knowledge
    ) -> Answer | None:
        """Return the answer for another value of a defined letter: a new case, a condition, or None."""
        earlier = knowledge.definitions[name]
        if not _new_case(earlier, value, sign, knowledge):
            return None
        if isinstance(value, Name) and value.name in knowledge.definitions:
            self.conditions[line] = frozenset(_letters_behind([earlier.node, value], knowledge))
            return Answer(DEFINITION, "a condition")
        self.learn(name, without_dots(value)[0], line)
        return Answer(DEFINITION, f"a new case: line {earlier.line} had another value")

    def _size(self, name: str, value: Formula, line: int, knowledge: Knowledge) -> Answer | None:
        """Return the answer for a size that is fixed by itself, such as l = 4r: a case, λ = 4."""
        if knowledge.crank is None or knowledge.crank.small is None or name in knowledge.moving:
            return None
        base = _solved(knowledge.meaning.values[name], value)
        if base is not None:
            self.learn(*base, line)
            return Answer(DEFINITION)
        small, evaluator = knowledge.crank.small[0], Evaluator(Domain(), knowledge.meaning)
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
        self.learn(small, rational_node(number), line)
        return Answer(DEFINITION, f"a case: {formula_text(Name(small), plain=True)} = {number}")

    def _letter(self, chain: Chain, k: int) -> tuple[str, Formula] | None:
        """Return the letter a relation may define, and its value."""
        left, right = chain.sides[k].node, chain.sides[k + 1].node
        if k == 0 and isinstance(left, Name) and left.name not in names(right):
            return left.name, right
        if isinstance(right, Name) and right.name not in names(left) | self.seen:
            return right.name, left
        return None


def _solved(node: Formula, value: Formula) -> tuple[str, Formula] | None:
    """Return the one letter a size is written in, and its value if the size has a number: s = 2r = 87."""
    found = counts(node)
    if names(value) or list(found.values()) != [1]:
        return None
    (letter,) = found
    solved = undone(node, value, letter)
    return None if solved is None else (letter, solved)


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
        return letters(Evaluator(Domain(), knowledge.meaning).form(value))
    except (NoFormError, TooLargeError):
        return []


def _new_case(earlier: Definition, value: Formula, sign: str, knowledge: Knowledge) -> bool:
    """Tell whether another value of a letter starts a new case, and is not a slip.

    It does between lone letters or numbers (θ = 0, then θ = π/2), unless two numbers nearly agree.
    """
    old = Side((earlier.node,), (0, 0))
    if sign == "≈" or judged(old, Side((value,), (0, 0)), sign, knowledge).proved:
        return False
    if names(earlier.node) and names(value):
        return isinstance(value, Name)
    if names(earlier.node) or names(value):
        return not _comes_to_a_number(earlier.node, knowledge)
    points = sample_trees([earlier.node, value], Meaning(), 1)
    if not points:
        return True
    one, other = points[0][1]
    return abs(one - other) > NEARLY * max(abs(one), abs(other))
