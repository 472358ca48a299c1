"""Single changes to a formula that undo the slips people make, each with its kind and its cost.

A change names the part it replaces, so that the report can point at it. Nothing here is proved:
`fixes` reports a change only if the changed line is.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import isqrt

from symbalance.document import formula
from symbalance.document.formula import (
    Call,
    Constant,
    Derivative,
    Evaluation,
    Extremum,
    Formula,
    IndexedProduct,
    Integral,
    Limit,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Summation,
)
from symbalance.document.text_writer import formula_text
from symbalance.notes.algebra.domain import Domain, NoFormError, TooLargeError
from symbalance.notes.algebra.evaluation import FormEvaluator
from symbalance.notes.algebra.number_formulas import rational_node
from symbalance.notes.checking.words.written_degrees import degrees_of

_SWAPS = {
    "sin": ("cos", "tan"),
    "cos": ("sin", "tan"),
    "tan": ("sin", "cos"),
    "asin": ("acos",),
    "acos": ("asin",),
}
MOST_RADICAND = 60
"""Under a root that is put for another."""
MOST_LETTERS = 24
"""That are put in for others: the number of changes grows with it times the formula's parts."""


@dataclass(frozen=True, slots=True)
class Edit:
    """The part `old` of a formula replaced by `new`; `cost` ranks changes of equal effect."""

    kind: str
    cost: float
    old: Formula
    new: Formula

    def applied(self, parents: dict[int, Formula]) -> Formula:
        """Return the whole formula changed; `parents` leads from each part to what it is a part of."""
        old, new = self.old, self.new
        while id(old) in parents:
            outer = parents[id(old)]
            new = formula.with_children(
                outer, tuple(new if p is old else p for p in formula.children(outer))
            )
            old = outer
        return new


def parents_of(node: Formula) -> dict[int, Formula]:
    """Return, for each part of a formula, the part it stands in."""
    result: dict[int, Formula] = {}
    for outer in formula.walk(node):
        for part in formula.children(outer):
            result[id(part)] = outer
    return result


def parts(node: Formula, role: str = "side") -> Iterator[tuple[Formula, str]]:
    """Yield every part with its role: side, term, factor, exponent, argument or operand.

    The letter that an integral, a derivative or a sum runs over is none: ∫ f dθ² is no slip.
    """
    yield node, role
    running = _running_letter(node)
    for part in formula.children(node):
        if isinstance(part, formula.Dots) or part is running:
            continue
        yield from parts(part, _role(node, part, role))


def _running_letter(node: Formula) -> Formula | None:
    match node:
        case Derivative() | Integral() | Evaluation() | Limit() | Extremum():
            return node.variable
        case Summation() | IndexedProduct():
            return node.index
    return None


def _role(node: Formula, part: Formula, role: str) -> str:
    outer_role = role if role in ("argument", "angle term", "phase", "exponent") else ""
    if isinstance(node, Sum):
        angle = "angle term" if formula.names(part) else "phase"
        return angle if outer_role else "term"
    if isinstance(node, Power):
        return "exponent" if part is node.exponent else outer_role or "operand"
    if isinstance(node, Call):
        return "radicand" if node.function == "sqrt" and isinstance(part, Number) else "argument"
    if outer_role:
        return outer_role
    return "factor" if isinstance(node, Product | Quotient) else "operand"


def edits(node: Formula, letters: Iterable[str], variables: Iterable[str]) -> Iterator[Edit]:
    """Yield the single changes of a formula; `letters` may be put in, `variables` differentiated by."""
    known_letters = list(letters)[:MOST_LETTERS]
    yield from _all_functions(node)
    for part, role in parts(node):
        yield from _signs(part, role)
        yield from _functions(part)
        yield from _exponents(part, role)
        yield from _letters(part, known_letters)
        yield from phases(part)
        yield from multiples(part, role)
        yield from radicands(part, role)
        yield from _missing(part, role, known_letters)
        if isinstance(part, Derivative):
            for name in variables:
                if name != part.variable.name:
                    yield Edit(
                        "variable of differentiation",
                        1,
                        part,
                        Derivative(part.expression, Name(name), part.order),
                    )
            for order in (1, 2):
                if order != part.order:
                    yield Edit(
                        "order of differentiation",
                        1.2,
                        part,
                        Derivative(part.expression, part.variable, order),
                    )


def _signs(part: Formula, role: str) -> Iterator[Edit]:
    if isinstance(part, Negative):
        yield Edit("sign", 1, part, part.operand)
    elif role in ("side", "term", "angle term", "phase", "exponent") and not isinstance(part, Sum):
        # cos(−θ − π/6) is cos(θ + π/6), which is what a person would write
        cost = {"angle term": 1.05, "phase": 0.98}.get(role, 1)
        yield Edit("sign", cost, part, Negative(part))
    elif role == "side":
        yield Edit("sign", 1.1, part, Negative(part))


