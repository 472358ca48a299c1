"""A computation as a list of short formulas that every target language can print.

A formula is infix text of names, numbers, + - * / and brackets, and of calls of

    rint(x)  the nearest whole number       abs(x)   sqrt(x)   cos(x)   sin(x)
    side(x)  1.0, or -1.0 where x < 0

The formulas are made here, of names and numbers of our own: no text from outside reaches them.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field

NAME = re.compile(r"[A-Za-z]\w*")


@dataclass(frozen=True)
class Statement:
    """One assignment, `name = formula`, and why."""

    name: str
    formula: str
    note: str = ""


@dataclass(frozen=True)
class NamedConstant:
    """A named double, and what it is."""

    name: str
    value: float
    note: str = ""


@dataclass
class Kernel:
    """Constants and lines, in order; what is added twice under one name must be the same."""

    constants: list[NamedConstant] = field(default_factory=list)
    lines: list[Statement] = field(default_factory=list)
    _known: set[str] = field(init=False, repr=False, compare=False)
    """Names of constants and of lines, which differ: there may be as many as terms of a long sum."""

    def __post_init__(self) -> None:
        self._known = {each.name for each in (*self.constants, *self.lines)}

    def constant(self, name: str, value: object, note: str = "") -> str:
        """Add a constant, rounded once to a double, and return its name."""
        if name not in self._known:
            self._known.add(name)
            self.constants.append(NamedConstant(name, float(value), note))  # pyright: ignore[reportArgumentType]
        return name

    def names(self) -> set[str]:
        """Return every name its formulas use."""
        return {name for line in self.lines for name in NAME.findall(line.formula)}

    def pruned(self, used: Iterable[str]) -> Kernel:
        """Return the kernel without lines and constants that nothing `used` rests on."""
        needed, lines = set(used), []
        for line in reversed(self.lines):
            if line.name in needed:
                needed.update(NAME.findall(line.formula))
                lines.append(line)
        return Kernel([c for c in self.constants if c.name in needed], lines[::-1])

    def line(self, name: str, formula: str, note: str = "") -> str:
        """Add a line and return its name."""
        if name not in self._known:
            self._known.add(name)
            self.lines.append(Statement(name, formula, note))
        return name


def horner(coefficients: list[str], variable: str) -> str:
    """Return a polynomial, constant term first, nested by Horner's rule; "" stands for a zero.

    >>> horner(["A", "B", "", "D"], "z")
    'A + z*(B + z*(z*D))'
    """
    head, *rest = coefficients
    if not rest:
        return head
    inner = horner(rest, variable)
    product = f"{variable}*{inner}" if len(rest) == 1 else f"{variable}*({inner})"
    return f"{head} + {product}" if head else product
