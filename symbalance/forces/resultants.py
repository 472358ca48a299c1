r"""Free forces and couples of a layout, order by order, exactly.

A cylinder pushes along its axis with F = A_n m r omega^2 cos n(theta + throw - bank). Its planar vector,
vertical + i lateral, is that times e^(i bank); summed over all cylinders,

    c_{+-n} = 1/2 sum of w_j e^(i (bank_j +- n (throw_j - bank_j))),

w_j = 1 for the force (unit F_n = A_n m r omega^2) and the station for the couple (unit F_n a, about the
reference plane): the vertical couple is positive when the front is pushed up, the lateral when right.
These sums are geometry alone; A_n is the kinematics of one cylinder; tables print the two apart.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import lcm
from typing import Any

from symbalance.engine.cylinders import Cylinder
from symbalance.engine.layout import Layout
from symbalance.errors import SymbalanceError, shown
from symbalance.exact.angles import SymbolPart
from symbalance.exact.phasor import ZERO, Phasor
from symbalance.exact.spectrum import Component, Number, Spectrum, SymbolicPhasor
from symbalance.forces.rotating import with_rotors
from symbalance.forces.unlike_spectrum import unlike_spectrum
from symbalance.kinematics.slider_crank import (
    Series,
    acceleration_series,
    acceleration_values,
    checked_order,
    checked_power,
    surviving,
)
from symbalance.text.numbers import Real, exact

HALF = Fraction(1, 2)


@dataclass(frozen=True)
class Resultant:
    """One order of a force or couple, seen as components; units F_n, or F_n a."""

    spectrum: Spectrum
    order: int

    def is_zero(self) -> bool:
        """Tell whether the whole order vanishes."""
        return self.order not in self.spectrum.terms and -self.order not in self.spectrum.terms

    def component(self, name: str) -> Component:
        """Return a component by name: vertical, lateral, forward or backward."""
        return self.spectrum.component(self.order, name)

    @cached_property
    def vertical(self) -> Component:
        """The part along the vertical."""
        return self.component("vertical")

    @cached_property
    def lateral(self) -> Component:
        """The part towards the right, seen from the front."""
        return self.component("lateral")

    @cached_property
    def forward(self) -> Component:
        """The part that turns with the crank, by its vertical component."""
        return self.component("forward")

    @cached_property
    def backward(self) -> Component:
        """The part that turns against the crank, by its vertical component."""
        return self.component("backward")


@dataclass(frozen=True)
class Order:
    """One order that survives: its coefficient A_n (None where cylinders are unlike) and its geometry."""

    order: int
    coefficient: Series | None
    force: Resultant
    couple: Resultant


@dataclass(frozen=True)
class Balance:
    """What is left free in a layout: `force` and `couple` by order, up to `highest`.

    `reference` is the station couples are taken about, None for the mean of all stations.

    >>> from symbalance.engine.builders import inline
    >>> left = balance(inline("1-2-4-5-3"), order=4)
    >>> [o.order for o in left.orders], left[1].couple.vertical.amplitude
    ([1, 2, 4], sqrt(25/2 - 11*sqrt(5)/2))
    """

    layout: Layout
    highest: int
    force: Spectrum
    couple: Spectrum
    reference: Fraction | None = None
    power: int | None = None

    def as_text(self) -> str:
        """Return it as text for a terminal of 80 columns."""
        from symbalance.forces.balance_text import balance_text

        return balance_text(self)

    def as_latex(self, *, standalone: bool = False) -> str:
        """Return it as LaTeX, a fragment or a whole document."""
        from symbalance.forces.balance_latex import balance_latex

        return balance_latex(self, standalone=standalone)

    def as_json(self) -> str:
        """Return it as JSON, every number exact, as a string."""
        from symbalance.forces.balance_json import balance_json

        return balance_json(self)

    @property
    def ratio(self) -> Fraction | None:
        """The rod ratio lambda = l/r, if known."""
        return self.layout.ratio

    @property
    def is_uniform(self) -> bool:
        """Whether components are geometry, in units of A_n m r omega^2: cylinders and shafts allow it.

        Else they hold the kinematics too, in units of m r omega^2 of cylinder 1, to 40 digits.
        """
        return self.layout.is_geometric

    @cached_property
    def orders(self) -> tuple[Order, ...]:
        """The orders that survive, lowest first; those that cancel are absent."""
        found = sorted({*self.force.orders(), *self.couple.orders()})
        return tuple(
            Order(
                n,
                self.coefficient(n) if self.is_uniform else None,
                Resultant(self.force, n),
                Resultant(self.couple, n),
            )
            for n in found
        )

    def __getitem__(self, order: int) -> Order:
        for found in self.orders:
            if found.order == order:
                return found
        kept = ", ".join(str(o.order) for o in self.orders) or "none"
        raise KeyError(f"order {order} is absent: it cancels or lies above {self.highest} (left: {kept})")

    def coefficient(self, order: int) -> Series:
        """Return A_order as a series in 1/lambda: through `power`, or two terms."""
        return acceleration_series(order, default_power(order) if self.power is None else self.power)

    @cached_property
    def values(self) -> dict[int, Real]:
        """A_n exact in lambda, to 30 digits, for the orders that survive; empty without a ratio."""
        if self.ratio is None or not self.orders or not self.is_uniform:
            return {}
        values = acceleration_values(self.orders[-1].order, self.ratio, 30)
        return {o.order: values[o.order] for o in self.orders}


def default_power(order: int) -> int:
    """Return the power of 1/lambda that keeps two terms of A_order (A_1 = 1 has but one)."""
    return order + 1 if order > 1 else 0


def balance(
    layout: Layout,
    order: int = 12,
    *,
    ratio: object = None,
    power: int | None = None,
    reference: object = None,
) -> Balance:
    """Return the free forces and couples of a layout to an order, each exact.

    `ratio` overrides the layout's rod ratio lambda = l/r, `power` keeps that many powers of 1/lambda in
    the printed series, `reference` is the station couples are taken about (default: the stations' mean).
    """
    order = checked_order(order)
    if not isinstance(layout, Layout):
        raise SymbalanceError(
            f"layout = {shown(layout)}", "must be a Layout", 'load one with load("v12-60"), or build one'
        )
    if ratio is not None:
        layout = layout.with_ratio(ratio)
    plane = layout.mean_station if reference is None else exact(reference, "reference")
    arms = [c.station - plane for c in layout.cylinders]
    force = with_rotors(layout, _summed_over(layout, order, [Fraction(1)] * len(arms)), order, None)
    couple = with_rotors(layout, _summed_over(layout, order, arms), order, plane)
    result = Balance(layout, order, force, couple, None if reference is None else plane, power)
    _check_power(power, sorted({*force.orders(), *couple.orders()}))
    return result


def _summed_over(layout: Layout, order: int, weights: Sequence[Fraction]) -> Spectrum:
    if layout.is_geometric:
        return geometry(layout, [n for n in range(1, order + 1) if surviving(n)], weights)

    def like(cylinders: Sequence[Cylinder], orders: Sequence[int], own: Sequence[Fraction]) -> Any:
        return _exact_terms(cylinders, layout.modulus, orders, own)

    return unlike_spectrum(layout, range(1, order + 1), weights, like)


def checked_balance(result: object) -> Balance:
    """Return a balance, or refuse what is none."""
    if not isinstance(result, Balance):
        raise SymbalanceError(
            f"result = {shown(result)}", "must be a Balance", "make one with balance(layout)"
        )
    return result


def _check_power(power: int | None, orders: Sequence[int]) -> None:
    if power is None:
        return
    checked_power(power)
    lost = [n for n in orders if n - 1 > power]
    if lost:
        raise SymbalanceError(
            f"power = {power}",
            f"keeps no term of order {lost[-1]}",
            f"the least power of 1/lambda that keeps every order here is {lost[-1] - 1}",
        )


def geometry(layout: Layout, orders: Sequence[int], weights: Sequence[Fraction]) -> Spectrum:
    """Return the sum over cylinders of weight times the unit order n, for each of `orders`.

    >>> from symbalance.engine.builders import inline
    >>> geometry(inline("1-2-3-4-5-6-7"), range(1, 15), [Fraction(1)] * 7).orders()
    [7, 14]
    """
    modulus = layout.modulus
    if layout.has_symbols:
        return _with_symbols(layout.cylinders, orders, weights)
    return Spectrum(_exact_terms(layout.cylinders, modulus, orders, weights))


def _exact_terms(
    cylinders: Sequence[Cylinder], modulus: int, orders: Sequence[int], weights: Sequence[Fraction]
) -> dict[int, Phasor]:
    denominator = lcm(*(w.denominator for w in weights))
    rows = [
        (_units(c.bank.turns, modulus), _units(c.delay.turns, modulus), int(w * denominator))
        for c, w in zip(cylinders, weights, strict=True)
        if w
    ]
    half = Fraction(1, 2 * denominator)
    seen: dict[int, Phasor] = {}  # a sum depends on its order modulo m only
    terms: dict[int, Phasor] = {}
    for n in orders:
        for signed in (n, -n):
            residue = signed % modulus
            if residue not in seen:
                total = Phasor.of(modulus, _summed(rows, residue, modulus))
                seen[residue] = ZERO if total.is_zero() else total.scaled(half)
            if seen[residue] is not ZERO:
                terms[signed] = seen[residue]
    return terms


def _units(turns: Fraction, modulus: int) -> int:
    return turns.numerator * (modulus // turns.denominator)


def _summed(rows: Iterable[tuple[int, int, int]], n: int, modulus: int) -> dict[int, int]:
    total: dict[int, int] = {}
    for bank, delay, weight in rows:
        exponent = (bank + n * delay) % modulus
        total[exponent] = total.get(exponent, 0) + weight
    return total


def _with_symbols(
    cylinders: Sequence[Cylinder], orders: Sequence[int], weights: Sequence[Fraction]
) -> Spectrum:
    terms: dict[int, Number] = {}
    for n in orders:
        for signed in (n, -n):
            total = SymbolicPhasor({})
            for cylinder, weight in zip(cylinders, weights, strict=True):
                turned = cylinder.bank + cylinder.delay.scaled(signed)
                part: SymbolPart = turned.symbols
                phasor = Phasor.root(turned.turns).scaled(weight * HALF)
                total = total + SymbolicPhasor.of({part: phasor})
            terms[signed] = total
    return Spectrum.of(terms)
