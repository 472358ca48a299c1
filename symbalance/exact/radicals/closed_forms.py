"""Closed forms of real numbers: rational combinations of square roots, cosines, sines and pi.

A form is exact. It is written three ways: as a formula for every medium, as text that SymPy reads, and
as a SymPy expression. Only the last needs SymPy, which takes longer to load than an engine to balance.

>>> number = ClosedForm.rational(Fraction(25, 2)) + square_root(ClosedForm.rational(5)).scaled(-3)
>>> number.spelling, number.expression()
('25/2 - 3*sqrt(5)', 25/2 - 3*sqrt(5))
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from math import gcd, isqrt, lcm
from typing import TYPE_CHECKING, NamedTuple

from symbalance.document.formula import PI, Call, Formula, Quotient, Sum, monomial, number, signed
from symbalance.text.reals import Real, cospi, fsum, pi, sqrt

if TYPE_CHECKING:
    import sympy

LARGEST_PRIME = 1000
"""Square factors of larger primes are not looked for in a sum's content: numbers of many digits cannot
be factored."""
LARGEST_PRIME_OF_A_RATIONAL = 1 << 15
"""The same of the root of a rational, as far as SymPy looks when it reads one."""
DIGITS = 60
"""Digits that terms are compared with: the radicands of small roots are differences of large numbers."""


class SquareRoot(NamedTuple):
    """The root of a whole number without square factors, or of a sum; that of 1 stands for 1."""

    radicand: int | ClosedForm


class Wave(NamedTuple):
    """The cosine or sine of `halves` times pi, an acute angle that has no short radicals."""

    function: str
    halves: Fraction


class Pi(NamedTuple):
    """The number pi."""


Irrational = SquareRoot | Wave | Pi
ONE = SquareRoot(1)


@dataclass(frozen=True, eq=False)
class ClosedForm:
    """A sum of rationals times roots, waves or pi; no rational is 0."""

    terms: Mapping[Irrational, Fraction]

    @staticmethod
    def of(terms: Iterable[tuple[Irrational, Fraction]]) -> ClosedForm:
        """Return the sum of terms, like ones taken together."""
        total: dict[Irrational, Fraction] = {}
        for irrational, factor in terms:
            total[irrational] = total.get(irrational, Fraction(0)) + factor
        return ClosedForm({irrational: factor for irrational, factor in total.items() if factor})

    @staticmethod
    def rational(value: int | Fraction) -> ClosedForm:
        """Return a rational number."""
        return ClosedForm.of([(ONE, Fraction(value))])

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ClosedForm) and self.terms == other.terms

    def __hash__(self) -> int:
        return hash(frozenset(self.terms.items()))

    def __add__(self, other: ClosedForm) -> ClosedForm:
        return ClosedForm.of([*self.terms.items(), *other.terms.items()])

    def scaled(self, factor: int | Fraction) -> ClosedForm:
        """Return the number times a rational."""
        return ClosedForm.of((irrational, c * factor) for irrational, c in self.terms.items())

    def is_zero(self) -> bool:
        """Tell whether no term stands in it."""
        return not self.terms

    def as_rational(self) -> Fraction | None:
        """Return the number as a fraction, None where roots, waves or pi stand in it."""
        return None if self.terms.keys() - {ONE} else self.terms.get(ONE, Fraction(0))

    def value(self) -> Real:
        """Return the number in decimals, good enough to compare terms by size."""
        return fsum((_value(irrational) * c for irrational, c in self.terms.items()), DIGITS)

    @property
    def spelling(self) -> str:
        """The number as SymPy spells it: terms by size, but a positive rational before what is taken off.

        >>> (ClosedForm.rational(-1) + square_root(ClosedForm.rational(5))).spelling
        '-1 + sqrt(5)'
        """
        return self._spelling

    @cached_property
    def _spelling(self) -> str:
        if not self.terms:
            return "0"
        spelled = [_spelled(irrational, c) for irrational, c in self._in_order()]
        return "".join([spelled[0], *(_joined(term) for term in spelled[1:])])

    def _in_order(self) -> list[tuple[Irrational, Fraction]]:
        terms = list(self.terms.items())
        if len(terms) < 2:
            return terms
        rational, others = self.terms.get(ONE), [c for kind, c in terms if kind != ONE]
        if rational is not None and rational > 0 and len(others) == 1 and others[0] < 0:
            return sorted(terms, key=lambda term: term[0] != ONE)
        return sorted(terms, key=lambda term: _value(term[0]) * term[1])

    def as_formula(self) -> Formula:
        """Return the number as handbooks write it: rationals first, over the common denominator.

        >>> from symbalance.document.text_writer import formula_text
        >>> number = square_root(ClosedForm.rational(5)).scaled(Fraction(-11, 2))
        >>> formula_text((number + ClosedForm.rational(Fraction(25, 2))).as_formula())
        '(25 − 11√5)/2'
        """
        if not self.terms:
            return number(0)
        common = lcm(*(c.denominator for c in self.terms.values())) if len(self.terms) > 1 else 1
        terms = sorted(self.terms.items(), key=_rank)
        printed = tuple(_term(irrational, c * common) for irrational, c in terms)
        whole = printed[0] if len(printed) == 1 else Sum(printed)
        return whole if common == 1 else Quotient(whole, number(common))

    def expression(self) -> sympy.Expr:
        """Return the number as a SymPy expression."""
        from symbalance.document.sympy_writer import formula_sympy

        return formula_sympy(self.as_formula())


ZERO_FORM = ClosedForm({})


def multiple_of_pi(factor: Fraction) -> ClosedForm:
    """Return so many times pi.

    >>> multiple_of_pi(Fraction(-2, 3)).spelling
    '-2*pi/3'
    """
    return ClosedForm.of([(Pi(), factor)])


def wave(function: str, halves: Fraction) -> ClosedForm:
    """Return cos or sin of `halves` times pi, 0 to pi: in short radicals where there are any.

    Others are brought into the first quadrant and stay what they are.

    >>> wave("cos", Fraction(5, 12)).spelling, wave("cos", Fraction(6, 7)).spelling
    ('-sqrt(2)/4 + sqrt(6)/4', '-cos(pi/7)')
    """
    sign = -1 if 2 * halves > 1 and function == "cos" else 1
    acute = min(halves, 1 - halves)
    from_axis = acute if function == "cos" else Fraction(1, 2) - acute
    short = _SHORT.get(from_axis)
    if short is None:
        return ClosedForm({Wave(function, acute): Fraction(sign)})
    return short.scaled(sign)


def square_root(square: ClosedForm) -> ClosedForm:
    """Return the root of a positive number with the square factors of its content before it.

    >>> square_root(ClosedForm.rational(Fraction(8, 3))).spelling
    '2*sqrt(6)/3'
    >>> five = square_root(ClosedForm.rational(5))
    >>> square_root(ClosedForm.rational(Fraction(5, 4)) + five.scaled(Fraction(-1, 2))).spelling
    'sqrt(5 - 2*sqrt(5))/2'
    """
    value = square.as_rational()
    if value is not None:
        return _root_of_rational(value)
    content = _content(square)
    above, over = _without_squares(content.numerator, LARGEST_PRIME)
    below, under = _without_squares(content.denominator, LARGEST_PRIME)
    inside = Fraction(over, under) / content
    return ClosedForm({SquareRoot(square.scaled(inside)): Fraction(above, below)})


def denested_root(square: ClosedForm) -> ClosedForm:
    """Return the root of a positive number, of a + b sqrt(d) as sqrt(x) +- sqrt(y) if these are rational.

    Formulas:
        (sqrt(6)/2 + sqrt(2)/2)^2 = 2 + sqrt(3)

    >>> three = square_root(ClosedForm.rational(3))
    >>> denested_root(ClosedForm.rational(2) + three).spelling
    'sqrt(2)/2 + sqrt(6)/2'
    """
    rational = square.terms.get(ONE, Fraction(0))
    others = [term for term in square.terms.items() if term[0] != ONE]
    if len(others) == 1 and isinstance(others[0][0], SquareRoot):
        radicand, factor = others[0][0].radicand, others[0][1]
        if isinstance(radicand, int):
            inner = _rational_root(rational**2 - factor**2 * radicand)
            if inner is not None:
                large, small = (rational + inner) / 2, (rational - inner) / 2
                return _root_of_rational(large) + _root_of_rational(small).scaled(1 if factor > 0 else -1)
    return square_root(square)


def _root_of_rational(value: Fraction) -> ClosedForm:
    """Return the root of a rational as a rational times the root of a whole number."""
    exact = _rational_root(value)
    if exact is not None:
        return ClosedForm.rational(exact)
    outside, inside = _without_squares(value.numerator * value.denominator, LARGEST_PRIME_OF_A_RATIONAL)
    return ClosedForm({SquareRoot(inside): Fraction(outside, value.denominator)})


def _rational_root(value: Fraction) -> Fraction | None:
    """Return the root of a square of a rational, None of what is none."""
    if value < 0:
        return None
    above, below = isqrt(value.numerator), isqrt(value.denominator)
    return (
        Fraction(above, below) if above**2 == value.numerator and below**2 == value.denominator else None
    )


@lru_cache(maxsize=1024)
def _without_squares(whole: int, largest: int) -> tuple[int, int]:
    """Return (a, b) with whole = a^2 b and no square of a prime up to `largest` in b."""
    outside, inside, divisor = 1, 1, 2
    while divisor <= largest and divisor * divisor <= whole:
        while whole % (divisor * divisor) == 0:
            whole //= divisor * divisor
            outside *= divisor
        if whole % divisor == 0:
            whole //= divisor
            inside *= divisor
        divisor += 1 if divisor == 2 else 2
    root = isqrt(whole)  # what is left of large numbers may be a square still
    return (outside * root, inside) if root * root == whole else (outside, inside * whole)


def _content(form: ClosedForm) -> Fraction:
    """Return the positive rational that leaves whole factors without a common divisor."""
    factors = form.terms.values()
    return Fraction(gcd(*(c.numerator for c in factors)), lcm(*(c.denominator for c in factors)))


@lru_cache(maxsize=4096)
def _value(irrational: Irrational) -> Real:
    if isinstance(irrational, Pi):
        return pi(DIGITS)
    if isinstance(irrational, Wave):
        quarter = Fraction(1, 2) if irrational.function == "sin" else Fraction(0)
        return cospi(irrational.halves - quarter, DIGITS)
    radicand = irrational.radicand
    return sqrt(radicand if isinstance(radicand, int) else radicand.value(), DIGITS)


@lru_cache(maxsize=4096)
def _name(irrational: Irrational) -> str:
    """Return a root, a wave or pi as SymPy spells it, 1 as nothing."""
    if isinstance(irrational, Pi):
        return "pi"
    if isinstance(irrational, Wave):
        return f"{irrational.function}({multiple_of_pi(irrational.halves).spelling})"
    radicand = irrational.radicand
    inside = str(radicand) if isinstance(radicand, int) else radicand.spelling
    return "" if irrational == ONE else f"sqrt({inside})"


def _spelled(irrational: Irrational, factor: Fraction) -> str:
    """Return a term as SymPy spells it: 3*sqrt(5)/2, -sqrt(3), 7/2."""
    name, above, below = _name(irrational), abs(factor.numerator), factor.denominator
    top = "*".join(([str(above)] if above != 1 or not name else []) + ([name] if name else []))
    return ("-" if factor < 0 else "") + top + (f"/{below}" if below != 1 else "")


def _joined(term: str) -> str:
    return f" - {term[1:]}" if term.startswith("-") else f" + {term}"


def _rank(term: tuple[Irrational, Fraction]) -> tuple[bool, bool, str]:
    """Rationals first, and where there is none a positive term first."""
    return term[0] != ONE, term[1] < 0, _name(term[0])


def _term(irrational: Irrational, factor: Fraction) -> Formula:
    sign, size = (1 if factor > 0 else -1), abs(factor)
    if irrational == ONE:
        return signed(sign, monomial(size, PI, 0))
    return signed(sign, monomial(size, _formula(irrational), 1))


@lru_cache(maxsize=4096)
def _formula(irrational: Irrational) -> Formula:
    if isinstance(irrational, Pi):
        return PI
    if isinstance(irrational, Wave):
        return Call(irrational.function, multiple_of_pi(irrational.halves).as_formula())
    radicand = irrational.radicand
    return Call("sqrt", number(radicand) if isinstance(radicand, int) else radicand.as_formula())


def _short_cosines() -> dict[Fraction, ClosedForm]:
    """Return the cosines of acute angles that are short in radicals, by the angle over pi.

    Formulas:
        cos(pi/5) = 1/4 + sqrt(5)/4
        cos(2 pi/5) = -1/4 + sqrt(5)/4
        cos(pi/12) = sqrt(2)/4 + sqrt(6)/4
        cos(5 pi/12) = sqrt(6)/4 - sqrt(2)/4
        cos(pi/8)^2 = 1/2 + cos(pi/4)/2
        cos(pi/10)^2 = 1/2 + cos(pi/5)/2
        cos(3 pi/10)^2 = 1/2 + cos(3 pi/5)/2
    """
    quarter, half = Fraction(1, 4), Fraction(1, 2)
    root = {n: ClosedForm({SquareRoot(n): Fraction(1)}) for n in (1, 2, 3, 5, 6)}
    cosines = {
        Fraction(0): root[1],
        Fraction(1, 12): (root[2] + root[6]).scaled(quarter),
        Fraction(1, 6): root[3].scaled(half),
        Fraction(1, 5): (root[1] + root[5]).scaled(quarter),
        Fraction(1, 4): root[2].scaled(half),
        Fraction(1, 3): root[1].scaled(half),
        Fraction(2, 5): (root[5] + root[1].scaled(-1)).scaled(quarter),
        Fraction(5, 12): (root[6] + root[2].scaled(-1)).scaled(quarter),
        Fraction(1, 2): ZERO_FORM,
    }
    for angle, sign in (
        (Fraction(1, 8), 1),
        (Fraction(3, 8), -1),
        (Fraction(1, 10), 1),
        (Fraction(3, 10), -1),
    ):
        double = min(2 * angle, 1 - 2 * angle)
        square = (root[1] + cosines[double].scaled(sign)).scaled(half)
        cosines[angle] = ClosedForm({SquareRoot(square): Fraction(1)})
    return cosines


_SHORT = _short_cosines()
