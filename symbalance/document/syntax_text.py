"""A tree as one line of plain text that reads back as the same formula."""

from __future__ import annotations

from symbalance.document.letters import CIRCULAR, GREEK_SIGN
from symbalance.document.syntax import (
    Call,
    Constant,
    Derivative,
    Dots,
    Name,
    Node,
    Number,
    Power,
    Product,
    Quotient,
    Summation,
)
from symbalance.document.syntax_printing import ATOM, POWER, QUOTIENT, Renderer, is_simple_angle, is_whole
from symbalance.document.syntax_printing import PRODUCT as PRODUCT_STRENGTH

_WORD = {"asin": "arcsin", "acos": "arccos", "atan": "arctan"}
_CONSTANT = {"pi": "π", "infinity": "∞", "e": "exp(1)", "i": "sqrt(-1)"}


def render(node: Node) -> str:
    """Return a formula as one line of text.

    >>> from fractions import Fraction
    >>> angle = Product((Number(Fraction(6)), Name("theta")))
    >>> render(Product((Quotient(Number(Fraction(9)), Name("lambda")), Call("cos", angle))))
    '9/λ cos 6θ'
    """
    return _Text().of(node)


class _Text(Renderer):
    def fraction(self, top: int, bottom: int) -> str:
        return f"{top}/{bottom}"

    def name(self, node: Name, _: bool) -> str:
        return letter(node.name)

    def constant(self, node: Constant, _: bool) -> str:
        if node.name == "i" and self.exponentials:
            return "i"
        return _CONSTANT.get(node.name, node.name)

    def dots(self, _node: Dots, _: bool) -> str:
        return self.dots_sign

    def product(self, node: Product, closed: bool) -> str:
        factors = node.factors
        if len(factors) < 2:
            return self.of(factors[0], 0, closed) if factors else "1"
        text = self.of(factors[0], QUOTIENT, closed=True)
        for place, factor in enumerate(factors[1:], 1):
            piece = self.of(factor, POWER, closed or place < len(factors) - 1)
            text += self._between(factors[place - 1], factor, piece) + piece
        return text

    def _between(self, before: Node, after: Node, piece: str) -> str:
        if piece[:1].isdecimal() or before == Name("d"):
            return "*"
        simple = isinstance(after, Name) and len(letter(after.name)) == 1 and after.name not in ("e", "E")
        return "" if is_whole(before) and simple else " "

    def quotient(self, node: Quotient, _: bool) -> str:
        bottom = node.denominator
        fractional = isinstance(bottom, Number) and self.binding(bottom) < ATOM
        below = f"({self.of(bottom)})" if fractional else self.of(bottom, POWER, closed=True)
        return f"{self.of(node.numerator, PRODUCT_STRENGTH, closed=True)}/{below}"

    def power(self, node: Power, closed: bool) -> str:
        base, exponent = node.base, node.exponent
        if isinstance(base, Call) and base.function in CIRCULAR and is_whole(exponent):
            return f"{base.function}^{self.of(exponent)}{self._argument(base.argument, closed)}"
        simple = isinstance(exponent, Name) and len(letter(exponent.name)) == 1
        above = self.of(exponent) if simple or is_whole(exponent) else f"({self.of(exponent)})"
        return f"{self.of(base, ATOM, closed=True)}^{above}"

    def call(self, node: Call, closed: bool) -> str:
        word = _WORD.get(node.function, node.function)
        if node.function == "exp":
            return f"exp({self.exponential(node)})"
        if node.function not in CIRCULAR:
            return f"{word}({self.of(node.argument)})"
        return word + self._argument(node.argument, closed)

    def _argument(self, node: Node, closed: bool) -> str:
        simple = not closed and is_simple_angle(node)
        return f" {self.of(node)}" if simple else f"({self.of(node)})"

    def derivative(self, node: Derivative, _: bool) -> str:
        order = f"^{node.order}" if node.order > 1 else ""
        variable = letter(node.variable.name)
        expression = node.expression
        if isinstance(expression, Name) and len(letter(expression.name)) == 1:
            return f"d{order}{letter(expression.name)}/d{variable}{order}"
        return f"d{order}/d{variable}{order}({self.of(expression)})"

    def summation(self, node: Summation, closed: bool) -> str:
        bounds = ""
        if node.index is not None:
            lower = f"={self.of(node.lower)}" if node.lower is not None else ""
            bounds = f"_{{{letter(node.index.name)}{lower}}}"
            bounds += f"^{{{self.of(node.upper)}}}" if node.upper is not None else ""
        return f"Σ{bounds} {self.of(node.body, PRODUCT_STRENGTH, closed)}"


def letter(name: str) -> str:
    """Return a letter as plain text.

    >>> letter("theta"), letter("m_rec"), letter("omega_1'")
    ('θ', 'm_rec', "ω_1'")
    """
    bare = name.rstrip("'")
    base, _, subscript = bare.partition("_")
    primes = name[len(bare) :]
    if not subscript:
        return GREEK_SIGN.get(base, base) + primes
    plain = subscript.isascii() and subscript.replace("_", "").isalnum()
    script = subscript if plain else f"{{{subscript}}}"
    return f"{GREEK_SIGN.get(base, base)}_{script}{primes}"