def _functions(part: Formula) -> Iterator[Edit]:
    if isinstance(part, Call):
        for function in _SWAPS.get(part.function, ()):
            yield Edit(f"{function} for {part.function}", 1, part, Call(function, part.argument))


def _all_functions(node: Formula) -> Iterator[Edit]:
    swapped_node = _with_functions_swapped(node)
    if swapped_node != node:
        yield Edit("sine and cosine exchanged", 1.05, node, swapped_node)


def _with_functions_swapped(node: Formula) -> Formula:
    parts_ = tuple(_with_functions_swapped(part) for part in formula.children(node))
    if isinstance(node, Call) and node.function in ("sin", "cos"):
        return Call("cos" if node.function == "sin" else "sin", parts_[0])
    return formula.with_children(node, parts_) if parts_ else node


def _exponents(part: Formula, role: str) -> Iterator[Edit]:
    if role == "exponent" and isinstance(part, Number) and part.value.denominator == 1:
        for value in range(2, 9):
            if value != part.value:
                yield Edit(
                    "exponent",
                    1.1 + abs(value - float(part.value)) / 100,
                    part,
                    rational_node(Fraction(value)),
                )
    if isinstance(part, Power):
        away = float(part.exponent.value) - 1 if isinstance(part.exponent, Number) else 20
        yield Edit("exponent", 1.1 + min(abs(away), 20) / 100, part, part.base)
    elif isinstance(part, Name | Call) and role != "exponent":
        for value in (2, 3):
            yield Edit("exponent", 1.2 + value / 100, part, Power(part, rational_node(Fraction(value))))
    if isinstance(part, Call) and part.function == "sqrt":
        yield Edit("root", 1.4, part, part.argument)


@cache
def _letter(name: str) -> str:
    """Return a letter as a page shows it: λ for lam."""
    return formula_text(Name(name), plain=True)


def _letters(part: Formula, letters: list[str]) -> Iterator[Edit]:
    if isinstance(part, Name):
        for name in letters:
            if name != part.name:
                yield Edit(f"{_letter(name)} for {_letter(part.name)}", 1.25, part, Name(name))
    if isinstance(part, Number) and part.last_place is None:
        for name in letters:
            yield Edit(f"{_letter(name)} for {part.value}", 1.6, part, Name(name))
    if isinstance(part, Name):
        for value in (1, 2):
            yield Edit(
                "letter too many" if value == 1 else f"2 for {_letter(part.name)}",
                1.5,
                part,
                rational_node(Fraction(value)),
            )


def _missing(part: Formula, role: str, letters: list[str]) -> Iterator[Edit]:
    if role in ("side", "term"):
        for name in letters:
            yield Edit(f"{_letter(name)} missing", 1.5, part, _product(part, Name(name)))
            yield Edit(f"{_letter(name)} too many", 1.55, part, Quotient(part, Name(name)))
            yield Edit(
                f"{_letter(name)}² missing",
                1.7,
                part,
                _product(part, Power(Name(name), rational_node(Fraction(2)))),
            )
        yield Edit("π missing", 1.6, part, _product(part, Constant("pi")))
    if isinstance(part, Sum) and role not in ("angle term", "argument"):
        for term in part.terms:
            if len(part.terms) > 1:
                rest = tuple(t for t in part.terms if t is not term)
                yield Edit("term too many", 1.8, part, rest[0] if len(rest) == 1 else Sum(rest))


def _product(part: Formula, factor: Formula) -> Formula:
    if isinstance(part, Negative):
        return Negative(_product(part.operand, factor))
    if isinstance(part, Quotient):
        return Quotient(_product(part.numerator, factor), part.denominator)
    if isinstance(part, Product):
        return Product((factor, *part.factors))
    one = part == Number(Fraction(1))
    return factor if one else Product((factor, part))


# Slips inside cos and sin: a phase not multiplied by the order, another order, another multiple of π


def phases(part: Formula) -> Iterator[Edit]:
    """A phase inside cos(nθ - φ) that was not multiplied by n, or was."""
    if not (
        isinstance(part, Call) and isinstance(part.argument, Sum) and part.function in ("sin", "cos")
    ):
        return
    multiple = _multiple(part.argument.terms[0])
    yield from _other_phases(part.argument)
    for term in part.argument.terms[1:]:
        for factor in dict.fromkeys(
            [
                multiple,
                1 / multiple if multiple else None,
                Fraction(2),
                Fraction(1, 2),
                Fraction(3),
                Fraction(4),
            ]
        ):
            if factor and factor != 1:
                times = f"times the order {multiple}" if factor == multiple else f"times {factor}"
                yield Edit(
                    f"phase not multiplied ({times})",
                    1.0 if factor == multiple else 1.15,
                    term,
                    _times(factor, term),
                )


