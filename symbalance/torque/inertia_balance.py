"""The inertia torque of a layout, order by order, exactly.

With delta_j = throw_j - bank_j a cylinder has the torque t_n m r^2 omega^2 sin n(theta + delta_j). Over
all cylinders that is T_n (C cos n theta + S sin n theta), T_n = t_n m r^2 omega^2,

    C + iS = i sum of e^(-i n delta_j):    geometry alone; t_n is the kinematics of one cylinder.

Torque is positive on the crank in the sense of rotation; the frame gets the opposite. m is the
reciprocating mass of one cylinder: the rod counts as two masses, one at each end. No t_n vanishes, so an
order is absent exactly where its geometry is zero.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property

from mpmath import mp

from symbalance.errors import SymbalanceError, shown
from symbalance.layout import Layout
from symbalance.rational import Real
from symbalance.slider_crank import Series, checked_order, checked_power, checked_ratio
from symbalance.spectrum import QUARTER, Component
from symbalance.torque.inertia import default_power, torque_series, torque_values
from symbalance.torque.stars import summed
from symbalance.trains import CrankTrain

DIGITS = 30


@dataclass(frozen=True)
class TorqueOrder:
    """One order that survives: its coefficient t_n, and its geometry in units of T_n."""

    order: int
    coefficient: Series
    torque: Component


@dataclass(frozen=True)
class TorqueBalance:
    """The inertia torque of a layout by order, up to `highest`; unit T_n = t_n m r^2 omega^2.

    >>> from symbalance.builders import inline
    >>> four = inertia_torque(inline("1-3-4-2"), order=6)
    >>> [(o.order, o.torque.amplitude, o.torque.phase) for o in four.orders]
    [(2, 4, pi/2), (4, 4, pi/2), (6, 4, pi/2)]
    """

    layout: Layout
    highest: int
    components: Mapping[int, Component] = field(hash=False)
    power: int | None = None

    @property
    def ratio(self) -> Fraction | None:
        """The rod ratio lambda = l/r, if known."""
        return shared_sizes(self.layout).ratio

    @cached_property
    def orders(self) -> tuple[TorqueOrder, ...]:
        """The orders that survive, lowest first; those that cancel are absent."""
        return tuple(TorqueOrder(n, self.coefficient(n), c) for n, c in self.components.items())

    def __getitem__(self, order: int) -> TorqueOrder:
        for found in self.orders:
            if found.order == order:
                return found
        kept = ", ".join(map(str, self.components)) or "none"
        raise KeyError(f"order {order} is absent: it cancels or lies above {self.highest} (left: {kept})")

    def coefficient(self, order: int) -> Series:
        """Return t_order as a series in 1/lambda: through `power`, or two terms."""
        return torque_series(order, default_power(order) if self.power is None else self.power)

    @cached_property
    def values(self) -> dict[int, Real]:
        """t_n exact in lambda, to 30 digits, for the orders that survive; empty without a ratio."""
        if self.ratio is None or not self.components:
            return {}
        values = torque_values(max(self.components), self.ratio, DIGITS)
        return {n: values[n] for n in self.components}

    def reaction(self) -> TorqueBalance:
        """Return the torque on the frame: the opposite."""
        return replace(self, components={n: Component(-c.number) for n, c in self.components.items()})

    def terms(
        self, ratio: object = None, digits: int = DIGITS
    ) -> tuple[tuple[Fraction, Real, Real], ...]:
        """Return (order, C t_n, S t_n) for each order, in m r^2 omega^2, exact in lambda to `digits`.

        >>> from symbalance.builders import inline
        >>> [(order, mp.nstr(s, 6)) for order, _, s in inertia_torque(inline("1-3-4-2"), 2).terms(4)]
        [(Fraction(2, 1), '-2.00052')]
        """
        if not self.components:
            return ()
        values = torque_values(max(self.components), checked_known(self.layout, ratio), digits)
        found = []
        with mp.workdps(digits + 10):
            for n, component in self.components.items():
                cos, sin = component.decimal(digits + 10)
                found.append((Fraction(n), cos * values[n], sin * values[n]))
        return tuple(found)


def checked_known(layout: Layout, ratio: object) -> Fraction:
    """Return a rod ratio: the one given, else the layout's, or refuse."""
    known = shared_sizes(layout).ratio if ratio is None else ratio
    if known is None:
        rule = "its torque's numbers need the rod ratio lambda = l/r"
        raise SymbalanceError(f"{layout.name} has no rod ratio", rule, "give ratio=4, or another")
    return checked_ratio(known)


def shared_sizes(layout: Layout) -> CrankTrain:
    """Return the sizes that all cylinders have, or refuse a layout of unlike ones."""
    if not isinstance(layout, Layout):
        remedy = 'load one with load("v12-60"), or build one'
        raise SymbalanceError(f"layout = {shown(layout)}", "must be a Layout", remedy)
    if not layout.is_uniform:
        rule = "has unlike cylinders, offset axes or link rods"
        raise SymbalanceError(layout.name, rule, "torque is that of like, centred cylinders")
    return layout.train_of(layout.cylinders[0])


def inertia_torque(
    layout: Layout, order: int = 12, *, ratio: object = None, power: int | None = None
) -> TorqueBalance:
    """Return the inertia torque of a layout to an order, each order exact.

    `ratio` overrides the layout's rod ratio lambda = l/r; `power` keeps that many powers of 1/lambda in
    the series. Symbolic angles are kept as symbols.

    >>> from symbalance.catalogue import load
    >>> [[o.order for o in inertia_torque(load(n)).orders] for n in ("inline-6", "v8-90", "v12-60")]
    [[3, 6, 9, 12], [4, 8, 12], [6, 12]]
    """
    order = checked_order(order)
    shared_sizes(layout)
    if ratio is not None:
        layout = layout.with_ratio(ratio)
    components = _components(layout, order)
    _check_power(power, list(components))
    return TorqueBalance(layout, order, components, power)


def _components(layout: Layout, highest: int) -> dict[int, Component]:
    """Return the components that do not vanish; orders a modulus apart share them, and the work."""
    modulus = highest + 1 if layout.has_symbols else layout.modulus
    seen: dict[int, Component] = {}
    for n in range(1, min(highest, modulus) + 1):
        angles = [c.delay.scaled(-n) for c in layout.cylinders]
        seen[n % modulus] = Component(summed(angles).turned(QUARTER))
    found = {n: seen[n % modulus] for n in range(1, highest + 1)}
    return {n: c for n, c in found.items() if not c.is_zero()}


def _check_power(power: int | None, orders: Sequence[int]) -> None:
    if power is None:
        return
    checked_power(power)
    least = {n: {1: 1, 2: 0}.get(n, n - 2) for n in orders}
    lost = [n for n in orders if least[n] > power]
    if lost:
        raise SymbalanceError(
            f"power = {power}",
            f"keeps no term of order {lost[-1]}",
            f"the least power of 1/lambda that keeps every order here is {max(least.values())}",
        )
