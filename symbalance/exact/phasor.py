"""Exact amplitudes: numbers of a cyclotomic field in a normal form that decides whether they are zero.

Every angle of an engine is a fraction of a turn, so every sum over its cylinders is a rational
combination of powers of one root of unity, zeta = e^(2 pi i/m). All linear relations between those
powers follow from

    sum over i = 0..p-1 of zeta^(k + i m/p) = 0     for each prime p dividing m and each k

(de Bruijn 1953; Conway and Jones 1976). Used as a rewriting rule for the powers whose leading digit
at p is p-1, they leave a basis of the field: two numbers are equal exactly when their reduced terms
are, and a number is zero exactly when no term is left. Nothing is simplified, and nothing is guessed.
The terms stay sparse, so a modulus of millions (angles typed as decimals) costs no more than a small one.

For p = 2, 3, 5 and 7:

Formulas:
    1 + e^(i pi) = 0
    1 + z + z^2 = 0
    1 + y + y^2 + y^3 + y^4 = 0
    cos(2 pi/7) + cos(4 pi/7) + cos(6 pi/7) = -1/2
    with z = e^(2 i pi/3); y = e^(2 i pi/5)
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property, lru_cache
from math import lcm, prod
from typing import Any, ClassVar, overload

from symbalance.errors import SymbalanceError, brief
from symbalance.exact.amplitude import Amplitude
from symbalance.text.reals import DIGITS, Complex, Real, cospi, fsum

LARGEST_RADICAL = 40_000
"""The product of the primes of a modulus may not pass this: it bounds the work of one reduction."""

MOST_DIGITS = 1_000_000
"""Where the search for a number's first digit ends."""

Coefficient = int | Fraction


@cache
def prime_factors(number: int) -> tuple[int, ...]:
    """Return the distinct primes of a positive integer, found by division up to `LARGEST_RADICAL`.

    What is left after that counts as one prime: `checked_modulus` refuses it either way.

    >>> prime_factors(720)
    (2, 3, 5)
    """
    primes, rest = [], number
    for divisor in range(2, LARGEST_RADICAL + 1):
        if divisor * divisor > rest:
            break
        if rest % divisor == 0:
            primes.append(divisor)
            while rest % divisor == 0:
                rest //= divisor
    return (*primes, rest) if rest > 1 else tuple(primes)


def checked_modulus(modulus: int) -> int:
    """Return `modulus`, or refuse one whose reductions would take too long."""
    if prod(prime_factors(modulus)) > LARGEST_RADICAL:
        raise SymbalanceError(
            f"angles in {brief(modulus)}ths of a turn",
            f"the product of this number's primes must be at most {LARGEST_RADICAL}",
            "write angles in decimals of up to four places, or in fractions of few primes",
        )
    return modulus


