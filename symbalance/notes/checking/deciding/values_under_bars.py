"""Values of formulas under bars: as mean values of samples, or as conjugates of complex numbers.

A mean of a product is not the product of the means; the conjugate of one is. A letter that varies has a
sample of values, another one a number, and a formula the list of its values.
"""

from __future__ import annotations

import cmath
import random
from collections.abc import Callable, Collection, Mapping
from functools import reduce
from operator import mul, truediv
from typing import Any

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
)
from symbalance.notes.checking.declared.symbol_roles import conjugate_name

SAMPLE = 5
"""Values of a letter that varies."""
MOST_INDEPENDENT = 8
"""Letters that vary apart from each other: each with two values, and each pair of values once."""
_BAR = conjugate_name("")
_CONSTANTS = {"pi": cmath.pi, "e": cmath.e, "i": 1j}
_FUNCTIONS: dict[str, Callable[[complex], complex]] = {
    "sin": cmath.sin, "cos": cmath.cos, "tan": cmath.tan, "exp": cmath.exp, "ln": cmath.log,
    "sqrt": cmath.sqrt, "abs": abs, "re": lambda z: z.real, "im": lambda z: z.imag,
}  # fmt: skip


class NoSampleError(Exception):
    """A formula of a kind whose values are not known here."""


class BarValues:
    """The values of formulas; `varying` letters are samples, or complex numbers where bars conjugate."""

    def __init__(
        self,
        varying: Collection[str],
        values: Mapping[str, Formula],
        *,
        are_means: bool,
        are_independent: bool = False,
        seed: int,
    ) -> None:
        self.varying, self.values, self.are_means = sorted(varying), values, are_means
        self.are_independent = are_independent and len(varying) <= MOST_INDEPENDENT
        self.size = (2 ** len(varying) if self.are_independent else SAMPLE) if are_means else 1
        self._chance = random.Random(f"bars {seed}")
        self._drawn: dict[str, list[complex]] = {}
        self._open: set[str] = set()

    def value(self, node: Formula) -> list[complex]:
        """Return the values of a formula; one of another kind raises NoSampleError."""
        try:
            return self._value(node)
        except (ZeroDivisionError, ValueError, OverflowError, RecursionError):
            raise NoSampleError from None

    def printed(self) -> dict[str, str]:
        """Return what was drawn for the letters, as a witness names it."""
        return {name: ", ".join(map(_printed, dict.fromkeys(own))) for name, own in self._drawn.items()}

    def _value(self, node: Formula) -> list[complex]:
        rule = _RULES.get(type(node))
        if rule is None:
            raise NoSampleError
        return rule(self, node)

    def each(self, change: Callable[..., complex], *parts: Formula) -> list[complex]:
        """Return what becomes of the values of parts, one by one."""
        return [complex(change(*own)) for own in zip(*map(self._value, parts), strict=True)]

    def constant(self, value: complex) -> list[complex]:
        """Return the values of a number."""
        return [complex(value)] * self.size

    def called(self, function: str, argument: Formula) -> list[complex]:
        """Return the values of a function, or of what stands under a bar."""
        if function == "conj":
            return self._barred(self._value(argument))
        if function not in _FUNCTIONS:
            raise NoSampleError
        return self.each(_FUNCTIONS[function], argument)

    def letter(self, name: str) -> list[complex]:
        """Return the values of a letter."""
        if name not in self._drawn:
            base = name.removeprefix(_BAR)
            if base != name and base in self.varying and name not in self.values:
                return self._barred(self.letter(base))
            if name in self.values and name not in self._open:
                self._open.add(name)
                known = self._value(self.values[name])
                self._open.discard(name)
                return known
            if name not in self.varying:
                self._drawn[name] = [complex(self._number())] * self.size
            elif self.are_means and self.are_independent:
                pair = self._chance.sample(range(1, 10), 2)
                place = self.varying.index(name)  # of all pairs, triples … of values one each
                self._drawn[name] = [complex(pair[n >> place & 1]) for n in range(self.size)]
            elif self.are_means:
                self._drawn[name] = [complex(self._number()) for _ in range(self.size)]
            else:
                self._drawn[name] = [complex(self._number(), self._number())]
        return self._drawn[name]

    def _barred(self, values: list[complex]) -> list[complex]:
        if self.are_means:
            return [sum(values) / len(values)] * self.size
        return [value.conjugate() for value in values]

    def _number(self) -> int:
        return self._chance.randint(1, 9)


def _constant(name: str) -> complex:
    if name not in _CONSTANTS:
        raise NoSampleError
    return _CONSTANTS[name]


_RULES: dict[type[Formula], Callable[[BarValues, Any], list[complex]]] = {
    Number: lambda at, node: at.constant(float(node.value)),
    Constant: lambda at, node: at.constant(_constant(node.name)),
    Name: lambda at, node: at.letter(node.name),
    Sum: lambda at, node: at.each(lambda *parts: sum(parts), *node.terms),
    Product: lambda at, node: at.each(lambda *parts: reduce(mul, parts), *node.factors),
    Negative: lambda at, node: at.each(lambda part: -part, node.operand),
    Quotient: lambda at, node: at.each(truediv, node.numerator, node.denominator),
    Power: lambda at, node: at.each(pow, node.base, node.exponent),
    Call: lambda at, node: at.called(node.function, node.argument),
}


def are_close(first: list[complex], second: list[complex]) -> bool:
    """Tell whether two lists of values are the same but for rounding."""
    pairs = list(zip(first, second, strict=True))
    scale = max(max(abs(a), abs(b)) for a, b in pairs)
    return all(abs(a - b) <= scale * 1e-9 for a, b in pairs)


def _printed(value: complex) -> str:
    sign = "+" if value.imag > 0 else "-"
    return f"{value.real:g}" if not value.imag else f"{value.real:g} {sign} {abs(value.imag):g} i"
