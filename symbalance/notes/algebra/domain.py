"""Generators of an exact algebra of harmonics: letters, phases e^(iθ), roots, and roots of unity.

A formula becomes a quotient of two Laurent polynomials with rational coefficients in generators:

==============  =====================================  ======================================
kind            generator                              relation it obeys
==============  =====================================  ======================================
turn            e^(2 pi i x), the exponent x a turn    e^(pi i) = -1, cyclotomic (see `zero`)
symbol          a letter                               none
constant        pi or e, whatever letters are called   none
exponential     e^(i m) of a monomial m (θ, n h)       none (integer n: e^(2 pi i n) = 1)
growth          e^m of a monomial m                    none
prime           p^x of a prime p, 0 < x < 1            p^(1/2) is a Gauss sum (see `zero`)
radical         the root of a polynomial q             its square is q
opaque          a function of a form: ln, asin         none
==============  =====================================  ======================================

Exponents are rational, so cos(θ/2) needs nothing new. A monomial is a tuple of (generator, exponent)
pairs in the order of the generators' numbers.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

Exponent = int | Fraction
Monomial = tuple[tuple[int, Exponent], ...]
Polynomial = dict[Monomial, Fraction]

ONE: Monomial = ()
TURN = 0
HALF = Fraction(1, 2)
QUARTER = Fraction(1, 4)


class TooLargeError(Exception):
    """A calculation that passes the limits; the checker then decides by numbers, or not at all."""


class NoFormError(Exception):
    """A formula that has no form in this domain; the message says which part."""


def plain(exponent: Exponent) -> Exponent:
    """Return a whole exponent as an int: quicker to add and to hash than a Fraction.

    >>> plain(Fraction(2)), plain(HALF)
    (2, Fraction(1, 2))
    """
    if type(exponent) is int or exponent.denominator != 1:
        return exponent
    return exponent.numerator


@dataclass(frozen=True, slots=True)
class Generator:
    """One generator: its kind, what it is made of, and whether it stands for a positive number."""

    kind: str
    content: Any
    positive: bool = False
    integer: bool = False


class Domain:
    """The generators of one calculation, numbered as they come up; it also collects assumptions.

    >>> domain = Domain()
    >>> half_turn = ((TURN, HALF),)
    >>> domain.times(((TURN, QUARTER),), ((TURN, QUARTER),))
    (-1, ())
    """

    def __init__(
        self,
        positive: Iterable[str] = (),
        integer: Iterable[str] = (),
        ranges: Mapping[str, tuple[int, int]] | None = None,
    ) -> None:
        self.positive, self.integer = frozenset(positive), frozenset(integer)
        self.ranges = ranges or {}
        self.generators: list[Generator] = [Generator("turn", None)]
        self._numbers: dict[Hashable, int] = {}
        self._special: set[int] = {TURN}
        self.radicals: list[int] = []
        self.opaque: list[int] = []
        self.assumptions: dict[str, None] = {}
        self.special: dict[str, tuple[str, Any]] = {}
        """For assumptions on whole numbers the letter, and its value at which they fail: N of N ≠ 1."""
        self.positive_polynomials: list[Polynomial] = []
        self.work = 0

    def _number(self, key: Hashable, generator: Generator) -> int:
        if key not in self._numbers:
            self._numbers[key] = len(self.generators)
            self.generators.append(generator)
            if generator.kind in ("prime", "radical") or generator.integer:
                self._special.add(self._numbers[key])
        return self._numbers[key]

    def symbol(self, name: str) -> int:
        """Return the generator of a letter; one that is called pi or e is a letter too."""
        generator = Generator("symbol", name, name in self.positive)
        return self._number(("symbol", name), generator)

    def constant(self, name: str) -> int:
        """Return the generator of the number `pi` or `e`."""
        return self._number(("constant", name), Generator("constant", name, positive=True))

    def count(self, name: str) -> None:
        """Take a letter for a whole number from here on: the index of a sum."""
        self.integer |= {name}

    def is_integer(self, monomial: Monomial) -> bool:
        """Tell whether a monomial is a product of letters declared to be whole numbers."""
        return all(
            self.generators[g].kind == "symbol"
            and self.generators[g].content in self.integer
            and e > 0
            and e.denominator == 1
            for g, e in monomial
        )

    def exponential(self, monomial: Monomial) -> int:
        """Return the generator e^(i monomial)."""
        pi = self.constant("pi")
        rest = tuple((g, e) for g, e in monomial if (g, e) != (pi, 1))
        whole = len(rest) < len(monomial) and self.is_integer(rest)
        return self._number(("exponential", monomial), Generator("exponential", monomial, integer=whole))

    def growth(self, monomial: Monomial) -> int:
        """Return the generator e^monomial."""
        return self._number(("growth", monomial), Generator("growth", monomial, positive=True))

    def prime(self, prime: int) -> int:
        """Return the generator of the fractional powers of a prime."""
        return self._number(("prime", prime), Generator("prime", prime, positive=True))

    def radical(self, square: Polynomial) -> int:
        """Return the generator whose square is that polynomial, of the positive sign."""
        key = ("radical", frozenset(square.items()))
        number = self._number(key, Generator("radical", square, positive=True))
        if number not in self.radicals:
            self.radicals.append(number)
        return number

    def opaque_function(self, content: Any) -> int:
        """Return a new generator for a function of a form; the caller finds equal ones."""
        number = len(self.generators)
        self.generators.append(Generator("opaque", content))
        self.opaque.append(number)
        return number

    def assume_positive(self, polynomial: Polynomial) -> None:
        """Note that what stands below in √(a/b) = √(ab)/b is positive."""
        self.assumptions["denominators under roots > 0"] = None
        if polynomial not in self.positive_polynomials:
            self.positive_polynomials.append(polynomial)

    def is_free(self, number: int) -> bool:
        """Tell whether no power of a generator has a relation: it is a letter, an angle or a function."""
        return number not in self._special

    def times(self, left: Monomial, right: Monomial) -> tuple[Fraction | int, Monomial]:
        """Return the product of two monomials as (rational factor, monomial), radicals left alone."""
        if not left:
            return 1, right
        if not right:
            return 1, left
        total = dict(left)
        for generator, exponent in right:
            total[generator] = plain(total[generator] + exponent) if generator in total else exponent
        return self._reduced_monomial(total)

    def raised(self, monomial: Monomial, exponent: Exponent) -> tuple[Fraction | int, Monomial]:
        """Return the monomial to a rational power, as (rational factor, monomial)."""
        return self._reduced_monomial({g: plain(e * exponent) for g, e in monomial})

    def _reduced_monomial(self, exponents: dict[int, Exponent]) -> tuple[Fraction | int, Monomial]:
        factor: Fraction | int = 1
        if not self._special.isdisjoint(exponents):
            for generator in self._special & exponents.keys():
                part, rest = self._reduced_power(generator, exponents[generator])
                exponents[generator] = plain(rest)
                factor *= part
        return factor, tuple(sorted(item for item in exponents.items() if item[1]))

    def _reduced_power(self, number: int, exponent: Exponent) -> tuple[Fraction | int, Exponent]:
        """Return generator^exponent as a rational times a power in the generator's own range."""
        generator = self.generators[number]
        if generator.kind == "turn":
            turns = exponent % 1
            return (-1, turns - HALF) if turns >= HALF else (1, turns)
        if generator.kind == "prime":
            whole = exponent.__floor__()
            return Fraction(generator.content) ** whole, exponent - whole
        if generator.integer:
            return 1, exponent % 2
        return 1, exponent
