"""The torque of a running engine against the crank angle, and what its flywheel makes of it.

T(theta) = sum over cylinders of A r (p - p_ambient) v^ - m r^2 omega^2 v^ dv^/dtheta, v^ = v/(r omega) at
the cylinder's own angle: the inertia part is the closed form, all orders at once.
The mean is the gas's alone: indicated, without friction. The inertia part is that of constant omega, its
change with the speed's own swing left out: of the size of delta times that part.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from math import pi, sin

from mpmath import mp

from symbalance.errors import SymbalanceError, shown
from symbalance.layout import Layout
from symbalance.rational import Real, checked_whole
from symbalance.torque.flywheel import (
    Fluctuation,
    extremes,
    flywheel_inertia,
    speed_fluctuation,
)
from symbalance.torque.gas import gas_torque, tangential_pressure
from symbalance.torque.inertia_balance import inertia_torque, shared_sizes
from symbalance.torque.measured import measured, positive
from symbalance.torque.pressure import PressureTrace
from symbalance.torque.stars import firing_tops
from symbalance.torque.tangential import AMBIENT, TangentialPressure, acceleration, velocity

PASCAL = 100_000
"""A bar, in Pa."""


@dataclass(frozen=True)
class CrankTorque:
    """A running engine's torque on its crank, SI: `area` m^2, `radius` m, `mass` kg, `omega` rad/s.

    `tops` are the cylinders' firing top dead centres in radians.
    """

    layout: Layout
    cylinder: TangentialPressure
    area: float
    radius: float
    mass: float
    omega: float
    tops: tuple[float, ...]

    @property
    def cycle(self) -> float:
        """The crank angle of a cycle, in radians."""
        return self.cylinder.trace.cycle * pi / 180

    @property
    def _gas_unit(self) -> float:
        return self.area * self.radius * PASCAL

    @property
    def _inertia_unit(self) -> float:
        return self.mass * (self.radius * self.omega) ** 2

    def gas(self, theta: float) -> float:
        """Return the gas torque at a crank angle (radians), in N m."""
        return self._gas_unit * sum(self.cylinder.at(theta - top) for top in self.tops)

    def inertia(self, theta: float) -> float:
        """Return the inertia torque at a crank angle (radians), in N m."""
        crank = float(self.cylinder.ratio)
        own = (theta - top for top in self.tops)
        return -self._inertia_unit * sum(velocity(a, crank) * acceleration(a, crank) for a in own)

    def at(self, theta: float) -> float:
        """Return the whole torque at a crank angle (radians), in N m: + in the sense of rotation."""
        return self.gas(theta) + self.inertia(theta)

    def frame(self, theta: float) -> float:
        """Return the torque on the frame at a crank angle: the opposite."""
        return -self.at(theta)

    @property
    def mean(self) -> float:
        """The mean torque: the gas's, indicated, in N m."""
        return self._gas_unit * len(self.tops) * self.cylinder.mean

    @property
    def work(self) -> float:
        """The work of all cylinders in one cycle, in J."""
        return self._gas_unit * len(self.tops) * self.cylinder.cycle_work

    @property
    def power(self) -> float:
        """The indicated power, in W."""
        return self.mean * self.omega

    def energy(self, theta: float) -> float:
        """Return the integral of T - mean up to a crank angle (radians), in J, to a constant."""
        crank = float(self.cylinder.ratio)
        worked = sum(self.cylinder.work(theta - top) for top in self.tops)
        moving = sum(velocity(theta - top, crank) ** 2 for top in self.tops)
        return self._gas_unit * worked - self._inertia_unit * moving / 2 - self.mean * theta

    def curve(self, points: int = 720) -> list[tuple[float, float, float, float]]:
        """Return (degrees, gas, inertia, whole torque) at evenly spread angles of one cycle."""
        checked_whole(points, "points", 1, 100_000, "720 is usual")
        angles = [self.cycle * i / points for i in range(points)]
        parts = ((a, self.gas(a), self.inertia(a)) for a in angles)
        return [(a * 180 / pi, gas, inertia, gas + inertia) for a, gas, inertia in parts]

    @cached_property
    def fluctuation(self) -> Fluctuation:
        """The swing of the torque and of its energy, their extremes narrowed to 1e-9 of a grid's step."""
        least, largest = extremes(self.at, self.cycle)
        low, high = extremes(self.energy, self.cycle)
        return Fluctuation(self.mean, least, largest, high - low, self.work)

    def flywheel(self, delta: object) -> float:
        """Return the moment of inertia J in kg m^2 that keeps the speed's fluctuation at `delta`."""
        return flywheel_inertia(self.fluctuation.energy, self.omega, delta)

    def speed_fluctuation(self, inertia: object) -> float:
        """Return delta = (omega_max - omega_min)/omega for a moment of inertia in kg m^2."""
        return speed_fluctuation(self.fluctuation.energy, self.omega, inertia)

    def at_speed(self, rpm: object) -> CrankTorque:
        """Return the same engine with the same trace at another speed."""
        return replace(self, omega=_omega(rpm))

    def terms(self, order: int = 6) -> tuple[tuple[Fraction, Real, Real], ...]:
        """Return (order, C, S) of the whole torque in N m, halves included, without the mean."""
        ratio = self.cylinder.ratio
        gas = gas_torque(
            self.layout, self.cylinder.trace, order, ratio=ratio, ambient=self.cylinder.ambient
        )
        total = {s: mp.mpc(c, i) * self._gas_unit for s, c, i in gas.terms()}
        lead = -self.tops[0] - 2 * pi * float(self.layout.cylinders[0].delay.turns)
        assert abs(sin(lead / 2)) < 1e-9  # both parts count theta alike
        for s, c, i in inertia_torque(self.layout, order).terms(ratio, 20):
            total[s] = total.get(s, mp.mpc(0)) + mp.mpc(c, i) * self._inertia_unit
        return tuple((s, total[s].real, total[s].imag) for s in sorted(total))


