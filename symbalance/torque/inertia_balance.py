"""Inertia torque of an engine, order by order, exactly.

With delta_j = throw_j - bank_j a cylinder has the torque t_n m r^2 omega^2 sin n(theta + delta_j). Over
all cylinders that is T_n (C cos n theta + S sin n theta), T_n = t_n m r^2 omega^2,

    C + iS = i sum of e^(-i n delta_j):    geometry alone; t_n is the kinematics of one cylinder.

Torque is positive on the crank in the sense of rotation. m is the reciprocating mass of one cylinder: the
rod counts as two masses, one at each end; what its inertia differs by is `roll`'s. No t_n vanishes, so an
order is absent exactly where its geometry is zero.

Where cylinders are not alike (offset axes, link rods, masses and strokes of their own) the components
hold the kinematics too, to 40 digits, in units of m r^2 omega^2 of cylinder 1 (`groups`).

Formulas:
    sin n (theta + d) = C cos n theta + S sin n theta
    C + i S = i e^(-i n d)
    with C = sin n d; S = cos n d; n a whole number; d an angle
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar, Unpack

from symbalance.document.result import Result
from symbalance.engine.engine import Engine, checked_engine
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.spectrum import QUARTER, Component
from symbalance.forces.free_forces import DIGITS, listed_orders, order_of
from symbalance.forces.operating_point import OperatingPoint, Sizes, operating_point, sized
from symbalance.kinematics.coefficients import INERTIA, OF_RODS, Kinematics
from symbalance.kinematics.slider_crank import Series, checked_order, checked_power, checked_ratio
from symbalance.text.reals import Real
from symbalance.torque.body_groups import has_common_torque, torque_groups, total_torque
from symbalance.torque.star_diagrams import unit_vector_sum

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

MILLI = 1000
"""Millimetres in a metre."""
INERTIA_TORQUE = "inertia torque on the crank"
OPPOSITE = "opposite of the "


@dataclass(frozen=True)
class TorqueOrder:
    """One order that does not cancel: the coefficient (None if cylinders differ), and the torque."""

    order: int
    coefficient: Series | None
    torque: Component


@dataclass(frozen=True, repr=False)
class TorqueBalance(Result):
    """The inertia torque of an engine by order, up to `highest`, in T_n = t_n m r^2 omega^2.

    `kinematics` says what t_n is; None where the components hold it, in `unit`. `quantity` is which
    torque or moment it is, in words.

    >>> from symbalance.engine.builders import inline
    >>> four = inertia_torque(inline("1-3-4-2"), order=6)
    >>> [(o.order, o.torque.amplitude, o.torque.phase) for o in four.orders]
    [(2, 4, pi/2), (4, 4, pi/2), (6, 4, pi/2)]
    """

    engine: Engine
    highest: int
    components: Mapping[int, Component] = field(hash=False)
    power: int | None = None
    kinematics: Kinematics | None = INERTIA
    unit: str = INERTIA.unit
    quantity: str = INERTIA_TORQUE
    operating_point: OperatingPoint | None = None
    """The speed and sizes that values in N m are for; None where none is asked for."""
    function: Callable[..., TorqueBalance] | None = field(default=None, compare=False, repr=False)
    """The function of engine and order that computes it, for other sizes; None where nobody says."""

    kind: ClassVar[str] = "torque-orders"
    record_keys: ClassVar[tuple[str, ...]] = (
        *("order", "of", "cos", "sin", "amplitude", "exact_cos", "exact_sin", "coefficient", "unit"),
    )

    def summary(self) -> str:
        """Return which orders are left, in one line."""
        orders = f"order {listed_orders([*self.components])}" if self.components else "none"
        what = self.quantity[0].upper() + self.quantity[1:]
        return f"{what}, {self.engine.name} to order {self.highest}: {orders}"

    def document(self) -> Document:
        """Return the orders that survive, then what the letters mean."""
        from symbalance.torque.torque_document import orders_document

        return orders_document(self)

    def data(self) -> dict[str, Any]:
        """Return the engine and every order, exact numbers as strings that SymPy reads."""
        from symbalance.torque.torque_data import orders_data

        return orders_data(self)

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each order, in decimals where it has no symbols."""
        from symbalance.torque.torque_data import orders_records

        return orders_records(self)

    @property
    def ratio(self) -> Fraction | None:
        """The rod ratio lambda = l/r, if known."""
        return self.engine.ratio

    @cached_property
    def orders(self) -> tuple[TorqueOrder, ...]:
        """The orders that survive, lowest first; those that cancel are absent."""
        return tuple(TorqueOrder(n, self.coefficient(n), c) for n, c in self.components.items())

    def __getitem__(self, order: int) -> TorqueOrder:
        return order_of(self.orders, order, self.highest)

    def coefficient(self, order: int) -> Series | None:
        """Return t_order as a series in 1/lambda: through `power`, or two terms."""
        return None if self.kinematics is None else self.kinematics.coefficient(order, self.power)

    @cached_property
    def values(self) -> dict[int, Real]:
        """t_n exact in lambda, to 30 digits, for the orders that survive; empty without a ratio."""
        if self.ratio is None or self.kinematics is None:
            return {}
        return self.kinematics.values_of(self.components, self.ratio, DIGITS)

    def at(self, *, rpm: object, **sizes: Unpack[Sizes]) -> TorqueBalance:
        """Return the same torque with its values in N m at a speed.

        `stroke`, `rod`, `pitch`, `bore` (mm) and `mass` (kg, of one cylinder's reciprocating parts) are
        sizes that the engine lacks. The rod ratio has to be known.

        >>> from symbalance.engine.builders import inline
        >>> four = inertia_torque(inline("1-3-4-2"), 2).at(rpm=6000, stroke=80, rod=160, mass="0.5")
        >>> [round(x, 3) for x in four.in_newton_metres(2)]
        [0.0, -631.819]
        """
        engine = sized(self.engine, sizes)
        if engine != self.engine:  # what holds the kinematics too, or weights in kg mm, depends on them
            if self.function is None:
                rule = "are of an engine whose torque these numbers are not"
                raise SymbalanceError("sizes", rule, "give them to the engine: engine.with_sizes(...)")
            again = replace(self.function(engine, self.highest), power=self.power)
            is_opposite = self.quantity.startswith(OPPOSITE)
            return (again.reaction() if is_opposite else again).at(rpm=rpm)
        needs_ratio = self.kinematics is not None and bool(self.components)
        point = operating_point(engine, rpm, needs_pitch=False, needs_ratio=needs_ratio)
        return replace(self, operating_point=point)

    @cached_property
    def unit_value(self) -> Real:
        """The torque's `unit` in N m, at the operating point."""
        point = self.operating_point
        if point is None:
            remedy = "put it at one: inertia_torque(engine).at(rpm=6000)"
            raise SymbalanceError("the torque", "has no operating point", remedy)
        if self.unit != OF_RODS:
            return point.torque
        return point.omega**2 * (first_excess(self.engine) / MILLI**2)

    def in_newton_metres(self, order: int) -> tuple[Real, Real]:
        """Return (cos, sin) of an order in N m; zeros where it cancels."""
        unit = self.unit_value
        if not 1 <= order <= self.highest:
            rule = f"is not among those of the torque, 1 to {self.highest}"
            raise SymbalanceError(f"order = {brief(order)}", rule, "take the torque to a higher order")
        if order not in self.components:
            return Real(0, DIGITS), Real(0, DIGITS)
        share = Real(1, DIGITS) if self.kinematics is None else self.values[order]
        cos, sin = self.components[order].decimal(DIGITS)
        return cos * share * unit, sin * share * unit

    def reaction(self) -> TorqueBalance:
        """Return the opposite: without offset and rods' inertia, the torque on the frame."""
        twice = self.quantity.startswith(OPPOSITE)
        quantity = self.quantity.removeprefix(OPPOSITE) if twice else OPPOSITE + self.quantity
        components = {n: Component(-c.number) for n, c in self.components.items()}
        return replace(self, components=components, quantity=quantity)

    def terms(
        self, ratio: object = None, digits: int = DIGITS
    ) -> tuple[tuple[Fraction, Real, Real], ...]:
        """Return (order, C t_n, S t_n) for each order, in `unit`, exact in lambda to `digits`.

        >>> from symbalance.engine.builders import inline
        >>> from symbalance.text.reals import nstr
        >>> [(order, nstr(s, 6)) for order, _, s in inertia_torque(inline("1-3-4-2"), 2).terms(4)]
        [(Fraction(2, 1), '-2.00052')]
        """
        if not self.components:
            return ()
        if self.kinematics is None:
            _check_own(self.engine, ratio)
            return tuple((Fraction(n), *c.decimal(digits)) for n, c in self.components.items())
        known = checked_known(self.engine, ratio)
        values = self.kinematics.values_of(self.components, known, digits)
        parts = {n: component.decimal(digits + 10) for n, component in self.components.items()}
        return tuple((Fraction(n), c * values[n], s * values[n]) for n, (c, s) in parts.items())


