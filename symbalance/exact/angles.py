"""Angles as exact fractions of a turn, plus multiples of symbols.

Numbers and text are degrees. A SymPy expression is the angle itself, in radians: a rational multiple
of pi plus rational multiples of symbols, so that ``alpha/2`` or ``pi/6 + alpha`` may be a bank angle.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from symbalance.errors import SymbalanceError, brief
from symbalance.text.numbers import exact

if TYPE_CHECKING:
    import sympy

LARGEST_DENOMINATOR = 10_000
"""An angle's denominator in degrees; 17.3333333 is refused because 52/3 was meant."""

SymbolPart = tuple[tuple[Any, Fraction], ...]
"""Rational multiples of SymPy symbols, sorted by name: the symbolic part of an angle."""


@dataclass(frozen=True, slots=True)
class Angle:
    """An angle: `turns` of a full turn plus rational multiples of symbols (radians).

    >>> degrees("360/7").turns
    Fraction(1, 7)
    >>> (degrees(90) - degrees(30)).in_degrees()
    Fraction(60, 1)
    """

    turns: Fraction
    symbols: SymbolPart = ()

    def __add__(self, other: Angle) -> Angle:
        return Angle(self.turns + other.turns, _merged(self.symbols, other.symbols))

    def __sub__(self, other: Angle) -> Angle:
        return self + other.scaled(-1)

    def scaled(self, factor: int | Fraction) -> Angle:
        """Return the angle times a rational."""
        part = tuple((name, value * factor) for name, value in self.symbols) if factor else ()
        return Angle(self.turns * factor, part)

    def normalized(self) -> Angle:
        """Return the angle with its turns in (-1/2, 1/2].

        >>> degrees(330).normalized().in_degrees(), degrees(-180).normalized().in_degrees()
        (Fraction(-30, 1), Fraction(180, 1))
        """
        turns = self.turns % 1
        return Angle(turns - 1 if turns > Fraction(1, 2) else turns, self.symbols)

    def in_degrees(self) -> Fraction:
        """Return the angle's numeric part in degrees."""
        return self.turns * 360

    def expression(self) -> sympy.Expr:
        """Return the angle as a SymPy expression in radians."""
        import sympy

        numeric = 2 * sympy.pi * sympy.Rational(self.turns.numerator, self.turns.denominator)
        return numeric + sympy.Add(
            *(sympy.Rational(f.numerator, f.denominator) * symbol for symbol, f in self.symbols)
        )

    def as_text(self) -> str:
        """Return degrees as files write them, symbols appended.

        >>> import sympy
        >>> angle(sympy.Symbol("alpha") / 2 + sympy.pi / 6, "bank").as_text()
        '30 + alpha/2'
        """
        terms = [str(self.turns * 360)] if self.turns or not self.symbols else []
        terms += [_multiple(name, factor) for name, factor in self.symbols]
        return " + ".join(terms).replace("+ -", "- ")


def _multiple(name: Any, factor: Fraction) -> str:
    sign = "-" if factor < 0 else ""
    number, below = abs(factor.numerator), factor.denominator
    head = str(name) if number == 1 else f"{number}*{name}"
    return sign + (head if below == 1 else f"{head}/{below}")


def _merged(first: SymbolPart, second: SymbolPart) -> SymbolPart:
    if not second:
        return first
    total = dict(first)
    for symbol, factor in second:
        total[symbol] = total.get(symbol, Fraction(0)) + factor
    nonzero = ((symbol, factor) for symbol, factor in total.items() if factor)
    return tuple(sorted(nonzero, key=lambda term: str(term[0])))


def degrees(value: object, name: str = "angle") -> Angle:
    """Return an angle from its degrees: a number, a decimal or a fraction as text."""
    number = exact(value, name)
    if number.denominator > LARGEST_DENOMINATOR:
        near = number.limit_denominator(100)
        raise SymbalanceError(
            f"{name} = {brief(value)}",
            f"an angle's denominator must be at most {LARGEST_DENOMINATOR}",
            f'write the fraction that is meant, such as "{near}"',
        )
    return Angle(number / 360)


def angle(value: object, name: str = "angle") -> Angle:
    """Return an angle from degrees, an `Angle`, or a SymPy expression in radians."""
    if isinstance(value, Angle):
        return value
    if hasattr(value, "free_symbols") and not getattr(value, "is_Rational", False):
        return _from_expression(value, name)
    return degrees(value, name)


def _from_expression(expression: Any, name: str) -> Angle:
    import sympy

    if isinstance(expression, sympy.Float):
        return degrees(str(expression), name)
    total = Angle(Fraction(0))
    if not isinstance(expression, sympy.Expr):
        raise SymbalanceError(
            f"{name} = {brief(expression)}",
            "is no angle",
            "give degrees, or a SymPy expression in radians",
        )
    for term in sympy.Add.make_args(sympy.expand(expression)):
        factor: Any
        factor, rest = term.as_coeff_Mul(rational=True)
        exact_factor = Fraction(int(factor.p), int(factor.q)) if factor.is_Rational else None
        if exact_factor is None or not (rest is sympy.pi or rest.is_Symbol):
            raise SymbalanceError(
                f"{name} = {brief(expression)}",
                "must be rational multiples of pi and of symbols (radians)",
                "write it like alpha/2 + pi/6, or give degrees as a number",
            )
        part = (
            Angle(exact_factor / 2) if rest is sympy.pi else Angle(Fraction(0), ((rest, exact_factor),))
        )
        total = total + part
    degrees(total.turns * 360, name)  # refuses what no number may be either
    return total
