r"""Relations that are said for some whole numbers: Σ cos k(θ + 2πj/3) = 0 for k = 1, 2, 4, 5.

Each number of the list is put in, and every one of the relations has to hold; of a list without end,
k = 3, 6, 9, …, the step is taken: k = 3 + 3n.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise

from symbalance.document.formula import Formula, Name, Number, Product, Sum, names
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.reading.equations import Chain, ReadNotes, Side

_FOR = re.compile(
    r"(?:[\s$)}\].,;:~(]|\\\)|\\q?quad|\\[,;: ]|\\(?:text|mbox)\s*\{[^{}]{0,20}\}"
    r"|(?:only\s+)?(?:for|für|with|where|when|if|bei|mit|all|alle)(?![A-Za-z]))*"
    r"(?P<letter>[A-Za-z])\s*=\s*(?P<list>[-−]?[0-9]{1,3}(?:\s*,\s*(?:\\[,;: ]\s*)*[-−]?[0-9]{1,3})+)"
    r"(?P<dots>\s*,\s*(?:\\[,;: ]\s*)*(?:\\(?:l|c)?dots(?![A-Za-z])|…|\.{3}))?"
    r"(?!\s*,?\s*(?:\\?[A-Za-z]{0,6}dots|…|\.\.))"
)
_MOST = 12


@dataclass(frozen=True)
class Listed:
    """A letter and the values that a relation is said for; `is_endless` where they go on so."""

    letter: str
    values: tuple[int, ...]
    is_endless: bool

    def formulas(self) -> list[Formula]:
        """Return what is put in for the letter: its values, or 3 + 3n of values without end."""
        if not self.is_endless:
            return [Number(Fraction(value)) for value in self.values]
        step = Number(Fraction(self.values[1] - self.values[0]))
        return [Sum((Number(Fraction(self.values[0])), Product((step, Name(self.counter)))))]

    @property
    def counter(self) -> str:
        """A letter for the number of steps that no page has."""
        return f"{self.letter}_steps"


def values_listed(page: ReadNotes, chain: Chain) -> Listed | None:
    """Return the whole numbers that a relation is said for right behind it, None where there are none."""
    match = _FOR.match(page.text, chain.end)
    if match is None or match["letter"] not in chain.letters:
        return None
    values = [int(number.replace("−", "-")) for number in re.findall(r"[-−]?[0-9]+", match["list"])]
    steps = {after - before for before, after in pairwise(values)}
    is_endless = match["dots"] is not None
    if len(values) > _MOST or (is_endless and (len(steps) > 1 or 0 in steps)):
        return None
    return Listed(match["letter"], tuple(values), is_endless)


def decide_for_values(page: ReadNotes, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Decide a relation that is said for listed values of a letter; None for any other.

    A letter alone on the left is defined, and not claimed to be anything.
    """
    left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
    listed = None if isinstance(left.node, Name) else values_listed(page, chain)
    if listed is None or listed.letter in knowledge.definitions:
        return None
    if listed.letter not in names(left.node) | names(right.node):
        return None
    integer = knowledge.meaning.integer | {listed.counter}
    known = replace(knowledge, meaning=replace(knowledge.meaning, integer=integer))
    last: Decision | None = None
    for value in listed.formulas():
        try:
            first, second = _at(left, listed.letter, value), _at(right, listed.letter, value)
        except NoFormError:
            return None
        decision = decide(first, second, sign, known)
        if decision.status == REFUTED and listed.is_endless:
            return replace(decision, status=UNDECIDED, reason="not shown for all of the values listed")
        if not decision.is_proved:
            if isinstance(value, Number):
                decision = replace(decision, reason=f"for {listed.letter} = {value.value}")
            return decision
        last = decision
    return last


def _at(side: Side, letter: str, value: Formula) -> Side:
    return side.changed(lambda node: substitute(node, letter, value))
