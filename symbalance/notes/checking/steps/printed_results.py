"""Numbers that a page has computed for its letters: F_I = m r ω² = 6.79 kN, and ½ F_I = 3.40 kN below.

A datum behind a letter may be out of reach where the letter is used, as one that was given "with" a
number in another section. What the page printed for the letter itself still stands, as long as nothing
behind the letter has another number since.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import islice, product

from symbalance.document.formula import Formula, Name, Number, Product, names, walk
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import REFUTED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import LONG, is_lone_number, significant_digits
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import replace_part, substitute
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.words.plain_formulas import lone_side
from symbalance.notes.reading.equations import Chain, Side

MOST_CHOICES = 8
"""Ways to take the letters' numbers as printed, where lines print them in several units."""


@dataclass
class PrintedResults:
    """The numbers that a page has proved last for each of its letters, with their line.

    A line may print one in several units, α = 0.0127 rad = 0.73°: what follows may go on with either.
    """

    numbers: dict[str, tuple[int, list[Formula]]] = field(default_factory=dict)
    places: dict[str, int] = field(default_factory=dict)
    """Where the relation begins that printed a letter's numbers last."""
    of_formulas: dict[Fraction, Formula] = field(default_factory=dict)
    """The formulas that printed numbers of three digits stand for: 4549 for m r ω²."""

    def note(self, chain: Chain, k: int, given_anew: Mapping[str, int]) -> None:
        """Note the number of a letter, or of a formula, that a proved relation gives in its chain.

        What the line printed before some letter got another number there is of that other case.
        """
        head, value = chain.sides[0].node, chain.sides[k + 1].node
        if names(value):
            return
        if isinstance(head, Name):
            line, values = self.numbers.get(head.name, (0, []))
            since = max(given_anew.values(), default=-1)
            is_here = line == chain.lines[0] and self.places.get(head.name, -1) >= since
            own = values if is_here else []
            self.numbers[head.name] = (chain.lines[0], [value, *own])
            self.places[head.name] = chain.start
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

    def decide(
        self, chain: Chain, k: int, knowledge: Knowledge, given_anew: Mapping[str, int]
    ) -> Decision | None:
        """Return the decision on a number by those of the letters beside it; None where one has none.

        `given_anew` tells where letters got another number than before, perhaps within one line.
        """
        left, right = chain.sides[k].node, chain.sides[k + 1]
        if not names(left) or not is_lone_number(right.node):
            return None
        is_letter = isinstance(left, Name)
        if isinstance(left, Name):  # k = 203.5 kN m by k = G I/L, with the I that was printed
            definition = knowledge.definitions.get(left.name)
            if definition is None or definition.numeric or definition.alternatives:
                return None
            left = definition.node
        printed = {name: self._numbers(name, knowledge, given_anew) for name in sorted(names(left))}
        lacking = [name for name, values in printed.items() if not values]
        if any(number_of(Name(name), knowledge) is None for name in lacking):
            return None
        choices = {name: values for name, values in printed.items() if values}
        if is_letter and not choices:
            return None
        first: Decision | None = None
        for chosen in islice(product(*choices.values()), MOST_CHOICES):
            node = left
            for name, value in zip(choices, chosen, strict=True):
                node = substitute(node, name, value)
            decision = decide(lone_side(node), right, chain.relations[k].sign, knowledge)
            if decision.is_proved:
                return decision
            first = first or decision
        return first if first is not None and first.status == REFUTED and not is_letter else None

    def _numbers(self, name: str, knowledge: Knowledge, given_anew: Mapping[str, int]) -> list[Formula]:
        """Return what the page has printed for a letter, none if it stands for something else since."""
        line, printed = self.numbers.get(name, (0, []))
        if not printed or name in knowledge.angles | knowledge.universal:
            return []
        values = {n: d.node for n, d in knowledge.definitions.items()} | dict(knowledge.meaning.values)
        behind = {name, *names_behind(Name(name), values)}
        place = self.places.get(name, -1)
        newer = any(
            n in knowledge.definitions
            and (knowledge.definitions[n].line > line or given_anew.get(n, -1) > place)
            for n in behind
        )
        return [] if newer or behind & knowledge.angles else printed
