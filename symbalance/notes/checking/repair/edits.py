"""Single changes to a formula, from the slips people make; each with its kind and its cost.

A change names the part it replaces, so that the report can point at it. Nothing here is proved:
`diagnosis` keeps a change only if the changed line is.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction

from symbalance.document import formula
from symbalance.document.formula import (
    Call,
    Constant,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
)
from symbalance.notes.algebra.numbers import rational_node
from symbalance.notes.checking.repair.angle_slips import multiples, phases
from symbalance.notes.checking.repair.change import Edit, parts

_SWAPS = {
    "sin": ("cos", "tan"),
    "cos": ("sin", "tan"),
    "tan": ("sin", "cos"),
    "asin": ("acos",),
    "acos": ("asin",),
}
MOST_LETTERS = 24


def edits(node: Formula, letters: Iterable[str], variables: Iterable[str]) -> Iterator[Edit]:
    """Yield the single changes of a formula; `letters` may be put in, `variables` differentiated by."""
    known = list(letters)[:MOST_LETTERS]
    yield from _all_functions(node)
    for part, role in parts(node):
        yield from _signs(part, role)
        yield from _functions(part)
        yield from _exponents(part, role)
        yield from _letters(part, known)
        yield from phases(part)
        yield from multiples(part, role)
        yield from _missing(part, role, known)
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
        yield Edit("sign", 1, part, Negative(part))
    elif role == "side":
        yield Edit("sign", 1.1, part, Negative(part))


def _functions(part: Formula) -> Iterator[Edit]:
    if isinstance(part, Call):
        for function in _SWAPS.get(part.function, ()):
            yield Edit(f"{function} for {part.function}", 1, part, Call(function, part.argument))


def _all_functions(node: Formula) -> Iterator[Edit]:
    swapped = _swapped(node)
    if swapped != node:
        yield Edit("sine and cosine exchanged", 1.05, node, swapped)


def _swapped(node: Formula) -> Formula:
    parts_ = tuple(_swapped(part) for part in formula.children(node))
    if isinstance(node, Call) and node.function in ("sin", "cos"):
        return Call("cos" if node.function == "sin" else "sin", parts_[0])
    return formula.with_children(node, parts_) if parts_ else node


def _exponents(part: Formula, role: str) -> Iterator[Edit]:
    if role == "exponent" and isinstance(part, Number) and part.value.denominator == 1:
        for value in range(1, 9):
            if value != part.value:
                yield Edit(
                    "exponent",
                    1.1 + abs(value - float(part.value)) / 100,
                    part,
                    rational_node(Fraction(value)),
                )
    if isinstance(part, Power):
        yield Edit("exponent", 1.3, part, part.base)
    elif isinstance(part, Name | Call) and role != "exponent":
        for value in (2, 3):
            yield Edit("exponent", 1.2 + value / 100, part, Power(part, rational_node(Fraction(value))))
    if isinstance(part, Call) and part.function == "sqrt":
        yield Edit("root", 1.4, part, part.argument)


def _letters(part: Formula, letters: list[str]) -> Iterator[Edit]:
    if isinstance(part, Name):
        for name in letters:
            if name != part.name:
                yield Edit(f"{name} for {part.name}", 1.25, part, Name(name))
    if isinstance(part, Number) and part.last_place is None:
        for name in letters:
            yield Edit(f"{name} for {part.value}", 1.6, part, Name(name))
    if isinstance(part, Name):
        for value in (1, 2):
            yield Edit(
                "letter too many" if value == 1 else f"2 for {part.name}",
                1.5,
                part,
                rational_node(Fraction(value)),
            )


def _missing(part: Formula, role: str, letters: list[str]) -> Iterator[Edit]:
    if role in ("side", "term"):
        for name in letters:
            yield Edit(f"{name} missing", 1.5, part, _product(part, Name(name)))
            yield Edit(f"{name} too many", 1.55, part, Quotient(part, Name(name)))
            yield Edit(
                f"{name}² missing",
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
