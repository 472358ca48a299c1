"""Gas torque of an engine: one cylinder's harmonics times the star diagrams of its firing order."""

from __future__ import annotations

from cmath import exp
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, ClassVar

from symbalance.document.result import Result
from symbalance.engine.engine import Engine, checked_engine
from symbalance.errors import SymbalanceError, brief
from symbalance.forces.free_forces import listed_orders, order_of
from symbalance.kinematics.mechanisms import Mechanism, SliderCrank
from symbalance.kinematics.mechanisms.mechanism_types import simplified
from symbalance.kinematics.slider_crank import checked_order
from symbalance.text.measurements import measurement
from symbalance.text.numbers import exact
from symbalance.text.reals import Real
from symbalance.torque.cylinder_gas import AMBIENT, TangentialPressure
from symbalance.torque.ideal_cycles import IdealCycle
from symbalance.torque.inertia_balance import checked_known
from symbalance.torque.pressure import MOST_BAR, PressureTrace
from symbalance.torque.star_diagrams import Star, firing_pin_passings, firing_stars, stars_of

if TYPE_CHECKING:
    from symbalance.document.nodes import Document


@dataclass(frozen=True)
class GasGroup:
    """Cylinders alike in gas torque: tangential pressure, firing angles, degrees, r over cylinder 1's."""

    tangential: TangentialPressure
    firing_angles: Mapping[int, Fraction]
    radius: float

    def numbers(self, strokes: int, order: int) -> dict[Fraction, complex]:
        """Return C + iS in bar of every order their star leaves: orders that close are absent."""
        harmonics, lead = self.tangential.harmonics(order), self.tangential.piston.top
        numbers = {}
        for star in stars_of(self.firing_angles, strokes, order):
            if not star.is_closed():
                rotated = complex(*star.resultant.decimal(20)) * exp(1j * float(star.order) * lead)
                numbers[star.order] = self.radius * harmonics[star.order] * rotated
        return numbers


@dataclass(frozen=True)
class GasOrder:
    """One order of the gas torque that does not cancel: C + iS in bar (times A r), and its star.

    `star` is that of all cylinders, whether they are alike or not.
    """

    order: Fraction
    star: Star
    number: complex

    @property
    def amplitude(self) -> float:
        """The size of the whole engine's order, in bar."""
        return abs(self.number)


