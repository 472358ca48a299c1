"""Free forces and couples of an engine, order by order: the result that `balance` returns.

A cylinder pushes along its axis with F = A_n m r omega^2 cos n(theta + throw - bank). Its planar vector,
vertical + i lateral, is that times e^(i bank); summed over all cylinders,

    c_{+-n} = 1/2 sum of w_j e^(i (bank_j +- n (throw_j - bank_j))),

w_j = 1 for the force (unit F_n = A_n m r omega^2) and the station for the couple (unit F_n a, about the
reference plane): the vertical couple is positive when the front is pushed up, the lateral when right.
These sums are geometry alone; A_n is the kinematics of one cylinder; tables print the two apart.

Per cylinder, with bank angle b and delay d = throw - bank:

Formulas:
    cos n (theta + d) = cos n d cos n theta - sin n d sin n theta
    cos n (theta + d) e^(i b) = cos n (theta + d) cos b + i cos n (theta + d) sin b
    with n a whole number; b, d angles
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from math import log10
from typing import TYPE_CHECKING, Any, ClassVar, Protocol, TypeVar, Unpack

from symbalance.document.result import Result
from symbalance.engine.engine import Engine, checked_engine
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.spectrum import COMPONENTS, Component, Spectrum
from symbalance.forces.force_sums import planar_vectors
from symbalance.forces.operating_point import OperatingPoint, Sizes, operating_point, sized
from symbalance.kinematics.coefficients import FORCE, Kinematics
from symbalance.kinematics.slider_crank import Series, checked_order, checked_power
from symbalance.text.numbers import exact
from symbalance.text.reals import Real

if TYPE_CHECKING:
    from symbalance.document.nodes import Document
    from symbalance.forces.turn_maximum import TurnMaximum

DIGITS = 30
"""Digits of a coefficient's value."""
NEGLIGIBLE = 1e-6
"""Of one piston's first order: an order below is named in a line instead of tabled."""


@dataclass(frozen=True)
class Resultant:
    """One order of a force, in F_n, or a couple, in F_n a, with its components."""

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
    """One order that does not cancel: coefficient A_n (None if cylinders differ), force and couple."""

    order: int
    coefficient: Series | None
    force: Resultant
    couple: Resultant


