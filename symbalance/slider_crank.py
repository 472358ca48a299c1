r"""One slider-crank: exact harmonics of the piston and of the rod, to any order.

The crank pin turns at radius r, the rod of length l joins it to a piston on an axis through the crank,
rho = r/l = 1/lambda < 1. With theta = 0 at top dead centre:

    displacement  x/r           = X_0 - cos theta - sum of B_n cos n theta     from top dead centre
    velocity      v/(r omega)   =       sin theta + sum of n B_n sin n theta
    acceleration  a/(r omega^2) =       cos theta + sum of A_n cos n theta,    A_n = n^2 B_n
    force         F/(m r omega^2) = the same: the inertia force, positive away from the crank
    rod-angle     phi           = asin(rho sin theta) = sum of R_n sin n theta (n odd)

over n = 2, 4, 6, .... From sqrt(1 - X) = 1 - 2 sum of Catalan(m-1) (X/4)^m with X = rho^2 sin^2 theta,
and sin^2m theta = (C(2m, m) + 2 sum of (-1)^k C(2m, m-k) cos 2k theta)/4^m,

    A_2k = (-1)^(k+1) sum over m >= k of 16 k^2 Catalan(m-1) C(2m, m-k) rho^(2m-1) / 16^m,

dyadic rationals whose numerators follow one exact integer recurrence in m. All terms of one A_2k have
the same sign, and the A_2k alternate: that makes the bounds of `left_out` sharp, not merely safe.
Likewise R_n = (-1)^i sum over j >= i of C(2j, j) C(2j+1, j-i) rho^(2j+1) / (16^j (2j+1)), n = 2i+1.

Exact in rho, with k' = sqrt(1 - rho^2) and q = (rho/(1 + k'))^2,

    A_2k = (4 k^2/rho) (1 + k') C(1/2, k) q^k 2F1(-1/2, k - 1/2; k + 1; q^2),

which converges like q^2: well before rho nears 1 and far beyond where powers of rho do.
Source: expanded afresh; the classical expansion is in Biezeno and Grammel, Technische Dynamik, ch. XI.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import comb
from typing import TYPE_CHECKING

from mpmath import mp

from symbalance.errors import SymbalanceError, shown
from symbalance.rational import Real, exact
from symbalance.symbols import symbol

if TYPE_CHECKING:
    import sympy

HIGHEST_ORDER = 1000
QUANTITIES = ("displacement", "velocity", "acceleration", "force", "rod-angle")


@dataclass(frozen=True, slots=True)
class Series:
    """A polynomial in 1/lambda, exact through the power `through`; higher powers are left out.

    `terms` maps a power of 1/lambda to its coefficient. `complete` says that nothing is left out at all.

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

        >>> acceleration_series(6, through=7).in_lam()
        9/(128*lam**5) + 45/(512*lam**7)
        """
        return self._expression(symbol("lam"), -1)

    def _expression(self, of: sympy.Symbol, sign: int) -> sympy.Expr:
        import sympy

        return sympy.Add(
            *(
                sympy.Rational(c.numerator, c.denominator) * of ** (sign * p)
                for p, c in self.terms.items()
            )
        )


def checked_order(order: int, name: str = "order", highest: int = HIGHEST_ORDER) -> int:
    """Return `order`, or refuse what is no whole number from 1 to `highest`."""
    if isinstance(order, bool) or not isinstance(order, int) or not 1 <= order <= highest:
        raise SymbalanceError(
            f"{name} = {shown(order)}",
            f"must be a whole number from 1 to {highest}",
            "12 shows what matters in most engines",
        )
    return order


def checked_ratio(ratio: object, name: str = "ratio") -> Fraction:
    """Return the rod ratio lambda = l/r as a fraction; the rod must be longer than the crank."""
    number = exact(ratio, name)
    if number <= 1:
        raise SymbalanceError(
            f"{name} = {shown(ratio)}",
            "the rod must be longer than the crank, lambda = l/r > 1",
            "engines have 3 to 4.5; r/l is the inverse",
        )
    return number


def surviving(order: int) -> bool:
    """Tell whether a centred slider-crank has that order at all: 1 and the even ones."""
    return order == 1 or order % 2 == 0


# Powers of rho: integers ------------------------------------------------------------------------


def acceleration_integers(order: int) -> list[list[int]]:
    """Return all A_2k to `order` as integers: row k-1 holds the numerators over 16^m, m = k, k+1, ....

    A_2k = sum over m of row[m-k] rho^(2m-1) / 16^m, kept through rho^(order-1).

    >>> acceleration_integers(6)
    [[16, 64, 480], [-64, -768], [288]]
    """
    half = order // 2
    return [list(_numerators(k, half)) for k in range(1, half + 1)]


def _numerators(k: int, last: int) -> Iterator[int]:
    """Yield the numerators over 16^m of A_2k for m = k..last, each from the one before."""
    term = 16 * k * k * (comb(2 * k - 2, k - 1) // k)
    if k % 2 == 0:
        term = -term
    square = k * k
    for m in range(k, last + 1):
        yield term
        term = term * (4 * (4 * m * m - 1)) // ((m + 1) * (m + 1) - square)


@lru_cache(maxsize=4096)
def acceleration_series(order: int, through: int) -> Series:
    """Return A_order kept through (1/lambda)^through; A_1 = 1, odd orders above it vanish.

    The same series serves the inertia force, in units of m r omega^2.
    """
    checked_order(order)
    if order % 2:
        return Series({0: Fraction(1)} if order == 1 else {}, max(through, 0), complete=True)
    k, last = order // 2, (through + 1) // 2
    terms = {2 * m - 1: Fraction(t, 1 << 4 * m) for m, t in enumerate(_numerators(k, last), k)}
    return Series(terms, through)


def rod_angle_series(order: int, through: int) -> Series:
    """Return R_order, the rod angle's coefficient of sin(order theta), through (1/lambda)^through.

    >>> rod_angle_series(3, through=5).in_powers_of_rho()
    -3*rho**5/128 - rho**3/24
    """
    checked_order(order)
    if order % 2 == 0:
        return Series({}, through, complete=True)
    i = order // 2
    terms = {
        2 * j + 1: Fraction((-1) ** i * comb(2 * j, j) * comb(2 * j + 1, j - i), (2 * j + 1) << 4 * j)
        for j in range(i, (through - 1) // 2 + 1)
    }
    return Series(terms, through)


@dataclass(frozen=True, slots=True)
class Harmonics:
    """A quantity as constant + sum of coefficient times cos (or sin) of n theta.

    `terms` maps n to the coefficient's `Series`; `function` is "cos" or "sin".
    """

    quantity: str
    function: str
    constant: Series
    terms: dict[int, Series]


def harmonics(quantity: str, order: int, through: int | None = None) -> Harmonics:
    """Return a quantity's harmonics to `order`, each kept through (1/lambda)^through.

    The default keeps what a hand expansion to sin^order keeps: `through` = order - 1 (order, for the
    rod's angle). Units: r, r omega, r omega^2, m r omega^2 and rad.

    >>> harmonics("displacement", 4).terms[4].in_powers_of_rho()
    rho**3/64
    """
    checked_order(order)
    if quantity not in QUANTITIES:
        raise SymbalanceError(f"quantity = {shown(quantity)}", f"must be one of {', '.join(QUANTITIES)}")
    if quantity == "rod-angle":
        kept = order if through is None else through
        odd = {n: rod_angle_series(n, kept) for n in range(1, order + 1, 2)}
        return Harmonics(quantity, "sin", Series({}, kept, complete=True), odd)
    kept = order - 1 if through is None else through
    orders = [1, *range(2, order + 1, 2)]
    rows = {n: acceleration_series(n, kept).scaled(_factor(quantity, n)) for n in orders}
    constant = _rest_position(kept) if quantity == "displacement" else Series({}, kept, complete=True)
    return Harmonics(quantity, "sin" if quantity == "velocity" else "cos", constant, rows)


def _factor(quantity: str, n: int) -> Fraction:
    """Return what A_n is multiplied by: the quantity is the acceleration, integrated so often."""
    return {"displacement": Fraction(-1, n * n), "velocity": Fraction(1, n)}.get(quantity, Fraction(1))


def _rest_position(through: int) -> Series:
    """Return X_0 = 1 + (1 - c_0)/rho, the mean piston position below top dead centre, over r."""
    terms = {0: Fraction(1)}
    for m in range(1, (through + 1) // 2 + 1):
        terms[2 * m - 1] = Fraction(2 * (comb(2 * m - 2, m - 1) // m) * comb(2 * m, m), 1 << 4 * m)
    return Series(terms, through)


# Exact in rho -----------------------------------------------------------------------------------


def exact_coefficient(order: int) -> sympy.Expr:
    """Return A_order exact in rho, as a SymPy expression with a hypergeometric function.

    >>> exact_coefficient(2).subs(symbol("rho"), 0.25).evalf(12)
    0.254025042307
    """
    import sympy

    checked_order(order)
    if order % 2:
        return sympy.Integer(order == 1)
    rho, k = symbol("rho"), sympy.Integer(order // 2)
    root = sympy.sqrt(1 - rho**2)
    q = (rho / (1 + root)) ** 2
    tail = sympy.hyper([-sympy.S.Half, k - sympy.S.Half], [k + 1], q**2)
    return 4 * k**2 / rho * (1 + root) * sympy.binomial(sympy.S.Half, k) * q**k * tail


def _rho_root_q(ratio: Fraction) -> tuple[Real, Real, Real]:
    """Return rho, sqrt(1 - rho^2) and q to the working precision, however near rho is to 0 or 1."""
    over, under = ratio.numerator, ratio.denominator
    rho = mp.mpf(under) / over
    root = mp.sqrt(mp.mpf(over * over - under * under)) / over
    return rho, root, (rho / (1 + root)) ** 2


def acceleration_value(order: int, ratio: Fraction, digits: int = 20) -> Real:
    """Return A_order for a rod ratio, exact in lambda, to `digits` significant digits."""
    if order % 2:
        return mp.mpf(order == 1)
    k = order // 2
    with mp.workdps(digits + 10):
        rho, root, q = _rho_root_q(ratio)
        tail = mp.hyp2f1(mp.mpf(-0.5), k - mp.mpf(0.5), k + 1, q * q)
        return 4 * k * k / rho * (1 + root) * mp.binomial(mp.mpf(0.5), k) * q**k * tail


def acceleration_values(order: int, ratio: Fraction, digits: int = 20) -> dict[int, Real]:
    """Return A_1 and every even A_n to `order`, exact in lambda, to `digits` significant digits.

    The c_k obey q (k - 3/2) c_{k-1} + (1 + q^2) k c_k + q (k + 3/2) c_{k+1} = 0 and are its minimal
    solution, so the recurrence is run downward from two values of the closed form (upward it is lost).
    """
    top = order // 2
    values = {1: mp.mpf(1)} | {
        2 * k: acceleration_value(2 * k, ratio, digits) for k in (top - 1, top) if k > 0
    }
    with mp.workdps(digits + 10):
        *_, q = _rho_root_q(ratio)
        both = (1 + q * q) / q
        for k in range(top - 1, 1, -1):
            above, here = values[2 * k + 2] / (k + 1) ** 2, values[2 * k] / k**2
            below = -(both * k * here + (k + mp.mpf(1.5)) * above) / (k - mp.mpf(1.5))
            values[2 * k - 2] = below * (k - 1) ** 2
    return dict(sorted(values.items()))


def rod_angle_value(order: int, ratio: Fraction, digits: int = 20) -> Real:
    """Return R_order for a rod ratio, exact in lambda, to `digits` significant digits."""
    if order % 2 == 0:
        return mp.mpf(0)
    i = order // 2
    lead = Fraction((-1) ** i * comb(2 * i, i), order << 4 * i)
    with mp.workdps(digits + 10):
        rho = mp.mpf(ratio.denominator) / ratio.numerator
        tail = mp.hyp2f1(i + mp.mpf(0.5), i + mp.mpf(0.5), order + 1, rho * rho)
        return mp.mpf(lead.numerator) / lead.denominator * rho**order * tail