def _other_phases(argument: Sum) -> Iterator[Edit]:
    """Yield other angles for the phase that is a number: the multiples of 15° and 18°, in its unit."""
    for term in argument.terms[1:]:
        inner = term.operand if isinstance(term, Negative) else term
        if formula.names(term) or not (isinstance(inner, Product | Quotient | Constant | Number)):
            continue
        for parts_of_turn in (24, 20):
            for k in range(1 - parts_of_turn // 2, parts_of_turn // 2 + 1):
                if k and (parts_of_turn == 24 or k % 5):
                    turns = Fraction(abs(k), parts_of_turn)
                    new = _angle_like(inner, turns)
                    yield Edit("phase", 1.2 + abs(k) / 10000, term, Negative(new) if k < 0 else new)


def _angle_like(angle: Formula, turns: Fraction) -> Formula:
    """Return an angle in degrees where another is."""
    if degrees_of(angle) is not None and isinstance(angle, Product):
        return Product((Number(360 * turns), angle.factors[-1]))
    return _pi_times(2 * turns)


def _pi_times(factor: Fraction) -> Formula:
    above: Formula = Constant("pi")
    if factor.numerator != 1:
        above = Product((Number(Fraction(factor.numerator)), above))
    return above if factor.denominator == 1 else Quotient(above, Number(Fraction(factor.denominator)))


def _multiple(term: Formula) -> Fraction | None:
    factors = term.factors if isinstance(term, Product) else (term,)
    numbers = [f.value for f in factors if isinstance(f, Number)]
    return numbers[0] if numbers else None


def _times(factor: Fraction, term: Formula) -> Formula:
    """Return factor times a phase, as one fraction of π where it is one.

    >>> from symbalance.document.text_writer import formula_text
    >>> from symbalance.document.formula import Quotient
    >>> third = Quotient(rational_node(Fraction(1)), rational_node(Fraction(3)))
    >>> formula_text(_times(Fraction(6), Product((third, Constant("pi")))), plain=True)
    '2 π'
    """
    evaluator = FormEvaluator(Domain())
    try:
        of_pi = evaluator.form(term).over(evaluator.form(Constant("pi"))).rational()
    except (NoFormError, TooLargeError):
        of_pi = None
    if of_pi:
        phase = Product((rational_node(abs(of_pi * factor)), Constant("pi")))
        return Negative(phase) if of_pi * factor < 0 else phase
    if isinstance(term, Negative):
        return Negative(_times(factor, term.operand))
    return Product((rational_node(factor), term))


def radicands(part: Formula, role: str) -> Iterator[Edit]:
    """Another whole number under a root, or for the root of one, or the root of one without it."""
    if role in ("factor", "side") and isinstance(part, Number) and part.last_place is None:
        value = part.value
        if value.denominator == 1 and 1 < value <= MOST_RADICAND and isqrt(int(value)) ** 2 != value:
            yield Edit("root missing", 1.25, part, Call("sqrt", part))
    if role == "radicand" and isinstance(part, Number) and part.value.denominator == 1:
        for value in range(2, MOST_RADICAND + 1):
            if value != part.value and isqrt(value) ** 2 != value:
                cost = 1.1 + abs(value - float(part.value)) / 100
                yield Edit(f"number misprinted ({value} for {part.value})", cost, part, _whole(value))
    if isinstance(part, Call) and part.function == "sqrt" and isinstance(part.argument, Number):
        for value in range(1, isqrt(MOST_RADICAND) + 1):
            kind = f"number misprinted ({value} for √{part.argument.value})"
            yield Edit(kind, 1.2 + value / 100, part, _whole(value))


def _whole(value: int) -> Formula:
    return rational_node(Fraction(value))


def multiples(part: Formula, role: str) -> Iterator[Edit]:
    """The order inside cos nθ: another whole number."""
    kind = "phase" if role == "phase" else "order"
    if role in ("argument", "angle term", "phase"):
        if isinstance(part, Number) and part.value.denominator == 1 and part.last_place is None:
            for value in range(1, 13):
                if value != part.value:
                    yield Edit(
                        kind,
                        1.1 + abs(value - float(part.value)) / 100,
                        part,
                        rational_node(Fraction(value)),
                    )
        elif isinstance(part, Name):
            for value in (2, 3, 4, 6):
                yield Edit(
                    "order", 1.15 + value / 100, part, Product((rational_node(Fraction(value)), part))
                )
        elif isinstance(part, Constant) and part.name == "pi":
            for factor in (Fraction(2), Fraction(1, 2)):
                yield Edit("phase", 1.3, part, Product((rational_node(factor), part)))
