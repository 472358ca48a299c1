"""Formulas as Unicode text.

>>> from symbalance.document.formula import Name, cos
>>> TextWriter().write(Name("r") * (1 - cos(Name("theta"))))
'r (1 − cos θ)'
"""

from __future__ import annotations

from fractions import Fraction
from typing import ClassVar

from symbalance.document import formula as f
from symbalance.document.notation import TEXT_NAMES, lowered, monomial_text, raised
from symbalance.document.writer import Visitor, bare_argument, holds_a_sum, meet


class TextWriter(Visitor):
    """Unicode text; widths in columns."""

    names = TEXT_NAMES
    minus = "−"
    relations: ClassVar[dict[str, str]] = {}

    def width(self, printed: str) -> float:
        """Return the number of columns."""
        return len(printed)

    def fences(self, value: f.Sum) -> tuple[str, str]:
        """Return round brackets, square ones around round ones."""
        return ("[", "]") if holds_a_sum(value) else ("(", ")")

    def product(self, left: f.Formula, right: f.Formula) -> str:
        """Return a dot between digits, nothing between a number and a letter, else a space."""
        if meet(left, right):
            return "·"
        if isinstance(left, f.Number) and isinstance(right, f.Name | f.Power | f.Indexed):
            return ""
        return " "

    def factor(self, value: f.Formula) -> str:
        """Return a factor, sums and fractions in brackets."""
        if isinstance(value, f.Sum):
            return self.write(value).join(self.fences(value))
        printed = self.write(value)
        return f"({printed})" if isinstance(value, f.Over | f.Monomial) and "/" in printed else printed

    def _tight(self, value: f.Formula) -> str:
        return self.write(value).replace(" ", "")

    def _number(self, value: f.Number) -> str:
        return "½" if value.value == Fraction(1, 2) else str(value.value).replace("-", "−")

    def _scientific(self, value: f.Scientific) -> str:
        if value.exponent == 0:
            return value.mantissa
        return f"{value.mantissa}·10{raised(str(value.exponent).replace('-', '−'))}"

    def _monomial(self, value: f.Monomial) -> str:
        return monomial_text(value, self.write(value.of) if value.of else "")

    def _over(self, value: f.Over) -> str:
        over, under = self.write(value.over), self.write(value.under)
        if isinstance(value.over, f.Sum):
            over = f"({over})"
        if isinstance(value.under, f.Sum | f.Times | f.Over):
            under = f"({under})"
        return f"{over}/{under}"

    def _power(self, value: f.Power) -> str:
        base = self.write(value.base)
        bare = isinstance(value.base, f.Name | f.Indexed) or base.isdecimal()
        return (base if bare else f"({base})") + raised(self._tight(value.exponent))

    def _root(self, value: f.Root) -> str:
        inside = self.write(value.inside)
        return f"√{inside}" if isinstance(value.inside, f.Name) else f"√({inside})"

    def _absolute(self, value: f.Absolute) -> str:
        return f"|{self.write(value.inside)}|"

    def _applied(self, value: f.Applied) -> str:
        name = value.function + (raised(self._tight(value.power)) if value.power else "")
        if bare_argument(value):
            return f"{name}{'' if value.power else ' '}{self._tight(value.argument)}"
        return f"{name}({self.write(value.argument)})"

    def _indexed(self, value: f.Indexed) -> str:
        return value.letter + lowered(self._tight(value.index))

    def _binomial(self, value: f.Binomial) -> str:
        return f"C({self._tight(value.upper)}, {self._tight(value.lower)})"

    def _series2f1(self, value: f.Series2F1) -> str:
        a, b, c, z = (self._tight(part) for part in (value.a, value.b, value.c, value.z))
        return f"₂F₁({a}, {b}; {c}; {z})"

    def _total(self, value: f.Total) -> str:
        index, first = self.write(value.index), self._tight(value.first)
        span = f"{index}≥{first}" if value.last is None else f"{index}={first}…{self._tight(value.last)}"
        return f"Σ({span}) {self.factor(value.body)}"
