"""The direction in which a page counts a force or an acceleration: the same for all of its orders.

With F = m r ω² (cos θ + λ cos 2θ) the fourth order is negative, with its opposite positive. What a page
counts first, an order by itself or the whole series, is its direction.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import NamedTuple

from symbalance.document.formula import Call, Formula, names, walk
from symbalance.notes.algebra.evaluation import SymbolValue
from symbalance.notes.algebra.tree_values import NO_VALUE, TreeValues
from symbalance.notes.checking.declared.geometry import Geometry
from symbalance.notes.reading.equations import Chain

_SMALL, _LARGE = Fraction(1, 4), Fraction(4)


class Direction(NamedTuple):
    """1 or -1, as at the top dead centre, and the line that counts so."""

    sign: int
    line: int


@dataclass
class OrderDirections:
    """The directions of one page, by a letter without its index and by the kind of its quantity."""

    chains: Sequence[Chain]
    known: dict[tuple[str, str], Direction] = field(default_factory=dict)

    def direction(self, letter: str, kind: str, sign: int, chain: Chain, sizes: Sizes) -> Direction:
        """Return the direction of a letter, or of the series above it; the first one noted stays."""
        key = letter, kind
        if key not in self.known:
            self.known[key] = self._of_series(chain, sizes) or Direction(sign, chain.lines[0])
        return self.known[key]

    def _of_series(self, chain: Chain, sizes: Sizes) -> Direction | None:
        """Return the direction of the last sum of the first and the second order above a relation."""
        for above in reversed(self.chains):
            if above.start >= chain.start:
                continue
            for side in reversed(above.sides[1:]):
                if sign := sizes.sign_at_top(side.node):
                    return Direction(sign, above.lines[0])
        return None


@dataclass(frozen=True)
class Sizes:
    """The letters of a slider-crank, and those that its force or acceleration is proportional to."""

    crank: Geometry
    factors: frozenset[str]

    def sign_at_top(self, node: Formula) -> int:
        """Return the sign of a series with the first and the second order at θ = 0, 0 for others."""
        theta = names(self.crank.theta)
        waves = {
            part.argument for part in walk(node) if isinstance(part, Call) and part.function == "cos"
        }
        if len(waves) != 2 or self.crank.theta not in waves or not self.factors <= names(node):
            return 0
        if len(theta) != 1 or names(node) - self.factors - theta - names(self.crank.ratio):
            return 0
        is_small = self.crank.small is None or self.crank.small[1] > 0
        point = dict.fromkeys(names(node), Fraction(1))
        point |= dict.fromkeys(names(self.crank.ratio) - self.factors, _SMALL if is_small else _LARGE)
        point |= dict.fromkeys(names(self.crank.length) - self.factors, _LARGE)
        point |= dict.fromkeys(theta, Fraction(0))
        try:
            value = TreeValues(SymbolValue(), point).value(node)
        except NO_VALUE:
            return 0
        return 0 if value.imag else (value.real > 0) - (value.real < 0)
