r"""Relations that are said for some values: Σ cos kθ_j = 0 for k = 1, 2, 4, cos θ = 0 at θ = ±π/2.

Each value of the list is put in, and every one of the relations has to hold; of a list of whole numbers
without end, k = 3, 6, 9, …, the step is taken: k = 3 + 3n.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise

from symbalance.document.formula import Constant, Formula, Name, Number, Product, Sum, names
from symbalance.document.letters import plain_letter
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.checking.deciding.equality import REFUTED, UNDECIDED, Decision
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.relations import decide
from symbalance.notes.checking.deciding.substitution import substitute
from symbalance.notes.reading.equations import Chain, ReadNotes, Side
from symbalance.notes.reading.letters.macro_letters import letter_in
from symbalance.notes.reading.spellings.listed_multiples import VALUE, is_of_degrees, multiple, written
from symbalance.text import lazy_patterns as re

_WORDS = r"(?:for|für|with|where|when|if|at|bei|mit|wenn|all|alle|both)(?![A-Za-z])"
_BLANK = r"[\s$)}\].,;:~(]|\\\)|\\\(|\\q?quad|\\[,;: ]"
_BEHIND = rf"(?:{_BLANK}|\\(?:text|mbox)\s*\{{[^{{}}]{{0,20}}\}}|(?:only\s+)?{_WORDS})*"
_BEHIND_WORD = rf"(?:{_BLANK}|\\(?:text|mbox)\s*\{{\s*)*(?<![A-Za-z]){_WORDS}(?:{_BLANK})*"
_FOR = re.compile(
    rf"{_BEHIND}"
    r"(?P<letter>[A-Za-z])\s*=\s*(?P<list>[-−]?[0-9]{1,3}(?:\s*,\s*(?:\\[,;: ]\s*)*[-−]?[0-9]{1,3})+)"
    r"(?P<dots>\s*,\s*(?:\\[,;: ]\s*)*(?:\\(?:l|c)?dots(?![A-Za-z])|…|\.{3}))?"
    r"(?!\s*,?\s*(?:\\?[A-Za-z]{0,6}dots|…|\.\.))"
)
_COMMA = r"\s*(?:,|(?<=\s)(?:and|or|und|oder)(?=\s))(?:\s|\\[,; ])*"
_PARTED = r"(?:\$\s*(?:,|and|or|und|oder)\s*\$|" + _COMMA + ")"
_AT = re.compile(
    rf"{_BEHIND_WORD}(?P<letter>\\[a-z]{{2,8}}(?![A-Za-z])|[^\W\d_](?![^\W\d_]))\s*=\s*"
    rf"(?P<list>{VALUE}(?:{_PARTED}{VALUE})*+)(?!{_COMMA}(?:\\[a-z]{{0,6}}dots|…|\.\.))"
    r"(?=\s*(?:\$|\\[)\]]|\\\\|[.,;)](?![0-9])|\n|$))"
)
"""Values that are multiples of one letter or angle, where the formula ends behind the last of them."""
_BETWEEN = re.compile(_PARTED)
_MOST, _FEWEST = 12, 2


@dataclass(frozen=True)
class Listed:
    """A letter and the values that a relation is said for; `is_endless` where they go on so."""

    letter: str
    values: tuple[Formula, ...]
    texts: tuple[str, ...]
    is_endless: bool = False
    is_of_multiples: bool = False

    def formulas(self) -> list[Formula]:
        """Return what is put in for the letter: its values, or 3 + 3n of values without end."""
        if not self.is_endless:
            return list(self.values)
        first, second = (value.value for value in self.values[:2] if isinstance(value, Number))
        return [Sum((Number(first), Product((Number(second - first), Name(self.counter)))))]

    @property
    def counter(self) -> str:
        """A letter for the number of steps that no page has."""
        return f"{self.letter}_steps"


def values_listed(page: ReadNotes, chain: Chain) -> Listed | None:
    """Return the values that a relation is said for right behind it, None where there are none."""
    match = _FOR.match(page.text, chain.end)
    if match is None or match["letter"] not in chain.letters:
        return _multiples_listed(page, chain)
    values = [int(number.replace("−", "-")) for number in re.findall(r"[-−]?[0-9]+", match["list"])]
    steps = {after - before for before, after in pairwise(values)}
    is_endless = match["dots"] is not None
    if len(values) > _MOST or (is_endless and (len(steps) > 1 or 0 in steps)):
        return None
    numbers = tuple(Number(Fraction(value)) for value in values)
    return Listed(match["letter"], numbers, tuple(map(str, values)), is_endless)


def _multiples_listed(page: ReadNotes, chain: Chain) -> Listed | None:
    """Return the multiples of a letter or an angle that a relation is said for, two of them or more."""
    match = _AT.match(page.text, chain.end)
    if match is None:
        return None
    letter = letter_in(page.text, match["letter"])
    parts = [multiple(value) for value in _BETWEEN.split(match["list"])]
    known = [part for part in parts if part is not None]
    if letter is None or letter not in chain.letters or len(known) < len(parts) or len(parts) > _MOST:
        return None
    sizes = [(size, part.letter) for part in known for size in part.sizes]
    if len(sizes) < _FEWEST or len({unit for size, unit in sizes if size}) > 1:
        return None
    formulas = [_formula(size, unit, page.text) for size, unit in sizes]
    texts = tuple(written(size, "°" if is_of_degrees(unit) else unit) for size, unit in sizes)
    values = tuple(value for value in formulas if value is not None)
    return Listed(letter, values, texts, is_of_multiples=True) if len(values) == len(formulas) else None


def _formula(size: Fraction, unit: str, document: str) -> Formula | None:
    """Return a number of times a letter or an angle as a formula, None where the unit is no letter."""
    if not unit or not size:
        return Number(size)
    if is_of_degrees(unit):
        return Product((Number(size / 180), Constant("pi")))
    name = letter_in(document, unit)
    if name is None:
        return None
    return Product((Number(size), Constant("pi") if name == "pi" else Name(name)))


def decide_for_values(page: ReadNotes, chain: Chain, k: int, knowledge: Knowledge) -> Decision | None:
    """Decide a relation that is said for listed values of a letter; None for any other.

    A letter alone on the left is defined, and not claimed to be anything. A cos θ = B at θ = 0, π may be
    solved for A and B, which nobody declared.
    """
    left, right, sign = chain.sides[k], chain.sides[k + 1], chain.relations[k].sign
    listed = None if isinstance(left.node, Name) else values_listed(page, chain)
    if listed is None or (listed.letter in knowledge.definitions and not listed.is_of_multiples):
        return None
    if listed.letter not in names(left.node) | names(right.node):
        return None
    integer = knowledge.meaning.integer | {listed.counter}
    known = replace(knowledge, meaning=replace(knowledge.meaning, integer=integer))
    others = (names(left.node) | names(right.node)) - {listed.letter}
    last: Decision | None = None
    for value, text in zip(listed.formulas(), listed.texts, strict=False):
        try:
            last = decide(_at(left, listed.letter, value), _at(right, listed.letter, value), sign, known)
        except NoFormError:
            return None
        if not last.is_proved:
            return _where_it_fails(last, listed, text, others, knowledge)
    return last


def _where_it_fails(
    decision: Decision, listed: Listed, text: str, others: Collection[str], knowledge: Knowledge
) -> Decision | None:
    """Return what is said of a relation that does not hold for one of the values."""
    if listed.is_endless:
        reason = "not shown for all of the values listed"
        return (
            replace(decision, status=UNDECIDED, reason=reason) if decision.status == REFUTED else decision
        )
    reason = f"for {plain_letter(listed.letter)} = {text}"
    if listed.is_of_multiples and not knowledge.meanings.keys() >= set(others):
        has_value = listed.letter in knowledge.definitions
        return replace(decision, status=UNDECIDED, reason=f"not {reason}") if has_value else None
    return replace(decision, reason=reason)


def _at(side: Side, letter: str, value: Formula) -> Side:
    return side.changed(lambda node: substitute(node, letter, value))
