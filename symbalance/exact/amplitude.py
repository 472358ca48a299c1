"""Base class of amplitudes, the complex numbers C + iS of an order: exact, symbolic or decimal.

An order of a force is one complex number, C + iS of C cos n theta + S sin n theta. It is held in one of
three ways, each of which can be taken for the next:

    Phasor          a number of a cyclotomic field: sizes in numbers, zero is proved
    SymbolicPhasor  the same with symbols for some angles: zero for all their values is proved
    DecimalPhasor   40 digits, where the engine's sizes leave nothing exact: zero is a matter of size

A sum or a product of two kinds is of the later one. Symbols have no decimals: that is refused.

Formulas:
    C cos n theta + S sin n theta = (1/2) (z e^(-i n theta) + w e^(i n theta))
    (z + w)/2 = C
    z w = C^2 + S^2
    with z = C + i S; w = C - i S; C, S numbers; n a whole number
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from fractions import Fraction
from typing import Any, ClassVar, Self

from symbalance.text.reals import DIGITS, Complex, Real

HALF, QUARTER = Fraction(1, 2), Fraction(1, 4)


class Amplitude(ABC):
    """A complex number, exact, symbolic or decimal, that decides for itself whether it is zero.

    >>> from symbalance.exact.decimal_phasor import DecimalPhasor
    >>> from symbalance.exact.phasor import Phasor
    >>> third = Phasor.root(Fraction(1, 3))
    >>> (third + third.rotated(Fraction(1, 2))).is_zero()
    True
    >>> type(third + DecimalPhasor(Complex(1))).__name__
    'DecimalPhasor'
    """

    rank: ClassVar[int]
    """The place among the kinds: of two the higher one can hold the other."""
    has_symbols: ClassVar[bool] = False
    """Whether symbols may stand in it, so that it has no decimals."""
    is_decimal: ClassVar[bool] = False
    """Whether it is a number of some digits, with no exact form."""

    @classmethod
    @abstractmethod
    def holding(cls, number: Any) -> Self:
        """Return a number of a lower rank as one of this kind."""

    @abstractmethod
    def is_zero(self) -> bool:
        """Tell whether the number is zero."""

    @abstractmethod
    def plus(self, other: Any) -> Self:
        """Return the sum with a number of the same kind."""

    @abstractmethod
    def multiplied(self, other: Any) -> Self:
        """Return the product with a number of the same kind."""

    @abstractmethod
    def __neg__(self) -> Self: ...

    @abstractmethod
    def scaled(self, factor: int | Fraction) -> Self:
        """Return the number times a rational."""

    @abstractmethod
    def rotated(self, turns: Fraction) -> Self:
        """Return the number times e^(2 pi i turns).

        Formulas:
            C e^(i d) = C cos d + i C sin d
            with C a number; d an angle
        """

    @abstractmethod
    def conjugate(self) -> Self:
        """Return the complex conjugate."""

    @abstractmethod
    def evaluated(self, digits: int = DIGITS) -> Complex:
        """Return the number in decimals, each part to `digits` digits; one with symbols is refused."""

    @property
    @abstractmethod
    def most(self) -> float:
        """The sum of its terms' sizes: of a number of one term its size, of others no less than that."""

    @property
    @abstractmethod
    def moduli(self) -> list[int]:
        """The orders of the cyclotomic fields that its exact parts are numbers of."""

    @property
    @abstractmethod
    def spelling(self) -> object:
        """What numbers that are written alike have in common: a key for what is made of them."""

    def __add__(self, other: Amplitude) -> Any:
        if other.rank > self.rank:
            return other.holding(self).plus(other)
        return self.plus(other if other.rank == self.rank else self.holding(other))

    def __sub__(self, other: Amplitude) -> Any:
        return self + -other

    def times(self, other: Amplitude) -> Any:
        """Return the product of two numbers."""
        if other.rank > self.rank:
            return other.holding(self).multiplied(other)
        return self.multiplied(other if other.rank == self.rank else self.holding(other))

    def real(self) -> Self:
        """Return the real part, as a number with no other."""
        return (self + self.conjugate()).scaled(HALF)

    def imaginary(self) -> Self:
        """Return the imaginary part, as a real number."""
        return self.rotated(-QUARTER).real()

    def norm(self) -> Self:
        """Return the number times its conjugate."""
        return self.times(self.conjugate())

    def size(self, digits: int = DIGITS) -> Real:
        """Return the absolute value in decimals; of a number with symbols it is refused."""
        return abs(self.evaluated(digits))
