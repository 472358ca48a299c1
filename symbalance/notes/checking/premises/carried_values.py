"""Results that are wrong where they are printed, and right lines that go on with them.

F = m r ω² = 4065 is refuted, 4605 it is. λ F = 0.3·4065 = 1219.5 puts in what the page has: nothing new
is wrong there, and nobody is accused a second time; it holds with the value of the line before. So does
m_b r_b = 0.42·0.043/3.4 below m_b r_b = m r/λ, where that is refuted, T = J ω²/2 = m R² ω²/2 below
J = m R², and the derivative of a velocity that is wrong. The wrong formula once more is wrong once more.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction

from symbalance.document.formula import Derivative, Formula, Name, Negative, Number, names, walk
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.letters_behind import names_behind
from symbalance.notes.checking.deciding.equality import Decision
from symbalance.notes.checking.deciding.knowledge import Definition, Knowledge
from symbalance.notes.checking.deciding.numbers_put_in import LONG, significant_digits
from symbalance.notes.checking.deciding.substitution import replace_part
from symbalance.notes.reading.equations import Chain, Side

ONE_IS_WRONG = "one of the two is wrong"
"""The end of a reason: a number and a formula are at odds, and nothing says which is wrong."""
_SCALES = (1.0, 1e-3, 1e3)
_PLACES = Fraction(1, 10**9)
MOST = 6
"""Wrong results, the last ones, that a line may go on with."""


@dataclass(frozen=True, slots=True)
class WrongResult:
    """A value that a line gives and that is refuted there, with the formula it stands for."""

    value: Formula
    formula: Formula
    name: str
    line: int
    is_open: bool = False
    """Whether the value or the formula is wrong, and nothing says which."""

    @property
    def text(self) -> str:
        """What a line that goes on with it rests on."""
        value = formula_text(self.value, plain=True)
        is_of_formula = bool(names(self.value)) and not self.name
        of = self.formula if is_of_formula else Name(self.name)
        letter = f"{formula_text(of, plain=True)} = " if self.name or is_of_formula else ""
        return f"{letter}{value} of line {self.line}, which is {'open' if self.is_open else 'refuted'}"


@dataclass
class CarriedValues:
    """The wrong results of a page so far."""

    results: list[WrongResult] = field(default_factory=list)

    def note(self, chain: Chain, k: int, *, is_open: bool = False) -> None:
        """Note the refuted k-th relation of a chain: a number for a formula in letters, or a formula.

        So with one that is at odds with a line which nothing proves (`is_open`).
        """
        node = chain.sides[k + 1].node
        number = node.operand if isinstance(node, Negative) else node
        of = next((s.node for s in reversed(chain.sides[: k + 1]) if names(s.node)), None)
        head = chain.sides[0].node
        name = head.name if isinstance(head, Name) else ""
        is_long = isinstance(number, Number) and significant_digits(number) >= LONG
        is_result = is_long or bool(name and not names(node))
        if is_result and of is not None:
            self.results.append(WrongResult(node, of, name, chain.lines[0], is_open))
        elif isinstance(head, Name) and names(node) and head.name not in names(node):
            self.results.append(WrongResult(node, head, head.name, chain.lines[0], is_open))
        elif names(head) and names(node) and not isinstance(head, Name):
            self.results.append(WrongResult(node, head, "", chain.lines[0], is_open))

    def decide(
        self,
        sides: tuple[Side, Side],
        knowledge: Knowledge,
        decide: Callable[[Side, Side, Knowledge], Decision],
        value_of: Callable[[Formula], float | None],
    ) -> Decision | None:
        """Return the proof of a refuted relation from a wrong result it goes on with, if there is one."""
        left, right = sides
        for wrong in reversed(self.results[-MOST:]):
            typed = [
                part
                for part in walk(right.node)
                if isinstance(part, Number)
                and part is not right.node
                and significant_digits(part) >= LONG
                and _is_same(part, wrong.value)
            ]
            exact = value_of(wrong.formula) if typed and names(left.node) else None
            if exact:
                assert isinstance(wrong.value, Number)
                scale = _scale(typed[0], wrong.value)
                number = Number(Fraction(exact) / scale, _PLACES * abs(Fraction(exact)) / scale)
                node = replace_part(right.node, typed[0], number)
                there = decide(left, replace(right, readings=(node,)), knowledge)
                if there.is_proved:
                    return replace(there, assumptions=(*there.assumptions, wrong.text))
            for known, of_wrong in _with_wrong(wrong, left, right, knowledge):
                there = decide(replace(left, readings=(of_wrong,)), right, known)
                if there.is_proved:
                    return replace(there, assumptions=(*there.assumptions, wrong.text))
        return None


def _with_wrong(
    wrong: WrongResult, left: Side, right: Side, knowledge: Knowledge
) -> Iterator[tuple[Knowledge, Formula]]:
    """Yield what a left side is with a wrong result for its letter or formula, and what is known then."""
    values = {n: d.node for n, d in knowledge.definitions.items()}
    is_number = not names(wrong.value)
    is_again = isinstance(wrong.formula, Name) or names(wrong.value) <= names(right.node)
    if not is_number and left.node == wrong.formula and is_again:
        return  # the same formula once more, or the letter again in other letters
    if is_number and left.node == Name(wrong.name):
        return  # the same number once more, perhaps at another place
    if not is_number and left.node == wrong.formula:
        yield knowledge, wrong.value
    if wrong.name in names_behind(left.node, values):
        earlier = knowledge.definitions.get(wrong.name) or Definition(wrong.value, wrong.line)
        own = replace(earlier, node=wrong.value, numeric=is_number, rounded=None)
        yield knowledge.with_definition(wrong.name, own), left.node
    rate, above = left.node, wrong.formula
    if isinstance(rate, Derivative) and isinstance(above, Derivative):
        is_of_it = (rate.expression, rate.variable) == (above.expression, above.variable)
        if is_of_it and rate.order > above.order:
            yield knowledge, Derivative(wrong.value, rate.variable, rate.order - above.order)


def _scale(typed: Number, printed: Number) -> Fraction:
    """Return what the number typed again is multiplied by to be the one that is printed: 1000 for kN."""
    ratio = float(printed.value / typed.value) if typed.value else 1.0
    return Fraction(round(ratio * 1000), 1000)


def _is_same(first: Number, second: Formula) -> bool:
    """Tell whether a number is typed again, perhaps in another unit."""
    return isinstance(second, Number) and any(
        math.isclose(float(first.value) * scale, float(second.value), rel_tol=1e-12) for scale in _SCALES
    )
