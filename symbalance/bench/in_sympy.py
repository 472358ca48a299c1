"""A formula as read, as the SymPy expression a user would type for it: what the bench measures against.

Nothing of the checker is used: derivatives are taken, sums with bounds written out and numbers evaluated
by SymPy. Letters that stand for something are replaced by it, as one must before asking `simplify`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy

from symbalance.document import formula

_FUNCTIONS = {
    "abs": sympy.Abs, "ln": sympy.log, "log": sympy.log, "sqrt": sympy.sqrt,
    "sin": sympy.sin, "cos": sympy.cos, "tan": sympy.tan, "cot": sympy.cot, "sec": sympy.sec,
    "csc": sympy.csc, "asin": sympy.asin, "acos": sympy.acos, "atan": sympy.atan, "exp": sympy.exp,
    "sinh": sympy.sinh, "cosh": sympy.cosh, "tanh": sympy.tanh,
}  # fmt: skip
_CONSTANTS = {"pi": sympy.pi, "e": sympy.E, "i": sympy.I, "infinity": sympy.oo}


@dataclass(frozen=True)
class InSympy:
    """Turns formulas into SymPy: `values` replaces letters by formulas, the other letters are symbols.

    `positive` and `integer` letters get SymPy's assumption of that name, all others `real`.
    A derivative by `time` is one by `angle`, times `speed`.

    >>> from symbalance.notes.reading import read_expression
    >>> cosine, product = (read_expression(text, "xy")[0] for text in ("cos 2x", "3 x y"))
    >>> InSympy(values={"y": cosine}).of(product)
    3*x*cos(2*x)
    """

    values: Mapping[str, formula.Formula] = field(default_factory=dict)
    positive: frozenset[str] = frozenset()
    integer: frozenset[str] = frozenset()
    time: str = "t"
    angle: str = "theta"
    speed: str = "omega"
    _known: dict[str, Any] = field(default_factory=dict)

    def of(self, node: formula.Formula) -> Any:
        """Return a formula as a SymPy expression; dots are left out."""
        rule = getattr(self, f"_{type(node).__name__.lower()}")
        return rule(node)

    def letter(self, name: str) -> Any:
        """Return what a letter stands for, or its symbol."""
        if name not in self._known:
            known = name in self.values
            self._known[name] = self.of(self.values[name]) if known else self.symbol(name)
        return self._known[name]

    def symbol(self, name: str) -> sympy.Symbol:
        """Return the symbol of a letter."""
        if name in self.positive:
            return sympy.Symbol(name, positive=True)
        return sympy.Symbol(name, integer=True) if name in self.integer else sympy.Symbol(name, real=True)

    def _number(self, node: formula.Number) -> Any:
        return sympy.Rational(node.value.numerator, node.value.denominator)

    def _name(self, node: formula.Name) -> Any:
        return self.letter(node.name)

    def _constant(self, node: formula.Constant) -> Any:
        return _CONSTANTS[node.name]

    def _sum(self, node: formula.Sum) -> Any:
        return sympy.Add(*map(self.of, node.terms))

    def _product(self, node: formula.Product) -> Any:
        return sympy.Mul(*map(self.of, node.factors))

    def _quotient(self, node: formula.Quotient) -> Any:
        return self.of(node.numerator) / self.of(node.denominator)

    def _power(self, node: formula.Power) -> Any:
        return self.of(node.base) ** self.of(node.exponent)

    def _negative(self, node: formula.Negative) -> Any:
        return -self.of(node.operand)

    def _call(self, node: formula.Call) -> Any:
        return _FUNCTIONS[node.function](self.of(node.argument))

    def _derivative(self, node: formula.Derivative) -> Any:
        found, name = self.of(node.expression), node.variable.name
        for _ in range(node.order):
            if name == self.time:
                found = sympy.diff(found, self.letter(self.angle)) * self.letter(self.speed)
            else:
                found = sympy.diff(found, self.symbol(name))
        return found

    def _summation(self, node: formula.Summation) -> Any:
        if node.index is None or node.lower is None or node.upper is None:
            raise ValueError("a sum without bounds")
        body, index = self.of(node.body), self.symbol(node.index.name)
        bounds = range(int(self.of(node.lower)), int(self.of(node.upper)) + 1)
        return sympy.Add(*(body.subs(index, value) for value in bounds))

    def _dots(self, _: formula.Dots) -> Any:
        return sympy.S.Zero
