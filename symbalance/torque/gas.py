"""The gas torque of a layout: one cylinder's harmonics times the stars of its firing order."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from mpmath import mp

from symbalance.errors import SymbalanceError, shown
from symbalance.layout import Layout
from symbalance.rational import Real, exact
from symbalance.slider_crank import checked_order, checked_ratio
from symbalance.torque.inertia_balance import checked_known, shared_sizes
from symbalance.torque.measured import measured
from symbalance.torque.pressure import MOST_BAR, PressureTrace
from symbalance.torque.stars import Star, firing_stars
from symbalance.torque.tangential import AMBIENT, TangentialPressure


@dataclass(frozen=True)
class GasOrder:
    """One order that survives: its star, and C + iS of one cylinder in bar."""

    order: Fraction
    star: Star
    harmonic: complex

    @property
    def number(self) -> complex:
        """C + iS of the whole layout, in bar; times A r the torque."""
        cosine, sine = self.star.resultant.decimal(20)
        return self.harmonic * complex(cosine, sine)

    @property
    def amplitude(self) -> float:
        """The size of the whole layout's order, in bar."""
        return abs(self.number)


@dataclass(frozen=True)
class GasTorque:
    """The gas torque of a layout by order, in bar: times A r (piston area, crank radius) the torque.

    Every cylinder has the same trace. Orders whose star is closed are absent.
    """

    layout: Layout
    cylinder: TangentialPressure
    highest: int
    orders: tuple[GasOrder, ...]

    @property
    def mean(self) -> float:
        """The mean over the cycle, of all cylinders."""
        return len(self.layout.cylinders) * self.cylinder.mean

    def __getitem__(self, order: object) -> GasOrder:
        wanted = exact(order, "order")
        for found in self.orders:
            if found.order == wanted:
                return found
        kept = ", ".join(str(o.order) for o in self.orders) or "none"
        why = f"it cancels or lies above {self.highest} (left: {kept})"
        raise KeyError(f"order {wanted} is absent: {why}")

    def terms(self) -> tuple[tuple[Fraction, Real, Real], ...]:
        """Return (order, C, S) in bar for each order; the digits are those of doubles."""
        return tuple((o.order, mp.mpf(o.number.real), mp.mpf(o.number.imag)) for o in self.orders)


def gas_torque(
    layout: Layout,
    trace: PressureTrace,
    order: int = 6,
    *,
    ratio: object = None,
    ambient: object = AMBIENT,
) -> GasTorque:
    """Return the gas torque of a layout whose cylinders all have one pressure trace.

    `ratio` overrides the layout's rod ratio, `ambient` is the pressure below the pistons, bar absolute.

    >>> from symbalance.catalogue import load
    >>> from symbalance.torque.ideal import ideal_cycle
    >>> six = gas_torque(load("inline-6"), ideal_cycle(10, heat=20).trace(4), 9)
    >>> [(str(o.order), round(o.amplitude, 2)) for o in six.orders]
    [('3', 12.43), ('6', 3.65), ('9', 1.32)]
    """
    cylinder = tangential_pressure(layout, trace, ratio=ratio, ambient=ambient)
    checked_order(order)
    stars = [star for star in firing_stars(layout, order) if not star.is_closed()]
    harmonics = cylinder.harmonics(order)
    found = tuple(GasOrder(star.order, star, harmonics[star.order]) for star in stars)
    return GasTorque(layout, cylinder, order, found)


def tangential_pressure(
    layout: Layout, trace: PressureTrace, *, ratio: object = None, ambient: object = AMBIENT
) -> TangentialPressure:
    """Return the tangential pressure of one cylinder of a layout."""
    shared_sizes(layout)
    if not isinstance(trace, PressureTrace):
        rule, remedy = "must be a PressureTrace", "read_pressure(path), or ideal_cycle(...).trace(ratio)"
        raise SymbalanceError(f"trace = {shown(trace)}", rule, remedy)
    if trace.strokes != layout.strokes:
        what, rule = (
            f"a trace of {trace.strokes} strokes",
            f"does not fit {layout.name}, of {layout.strokes}",
        )
        raise SymbalanceError(what, rule, "give the same strokes to both")
    below = measured(ambient, "ambient")
    if not 0 <= below <= MOST_BAR:
        what, rule = f"ambient = {shown(ambient)}", f"must lie in [0, {MOST_BAR}] bar"
        raise SymbalanceError(what, rule, "absolute; the atmosphere is 1.01325")
    return TangentialPressure(trace, checked_ratio(checked_known(layout, ratio)), float(below))
