"""Numbers for letters that equations above give one already: after c = cos θ = 0.2247, θ = 77.0°.

A first number for a letter is its definition, and another one than before may be a new case. But where
the page has an equation in which all other letters have numbers, the number can be computed: it is what
the equation gives, to the digits printed, or it is wrong. One that is computed from a result that is
refuted where it stands, c = cos θ = 0.2956, goes on with it: that is no second slip.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Sum,
    names,
    walk,
)
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import NoFormError
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.checking.deciding.equality import PROVED, REFUTED, Decision, digits, without_dots
from symbalance.notes.checking.deciding.knowledge import Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import is_lone_number
from symbalance.notes.checking.deciding.rounding import decimals
from symbalance.notes.checking.deciding.substitution import replace_part, substitute
from symbalance.notes.checking.meant.meant_words import NOBODY
from symbalance.notes.checking.premises.impossible_values import number_of
from symbalance.notes.checking.units.formulas_between_numbers import may_convert
from symbalance.notes.checking.verdicts import (
    CONDITION,
    DEFINITION,
    PREMISE,
    PROVED_WORDS,
    UNDECIDED,
    Verdict,
)
from symbalance.notes.reading.equations import Chain

MOST = 12
"""Equations, the last ones, that a number is put into."""
FAR_IN_PLACES, FAR = Fraction(3, 2), Fraction(1, 200)
"""Units of its last place, and part of itself, that a number may be off before it is called wrong."""


@dataclass(frozen=True, slots=True)
class GivenEquation:
    """An equation that a page takes as given, or one of which nobody knows (`is_sure`)."""

    left: Formula
    right: Formula
    line: int
    is_sure: bool

    @property
    def converts_units(self) -> bool:
        """Whether it is between the numbers of quantities, and the quantities do not satisfy it."""
        if is_lone_number(self.right):  # a result: no constant stands there that could convert
            return may_convert(self.left)
        return may_convert(self.left) or may_convert(self.right)

    @property
    def text(self) -> str:
        """The equation for a reason."""
        return f"{formula_text(self.left, plain=True)} = {formula_text(self.right, plain=True)}"


@dataclass
class GivenNumbers:
    """The equations that a page has so far for the numbers of its letters."""

    equations: list[GivenEquation] = field(default_factory=list)
    wrong_results: list[GivenEquation] = field(default_factory=list)
    """What formulas are equal to by lines that are refuted: sin β = 0.03, after sin β = λ = 0.3."""

    def note(self, chain: Chain, k: int, verdict: Verdict) -> None:
        """Note a relation that is given, as a definition or condition; a series and ≈ fix no number."""
        left, right = chain.sides[k].node, chain.sides[k + 1].node
        if k and verdict.verdict in (*PROVED_WORDS, PREMISE):
            self._note_result(chain, right, self.equations)
        elif verdict.verdict == REFUTED:
            self._note_result(chain, right, self.wrong_results)
        is_given = verdict.verdict in (DEFINITION, PREMISE, CONDITION) or NOBODY in verdict.assumption
        if chain.relations[k].sign != "=" or not (is_given or verdict.verdict == UNDECIDED):
            return
        is_series = any(without_dots(node)[1] for node in (left, right))
        is_value = isinstance(left, Name) and not names(right)  # another value may be another case
        if names(left) | names(right) and not is_series and not is_value:
            self.equations.append(GivenEquation(left, right, chain.lines[0], is_given))

    @staticmethod
    def _note_result(chain: Chain, right: Formula, results: list[GivenEquation]) -> None:
        """Note the number at the end of a chain that begins with a formula: sin β = λ/2 = 0.1435."""
        head = chain.sides[0].node
        is_formula = bool(names(head)) and not isinstance(head, Name)
        if is_formula and is_lone_number(right) and all(each.sign in "=≈" for each in chain.relations):
            results.append(GivenEquation(head, right, chain.lines[0], True))

    def goes_on_with(self, name: str, value: Formula, knowledge: Knowledge) -> Decision | None:
        """Return the proof of a letter's number from a result that is refuted where it stands."""
        near = _interval(value, Fraction(1, 2))
        for result in self.wrong_results[::-1][:MOST]:
            if name in names(result.left) and _has_root(result, name, near, knowledge):
                text = f"{result.text} of line {result.line}, which is refuted"
                return Decision(PROVED, order="the digits printed", assumptions=(text,))
        return None

    def end(self, letters: frozenset[str], first: int) -> None:
        """Leave the numbers that lines from a first one on give what holds any of some letters."""
        self.equations = [
            e for e in self.equations if e.line < first or names(e.right) or not names(e.left) & letters
        ]

    def decide(
        self,
        name: str,
        value: Formula,
        line: int,
        first: int,
        knowledge: Knowledge,
        *,
        of_it_alone: bool = False,
    ) -> Decision | None:
        """Return the decision on a number by what equations give; None where none gives one.

        It is refuted where an equation from line `first` on, or one with a letter that has its number
        there, gives another: what stands apart may be of another engine. With `of_it_alone` only
        equations without other letters count, sin β = 0.1435.
        """
        others = {n: d for n, d in knowledge.definitions.items() if n != name}
        known = replace(knowledge, definitions=others)
        near, far = _interval(value, Fraction(1, 2)), _interval(value, FAR_IN_PLACES, FAR)
        proof: GivenEquation | None = None
        wrong: GivenEquation | None = None
        for equation in self._about(name, known):
            if equation.line == line and equation.right is value:
                continue
            if of_it_alone and names(equation.left) | names(equation.right) != {name}:
                continue
            is_solution = _has_root(equation, name, near, known)
            if is_solution:
                proof = proof or equation
            elif is_solution is False and equation.is_sure and not equation.converts_units:
                is_near = equation.line >= first or self._has_number_there(equation, first, known)
                if is_near and _has_root(equation, name, far, known) is False:
                    wrong = wrong or equation
        if proof is not None and wrong is None:
            reason = f"by line {proof.line}"
            texts = () if proof.is_sure else (proof.text,)
            return Decision(PROVED, reason, order="the digits printed", assumptions=texts)
        return None if wrong is None or proof is not None else _refuted(wrong, name, value, known)

    def _about(self, name: str, knowledge: Knowledge) -> Iterator[GivenEquation]:
        own = [
            e for e in self.equations if name in names(e.left) | names(e.right) and not _is_value(e, name)
        ]
        for equation in own[::-1][:MOST]:
            others = (names(equation.left) | names(equation.right)) - {name}
            if all(n in knowledge.definitions or knowledge.has_meaning(n) for n in others):
                yield equation

    @staticmethod
    def _has_number_there(equation: GivenEquation, first: int, knowledge: Knowledge) -> bool:
        values = {n: d.node for n, d in knowledge.definitions.items()} | dict(knowledge.meaning.values)
        sides = equation.left, equation.right
        behind = {n for node in sides for n in names_behind(node, values)}
        return any(n in knowledge.definitions and knowledge.definitions[n].line >= first for n in behind)


