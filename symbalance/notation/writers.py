r"""The two writers of formulas: `TextWriter` for a terminal, `LatexWriter` for a paper.

>>> from symbalance.notation.formula import Name, cos
>>> value = Name("r") * (1 - cos(Name("theta")))
>>> TextWriter().write(value), LatexWriter().write(value)
('r (1 − cos θ)', 'r \\left(1 - \\cos \\theta\\right)')
"""

from __future__ import annotations

import re
from fractions import Fraction
from typing import ClassVar, Protocol

from symbalance.notation import formula as f
from symbalance.notation.series import (
    LATEX_NAMES,
    TEXT_NAMES,
    lowered,
    monomial_latex,
    monomial_text,
    raised,
    signed,
)


class Writer(Protocol):
    """Prints formulas; `width` is the room that something printed takes, in the writer's own unit."""

    minus: str
    relations: dict[str, str]

    def write(self, value: f.Formula) -> str:
        """Return a formula in print."""
        ...

    def width(self, printed: str) -> float:
        """Return how much room something printed takes."""
        ...

    def fences(self, value: f.Sum) -> tuple[str, str]:
        """Return the brackets around a sum that may run over several lines."""
        ...

    def factor(self, value: f.Formula) -> str:
        """Return a factor of a product, in brackets where it needs them."""
        ...

    def product(self, left: f.Formula, right: f.Formula) -> str:
        """Return what stands between two factors."""
        ...


def holds_a_sum(value: f.Sum) -> bool:
    """Tell whether a bracketed sum stands inside `value`, which then takes square brackets.

    >>> x = f.Name("x")
    >>> holds_a_sum(1 + x * (1 + x)), holds_a_sum(1 + x)
    (True, False)
    """
    factors = (t.factors if isinstance(t, f.Times) else (t,) for _, t in value.terms)
    return any(isinstance(factor, f.Sum) for each in factors for factor in each)


class _Visitor:
    """Prints by the type of the formula; what both writers share."""

    names: dict[str, str]
    minus: str

    def write(self, value: f.Formula) -> str:
        return getattr(self, f"_{type(value).__name__.lower()}")(value)

    def product(self, left: f.Formula, right: f.Formula) -> str:
        raise NotImplementedError

    def factor(self, value: f.Formula) -> str:
        raise NotImplementedError

    def _name(self, value: f.Name) -> str:
        return self.names.get(value.name, value.name)

    def _sum(self, value: f.Sum) -> str:
        terms = [(s, self.factor(t) if isinstance(t, f.Sum) else self.write(t)) for s, t in value.terms]
        return signed(terms, self.minus)

    def _times(self, value: f.Times) -> str:
        printed = self.factor(value.factors[0])
        for left, right in zip(value.factors, value.factors[1:], strict=False):
            last = right is value.factors[-1] and isinstance(right, f.Over)
            printed += self.product(left, right) + (self.write(right) if last else self.factor(right))
        return printed


def _meet(left: f.Formula, right: f.Formula) -> bool:
    """Tell whether two factors need a dot between them: digits meet digits."""
    return (isinstance(left, f.Number) and isinstance(right, f.Number | f.Scientific)) or (
        isinstance(left, f.Number) and isinstance(right, f.Power) and isinstance(right.base, f.Number)
    )


def _bare_argument(value: f.Applied) -> bool:
    """Tell whether a function's argument goes without brackets, as in cos 2 theta."""
    if isinstance(value.argument, f.Times):
        return not any(isinstance(factor, f.Applied) for factor in value.argument.factors)
    return isinstance(value.argument, f.Name)


class TextWriter(_Visitor):
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
        """Return a dot after a fraction, nothing between a number and a letter, else a space."""
        if _meet(left, right) or (isinstance(left, f.Monomial) and not isinstance(right, f.Sum)):
            return "·"
        if isinstance(left, f.Number) and isinstance(right, f.Name | f.Power | f.Indexed):
            return ""
        return " "

    def factor(self, value: f.Formula) -> str:
        if isinstance(value, f.Sum):
            return self.write(value).join(self.fences(value))
        return f"({self.write(value)})" if isinstance(value, f.Over) else self.write(value)

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
        if _bare_argument(value):
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


class LatexWriter(_Visitor):
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
        size = tall if any(mark in self.write(value) for mark in (r"\frac", r"\binom")) else ("", "")
        left, right = ("[", "]") if holds_a_sum(value) else ("(", ")")
        return size[0] + left, size[1] + right

    def product(self, left: f.Formula, right: f.Formula) -> str:
        """Return a dot between digits, else the space that LaTeX ignores."""
        return r" \cdot " if _meet(left, right) else " "

    def factor(self, value: f.Formula) -> str:
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
        if _bare_argument(value):
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


_LATEX_FUNCTIONS = {"asin": r"\arcsin"}
_INNER = r"\{((?:[^{}]|\{[^{}]*\})*)\}"
_FRACTION = re.compile(rf"\\frac{_INNER}{_INNER}")
_FUNCTION = re.compile(r"\\(sin|cos|arcsin)")
_FENCE = re.compile(r"\\(?:left|right|biggl|biggr|lvert|rvert)")
_COMMAND = re.compile(r"\\[a-zA-Z]+")
_BARE = re.compile(r"[\^_{} ]")
