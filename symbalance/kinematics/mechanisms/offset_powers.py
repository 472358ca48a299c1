"""Inertia force of an offset slider-crank as a power series in rho = r/l and delta = e/l, exactly.

With X = rho sin p - delta the height over r is cos p + sqrt(1 - X^2)/rho, and with b_m the coefficients
of sqrt(1 - X^2) = sum of b_m X^2m, b_m = -2 Catalan(m-1)/4^m,

    X^2m = sum over i of C(2m, i) rho^i sin^i p (-delta)^(2m-i).

sin^i p holds the orders n = i, i-2, ... only, even ones as cosines and odd ones as sines, each with
(-1)^floor(n/2) 2 C(i, (i-n)/2)/2^i. So, with -d^2/dp^2 = n^2, for n >= 2 and n >= 1 each

    A_n = n^2 (-1)^(n/2)     sum of b_m C(2m, i) 2 C(i, (i-n)/2)/2^i rho^(i-1) delta^(2m-i),   n even,
    B_n = n^2 (-1)^((n+1)/2) sum of the same,                                                  n odd,

over i = n, n+2, ... <= 2m; A_1 = 1, and no other cosine of odd order nor sine of even order occurs.
Every term is of odd total degree 2m - 1: A_n has odd powers of rho, from n - 1 on, times even powers
of delta; B_n even powers of rho, from n - 1 on, times odd powers of delta. The series converge for
rho + |delta| < 1, which is lambda > 1 + |eps|: wherever the crank can turn.

The height, and the start of its series:

Formulas:
    sqrt(1 - X^2) = 1 - X^2/2 - X^4/8 - X^6/16 - ...
    cos p + sqrt(L^2 - (sin p - e)^2) = cos p + L sqrt(1 - X^2)
    with X = (sin p - e)/L; p an angle; L, e positive
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from functools import lru_cache
from math import comb
from typing import TYPE_CHECKING, NamedTuple

from symbalance.document.symbols import symbol
from symbalance.kinematics.mechanisms.mechanism_types import SliderCrank
from symbalance.kinematics.slider_crank import checked_order
from symbalance.text.numbers import checked_whole

if TYPE_CHECKING:
    import sympy

HIGHEST_DEGREE = 400
"""A series of degree d has some d^2/8 terms."""

Powers = tuple[int, int]


def delta_symbol() -> sympy.Symbol:
    """Return the symbol delta = e/l, the offset over the rod's length; it may be negative."""
    import sympy

    return sympy.Symbol("delta", real=True)


@dataclass(frozen=True)
class OffsetPowers:
    """A polynomial in rho and delta, exact through the total degree `through`; higher ones are left out.

    `terms` maps (i, j) to the coefficient of rho^i delta^j. `complete`: nothing is left out at all.
    """

    terms: dict[Powers, Fraction] = field(hash=False)
    through: int
    complete: bool = False

    def at(self, mechanism: SliderCrank) -> Fraction:
        """Return the kept terms' sum for a slider-crank, exactly."""
        rho, delta = 1 / mechanism.ratio, mechanism.offset / mechanism.ratio
        return sum((c * rho**i * delta**j for (i, j), c in self.terms.items()), Fraction(0))

    def expression(self) -> sympy.Expr:
        """Return the kept terms as a SymPy expression in rho and `delta_symbol()`."""
        import sympy

        rho, delta = symbol("rho"), delta_symbol()
        return sympy.Add(
            *(
                sympy.Rational(c.numerator, c.denominator) * rho**i * delta**j
                for (i, j), c in self.terms.items()
            )
        )


class OffsetSeries(NamedTuple):
    """One order of the force over m r omega^2: `cos` is A_n of cos np, `sin` is B_n of sin np."""

    cos: OffsetPowers
    sin: OffsetPowers


@lru_cache(maxsize=256)
def offset_series(order: int, through: int) -> OffsetSeries:
    """Return A_order and B_order with all terms rho^i delta^j of total degree i + j <= `through`.

    >>> offset_series(2, 3).cos.expression()
    3*delta**2*rho/2 + rho**3/4 + rho
    >>> offset_series(1, 3).sin.expression()
    delta**3/2 + 3*delta*rho**2/8 + delta
    """
    n = checked_order(order)
    checked_whole(through, "through", 0, HIGHEST_DEGREE, "5 is usual")
    terms = {}
    for m in range((n + 1) // 2, (through + 1) // 2 + 1):
        root = Fraction(-2 * comb(2 * m - 2, m - 1) // m, 4**m)
        for i in range(n, 2 * m + 1, 2):
            spread = Fraction(2 * comb(2 * m, i) * comb(i, (i - n) // 2), 2**i)
            terms[i - 1, 2 * m - i] = n * n * (-1) ** ((n + 1) // 2) * root * spread
    powers = OffsetPowers(terms, through)
    if n % 2 == 0:
        return OffsetSeries(powers, OffsetPowers({}, through, complete=True))
    first = {(0, 0): Fraction(1)} if n == 1 else {}
    return OffsetSeries(OffsetPowers(first, through, complete=True), powers)


def offset_left_out(order: int, through: int, mechanism: SliderCrank) -> Fraction:
    """Return a proved bound on what `offset_series` leaves out of A_order or B_order, exactly.

    The harmonics of X^2m are at most 2 (rho + |delta|)^2m and |b_m| falls with m, so with x =
    (rho + |delta|)^2 < 1 and M the first m left out the rest is at most 2 n^2/rho |b_M| x^M/(1 - x).

    >>> float(offset_left_out(2, 15, SliderCrank(4)))
    5.419072598063697e-12
    """
    m = (through + 1) // 2 + 1
    x = ((1 + abs(mechanism.offset)) / mechanism.ratio) ** 2
    root = Fraction(2 * comb(2 * m - 2, m - 1) // m, 4**m)
    return 2 * order * order * mechanism.ratio * root * x**m / (1 - x)
