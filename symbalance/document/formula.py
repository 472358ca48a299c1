"""Formulas as plain data, written with Python's operators and printed by `symbalance.notation`.

A formula is kept as it was written: nothing is evaluated, sorted or simplified, so that a derivation
shows the very steps a person would take.

>>> theta, r = Name("theta"), Name("r")
>>> r * (1 - cos(theta)) == Times((r, Sum(((1, Number(1)), (-1, cos(theta))))))
True
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction


class Formula:
    """Anything that can be printed; operators build larger formulas from smaller ones."""

    __slots__ = ()

    def __add__(self, other: Value) -> Sum:
        return Sum((*_terms(self), *_terms(formula(other))))

    def __radd__(self, other: Value) -> Sum:
        return formula(other) + self

    def __sub__(self, other: Value) -> Sum:
        return Sum((*_terms(self), (-1, formula(other))))

    def __rsub__(self, other: Value) -> Sum:
        return formula(other) - self

    def __neg__(self) -> Sum:
        return Sum(((-1, self),))

    def __mul__(self, other: Value) -> Times:
        return Times((*_factors(self), *_factors(formula(other))))

    def __rmul__(self, other: Value) -> Times:
        return formula(other) * self

    def __truediv__(self, other: Value) -> Over:
        return Over(self, formula(other))

    def __rtruediv__(self, other: Value) -> Over:
        return Over(formula(other), self)

    def __pow__(self, exponent: Value) -> Power:
        return Power(self, formula(exponent))


Value = Formula | int | Fraction


@dataclass(frozen=True, slots=True)
class Name(Formula):
    """A letter, by the name `symbalance.notation` knows it by."""

    name: str


@dataclass(frozen=True, slots=True)
class Number(Formula):
    """A whole number or a half."""

    value: int | Fraction


@dataclass(frozen=True, slots=True)
class Scientific(Formula):
    """mantissa x 10^exponent, the mantissa as it is to be printed."""

    mantissa: str
    exponent: int


@dataclass(frozen=True, slots=True)
class Monomial(Formula):
    """coefficient x letter^exponent x `of`, printed as one fraction; the coefficient is positive."""

    coefficient: Fraction
    letter: str
    exponent: int
    of: Formula | None = None


@dataclass(frozen=True, slots=True)
class Sum(Formula):
    """Signed terms."""

    terms: tuple[tuple[int, Formula], ...]


@dataclass(frozen=True, slots=True)
class Times(Formula):
    """Factors side by side."""

    factors: tuple[Formula, ...]


@dataclass(frozen=True, slots=True)
class Over(Formula):
    """A fraction."""

    over: Formula
    under: Formula


@dataclass(frozen=True, slots=True)
class Power(Formula):
    """base^exponent."""

    base: Formula
    exponent: Formula


@dataclass(frozen=True, slots=True)
class Root(Formula):
    """A square root."""

    inside: Formula


@dataclass(frozen=True, slots=True)
class Absolute(Formula):
    """An absolute value."""

    inside: Formula


@dataclass(frozen=True, slots=True)
class Applied(Formula):
    """function^power(argument): sin^2 theta has the power 2."""

    function: str
    argument: Formula
    power: Formula | None = None


@dataclass(frozen=True, slots=True)
class Indexed(Formula):
    """A letter with a subscript."""

    letter: str
    index: Formula


@dataclass(frozen=True, slots=True)
class Binomial(Formula):
    """The binomial coefficient C(upper, lower)."""

    upper: Formula
    lower: Formula


@dataclass(frozen=True, slots=True)
class Series2F1(Formula):
    """Gauss' hypergeometric function 2F1(a, b; c; z)."""

    a: Formula
    b: Formula
    c: Formula
    z: Formula


@dataclass(frozen=True, slots=True)
class Total(Formula):
    """The sum of `body` over `index` from `first` to `last`, or without end where `last` is None."""

    index: Name
    first: Formula
    last: Formula | None
    body: Formula


@dataclass(frozen=True, slots=True)
class Equation:
    """left, then every relation ("=", "≈", "≤") with what follows it."""

    left: Formula
    links: tuple[tuple[str, Formula], ...]


DOTS = Name("dots")


def formula(value: Value) -> Formula:
    """Return a number as a formula, a formula as it is."""
    return value if isinstance(value, Formula) else Number(value)


def equal(left: Value, *rights: Value) -> Equation:
    """Return left = right = right ...."""
    return Equation(formula(left), tuple(("=", formula(right)) for right in rights))


def sin(argument: Formula, power: Value | None = None) -> Applied:
    """Return sin^power(argument)."""
    return Applied("sin", argument, None if power in (None, 1) else formula(power))


def cos(argument: Formula) -> Applied:
    """Return cos(argument)."""
    return Applied("cos", argument)


def alternating(exponent: Value) -> Power:
    """Return (-1)^exponent."""
    return Power(Number(-1), formula(exponent))


def _terms(value: Formula) -> tuple[tuple[int, Formula], ...]:
    return value.terms if isinstance(value, Sum) else ((1, value),)


def _factors(value: Formula) -> tuple[Formula, ...]:
    return value.factors if isinstance(value, Times) else (value,)