@dataclass(frozen=True, repr=False)
class Balance(Result):
    """Free force and couple of an engine, `force` and `couple`, by order, up to `highest`.

    `reference` is the station couples are taken about, None for the mean of all stations. `kinematics`
    says what A_n is where components are geometry, in units of A_n m r omega^2; it is None where they
    hold the kinematics too, to 40 digits, in units of m r omega^2 of cylinder 1. Of an in-line four the
    first order cancels and the second does not, in units of F_1 and F_2:

    Formulas:
        S = 0
        T = 4 cos 2 theta
        with S the force of order 1 of inline-4; T the force of order 2 of inline-4

    >>> from symbalance.engine.builders import inline
    >>> left = balance(inline("1-2-4-5-3"), order=4)
    >>> [o.order for o in left.orders], left[1].couple.vertical.amplitude
    ([1, 2, 4], sqrt(25/2 - 11*sqrt(5)/2))
    """

    engine: Engine
    highest: int
    force: Spectrum
    couple: Spectrum
    reference: Fraction | None = None
    power: int | None = None
    kinematics: Kinematics | None = FORCE
    operating_point: OperatingPoint | None = None
    """The speed and sizes that values in N and N m are for; None where none is asked for."""

    kind: ClassVar[str] = "balance"
    record_keys: ClassVar[tuple[str, ...]] = (
        *("order", "of", "component", "cos", "sin", "amplitude", "exact_cos", "exact_sin"),
        *("unit", "coefficient"),
    )

    def summary(self) -> str:
        """Return which orders are left free, in one line."""
        parts = [
            f"free {name} of order {listed_orders(sorted(orders))}" if orders else f"no free {name}"
            for name, orders in (("force", self.force.orders()), ("couple", self.couple.orders()))
        ]
        return f"Balance of {self.engine.name} to order {self.highest}: {'; '.join(parts)}"

    def document(self) -> Document:
        """Return the free force and couple by order, then what the letters mean."""
        from symbalance.forces.balance_document import balance_document

        return balance_document(self)

    def data(self) -> dict[str, Any]:
        """Return the engine and every order, exact numbers as strings that SymPy reads."""
        from symbalance.forces.balance_data import balance_data

        return balance_data(self)

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each component of each order, in decimals where it has no symbols."""
        from symbalance.forces.balance_data import balance_records

        return balance_records(self)

    @property
    def ratio(self) -> Fraction | None:
        """The rod ratio lambda = l/r, if known."""
        return self.engine.ratio

    def at(self, *, rpm: object, **sizes: Unpack[Sizes]) -> Balance:
        """Return the same balance with its values in N and N m at a speed.

        `stroke`, `rod`, `pitch`, `bore` (mm) and `mass` (kg, of one cylinder's reciprocating parts) are
        sizes that the engine lacks. A couple needs the pitch, an order above the first the rod ratio.

        >>> from symbalance.engine.catalogue import load
        >>> four = balance(load("inline-4"), 2).at(rpm=6000, stroke=80, mass="0.5", rod=160)
        >>> [round(x) for x in four.in_newtons(2, "force.vertical")]
        [8023, 0]
        """
        if sizes:  # what holds the kinematics too, or weights in kg mm, depends on them
            engine = sized(self.engine, sizes)
            return _balance(engine, self.highest, self.power, self.reference).at(rpm=rpm)
        point = operating_point(
            self.engine,
            rpm,
            needs_pitch=bool(self.couple.orders()),
            needs_ratio=self.kinematics is not None and max(self._numbers, default=1) > 1,
        )
        return replace(self, operating_point=point)

    def in_newtons(self, order: int, output: str) -> tuple[Real, Real]:
        """Return (cos, sin) of an output ("force.lateral", "couple.vertical") of an order, N or N m."""
        of, _, name = output.partition(".")
        if of not in ("force", "couple") or name not in COMPONENTS:
            rule = "must be force. or couple. with vertical, lateral, forward or backward"
            raise SymbalanceError(f"output = {brief(output)}", rule, 'write "force.vertical"')
        if not 1 <= order <= self.highest:
            rule = f"is not among those of the balance, 1 to {self.highest}"
            raise SymbalanceError(f"order = {brief(order)}", rule, "balance the engine to a higher order")
        resultant = Resultant(self.force if of == "force" else self.couple, order)
        if resultant.is_zero() and self.operating_point is not None:
            return Real(0, DIGITS), Real(0, DIGITS)
        factor = self.unit_value(of) * self.share(order)
        cos, sin = resultant.component(name).decimal(DIGITS)
        return cos * factor, sin * factor

    def unit_value(self, of: str) -> Real:
        """Return m r omega^2 in N, or of a "couple" m r omega^2 a in N m, at the operating point."""
        point = self.operating_point
        if point is None:
            remedy = "put the balance at one: balance(engine).at(rpm=6000)"
            raise SymbalanceError("the balance", "has no operating point", remedy)
        unit = point.force if of == "force" else point.couple
        if unit is None:
            raise SymbalanceError(
                "pitch", "is not known", "add pitch to [crank_train], or say --pitch MM"
            )
        return unit

    def share(self, order: int) -> Real:
        """Return what 1 of an order is in one piston's first order, m r omega^2: A_n, or 1."""
        return Real(1, DIGITS) if self.kinematics is None else self._coefficients[order]

    @cached_property
    def _coefficients(self) -> dict[int, Real]:
        assert self.kinematics is not None
        if self.ratio is None:
            return {1: Real(1, DIGITS)}
        return self.kinematics.values_of([1, *self._numbers], self.ratio, DIGITS)

    @cached_property
    def _numbers(self) -> list[int]:
        return sorted({*self.force.orders(), *self.couple.orders()})

    @cached_property
    def turn_maxima(self) -> dict[str, TurnMaximum]:
        """The largest force and couple of all orders together over a turn, with proved bounds, N, N m.

        Keys are force.vertical, force.lateral, force (its size, whatever its direction), and those of
        the couple. Orders above `highest` count too.
        """
        from symbalance.forces.all_orders import turn_maxima

        return turn_maxima(self)

    @cached_property
    def orders(self) -> tuple[Order, ...]:
        """The orders that survive, lowest first; those that cancel are absent."""
        return tuple(
            Order(
                n,
                self.coefficient(n),
                Resultant(self.force, n),
                Resultant(self.couple, n),
            )
            for n in self._numbers
        )

    def __getitem__(self, order: int) -> Order:
        return order_of(self.orders, order, self.highest)

    def coefficient(self, order: int) -> Series | None:
        """Return A_order as a series in 1/lambda, through `power` or two terms; None if not apart."""
        return None if self.kinematics is None else self.kinematics.coefficient(order, self.power)

    @cached_property
    def values(self) -> dict[int, Real]:
        """A_n exact in lambda, to 30 digits, for the orders that survive; empty without a ratio."""
        if self.ratio is None or self.kinematics is None:
            return {}
        return self.kinematics.values_of([o.order for o in self.orders], self.ratio, DIGITS)


def balance(
    engine: Engine,
    order: int = 12,
    *,
    ratio: object = None,
    power: int | None = None,
    reference: object = None,
) -> Balance:
    """Return the free forces and couples of an engine to an order, each exact.

    `ratio` overrides the engine's rod ratio lambda = l/r, `power` keeps that many powers of 1/lambda in
    the printed series, `reference` is the station couples are taken about (default: the stations' mean).

    The primary force of a 90-degree V-twin on one pin has the size F_1 and turns with the crank, theta
    counting from cylinder 1: a counterweight balances it.

    Formulas:
        V = cos(theta - pi/4)
        H = sin(theta - pi/4)
        with V the force.vertical of order 1 of v2-90; H the force.lateral of order 1 of v2-90
    """
    order = checked_order(order)
    return _balance(checked_engine(engine, ratio), order, power, reference)


class _Numbered(Protocol):
    """What has an order: a whole or a half number."""

    @property
    def order(self) -> int | Fraction: ...


OneOrder = TypeVar("OneOrder", bound=_Numbered)


def order_of(orders: Sequence[OneOrder], number: int | Fraction, highest: int) -> OneOrder:
    """Return the order of that number among those that survive to `highest`; KeyError if it is absent."""
    for one_order in orders:
        if one_order.order == number:
            return one_order
    present = ", ".join(str(o.order) for o in orders) or "none"
    why = f"it cancels or lies above {highest} (left: {present})"
    raise KeyError(f"order {number} is absent: {why}")


def listed_orders(orders: Sequence[int | Fraction]) -> str:
    """Return orders with commas, the first and the last where there are many; halves as decimals.

    >>> listed_orders([Fraction(1, 2), 1, Fraction(3, 2)])
    '0.5, 1, 1.5'
    """
    printed = [str(n) if n == int(n) else str(float(n)) for n in orders]
    return ", ".join([*printed[:6], "…", printed[-1]] if len(printed) > 8 else printed)


def slight_orders(orders: Sequence[int | Fraction], least: float = NEGLIGIBLE) -> str:
    """Return in a line which orders are below `least`, a power of ten, of one piston's first order."""
    word = "order" if len(orders) == 1 else "orders"
    power = f"10⁻{'⁰¹²³⁴⁵⁶⁷⁸⁹'[-round(log10(least))]}"
    return f"{word} {listed_orders(orders)}: below {power} of one piston's first order"


def _balance(engine: Engine, order: int, power: int | None, reference: object) -> Balance:
    plane = None if reference is None else exact(reference, "reference")
    force, couple = planar_vectors(engine, order, plane)
    apart = FORCE if engine.counts_in_orders else None
    return _with_power(Balance(engine, order, force, couple, plane, kinematics=apart), power)


def checked_balance(result: object) -> Balance:
    """Return a balance, or refuse what is none."""
    if not isinstance(result, Balance):
        raise SymbalanceError(
            f"result = {brief(result)}", "must be a Balance", "make one with balance(engine)"
        )
    return result


def _with_power(result: Balance, power: int | None) -> Balance:
    """Return a balance that keeps so many powers of 1/lambda; refused where an order would lose all."""
    if power is None:
        return result
    checked_power(power)
    orders = sorted({*result.force.orders(), *result.couple.orders()})
    empty = [n for n in orders if n - 1 > power]
    if empty:
        raise SymbalanceError(
            f"power = {power}",
            f"keeps no term of order {empty[-1]}",
            f"the least power of 1/lambda that keeps every order here is {empty[-1] - 1}",
        )
    return replace(result, power=power)
