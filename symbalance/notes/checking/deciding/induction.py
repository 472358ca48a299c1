"""Proofs by induction of sums with a letter in their bounds.

To show that T(1) + T(2) + ⋯ + T(N) equals C(N), with T(N) the last term as written, it suffices that

    C(1) = T(1)    and    C(N) - C(N-1) = T(N)

and both are identities without a sum. The same holds for Σ from k = a to U(N). The letter N stays free:
definitions that hold it (h = 4π/N) are not used.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

from symbalance.document import formula
from symbalance.document.formula import Dots, Formula, Name, Negative, Sum, Summation, names
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.algebra.sums import indexed_letters
from symbalance.notes.checking.deciding.equality import PROVED, UNDECIDED, Decision, decide_equality
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.substitution import replace_part, substitute


@dataclass(frozen=True, slots=True)
class Progression:
    """A sum over a letter: its last term as a function of `letter`, and where it starts."""

    part: Formula
    letter: str
    first_value: Formula
    first: Formula
    second: Formula | None
    last: Formula


def progressions(node: Formula) -> Iterator[Progression]:
    """Yield the ways a formula's one sum with open bounds may be read as a progression in a letter."""
    for part in formula.parts_of_kind(node, Summation, Sum):
        if isinstance(part, Summation) and part.index and part.lower and part.upper:
            yield from _of_summation(part)
        if isinstance(part, Sum) and any(isinstance(t, Dots) for t in part.terms[:-1]):
            yield from _of_dots(part)


def _of_summation(part: Summation) -> Iterator[Progression]:
    assert part.index
    if indexed_letters(part.body, part.index.name):
        return  # its terms are letters of their own each
    assert part.lower
    assert part.upper
    for letter in sorted(names(part.upper)):
        gap = Sum((Name(letter), Negative(part.upper), part.lower))  # N - U(N) + a
        first = substitute(part.body, part.index.name, part.lower)
        yield Progression(
            part, letter, gap, first, None, substitute(part.body, part.index.name, part.upper)
        )


def _of_dots(part: Sum) -> Iterator[Progression]:
    place = next(k for k, t in enumerate(part.terms) if isinstance(t, Dots))
    before, after = part.terms[:place], part.terms[place + 1 :]
    if not before or len(after) != 1:
        return
    first, *further = before
    for letter in sorted(names(after[0]) - names(first)):
        yield Progression(
            part, letter, rational_node(Fraction(1)), first, further[0] if further else None, after[0]
        )


def decide_by_induction(left: Formula, right: Formula, knowledge: Knowledge) -> Decision | None:
    """Decide left = right where one side holds one sum with open bounds; None if there is none."""
    try:
        return _decide_by_induction(left, right, knowledge)
    except NoFormError as problem:
        return Decision(UNDECIDED, str(problem))


def _decide_by_induction(left: Formula, right: Formula, knowledge: Knowledge) -> Decision | None:
    left, right = _with_sums_written_out(left, knowledge), _with_sums_written_out(right, knowledge)
    sums = list(progressions(left))
    if not sums:
        sums, left, right = list(progressions(right)), right, left
    if not sums:
        return None
    for progression in sums:
        if _proves(progression, left, right, _without(knowledge, progression.letter)):
            return Decision(PROVED, f"by induction over {progression.letter}")
    return Decision(UNDECIDED, "the sum was not brought to that form by induction")


def _with_sums_written_out(node: Formula, knowledge: Knowledge) -> Formula:
    """Return a formula with the letters that stand for sums replaced by those."""
    for name in names(node):
        definition = knowledge.definitions.get(name)
        if definition is not None and next(progressions(definition.node), None) is not None:
            node = substitute(node, name, definition.node)
    return node


def _without(knowledge: Knowledge, letter: str) -> Knowledge:
    definitions = {
        n: d for n, d in knowledge.definitions.items() if letter not in names(d.node) and n != letter
    }
    return replace(knowledge, definitions=definitions)


def _proves(part: Progression, left: Formula, right: Formula, knowledge: Knowledge) -> bool:
    """Tell whether C(1) = T(1) and C(N) - C(N-1) = T(N), and the terms written out are those of T."""

    def in_place(term: Formula) -> Formula:
        """Return the left side with a term in the place of the sum."""
        return replace_part(left, part.part, term)

    def at(value: Formula, side: Formula) -> Formula:
        return substitute(side, part.letter, value)

    nothing = rational_node(Fraction(0))
    if part.letter in names(in_place(nothing)):
        return False
    if isinstance(part.part, Sum):
        for k, term in ((1, part.first), (2, part.second)):
            instance = at(rational_node(Fraction(k)), part.last)
            if term is not None and not decide_equality(instance, term, knowledge).is_proved:
                return False
    start = decide_equality(in_place(part.first), at(part.first_value, right), knowledge)
    previous = Sum((Name(part.letter), Negative(rational_node(Fraction(1)))))
    difference = Sum((right, Negative(at(previous, right))))
    last_term = Sum((in_place(part.last), Negative(in_place(nothing))))
    return start.is_proved and decide_equality(last_term, difference, knowledge).is_proved
