"""Base class of the formula writers: precedence of operators, brackets, exact decimals."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

from symbalance.document.formula import (
    Apply,
    Call,
    Cases,
    Constant,
    Decimal,
    Derivative,
    Dots,
    Equation,
    Evaluation,
    Extremum,
    Formula,
    IndexedProduct,
    Integral,
    Limit,
    Matrix,
    Name,
    Negative,
    Number,
    PlusMinus,
    Power,
    Product,
    Quotient,
    Subscript,
    Sum,
    Summation,
    Upright,
)

OPERATORS = (Summation, IndexedProduct, Integral, Limit, Extremum)
"""What begins with a sign of its own and goes on to the end of its term."""
SUM, SIGN, PRODUCT, QUOTIENT, POWER, ATOM = range(6)
"""How tightly a formula binds; one within another that binds tighter needs brackets."""

_STRENGTH: dict[type[Formula], int] = {
    Sum: SUM, Dots: SUM, Negative: SIGN, Summation: SIGN, Product: PRODUCT, Quotient: QUOTIENT,
    Derivative: QUOTIENT, Power: POWER, Call: ATOM, Apply: ATOM, Subscript: ATOM, Name: ATOM,
    Constant: ATOM, Upright: ATOM, Matrix: ATOM, IndexedProduct: SIGN, Integral: SIGN, Limit: SIGN,
    Extremum: SIGN, PlusMinus: SUM, Evaluation: POWER, Cases: ATOM,
}  # fmt: skip


def strength(node: Formula) -> int:
    """Return how tightly a formula binds.

    >>> strength(Number(Fraction(-3))) == SIGN, strength(Name("x")) == ATOM
    (True, True)
    """
    if isinstance(node, Number):
        if node.value.numerator < 0:
            return SIGN
        whole = node.last_place is None and node.value.denominator == 1
        return ATOM if whole or numeral(node) else QUOTIENT
    if isinstance(node, Product | Sum):
        parts = node.factors if isinstance(node, Product) else node.terms
        if len(parts) < 2:
            return strength(parts[0]) if parts else ATOM
    elif isinstance(node, Decimal):
        return SIGN if node.text.startswith("-") else PRODUCT if "e" in node.text else ATOM
    return _STRENGTH[type(node)]


def numeral(number: Number) -> str:
    """Return the absolute value's digits as printed, or "" where it is no decimal number.

    >>> numeral(Number(Fraction(201, 50), Fraction(1, 100))), numeral(Number(Fraction(1, 3)))
    ('4.02', '')
    >>> numeral(Number(Fraction("293.15"), Fraction(3, 10)))
    '293.15'
    """
    value, place = number.value, number.last_place
    if place is None:
        return str(abs(value.numerator)) if value.denominator == 1 else ""
    decimals = _decimals(place)
    steps = abs(value) / place
    if decimals is None and (100 * value).denominator == 1:
        return f"{float(abs(value)):g}" if abs(value) < 10**4 else ""
    if decimals is None or steps.denominator != 1:
        return ""
    places = max(decimals, 1)
    digits = str(steps.numerator).rjust(places + 1, "0")
    scale = "" if decimals > 0 else f"e{1 - decimals}"
    return f"{digits[:-places]}.{digits[-places:]}{scale}"


def _decimals(place: Fraction) -> int | None:
    """Return n of place = 10^-n, or None."""
    top, bottom = place.numerator, place.denominator
    zeros = len(str(max(top, bottom))) - 1
    if top == 1 and bottom == 10**zeros:
        return zeros
    return -zeros if bottom == 1 and top == 10**zeros else None


def is_whole(node: Formula) -> bool:
    """Tell whether a formula is a natural number printed without a point."""
    if not isinstance(node, Number) or node.last_place is not None:
        return False
    return node.value.numerator >= 0 and node.value.denominator == 1


def is_simple_angle(node: Formula) -> bool:
    """Tell whether a function needs no brackets around a formula: θ, 2θ."""
    if isinstance(node, Product) and len(node.factors) == 2:
        return is_whole(node.factors[0]) and isinstance(node.factors[1], Name)
    return isinstance(node, Name)


def holds_a_sum(value: Sum) -> bool:
    """Tell whether a bracketed sum stands inside `value`, which then takes square brackets.

    >>> x = Name("x")
    >>> holds_a_sum(1 + x * (1 + x)), holds_a_sum(1 + x)
    (True, False)
    """
    return any(isinstance(factor, Sum) for term in value.terms for factor in _signless_factors(term))


def _signless_factors(term: Formula) -> tuple[Formula, ...]:
    term = term.operand if isinstance(term, Negative) else term
    return term.factors if isinstance(term, Product) else (term,)


class FormulaWriter:
    """Writes a formula; what each kind of it looks like is the subclass's.

    A method is named after the class of formula that it writes.
    """

    minus = "-"
    dots_sign = "…"
    plus_minus = {1: "±", -1: "∓"}  # noqa: RUF012 - a table
    relations: dict[str, str] = {}  # noqa: RUF012 - a table that subclasses replace

    def __init__(self) -> None:
        self.exponentials = 0
        self._methods: dict[type[Formula], Callable[[Any, bool], str]] = {}

    def write(self, node: Formula, least: int = 0, closed: bool = False) -> str:
        """Return the formula in print, in brackets if it binds less than `least`.

        `closed` asks for brackets around function arguments, as more is to follow.
        """
        kind = type(node)
        writer = self._methods.get(kind)
        if writer is None:
            writer = self._methods[kind] = getattr(self, kind.__name__.lower())
        if least and self.binding(node) < least:
            return self.bracketed(writer(node, False))
        return writer(node, closed)

    def relation(self, sign: str) -> str:
        """Return the sign of a relation in print."""
        return self.relations.get(sign, sign)

    def equation(self, value: Equation) -> str:
        """Return an equation in print, all its relations in one line."""
        links = [f"{self.relation(sign)} {self.write(right)}" for sign, right in value.links]
        return " ".join([self.write(value.left), *links])

    def binding(self, node: Formula) -> int:
        """Return how tightly a formula binds in this notation."""
        return strength(node)

    def bracketed(self, printed: str) -> str:
        """Return something printed in brackets."""
        return f"({printed})"

    def fraction(self, top: int, bottom: int) -> str:
        """Return a fraction of two numbers."""
        raise NotImplementedError

    def number(self, node: Number, _: bool) -> str:
        """Write a number."""
        digits = numeral(node)
        if not digits:
            top, bottom = abs(node.value).as_integer_ratio()
            digits = str(top) if bottom == 1 else self.fraction(top, bottom)
        return f"{self.minus}{digits}" if node.value.numerator < 0 else digits

    def negative(self, node: Negative, closed: bool) -> str:
        """Write -a."""
        return f"{self.minus}{self.write(node.operand, PRODUCT, closed)}"

    def plusminus(self, node: PlusMinus, closed: bool) -> str:
        """Write ±a."""
        return f"{self.plus_minus[node.upper]}{self.write(node.operand, PRODUCT, closed)}"

    def sum(self, node: Sum, closed: bool) -> str:
        """Write a + b - c."""
        return "".join(sign + term for sign, term in self.signed_terms(node, closed)) or "0"

    def signed_terms(self, node: Sum, closed: bool = False) -> Iterator[tuple[str, str]]:
        """Yield the terms of a sum in print, each after the sign that stands before it."""
        last = len(node.terms) - 1
        for place, term in enumerate(node.terms):
            yield self._term(term, place, last, closed and place == last)

    def _term(self, term: Formula, place: int, last: int, closed: bool) -> tuple[str, str]:
        if isinstance(term, Dots):
            return " + " if place else "", self.write(term)
        if not place:
            return "", self.write(term, SIGN if last else 0, closed)
        if isinstance(term, PlusMinus):
            least = self.least_subtracted(term.operand)
            return f" {self.plus_minus[term.upper]} ", self.write(term.operand, least, closed)
        if isinstance(term, Negative) and self.takes_minus(term.operand):
            return f" {self.minus} ", self.write(
                term.operand, self.least_subtracted(term.operand), closed
            )
        return " + ", self.write(term, SIGN if isinstance(term, OPERATORS) else PRODUCT, closed)

    def takes_minus(self, operand: Formula) -> bool:
        """Tell whether a minus may stand before an operand in a sum without brackets around both."""
        return True

    def least_subtracted(self, operand: Formula) -> int:
        """Return how tightly a subtracted term must bind to stand without brackets."""
        return SUM if isinstance(operand, Dots) else SIGN if isinstance(operand, OPERATORS) else PRODUCT

    def exponential(self, node: Call) -> str:
        """Write the argument of exp, where i is the imaginary unit."""
        self.exponentials += 1
        printed = self.write(node.argument)
        self.exponentials -= 1
        return printed