def crank_torque(
    layout: Layout,
    trace: PressureTrace,
    *,
    bore: object,
    rpm: object,
    stroke: object = None,
    reciprocating_mass: object = None,
    ratio: object = None,
    ambient: object = AMBIENT,
) -> CrankTorque:
    """Return the torque of a running engine: bore and stroke in mm, mass in kg, rpm, ambient in bar.

    Stroke, reciprocating mass (per cylinder) and rod ratio default to the layout's crank train.

    >>> from symbalance.catalogue import load
    >>> from symbalance.torque.ideal import ideal_cycle
    >>> trace = ideal_cycle(10, heat=20).trace(4)
    >>> four = crank_torque(load("inline-4"), trace, bore=80, stroke=80, reciprocating_mass=0.5, rpm=3000)
    >>> round(four.mean, 1), round(four.work, 1), round(four.fluctuation.of_torque, 2)
    (141.6, 1780.0, 2.78)
    """
    cylinder = tangential_pressure(layout, trace, ratio=ratio, ambient=ambient)
    train, unit = shared_sizes(layout), Fraction(1, 1000)
    length = _given(stroke, train.stroke, "stroke", "mm") * unit
    mass = _given(reciprocating_mass, train.reciprocating_mass, "reciprocating_mass", "kg")
    width = positive(bore, "bore") / 1000
    tops = tuple(float(top) * pi / 180 for top in firing_tops(layout).values())
    area = pi * width**2 / 4
    return CrankTorque(layout, cylinder, area, float(length / 2), float(mass), _omega(rpm), tops)


def _given(value: object, known: Fraction | None, name: str, unit: str) -> Fraction:
    if value is None and known is None:
        rule, remedy = "is needed, and the engine does not give it", f"give {name}, in {unit}"
        raise SymbalanceError(name, rule, remedy)
    number = measured(known if value is None else value, name)
    if number < 0 or (number == 0 and name == "stroke"):
        raise SymbalanceError(f"{name} = {shown(value)}", "must be positive", f"in {unit}")
    return number


def _omega(rpm: object) -> float:
    return positive(rpm, "rpm") * pi / 30
