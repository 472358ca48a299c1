"""Polynomials in symbols with exact coefficients, whose zero is decided term by term.

A `Polynomial` maps a monomial to a rational, a `SymbolSum` maps one to a number of the engine's field
(a `SymbolicPhasor`, for a bank angle may be a symbol too). Monomials in independent symbols, powers of
either sign, are linearly independent over the complex numbers, also beside exponentials of symbols: a sum
is zero for all values exactly when no term is left. Nothing is simplified to know that.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

from symbalance.errors import SymbalanceError, brief
from symbalance.exact.phasor import Phasor
from symbalance.exact.spectrum import Component
from symbalance.exact.symbolic_phasor import SymbolicPhasor
from symbalance.text.numbers import exact

if TYPE_CHECKING:
    import sympy

Monomial = tuple[tuple[Any, int], ...]
"""Symbols with their exponents, which are not 0, sorted by name."""
Polynomial = Mapping[Monomial, Fraction]
Numbers = Mapping[Any, Fraction]
MOST_TERMS = 20_000


def monomial_product(first: Monomial, second: Monomial) -> Monomial:
    """Return the product of two monomials."""
    if not first or not second:
        return first or second
    powers = dict(first)
    for symbol, power in second:
        powers[symbol] = powers.get(symbol, 0) + power
    return tuple(sorted(((s, p) for s, p in powers.items() if p), key=lambda term: str(term[0])))


def multiply(first: Polynomial, second: Polynomial) -> Polynomial:
    """Return the product of two polynomials."""
    total: dict[Monomial, Fraction] = {}
    for monomial_of_first, c in first.items():
        for monomial_of_second, d in second.items():
            monomial = monomial_product(monomial_of_first, monomial_of_second)
            total[monomial] = total.get(monomial, Fraction(0)) + c * d
    return {monomial: c for monomial, c in total.items() if c}


def add(first: Polynomial, second: Polynomial) -> Polynomial:
    """Return the sum of two polynomials."""
    total = dict(first)
    for monomial, c in second.items():
        total[monomial] = total.get(monomial, Fraction(0)) + c
    return {monomial: c for monomial, c in total.items() if c}


def raise_to_power(base: Polynomial, power: int, name: str) -> Polynomial:
    """Return a whole power; of one term any, of more terms none below 0."""
    if power < 0:
        if len(base) != 1:
            rule = "is divided by, and must be one number or one symbol"
            raise SymbalanceError(name, rule, "give it a symbol of its own")
        ((monomial, c),) = base.items()
        base, power = {tuple((s, -p) for s, p in monomial): 1 / c}, -power
    total: Polynomial = {(): Fraction(1)}
    for _ in range(power):
        total = multiply(total, base)
    return total


def polynomial(value: object, name: str) -> Polynomial:
    """Return a number, or a SymPy polynomial with rational coefficients, term by term.

    >>> import sympy
    >>> x, y = sympy.symbols("x y")
    >>> polynomial(x * (y + 2) / 3, "mass")
    {((x, 1), (y, 1)): Fraction(1, 3), ((x, 1),): Fraction(2, 3)}
    """
    if not getattr(value, "free_symbols", None):
        number = exact(value, name)
        return {(): number} if number else {}
    import sympy

    symbols = sorted(value.free_symbols, key=str)  # type: ignore[attr-defined]
    try:
        terms = sympy.Poly(value, *symbols, domain="QQ").terms()
    except sympy.PolynomialError:
        terms = None
    except sympy.CoercionFailed:
        terms = None
    if terms is None:
        rule = "must be a polynomial in symbols with rational coefficients"
        raise SymbalanceError(f"{name} = {brief(value)}", rule, "write it like m1 or m + m1/2")
    coefficients = {}
    for powers, c in terms:
        monomial = tuple((s, p) for s, p in zip(symbols, powers, strict=True) if p)
        coefficients[monomial] = Fraction(int(c.p), int(c.q))
    return coefficients


@dataclass(frozen=True, eq=False)
class SymbolSum:
    """A polynomial in symbols with exact complex coefficients: monomial to coefficient, in `terms`."""

    terms: Mapping[Monomial, SymbolicPhasor] = field(hash=False)

    @staticmethod
    def of(factor: Polynomial, number: SymbolicPhasor) -> SymbolSum:
        """Return a polynomial times one number."""
        return SymbolSum({m: n for m, c in factor.items() if not (n := number.scaled(c)).is_zero()})

    def is_zero(self) -> bool:
        """Tell whether the sum is zero for all values of its symbols: a proof either way."""
        return not self.terms

    def __add__(self, other: SymbolSum) -> SymbolSum:
        total = dict(self.terms)
        for monomial, number in other.terms.items():
            total[monomial] = total[monomial] + number if monomial in total else number
        if len(total) > MOST_TERMS:
            rule = f"has more than {MOST_TERMS} terms"
            raise SymbalanceError("the sum", rule, "leave fewer symbols in, or ask for a lower power")
        return SymbolSum({m: n for m, n in total.items() if not n.is_zero()})

    def __neg__(self) -> SymbolSum:
        return SymbolSum({m: -n for m, n in self.terms.items()})

    def rotated(self, turns: Fraction) -> SymbolSum:
        """Return the sum times e^(2 pi i turns)."""
        return SymbolSum({m: n.rotated(turns) for m, n in self.terms.items()})

    def conjugate(self) -> SymbolSum:
        """Return the complex conjugate, all symbols being real."""
        return SymbolSum({m: n.conjugate() for m, n in self.terms.items()})

    def at(self, numbers: Numbers) -> SymbolSum:
        """Return the sum with numbers put in for some of its symbols (angles stay symbols)."""
        total = SymbolSum({})
        for monomial, number in self.terms.items():
            factor, rest = Fraction(1), []
            for symbol, power in monomial:
                if symbol in numbers:
                    factor *= _power(symbol, numbers[symbol], power)
                else:
                    rest.append((symbol, power))
            total = total + SymbolSum.of({tuple(rest): factor}, number)
        return total

    def differentiated(self, symbol: Any) -> SymbolSum:
        """Return the derivative by a symbol that stands in the monomials."""
        total = SymbolSum({})
        for monomial, number in self.terms.items():
            power = dict(monomial).get(symbol, 0)
            if power:
                total = total + SymbolSum.of(
                    {monomial_product(monomial, ((symbol, -1),)): Fraction(power)}, number
                )
        return total

    def number(self) -> Phasor | SymbolicPhasor | None:
        """Return the number that is left when no monomial holds a symbol, else None."""
        if any(self.terms):
            return None
        constant = self.terms.get((), SymbolicPhasor({}))
        return constant.parts.get((), Phasor(1, {})) if set(constant.parts) <= {()} else constant

    def real_part(self) -> sympy.Expr:
        """Return the real part as a SymPy expression."""
        import sympy

        terms = []
        for monomial, number in self.terms.items():
            real = Component(number if set(number.parts) != {()} else number.parts[()]).cos
            terms.append(sympy.Mul(real, *(symbol**power for symbol, power in monomial)))
        return sympy.Add(*terms)


def _power(symbol: Any, number: Fraction, power: int) -> Fraction:
    if power < 0 and not number:
        raise SymbalanceError(f"{symbol} = 0", "is divided by", "give it another value")
    return number**power


@dataclass(frozen=True, eq=False)
class SymbolComponent:
    """One order of one component with symbols left in: C cos n theta + S sin n theta.

    `sum` is C + iS. `cos`, `sin` and `amplitude` are SymPy expressions, the symbols taken for real.
    """

    sum: SymbolSum

    def is_zero(self) -> bool:
        """Tell whether it vanishes for all values of the symbols: a proof either way."""
        return self.sum.is_zero()

    @cached_property
    def cos(self) -> sympy.Expr:
        """The coefficient of cos n theta."""
        return self.sum.real_part()

    @cached_property
    def sin(self) -> sympy.Expr:
        """The coefficient of sin n theta."""
        return self.sum.rotated(Fraction(-1, 4)).real_part()

    @cached_property
    def amplitude(self) -> sympy.Expr:
        """The amplitude: exact where no symbol is left, else the root of C^2 + S^2."""
        import sympy

        number = self.sum.number()
        if number is not None:
            return Component(number).amplitude
        return sympy.sqrt(sympy.expand(self.cos**2 + self.sin**2))
