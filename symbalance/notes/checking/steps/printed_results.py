"""Numbers that a page has computed for its letters: F_I = m r ω² = 6.79 kN, and ½ F_I = 3.40 kN below.

A datum behind a letter may be out of reach where the letter is used, as one that was given "with" a
number in another section. What the page printed for the letter itself still stands, as long as nothing
behind the letter has another number since.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from fractions import Fraction

from symbalance.document.formula import Formula, Name, Number, Product, names, walk
from symbalance.notes.algebra.tree_values import names_behind
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import LONG, is_lone_number, significant_digits
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import replace_part, substitute
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading.equations import Chain, Side


@dataclass
class PrintedResults:
    """The last number that a page has proved for each of its letters, with its line."""

    numbers: dict[str, tuple[int, Formula]] = field(default_factory=dict)
    of_formulas: dict[Fraction, Formula] = field(default_factory=dict)
    """The formulas that printed numbers of three digits stand for: 4549 for m r ω²."""

    def note(self, chain: Chain, k: int) -> None:
        """Note the number of a letter, or of a formula, that a proved relation gives in its chain."""
        head, value = chain.sides[0].node, chain.sides[k + 1].node
        if names(value):
            return
        if isinstance(head, Name):
            self.numbers[head.name] = (chain.lines[0], value)
        number = value.factors[0] if isinstance(value, Product) else value
        formula = next((s.node for s in reversed(chain.sides[: k + 1]) if names(s.node)), None)
        is_long = isinstance(number, Number) and significant_digits(number) >= LONG
        if isinstance(number, Number) and is_long and formula is not None and is_lone_number(value):
            self.of_formulas[number.value] = formula

    def with_formulas(self, side: Side) -> Side | None:
        """Return an arithmetic with the formulas that its numbers were printed for, None without any."""
        node = side.node
        if is_lone_number(node):
            return None
        for part in [p for p in walk(node) if isinstance(p, Number)]:
            if part.value in self.of_formulas and significant_digits(part) >= LONG:
                node = replace_part(node, part, self.of_formulas[part.value])
        return None if node is side.node else replace(side, readings=(node,))

    def decide(self, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
        """Return the decision on a number by those of the letters beside it; None where one has none."""
        left, right = chain.sides[k].node, chain.sides[k + 1]
        if not names(left) or not is_lone_number(right.node):
            return None
        is_letter = isinstance(left, Name)
        if isinstance(left, Name):  # k = 203.5 kN m by k = G I/L, with the I that was printed
            definition = knowledge.definitions.get(left.name)
            if definition is None or definition.numeric or definition.alternatives:
                return None
            left = definition.node
        are_printed = False
        for name in sorted(names(left)):
            value = self._number(name, knowledge)
            if value is not None:
                left, are_printed = substitute(left, name, value), True
            elif number_of(Name(name), knowledge) is None:
                return None
        if is_letter and not are_printed:
            return None
        decision = decide(lone_side(left), right, chain.relations[k].sign, knowledge)
        is_refuted = decision.status == REFUTED and not is_letter
        return decision if decision.is_proved or is_refuted else None

    def _number(self, name: str, knowledge: Knowledge) -> Formula | None:
        """Return what the page has printed for a letter, None if it stands for something else since."""
        line, value = self.numbers.get(name, (0, None))
        if value is None or name in knowledge.angles | knowledge.universal:
            return None
        values = {n: d.node for n, d in knowledge.definitions.items()} | dict(knowledge.meaning.values)
        behind = {name, *names_behind(Name(name), values)}
        newer = any(n in knowledge.definitions and knowledge.definitions[n].line > line for n in behind)
        return None if newer or behind & knowledge.angles else value