@dataclass(frozen=True, repr=False)
class GasTorque(Result):
    """The gas torque of an engine by order, in bar: multiply by piston area times crank radius.

    Every cylinder has the same bore, and the same trace or ideal cycle, counted from its own firing top
    dead centre. r is cylinder 1's. Orders that close among like cylinders, and in all, are absent.
    `pressure` is that trace or cycle.
    """

    engine: Engine
    groups: tuple[GasGroup, ...]
    highest: int
    orders: tuple[GasOrder, ...]
    pressure: PressureTrace | IdealCycle

    kind: ClassVar[str] = "gas-torque"

    def summary(self) -> str:
        """Return the mean and the orders that survive, in one line."""
        orders = f"order {listed_orders([o.order for o in self.orders])}" if self.orders else "no order"
        what = f"Gas torque of {self.engine.name} to order {self.highest}"
        return f"{what}: {orders}; mean {self.mean:.6g} bar"

    def document(self) -> Document:
        """Return the mean and the orders that survive, then what they are times and where they act."""
        from symbalance.torque.gas_document import gas_document

        return gas_document(self)

    def data(self) -> dict[str, Any]:
        """Return the mean and every order that survives, in bar: times A r the torque."""
        return {
            "engine": self.engine.name,
            "strokes": self.engine.strokes,
            "ratio": str(self.cylinder.ratio),
            "ambient_bar": self.ambient,
            "pressure": self.pressure.summary(),
            "highest_order": self.highest,
            "unit": "bar (times piston area and crank radius)",
            "mean": self.mean,
            "orders": [
                {"order": str(o.order), "cos": o.number.real, "sin": o.number.imag} for o in self.orders
            ],
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each order that survives; keys: order, of, cos, sin, amplitude, unit."""
        return [
            {
                "order": float(o.order),
                "of": "gas torque on the crank over A r",
                "cos": o.number.real,
                "sin": o.number.imag,
                "amplitude": o.amplitude,
                "unit": "bar",
            }
            for o in self.orders
        ]

    @property
    def ambient(self) -> float:
        """The pressure below the pistons, in bar absolute."""
        return self.cylinder.ambient

    @property
    def cylinder(self) -> TangentialPressure:
        """The tangential pressure of the first cylinder."""
        return _of_first(self.engine, self.groups)

    @property
    def mean(self) -> float:
        """The mean over the cycle, of all cylinders."""
        return sum(
            len(group.firing_angles) * group.radius * group.tangential.mean for group in self.groups
        )

    def __getitem__(self, order: object) -> GasOrder:
        return order_of(self.orders, exact(order, "order"), self.highest)

    def terms(self) -> tuple[tuple[Fraction, Real, Real], ...]:
        """Return (order, C, S) in bar for each order; the digits are those of doubles."""
        return tuple((o.order, Real(o.number.real), Real(o.number.imag)) for o in self.orders)


def gas_torque(
    engine: Engine,
    trace: PressureTrace | IdealCycle,
    order: int = 6,
    *,
    ratio: object = None,
    ambient: object = AMBIENT,
) -> GasTorque:
    """Return the gas torque of an engine whose cylinders all have one pressure trace, or one ideal cycle.

    `ratio` overrides the engine's rod ratio, `ambient` is the pressure below the pistons, bar absolute.
    An ideal cycle gives every kind of cylinder the trace of its own piston's displacement.

    >>> from symbalance.engine.catalogue import load
    >>> from symbalance.torque.ideal_cycles import ideal_cycle
    >>> six = gas_torque(load("inline-6"), ideal_cycle(10, heat=20).trace(4), 9)
    >>> [(str(o.order), round(o.amplitude, 2)) for o in six.orders]
    [('3', 12.43), ('6', 3.65), ('9', 1.32)]
    """
    groups = gas_groups(engine, trace, ratio=ratio, ambient=ambient)
    engine = engine if ratio is None else engine.with_ratio(ratio)
    checked_order(order)
    total: dict[Fraction, complex] = {}
    for group in groups:
        for n, number in group.numbers(engine.strokes, order).items():
            total[n] = total.get(n, 0j) + number
    stars = {star.order: star for star in firing_stars(engine, order)}
    orders = tuple(GasOrder(n, stars[n], total[n]) for n in sorted(total))
    return GasTorque(engine, groups, order, orders, trace)


def gas_groups(
    engine: Engine,
    trace: PressureTrace | IdealCycle,
    *,
    ratio: object = None,
    ambient: object = AMBIENT,
) -> tuple[GasGroup, ...]:
    """Return the cylinders by kind, each with its tangential pressure."""
    below, firing_angles = _checked(engine, trace, ambient), firing_pin_passings(engine)
    engine = engine if ratio is None else engine.with_ratio(ratio)
    radius = {c.number: r for c, r in zip(engine.cylinders, engine.radii, strict=True)}
    by_kind = engine.grouped(
        lambda c: (c.mechanism or SliderCrank(checked_known(engine, None)), radius[c.number])
    )
    return tuple(
        GasGroup(
            _tangential(mechanism, trace, below),
            {c.number: firing_angles[c.number] for c in cylinders},
            float(size),
        )
        for (mechanism, size), cylinders in by_kind.items()
    )


def tangential_pressure(
    engine: Engine,
    trace: PressureTrace | IdealCycle,
    *,
    ratio: object = None,
    ambient: object = AMBIENT,
) -> TangentialPressure:
    """Return the tangential pressure of an engine's first cylinder."""
    return _of_first(engine, gas_groups(engine, trace, ratio=ratio, ambient=ambient))


def _of_first(engine: Engine, groups: tuple[GasGroup, ...]) -> TangentialPressure:
    return next(group.tangential for group in groups if engine.first.number in group.firing_angles)


def _tangential(
    mechanism: Mechanism, trace: PressureTrace | IdealCycle, below: float
) -> TangentialPressure:
    own = trace.trace(mechanism) if isinstance(trace, IdealCycle) else trace
    return TangentialPressure(own, simplified(mechanism).length, below, mechanism)


def _checked(engine: Engine, trace: object, ambient: object) -> float:
    """Return the pressure below the pistons; refuse it, or a trace that does not fit the engine."""
    checked_engine(engine)
    if not isinstance(trace, PressureTrace | IdealCycle):
        rule, remedy = "must be a PressureTrace", "read_pressure(path), or ideal_cycle(...).trace(ratio)"
        raise SymbalanceError(f"trace = {brief(trace)}", rule, remedy)
    if trace.strokes != engine.strokes:
        what = f"a trace of {trace.strokes} strokes"
        rule = f"does not fit {engine.name}, of {engine.strokes}"
        raise SymbalanceError(what, rule, "give the same strokes to both")
    below = measurement(ambient, "ambient")
    if not 0 <= below <= MOST_BAR:
        what, rule = f"ambient = {brief(ambient)}", f"must lie in [0, {MOST_BAR}] bar"
        raise SymbalanceError(what, rule, "absolute; the atmosphere is 1.01325")
    return float(below)
