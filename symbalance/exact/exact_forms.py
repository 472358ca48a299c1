"""Exact numbers as they are printed: a formula for every medium, text that SymPy reads, an expression.

A `ClosedForm` of radicals and cosines, which needs no SymPy; a SymPy expression, where symbols stand in
a number or it has only decimals; an angle that is no fraction of a turn, and a root that stays a root.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

from symbalance.document.formula import Apply, Formula, sqrt

if TYPE_CHECKING:
    import sympy


class ExactForm(Protocol):
    """What an exact number is printed from."""

    @property
    def spelling(self) -> str:
        """The number as SymPy spells it."""
        ...

    def is_zero(self) -> bool:
        """Tell whether it is 0."""
        ...

    def as_formula(self) -> Formula:
        """Return it as handbooks write it."""
        ...

    def expression(self) -> sympy.Expr:
        """Return it as a SymPy expression."""
        ...


@dataclass(frozen=True)
class FromSymPy:
    """A number that SymPy holds."""

    value: Any

    @property
    def spelling(self) -> str:
        """The number as SymPy spells it."""
        return str(self.value)

    def is_zero(self) -> bool:
        """Tell whether it is 0."""
        return bool(self.value == 0)

    def as_formula(self) -> Formula:
        """Return it as handbooks write it."""
        from symbalance.document.expressions import formula_of

        return formula_of(self.value)

    def expression(self) -> sympy.Expr:
        """Return it as a SymPy expression."""
        return self.value


@dataclass(frozen=True)
class Direction:
    """The angle of the point (cos, sin), an atan2 that is not evaluated."""

    cos: ExactForm
    sin: ExactForm

    @property
    def spelling(self) -> str:
        """The angle as SymPy spells it."""
        return f"atan2({self.sin.spelling}, {self.cos.spelling})"

    def is_zero(self) -> bool:
        """Tell whether it is 0: no fraction of a turn is written so."""
        return False

    def as_formula(self) -> Formula:
        """Return it as a function of two arguments."""
        return Apply("atan2", (self.sin.as_formula(), self.cos.as_formula()))

    def expression(self) -> sympy.Expr:
        """Return it as a SymPy expression."""
        import sympy

        return sympy.atan2(self.sin.expression(), self.cos.expression(), evaluate=False)


@dataclass(frozen=True)
class RootOfSquares:
    """The distance of the point (cos, sin) from 0, as the root of a sum that is not multiplied out."""

    cos: ExactForm
    sin: ExactForm

    @property
    def spelling(self) -> str:
        """The root as text that SymPy reads; SymPy would spell its terms in another order."""
        return f"sqrt(({self.cos.spelling})**2 + ({self.sin.spelling})**2)"

    def is_zero(self) -> bool:
        """Tell whether it is 0."""
        return self.cos.is_zero() and self.sin.is_zero()

    def as_formula(self) -> Formula:
        """Return it as a root of squares."""
        return sqrt(self.cos.as_formula() ** 2 + self.sin.as_formula() ** 2)

    def expression(self) -> sympy.Expr:
        """Return it as a SymPy expression, not evaluated: SymPy would ask each square for its size."""
        import sympy

        squares = self.cos.expression() ** 2 + self.sin.expression() ** 2
        return sympy.Pow(squares, sympy.S.Half, evaluate=False)
