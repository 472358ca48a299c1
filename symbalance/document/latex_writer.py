r"""Formulas as LaTeX, displayed or within a sentence.

>>> from symbalance.document.formula import Name, cos
>>> print(LatexWriter().write(Name("r") * (1 - cos(Name("theta")))))
r \left(1 - \cos \theta\right)
"""

from __future__ import annotations

import re
from fractions import Fraction
from typing import ClassVar

from symbalance.document import formula as f
from symbalance.document.notation import LATEX_NAMES, monomial_latex
from symbalance.document.writer import Visitor, bare_argument, holds_a_sum, meet


class LatexWriter(Visitor):
    """LaTeX for amsmath; widths in points, on the wide side."""

    names = LATEX_NAMES
    minus = "-"
    relations: ClassVar[dict[str, str]] = {"≈": r"\approx", "≤": r"\leq"}

    def width(self, printed: str) -> float:
        """Return a generous estimate in points: digits take 5, letters 6, signs 12."""
        flat = _FRACTION.sub(lambda m: max(m[1], m[2], key=self.width), printed)
        flat = _FUNCTION.sub(lambda m: m[1], _FENCE.sub("", flat))
        flat = _BARE.sub("", _COMMAND.sub("x", flat))
        return 5.5 * len(flat) + 8 * sum(map(flat.count, "+-=≈"))

    def fences(self, value: f.Sum) -> tuple[str, str]:
        r"""Return brackets of fixed size, which may stand on different lines as \left, \right may not."""
        tall = r"\biggl", r"\biggr"
        size = tall if any(mark in self.write(value) for mark in _TALL) else ("", "")
        left, right = ("[", "]") if holds_a_sum(value) else ("(", ")")
        return size[0] + left, size[1] + right

    def product(self, left: f.Formula, right: f.Formula) -> str:
        """Return a dot between digits, a thin space where letters would run together, else none."""
        if meet(left, right):
            return r" \cdot "
        apart = isinstance(left, f.Scientific) or isinstance(right, f.Series2F1 | f.Over)
        return r" \, " if apart else " "

    def factor(self, value: f.Formula) -> str:
        """Return a factor, sums in brackets that grow with them."""
        if isinstance(value, f.Sum):
            left, right = ("[", "]") if holds_a_sum(value) else ("(", ")")
            return rf"\left{left}{self.write(value)}\right{right}"
        return self.write(value)

    def _number(self, value: f.Number) -> str:
        return r"\tfrac{1}{2}" if value.value == Fraction(1, 2) else str(value.value)

    def _scientific(self, value: f.Scientific) -> str:
        if value.exponent == 0:
            return value.mantissa
        return rf"{value.mantissa} \times 10^{{{value.exponent}}}"

    def _monomial(self, value: f.Monomial) -> str:
        return monomial_latex(value, self.write(value.of) if value.of else "")

    def _over(self, value: f.Over) -> str:
        return rf"\frac{{{self.write(value.over)}}}{{{self.write(value.under)}}}"

    def _power(self, value: f.Power) -> str:
        base = self.write(value.base)
        bare = isinstance(value.base, f.Name | f.Indexed) or base.isdecimal()
        return (base if bare else rf"\left({base}\right)") + f"^{{{self.write(value.exponent)}}}"

    def _root(self, value: f.Root) -> str:
        return rf"\sqrt{{{self.write(value.inside)}}}"

    def _absolute(self, value: f.Absolute) -> str:
        return rf"\lvert {self.write(value.inside)} \rvert"

    def _applied(self, value: f.Applied) -> str:
        name = _LATEX_FUNCTIONS.get(value.function, rf"\{value.function}")
        name += f"^{{{self.write(value.power)}}}" if value.power else ""
        if bare_argument(value):
            return f"{name} {self.write(value.argument)}"
        return rf"{name}\left({self.write(value.argument)}\right)"

    def _indexed(self, value: f.Indexed) -> str:
        return f"{value.letter}_{{{self.write(value.index)}}}"

    def _binomial(self, value: f.Binomial) -> str:
        return rf"\binom{{{self.write(value.upper)}}}{{{self.write(value.lower)}}}"

    def _series2f1(self, value: f.Series2F1) -> str:
        a, b, c, z = (self.write(part) for part in (value.a, value.b, value.c, value.z))
        return rf"{{}}_{{2}}F_{{1}}\left({a}, {b}; {c}; {z}\right)"

    def _total(self, value: f.Total) -> str:
        index, first = self.write(value.index), self.write(value.first)
        last = r"\infty" if value.last is None else self.write(value.last)
        return rf"\sum_{{{index}={first}}}^{{{last}}} {self.factor(value.body)}"


class InlineLatexWriter(LatexWriter):
    r"""LaTeX within a sentence: fractions with a slash.

    >>> InlineLatexWriter().write(f.Name("l") / (2 * f.Name("r")))
    'l/(2 r)'
    """

    def factor(self, value: f.Formula) -> str:
        """Return a factor, sums and slashed fractions in brackets."""
        printed = super().factor(value)
        return f"({printed})" if isinstance(value, f.Over) else printed

    def _monomial(self, value: f.Monomial) -> str:
        size, letter = value.coefficient, f.Name(value.letter) ** f.Number(abs(value.exponent))
        power = f.Name(value.letter) if abs(value.exponent) == 1 else letter
        over: list[f.Formula] = [f.Number(size.numerator)] if size.numerator > 1 else []
        under: list[f.Formula] = [f.Number(size.denominator)] if size.denominator > 1 else []
        (over if value.exponent > 0 else under).append(power)
        over += [value.of] if value.of else []
        above = f.Times(tuple(over)) if over else f.Number(1)
        return self._over(f.Over(above, _product(under))) if under else self.write(above)

    def _over(self, value: f.Over) -> str:
        over, under = self.write(value.over), self.write(value.under)
        if isinstance(value.over, f.Sum):
            over = f"({over})"
        return (
            f"{over}/({under})"
            if isinstance(value.under, f.Sum | f.Times | f.Over)
            else f"{over}/{under}"
        )


def _product(factors: list[f.Formula]) -> f.Formula:
    return factors[0] if len(factors) == 1 else f.Times(tuple(factors))


_TALL = (r"\frac", r"\binom", r"\sum", r"\sqrt")
_LATEX_FUNCTIONS = {"asin": r"\arcsin"}
_INNER = r"\{((?:[^{}]|\{[^{}]*\})*)\}"
_FRACTION = re.compile(rf"\\frac{_INNER}{_INNER}")
_FUNCTION = re.compile(r"\\(sin|cos|arcsin)")
_FENCE = re.compile(r"\\(?:left|right|biggl|biggr|lvert|rvert)")
_COMMAND = re.compile(r"\\[a-zA-Z]+")
_BARE = re.compile(r"[\^_{} ]|\\,")