def _is_value(equation: GivenEquation, name: str) -> bool:
    """Tell whether an equation is only another number of the letter, whose cases are judged elsewhere."""
    return equation.left == Name(name) and not names(equation.right)


Interval = tuple[Formula, Formula, Formula]


def _interval(value: Formula, places: Fraction, part: Fraction = Fraction(0)) -> Interval | None:
    """Return a printed number with the ends of what it stands for, None for what is no lone number."""
    numbers = decimals(value)
    bare = value.operand if isinstance(value, Negative) else value
    if not numbers:  # of degrees to the degree, of a whole number that it is exact
        angle = bare.factors[0] if isinstance(bare, Product) else None
        turns = isinstance(bare, Product) and any(isinstance(part, Constant) for part in walk(bare))
        is_angle = isinstance(angle, Number) and turns  # 2½ in is a product too, of the inch
        numbers = [n for n in (angle, bare) if isinstance(n, Number)]
        place = Fraction(1) if is_angle else Fraction(0)
    else:
        place = numbers[0].last_place or Fraction(0)
    if len(numbers) != 1:
        return None
    (number,) = numbers
    off = max(place * places, abs(number.value) * part)
    ends = (replace_part(value, number, Number(number.value + step)) for step in (-off, off))
    low, high = ends
    return low, value, high


def _has_root(
    equation: GivenEquation, name: str, interval: Interval | None, knowledge: Knowledge
) -> bool | None:
    """Tell whether an equation has a solution among values of a letter; None where it gives no numbers.

    An identity has one everywhere, and gives none.
    """
    if interval is None:
        return None
    gaps = [_gap(equation, name, value, knowledge) for value in interval]
    if None in gaps:
        return None
    low, middle, high = (0 if abs(gap) < 1e-18 else gap for gap in gaps)
    if not middle:
        beside = _gap(equation, name, Sum((interval[1], rational_node(Fraction(1, 100)))), knowledge)
        return True if beside is not None and abs(beside) > 1e-18 else None
    return (low > 0) != (high > 0) and bool(low or high)


def _gap(equation: GivenEquation, name: str, value: Formula, knowledge: Knowledge) -> Any:
    gap = Sum((equation.left, Negative(equation.right)))
    try:
        return number_in_example(substitute(gap, name, value), knowledge)
    except NoFormError:
        return None


def number_in_example(node: Formula, knowledge: Knowledge) -> Any:
    """Return the number that a formula has in the example of which the numbers around it are."""
    level = list(knowledge.levels(node, rational_node(Fraction(0))))[-1]
    return number_of(node, replace(knowledge, meaning=replace(knowledge.meaning, values=level.values)))


def _refuted(equation: GivenEquation, name: str, value: Formula, knowledge: Knowledge) -> Decision | None:
    """Return the refutation by an equation, with what its sides differ by at the value as witness."""
    gap = _gap(equation, name, value, knowledge)
    if gap is None:
        return None
    witness = {name: digits(number_of(value, knowledge)), "left": digits(gap), "right": "0.0"}
    return Decision(REFUTED, f"does not satisfy {equation.text} of line {equation.line}", witness=witness)


def number_given(chain: Chain, k: int) -> tuple[str, Formula] | None:
    """Return the letter that a relation gives a number, first in its chain, and that; None for others."""
    left, right = chain.sides[0].node, chain.sides[1].node
    is_number = isinstance(left, Name) and not names(right) and chain.relations[0].sign in "=≈"
    return (left.name, right) if not k and isinstance(left, Name) and is_number else None


def size_given(chain: Chain, k: int) -> tuple[str, Formula] | None:
    """Return the letter whose size a relation gives as a number, |K| ≈ 4.98, and that; or None."""
    left, right = chain.sides[0].node, chain.sides[1].node
    if k or not isinstance(left, Call) or left.function != "abs" or chain.relations[0].sign not in "=≈":
        return None
    letter = left.argument
    return (letter.name, right) if isinstance(letter, Name) and is_lone_number(right) else None