def _check_own(engine: Engine, ratio: object) -> None:
    if ratio is not None and checked_ratio(ratio) != engine.ratio:
        rule = "cannot be set for cylinders that are not alike"
        raise SymbalanceError(f"ratio = {brief(ratio)}", rule, "give each its stroke and rod")


def checked_known(engine: Engine, ratio: object) -> Fraction:
    """Return a rod ratio: the one given, else the engine's, or refuse."""
    known = checked_engine(engine).ratio if ratio is None else ratio
    if known is None:
        rule = "its torque's numbers need the rod ratio lambda = l/r"
        raise SymbalanceError(f"{engine.name} has no rod ratio", rule, "give ratio=4, or another")
    return checked_ratio(known)


def inertia_torque(
    engine: Engine, order: int = 12, *, ratio: object = None, power: int | None = None
) -> TorqueBalance:
    """Return the inertia torque of an engine to an order, each order exact.

    `ratio` overrides the engine's rod ratio lambda = l/r; `power` keeps that many powers of 1/lambda in
    the series. Symbolic angles are kept as symbols. Of cylinders that are not alike the components are
    numbers, in m r^2 omega^2 of cylinder 1.

    >>> from symbalance.engine.catalogue import load
    >>> [[o.order for o in inertia_torque(load(n)).orders] for n in ("inline-6", "v8-90", "v12-60")]
    [[3, 6, 9, 12], [4, 8, 12], [6, 12]]
    """
    order = checked_order(order)
    checked_engine(engine)
    if ratio is not None:
        engine = engine.with_ratio(ratio)
    if has_common_torque(engine):
        components = sine_components(engine, order)
        _check_power(power, list(components))
        return TorqueBalance(engine, order, components, power, function=inertia_torque)
    _check_no_power(engine, power)
    components = total_torque(torque_groups(engine), order)
    return TorqueBalance(engine, order, components, kinematics=None, function=inertia_torque)


