"""Truncated power series in 1/lambda: polynomials that know the highest power they are exact to."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from symbalance.document.symbols import symbol

if TYPE_CHECKING:
    import sympy

    from symbalance.document.formula import Formula


@dataclass(frozen=True, slots=True)
class Series:
    """A truncated series in 1/lambda, exact through the power `through`.

    `terms` maps a power of 1/lambda to its coefficient. `complete` says that nothing is left out at all.

    >>> from symbalance.kinematics.slider_crank import acceleration_series
    >>> acceleration_series(2, through=5)
    Series(terms={1: Fraction(1, 1), 3: Fraction(1, 4), 5: Fraction(15, 128)}, through=5, complete=False)
    """

    terms: dict[int, Fraction]
    through: int
    complete: bool = False

    def at(self, ratio: Fraction) -> Fraction:
        """Return the kept terms' sum for a rod ratio lambda, exactly."""
        return sum((c / ratio**p for p, c in self.terms.items()), Fraction(0))

    def scaled(self, factor: Fraction | int) -> Series:
        """Return the series times a rational."""
        terms = {p: c * factor for p, c in self.terms.items()}
        return Series(terms, self.through, self.complete)

    def in_powers_of_rho(self) -> sympy.Expr:
        """Return the kept terms as a SymPy expression in rho = r/l."""
        return self._expression(symbol("rho"), 1)

    def in_lam(self) -> sympy.Expr:
        """Return the kept terms as a SymPy expression in lam = l/r.

        >>> from symbalance.kinematics.slider_crank import acceleration_series
        >>> acceleration_series(6, through=7).in_lam()
        9/(128*lam**5) + 45/(512*lam**7)
        """
        return self._expression(symbol("lam"), -1)

    @property
    def spelling(self) -> str:
        """The kept terms in lam = l/r as SymPy spells them, for programs that read them so.

        >>> from symbalance.kinematics.slider_crank import acceleration_series
        >>> acceleration_series(6, through=7).spelling
        '9/(128*lam**5) + 45/(512*lam**7)'
        """
        terms = [_spelled(c, power) for power, c in sorted(self.terms.items()) if c]
        return " + ".join(terms).replace(" + -", " - ") or "0"

    def as_formula(self) -> Formula:
        """Return the series as a formula, dots where it goes on."""
        from symbalance.kinematics.series_printing import series_formula

        return series_formula(self, ellipsis=True)

    def _expression(self, of: sympy.Symbol, sign: int) -> sympy.Expr:
        import sympy

        return sympy.Add(
            *(
                sympy.Rational(c.numerator, c.denominator) * of ** (sign * p)
                for p, c in self.terms.items()
            )
        )


def _spelled(factor: Fraction, power: int) -> str:
    """Return factor/lam^power as SymPy spells it."""
    above, below = factor.as_integer_ratio()
    if power == 0:
        return str(factor)
    letter = "lam" if power == 1 else f"lam**{power}"
    if factor == 1 and power > 1:
        return f"lam**(-{power})"
    return f"{above}/{letter}" if below == 1 else f"{above}/({below}*{letter})"
