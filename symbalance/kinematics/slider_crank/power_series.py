"""Harmonics as power series in 1/lambda with rational coefficients, from integer recurrences."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import comb
from typing import TYPE_CHECKING, Any, ClassVar

from symbalance.document.result import Result
from symbalance.kinematics.slider_crank.arguments import checked_order, checked_power, checked_quantity
from symbalance.kinematics.slider_crank.series import Series

if TYPE_CHECKING:
    from symbalance.document.nodes import Document


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

    Formulas:
        A_2 = rho + rho^3/4 + 15 rho^5/128 + ...
        A_4 = -rho^3/4 - 3 rho^5/16 - ...
    """
    checked_order(order)
    if order % 2:
        return Series({0: Fraction(1)} if order == 1 else {}, max(through, 0), complete=True)
    k, last = order // 2, (through + 1) // 2
    terms = {2 * m - 1: Fraction(t, 1 << 4 * m) for m, t in enumerate(_numerators(k, last), k)}
    return Series(terms, through)


def rod_angle_series(order: int, through: int) -> Series:
    """Return R_order, the rod angle's coefficient of sin(order theta), through (1/lambda)^through.

    Formulas:
        R_1 = rho + rho^3/8 + 3 rho^5/64 + ...
        R_3 = -rho^3/24 - 3 rho^5/128 - ...

    >>> rod_angle_series(3, through=5).in_powers_of_rho()
    -3*rho**5/128 - rho**3/24
    """
    checked_order(order)
    if order % 2 == 0:
        return Series({}, through, complete=True)
    i = order // 2
    term, terms = (-1) ** i * comb(2 * i, i), {}
    for j in range(i, (through - 1) // 2 + 1):
        terms[2 * j + 1] = Fraction(term, (2 * j + 1) << 4 * j)
        term = term * (4 * (2 * j + 1) * (2 * j + 3)) // ((j + 1 - i) * (j + 2 + i))
    return Series(terms, through)


@dataclass(frozen=True, repr=False)
class Harmonics(Result):
    """A quantity as constant + sum of coefficient times cos (or sin) of n theta.

    `terms` maps n to the coefficient's `Series`; `function` is "cos" or "sin".
    """

    quantity: str
    function: str
    constant: Series
    terms: dict[int, Series]
    kind: ClassVar[str] = "harmonics"

    def summary(self) -> str:
        """Return what the harmonics are of, in one line."""
        return f"Harmonics of the {self.quantity} of one slider-crank to order {max(self.terms)}"

    def document(self) -> Document:
        """Return a table of the coefficients as series in 1/lambda."""
        from symbalance.kinematics.harmonics_document import harmonics_document

        return harmonics_document(self)

    def data(self) -> dict[str, Any]:
        """Return every coefficient as a series that SymPy reads."""
        from symbalance.kinematics.harmonics_document import harmonics_data

        return harmonics_data(self)

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each power of 1/lambda of each order."""
        from symbalance.kinematics.harmonics_document import harmonics_records

        return harmonics_records(self)


def harmonics(quantity: str, order: int, through: int | None = None) -> Harmonics:
    """Return a quantity's harmonics to `order`, each kept through (1/lambda)^through.

    The default keeps what a hand expansion to sin^order keeps: `through` = order - 1 (order, for the
    rod's angle). Units: r, r omega, r omega^2, m r omega^2 and rad.

    Formulas:
        x/r = B_0 - cos theta - B_2 cos 2 theta - B_4 cos 4 theta - ...
        v/(r omega) = sin theta + A_2/2 sin 2 theta + A_4/4 sin 4 theta + ...
        a/(r omega^2) = cos theta + A_2 cos 2 theta + A_4 cos 4 theta + ...
        phi = R_1 sin theta + R_3 sin 3 theta + ...

    >>> harmonics("displacement", 4).terms[4].in_powers_of_rho()
    rho**3/64
    """
    checked_order(order)
    checked_quantity(quantity)
    if through is not None:
        checked_power(through, "through")
    if quantity == "rod-angle":
        power = order if through is None else through
        odd = {n: rod_angle_series(n, power) for n in range(1, order + 1, 2)}
        return Harmonics(quantity, "sin", Series({}, power, complete=True), odd)
    power = order - 1 if through is None else through
    orders = [1, *range(2, order + 1, 2)]
    rows = {n: acceleration_series(n, power).scaled(integrated(quantity, n)) for n in orders}
    constant = _rest_position(power) if quantity == "displacement" else Series({}, power, complete=True)
    return Harmonics(quantity, "sin" if quantity == "velocity" else "cos", constant, rows)


def integrated(quantity: str, n: int) -> Fraction:
    """Return what A_n is multiplied by: the quantity is the acceleration, integrated so often.

    Formulas:
        A_2 = 4 B_2
        A_6 = 36 B_6

    >>> integrated("displacement", 4), integrated("force", 4)
    (Fraction(-1, 16), Fraction(1, 1))
    """
    return {"displacement": Fraction(-1, n * n), "velocity": Fraction(1, n)}.get(quantity, Fraction(1))


def _rest_position(through: int) -> Series:
    """Return B_0 = 1 + (1 - c_0)/rho, the mean piston position below top dead centre, over r.

    Formulas:
        B_0 = 1 + rho/4 + 3 rho^3/64 + ...
    """
    terms = {0: Fraction(1)}
    for m in range(1, (through + 1) // 2 + 1):
        terms[2 * m - 1] = Fraction(2 * (comb(2 * m - 2, m - 1) // m) * comb(2 * m, m), 1 << 4 * m)
    return Series(terms, through)