@cache
def _steps(modulus: int) -> tuple[tuple[int, int, int, int], ...]:
    """Return, for each prime p of m: (p, p^a, p^(a-1), m/p) with p^a the power of p in m."""
    steps = []
    for prime in prime_factors(modulus):
        power = prime
        while modulus % (power * prime) == 0:
            power *= prime
        steps.append((prime, power, power // prime, modulus // prime))
    return tuple(steps)


class _ReductionTable(dict[int, tuple[tuple[int, int], ...]]):
    """The powers of one zeta_m on the basis, as (exponent, sign) pairs, each computed on first use."""

    def __init__(self, modulus: int) -> None:
        super().__init__()
        self.modulus = modulus

    def __missing__(self, exponent: int) -> tuple[tuple[int, int], ...]:
        terms = [(exponent, 1)]
        for prime, power, below, shift in _steps(self.modulus):
            if (exponent % power) // below == prime - 1:
                terms = [
                    ((place + i * shift) % self.modulus, -sign)
                    for place, sign in terms
                    for i in range(1, prime)
                ]
        self[exponent] = tuple(terms)
        return self[exponent]


_reduction_table = lru_cache(maxsize=64)(_ReductionTable)


@lru_cache(maxsize=16_384)
def _cosine(k: int, modulus: int, digits: int) -> Real:
    """Return cos(2 pi k/modulus): the numbers of one engine share a few angles."""
    return cospi(Fraction(2 * k, modulus), digits)


def common_denominator(terms: Mapping[int, Coefficient]) -> tuple[dict[int, int], int]:
    """Return terms as integers over one denominator, which add and multiply faster than fractions.

    >>> common_denominator({0: Fraction(1, 2), 3: Fraction(2, 3)})
    ({0: 3, 3: 4}, 6)
    """
    below = lcm(*(c.denominator for c in terms.values()))
    return {k: c.numerator * (below // c.denominator) for k, c in terms.items()}, below


def _reduced(modulus: int, terms: Mapping[int, Coefficient]) -> dict[int, Coefficient]:
    """Return the sum of coefficient times zeta^exponent on the basis; exponents lie in [0, m)."""
    powers, (whole, below) = _reduction_table(modulus), common_denominator(terms)
    total: dict[int, int] = {}
    for exponent, coefficient in whole.items():
        for place, sign in powers[exponent]:
            total[place] = total.get(place, 0) + sign * coefficient
    return {k: c if below == 1 else Fraction(c, below) for k, c in total.items() if c}


@dataclass(frozen=True, eq=False)
class Phasor(Amplitude):
    """A number of Q(zeta_m): the sum of coefficient times zeta^exponent over `terms`.

    `terms` stay as they were added up, exponents in [0, m): short, and fit to be printed. `normal` holds
    them reduced to the basis, which is what decides equality and zero. All arithmetic is exact.

    >>> Phasor.of(7, {k: 1 for k in range(7)}).is_zero()  # the first order of an in-line seven
    True
    >>> Phasor.of(6, {1: 1, 5: 1}) == ONE  # 2 cos 60 degrees
    True
    """

    modulus: int
    terms: Mapping[int, Coefficient]
    rank: ClassVar[int] = 0

    @classmethod
    def holding(cls, number: Phasor) -> Phasor:
        """Return the number itself: there is no kind below this one."""
        return number

    @staticmethod
    def of(modulus: int, terms: Mapping[int, Coefficient]) -> Phasor:
        """Return the sum of coefficient times e^(2 pi i exponent/modulus), exponents in [0, modulus)."""
        return Phasor(modulus, {k: c for k, c in terms.items() if c})

    @staticmethod
    def root(turns: Fraction) -> Phasor:
        """Return e^(2 pi i turns)."""
        return Phasor(turns.denominator, {turns.numerator % turns.denominator: 1})

    @cached_property
    def normal(self) -> Mapping[int, Coefficient]:
        """The terms on the basis of the field: equal for equal numbers of one modulus."""
        return _reduced(self.modulus, self.terms)

    def is_zero(self) -> bool:
        """Tell whether the number is zero: a proof either way."""
        return not self.terms or not self.normal

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Phasor) and (self - other).is_zero()

    __hash__ = None  # type: ignore[assignment]

    def lifted(self, modulus: int) -> Phasor:
        """Return the same number written with the roots of a multiple of its modulus."""
        step = modulus // self.modulus
        return self if step == 1 else Phasor(modulus, {k * step: c for k, c in self.terms.items()})

    @overload
    def __add__(self, other: Phasor) -> Phasor: ...
    @overload
    def __add__(self, other: Amplitude) -> Any: ...
    def __add__(self, other: Amplitude) -> Any:
        return self.plus(other) if type(other) is Phasor else super().__add__(other)

    @overload
    def __sub__(self, other: Phasor) -> Phasor: ...
    @overload
    def __sub__(self, other: Amplitude) -> Any: ...
    def __sub__(self, other: Amplitude) -> Any:
        return self + -other

    def plus(self, other: Phasor) -> Phasor:
        """Return the sum of two numbers of cyclotomic fields."""
        if not other.terms:
            return self
        if not self.terms:
            return other
        modulus = lcm(self.modulus, other.modulus)
        total = dict(self.lifted(modulus).terms)
        for exponent, coefficient in other.lifted(modulus).terms.items():
            total[exponent] = total.get(exponent, 0) + coefficient
        return Phasor.of(modulus, total)

    def __neg__(self) -> Phasor:
        return Phasor(self.modulus, {k: -c for k, c in self.terms.items()})

    def scaled(self, factor: Coefficient) -> Phasor:
        """Return the number times a rational."""
        return Phasor(self.modulus, {k: c * factor for k, c in self.terms.items()} if factor else {})

    def rotated(self, turns: Fraction) -> Phasor:
        """Return the number times e^(2 pi i turns).

        >>> Phasor.root(Fraction(1, 3)).rotated(Fraction(-1, 3)) == ONE
        True
        """
        modulus = lcm(self.modulus, turns.denominator)
        step, by = modulus // self.modulus, turns.numerator * (modulus // turns.denominator)
        return Phasor(modulus, {(k * step + by) % modulus: c for k, c in self.terms.items()})

    @overload
    def times(self, other: Phasor) -> Phasor: ...
    @overload
    def times(self, other: Amplitude) -> Any: ...
    def times(self, other: Amplitude) -> Any:
        """Return the product of two numbers."""
        return self.multiplied(other) if type(other) is Phasor else super().times(other)

    def multiplied(self, other: Phasor) -> Phasor:
        """Return the product of two numbers of cyclotomic fields."""
        modulus = lcm(self.modulus, other.modulus)
        first, above = common_denominator(self.lifted(modulus).terms)
        second, below = common_denominator(other.lifted(modulus).terms)
        total: dict[int, int] = {}
        for j, c in first.items():
            for k, d in second.items():
                place = (j + k) % modulus
                total[place] = total.get(place, 0) + c * d
        product = Phasor.of(modulus, total)
        return product if above * below == 1 else product.scaled(Fraction(1, above * below))

    def conjugate(self) -> Phasor:
        """Return the complex conjugate."""
        return self.mapped(-1)

    def mapped(self, unit: int) -> Phasor:
        """Return the image under zeta -> zeta^unit, with `unit` prime to the modulus."""
        return Phasor(self.modulus, {k * unit % self.modulus: c for k, c in self.terms.items()})

    def evaluated(self, digits: int = DIGITS) -> Complex:
        """Return the number in decimals, each part to `digits` significant digits."""
        return Complex(self.real_value(digits), self._wave_sum(digits, 1))

    def real_value(self, digits: int = DIGITS) -> Real:
        """Return the real part to `digits` significant digits and five more, whatever cancels in it."""
        return self._wave_sum(digits, 0)

    def _wave_sum(self, digits: int, quarters: int) -> Real:
        """Return the sum of c cos(2 pi k/m), or of c sin(2 pi k/m) for a delay of one quarter turn.

        Whether it is exactly 0 is only asked where digits do not show that it is not.
        """
        fine = 4 * self.modulus
        if len(self.terms) == 1:  # as of one cylinder alone: nothing cancels
            ((k, c),) = self.terms.items()
            wave = _cosine((4 * k - quarters * self.modulus) % fine, fine, digits + 15)
            return (wave * c).rounded(digits + 5)
        whole, below = common_denominator(self.terms)
        size, working = sum(map(abs, whole.values())), digits + 15
        while True:
            places = (((4 * k - quarters * self.modulus) % fine, c) for k, c in whole.items())
            value = fsum((_cosine(place, fine, working) * c for place, c in places), working)
            if abs(value) > Fraction(size, 10 ** (working - digits - 5)):
                return (value / below if below > 1 else value).rounded(digits + 5)
            if working == digits + 15 and (self.imaginary() if quarters else self.real()).is_zero():
                return Real(0, digits + 5)
            working *= 2
            if working > MOST_DIGITS:
                raise AssertionError(f"{self} is called non-zero, and has no digit")

    @property
    def most(self) -> float:
        """The sum of its terms' sizes."""
        return sum(abs(float(Fraction(c))) for c in self.terms.values())

    @property
    def moduli(self) -> list[int]:
        """The order of its field."""
        return [self.modulus]

    @property
    def spelling(self) -> object:
        """The terms, in the field they are written in."""
        return self.modulus, frozenset(self.terms.items())

    def primitive(self) -> Phasor:
        """Return the same number, reduced, in the smallest cyclotomic field that holds it.

        >>> Phasor.of(24, {3: 1, 21: 1}).primitive().modulus  # the square root of 2
        8
        """
        number = Phasor(self.modulus, self.normal)
        for prime, *_ in _steps(self.modulus):
            while number.modulus % prime == 0 and all(k % prime == 0 for k in number.terms):
                smaller = number.modulus // prime
                fewer = {k // prime: c for k, c in number.terms.items()}
                number = Phasor(smaller, _reduced(smaller, fewer))
        return number

    def rational(self) -> Fraction | None:
        """Return the number as a fraction if it is rational."""
        if any(self.normal):
            return None
        return Fraction(self.normal.get(0, 0))


ZERO = Phasor(1, {})
ONE = Phasor(1, {0: 1})


def amplitude_sum(numbers: Sequence[Amplitude]) -> Any:
    """Return the sum of at least one number; exact ones are added up in one field, all at once.

    One by one each step would copy all terms so far.

    >>> amplitude_sum([Phasor.root(Fraction(k, 5)) for k in range(4)]) == -Phasor.root(Fraction(4, 5))
    True
    """
    exact = [number for number in numbers if isinstance(number, Phasor)]
    if len(exact) < len(numbers):
        first, *others = numbers
        return sum(others, first)
    modulus = lcm(*(number.modulus for number in exact))
    total: dict[int, Coefficient] = {}
    for number in exact:
        for exponent, coefficient in number.lifted(modulus).terms.items():
            total[exponent] = total.get(exponent, 0) + coefficient
    return Phasor.of(modulus, total)
