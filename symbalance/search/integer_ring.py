"""Sums of roots of unity as vectors of integers: Z[zeta_m] on the basis 1, zeta, ..., zeta^(phi(m) - 1).

Every power of zeta is reduced modulo the cyclotomic polynomial Phi_m once; after that a sum is an
addition of rows, and a number is zero exactly when its vector is. The square of a number's size,

    |sum c_i zeta^i|^2 = R_0 + sum over d > 0 of R_d (zeta^d + zeta^-d),   R_d = sum c_i c_(i+d),

is another such vector: equal squares have equal vectors.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from symbalance.exact.phasor import Phasor
from symbalance.text.reals import cospi

Array = np.ndarray[Any, np.dtype[Any]]


@lru_cache(maxsize=256)
def cyclotomic(m: int) -> tuple[int, ...]:
    """Return the coefficients of Phi_m, constant first.

    >>> cyclotomic(12)
    (1, 0, -1, 0, 1)
    """
    numerator = [-1, *[0] * (m - 1), 1]
    for divisor in range(1, m):
        if m % divisor == 0:
            numerator = _divided(numerator, cyclotomic(divisor))
    return tuple(numerator)


def _divided(above: list[int], below: tuple[int, ...]) -> list[int]:
    """Return the quotient by a monic polynomial that divides without rest."""
    rest, quotient = list(above), [0] * (len(above) - len(below) + 1)
    for place in range(len(quotient) - 1, -1, -1):
        factor = quotient[place] = rest[place + len(below) - 1]
        for i, c in enumerate(below):
            rest[place + i] -= factor * c
    return quotient


@dataclass(frozen=True)
class IntegerRing:
    """Z[zeta_m], its numbers written as vectors of `degree` integers."""

    modulus: int

    @cached_property
    def degree(self) -> int:
        """How many integers a number has: phi(m)."""
        return len(cyclotomic(self.modulus)) - 1

    @cached_property
    def powers(self) -> Array:
        """The vector of each power of zeta: row k is zeta^k, k = 0..m-1."""
        polynomial = cyclotomic(self.modulus)
        rows = np.zeros((self.modulus, self.degree), np.int64)
        row = [1, *[0] * (self.degree - 1)]
        for k in range(self.modulus):
            rows[k] = row
            top = row[-1]
            row = [low - top * c for low, c in zip([0, *row[:-1]], polynomial[:-1], strict=True)]
        return rows

    @cached_property
    def cosines(self) -> Array:
        """Cos and sin of the basis's angles, as complex numbers, each rounded once."""
        turns = [Fraction(2 * k, self.modulus) for k in range(self.degree)]
        real = [float(cospi(turn, 25)) for turn in turns]
        lateral = [float(cospi(turn - Fraction(1, 2), 25)) for turn in turns]
        return np.array(real) + 1j * np.array(lateral)

    def vector(self, terms: Mapping[Fraction, int]) -> Array:
        """Return the sum of integers times e^(2 pi i turns); the turns are multiples of 1/m."""
        total = np.zeros(self.degree, np.int64)
        for turns, factor in terms.items():
            total += factor * self.powers[int(turns * self.modulus) % self.modulus]
        return total

    def squares(self, vectors: Array) -> Array:
        """Return the vectors of |z|^2 of the numbers that stand along the last axis."""
        degree = self.degree
        total = np.zeros_like(vectors)
        for d in range(degree):
            products = (vectors[..., : degree - d] * vectors[..., d:]).sum(-1)
            pair = self.powers[d] if d == 0 else self.powers[d] + self.powers[-d % self.modulus]
            total += products[..., None] * pair
        return total

    def phasor(self, vector: Array) -> Phasor:
        """Return a vector as a number of the exact core."""
        return Phasor.of(self.modulus, {k: int(c) for k, c in enumerate(vector)})
