"""What both renderers share: how tightly each kind of node binds, exact decimals, sums."""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.syntax import (
    Call,
    Constant,
    Derivative,
    Dots,
    Name,
    Negative,
    Node,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Summation,
)

SUM, SIGN, PRODUCT, QUOTIENT, POWER, ATOM = range(6)
"""How tightly a node binds; a node within one that binds tighter needs brackets."""

_STRENGTH: dict[type[Node], int] = {
    Sum: SUM, Dots: SUM, Negative: SIGN, Summation: SIGN, Product: PRODUCT, Quotient: QUOTIENT,
    Derivative: QUOTIENT, Power: POWER, Call: ATOM, Name: ATOM, Constant: ATOM,
}  # fmt: skip


def strength(node: Node) -> int:
    """Return how tightly a node binds.

    >>> strength(Number(Fraction(-3))) == SIGN, strength(Name("x")) == ATOM
    (True, True)
    """
    if isinstance(node, Number):
        if node.value < 0:
            return SIGN
        return ATOM if numeral(node) else QUOTIENT
    parts = node.factors if isinstance(node, Product) else node.terms if isinstance(node, Sum) else None
    if parts is not None and len(parts) < 2:
        return strength(parts[0]) if parts else ATOM
    return _STRENGTH[type(node)]


def numeral(number: Number) -> str:
    """Return the absolute value's digits as printed, or "" where it is no decimal number.

    >>> numeral(Number(Fraction(201, 50), Fraction(1, 100))), numeral(Number(Fraction(1, 3)))
    ('4.02', '')
    """
    value, place = abs(number.value), number.last_place
    if place is None:
        return str(value) if value.denominator == 1 else ""
    decimals = _decimals(place)
    steps = value / place
    if decimals is None or steps.denominator != 1:
        return ""
    kept = max(decimals, 1)
    digits = str(steps.numerator).rjust(kept + 1, "0")
    scale = "" if decimals > 0 else f"e{1 - decimals}"
    return f"{digits[:-kept]}.{digits[-kept:]}{scale}"


def _decimals(place: Fraction) -> int | None:
    """Return n of place = 10^-n, or None."""
    top, bottom = place.numerator, place.denominator
    zeros = len(str(max(top, bottom))) - 1
    if top == 1 and bottom == 10**zeros:
        return zeros
    return -zeros if bottom == 1 and top == 10**zeros else None


def is_whole(node: Node) -> bool:
    """Tell whether a node is a natural number printed without a point."""
    if not isinstance(node, Number) or node.last_place is not None:
        return False
    return node.value >= 0 and node.value.denominator == 1


def is_simple_angle(node: Node) -> bool:
    """Tell whether a function needs no brackets around a node: θ, 2θ."""
    if isinstance(node, Product) and len(node.factors) == 2:
        return is_whole(node.factors[0]) and isinstance(node.factors[1], Name)
    return isinstance(node, Name)


class Renderer:
    """Writes a tree; what each kind of node looks like is the subclass's."""

    dots_sign = "…"

    def __init__(self) -> None:
        self.exponentials = 0

    def of(self, node: Node, least: int = 0, closed: bool = False) -> str:
        """Return the text, in brackets if it binds less than `least`.

        `closed` asks for brackets around function arguments, as more is to follow.
        """
        writer = getattr(self, type(node).__name__.lower())
        if self.binding(node) < least:
            return self.bracketed(writer(node, False))
        return writer(node, closed)

    def binding(self, node: Node) -> int:
        """Return how tightly a node binds in this notation."""
        return strength(node)

    def bracketed(self, text: str) -> str:
        """Return the text in brackets."""
        return f"({text})"

    def fraction(self, top: int, bottom: int) -> str:
        """Return a fraction of two numbers."""
        raise NotImplementedError

    def number(self, node: Number, _: bool) -> str:
        """Write a number."""
        value = abs(node.value)
        digits = numeral(node)
        if not digits:
            whole = value.denominator == 1
            digits = str(value) if whole else self.fraction(value.numerator, value.denominator)
        return f"-{digits}" if node.value < 0 else digits

    def negative(self, node: Negative, closed: bool) -> str:
        """Write -a."""
        return f"-{self.of(node.operand, PRODUCT, closed)}"

    def sum(self, node: Sum, closed: bool) -> str:
        """Write a + b - c."""
        pieces: list[str] = []
        last = len(node.terms) - 1
        for place, term in enumerate(node.terms):
            pieces.append(self._term(term, place, last, closed and place == last))
        return "".join(pieces) or "0"

    def _term(self, term: Node, place: int, last: int, closed: bool) -> str:
        if isinstance(term, Dots):
            return f" + {self.dots_sign}" if place else self.dots_sign
        if not place:
            return self.of(term, SIGN if last else 0, closed)
        if isinstance(term, Negative) and not isinstance(term.operand, Dots):
            return f" - {self.of(term.operand, PRODUCT, closed)}"
        return f" + {self.of(term, SIGN if isinstance(term, Summation) else PRODUCT, closed)}"

    def exponential(self, node: Call) -> str:
        """Write the argument of exp, where i is the imaginary unit."""
        self.exponentials += 1
        text = self.of(node.argument)
        self.exponentials -= 1
        return text
