"""What the formulas of the bench's page are worth, found by SymPy and mpmath: nothing of the checker."""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import mpmath
import sympy

from symbalance.bench.check_page import Page
from symbalance.document.formula import Dots, Formula, walk

POINTS, DIGITS, MANY_DIGITS = 3, 30, 150
TINY = -12
"""The power of ten that the small letter is set to where an order is looked for."""


@dataclass
class PageValues:
    """Values of formulas of a page at a few random points, and the orders through which they agree."""

    page: Page
    seed: int = 1
    _known: dict[Formula, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        chance = random.Random(self.seed)
        self.convert = self.page.in_sympy()
        self.free = sorted(self.page.letters - set(self.page.values))
        self.points = [{name: _chosen(name, chance) for name in self.free} for _ in range(POINTS)]

    def of(self, node: Formula) -> Sequence[Any]:
        """Return a formula's values at the points."""
        if node not in self._known:
            function = self._function(self.convert.of(node))
            with mpmath.workdps(DIGITS):
                self._known[node] = [function(point) for point in self.points]
        return self._known[node]

    def same(self, one: Formula, other: Formula) -> bool:
        """Tell whether two formulas have one value at all points."""
        pairs = zip(self.of(one), self.of(other), strict=True)
        return all(abs(a - b) <= 1e-15 * max(abs(a), abs(b), 1e-6) for a, b in pairs)

    def degree(self, node: Formula) -> int | None:
        """Return the highest power of the small letter in a formula; None if it is no polynomial."""
        small = sympy.Symbol("small", positive=True)
        found = sympy.expand(self.convert.of(node).subs(self._large, 1 / small).subs(self._small, small))
        return (
            int(sympy.Poly(found, small).degree()) if found.is_polynomial(small) and found != 0 else None
        )

    def agreement(self, one: Formula, other: Formula) -> float:
        """Return the power of the small letter with which two formulas begin to differ."""
        function = self._function(self.convert.of(one) - self.convert.of(other))
        with mpmath.workdps(MANY_DIGITS):
            tiny = mpmath.mpf(10) ** TINY
            point = dict(self.points[0]) | {"u": tiny, "lambda": 1 / tiny}
            difference = abs(function(point))
            if difference < mpmath.mpf(10) ** (20 - MANY_DIGITS):
                return float("inf")
            return int(mpmath.nint(mpmath.log10(difference) / TINY))

    def is_true_to_order(self, one: Formula, exact: Formula) -> bool:
        """Tell whether a formula equals another through the highest power of the small letter it keeps.

        That is claimed only of a cut-off series: where the other is no polynomial, or dots end one.
        """
        kept = self.degree(one)
        cut = any(isinstance(part, Dots) for part in walk(one))
        if kept is None or not (cut or self.degree(exact) is None):
            return False
        return self.agreement(one, exact) > kept

    @property
    def _large(self) -> sympy.Symbol:
        return self.convert.symbol("lambda")

    @property
    def _small(self) -> sympy.Symbol:
        return self.convert.symbol("u")

    def _function(self, expression: Any) -> Any:
        symbols = [self.convert.symbol(name) for name in self.free]
        found = sympy.lambdify(symbols, expression, "mpmath", dummify=True)
        return lambda point: mpmath.mpmathify(found(*(point[name] for name in self.free)))


def _chosen(name: str, chance: random.Random) -> Any:
    """Return a random value: a whole number for n and k, a rod ratio above 2, u below 1."""
    if name in ("n", "k"):
        return chance.randint(2, 5)
    low = {"lambda": 2.0, "u": 0.1}.get(name, 0.3)
    return mpmath.mpf(round(chance.uniform(low, low + (0.7 if name == "u" else 1.1)), 6))