def first_excess(engine: Engine) -> Fraction:
    """Return J_x in kg mm^2 of the first rod that has one: the unit of the rods' parts."""
    rods = sorted(engine.cylinders, key=lambda c: c.number)
    return next((c.excess for c in rods if c.excess), Fraction(0))


def sine_components(engine: Engine, highest: int) -> dict[int, Component]:
    """Return the components that do not vanish; orders a modulus apart share them, and the work."""
    modulus = highest + 1 if engine.has_symbols else engine.modulus
    by_residue: dict[int, Component] = {}
    for n in range(1, min(highest, modulus) + 1):
        angles = [c.delay.scaled(-n) for c in engine.cylinders]
        by_residue[n % modulus] = Component(unit_vector_sum(angles).rotated(QUARTER))
    components = {n: by_residue[n % modulus] for n in range(1, highest + 1)}
    return {n: c for n, c in components.items() if not c.is_zero()}


def _check_no_power(engine: Engine, power: int | None) -> None:
    if power is not None:
        rule = f"is for cylinders that are alike, and those of {engine.name} are not"
        raise SymbalanceError(f"power = {power}", rule, "leave it out: the numbers hold all powers")


def _check_power(power: int | None, orders: Sequence[int]) -> None:
    if power is None:
        return
    checked_power(power)
    least = {n: {1: 1, 2: 0}.get(n, n - 2) for n in orders}
    empty = [n for n in orders if least[n] > power]
    if empty:
        raise SymbalanceError(
            f"power = {power}",
            f"keeps no term of order {empty[-1]}",
            f"the least power of 1/lambda that keeps every order here is {max(least.values())}",
        )
