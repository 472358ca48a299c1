"""Formulas in complex floats at a few points: a quick sieve before anything is proved."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping, Sequence

from symbalance.document import formula
from symbalance.document.formula import Formula

Values = tuple[complex, ...]
CLOSE = 1e-9

_FUNCTIONS: dict[str, Callable[[complex], complex]] = {
    "sin": cmath.sin,
    "cos": cmath.cos,
    "tan": cmath.tan,
    "cot": lambda x: 1 / cmath.tan(x),
    "sec": lambda x: 1 / cmath.cos(x),
    "csc": lambda x: 1 / cmath.sin(x),
    "asin": cmath.asin,
    "acos": cmath.acos,
    "atan": cmath.atan,
    "sinh": cmath.sinh,
    "cosh": cmath.cosh,
    "tanh": cmath.tanh,
    "exp": cmath.exp,
    "ln": cmath.log,
    "log": cmath.log,
    "sqrt": cmath.sqrt,
    "abs": abs,
}
_CONSTANTS = {"pi": complex(math.pi), "e": complex(math.e), "i": 1j}


class NoValueError(Exception):
    """A formula without a value here: a pole, an unknown letter, a derivative."""


class Sieve:
    """Values of one formula and of its changed copies: parts they share are found once.

    `letters` gives the letters' values, one a point; `known` may give the values of whole parts (of
    derivatives, which are not evaluated here).
    """

    def __init__(self, letters: Mapping[str, Sequence[complex]], points: int) -> None:
        self.letters, self.points = letters, points
        self._known: dict[int, Values] = {}
        self._kept: list[Formula] = []

    def keep(self, node: Formula) -> Values:
        """Return a formula's values, and keep those of all its parts."""
        for part in formula.children(node):
            try:
                self.keep(part)
            except NoValueError:
                continue
        found = self.values(node)
        self.tell(node, found)
        return found

    def tell(self, node: Formula, values: Values) -> None:
        """Keep the values of a part that were found elsewhere."""
        self._known[id(node)] = values
        self._kept.append(node)

    def values(self, node: Formula) -> Values:
        """Return a formula's values at the points."""
        known = self._known.get(id(node))
        if known is not None:
            return known
        try:
            return self._found(node)
        except (ZeroDivisionError, OverflowError, ValueError, KeyError) as problem:
            raise NoValueError from problem

    def _found(self, node: Formula) -> Values:
        if isinstance(node, formula.Number):
            return (complex(float(node.value)),) * self.points
        if isinstance(node, formula.Name):
            return tuple(self.letters[node.name])
        if isinstance(node, formula.Constant):
            return (_CONSTANTS[node.name],) * self.points
        rule = _rule(node)
        rows = [self.values(p) for p in formula.children(node) if not isinstance(p, formula.Dots)]
        if not rows:  # dots alone
            raise NoValueError
        return tuple(rule(column) for column in zip(*rows, strict=True))


def _rule(node: Formula) -> Callable[[Sequence[complex]], complex]:
    """Return what a part does with the values of its parts."""
    if isinstance(node, formula.Call):
        function = _FUNCTIONS[node.function]
        return lambda column: function(column[0])
    if type(node) not in _RULES:
        raise NoValueError
    return _RULES[type(node)]


_RULES: dict[type[Formula], Callable[[Sequence[complex]], complex]] = {
    formula.Negative: lambda column: -column[0],
    formula.Quotient: lambda column: column[0] / column[1],
    formula.Power: lambda column: column[0] ** column[1],
    formula.Sum: sum,
    formula.Product: math.prod,
}


def close(left: Values, right: Values) -> bool:
    """Tell whether two rows of values agree, all to nine digits."""
    return all(abs(a - b) <= CLOSE * max(abs(a), abs(b), 1e-30) for a, b in zip(left, right, strict=True))
