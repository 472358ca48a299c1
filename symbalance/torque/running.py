"""Torque of a running engine against the crank angle, its fluctuation and its flywheel.

With v^ = v/(r omega) and the rod's angle phi at each cylinder's own angle,

    T(theta) = sum of A r (p - p_ambient) v^ - m r^2 omega^2 v^ dv^/dtheta - J_x omega^2 phi' phi'':

the inertia part is the closed form, all orders at once. Every cylinder has its own mechanism, mass and
radius, and all have one bore. The frame's moment is that of `roll`.
The mean is the gas's alone: indicated, without friction. The inertia part is that of constant omega, its
change with the speed's own swing left out: of the size of delta times that part.

Formulas:
    -w dw/dtheta = t_1 sin theta + t_2 sin 2 theta + t_3 sin 3 theta + t_4 sin 4 theta + ...
    with w = v/(r omega)
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from math import pi
from typing import TYPE_CHECKING, Any, ClassVar

from symbalance.document.result import Result
from symbalance.engine.engine import Engine, checked_engine
from symbalance.errors import SymbalanceError, brief
from symbalance.forces.shaft_moments import shaft_terms
from symbalance.kinematics.slider_crank import checked_order
from symbalance.text.measurements import measurement, positive_float
from symbalance.text.numbers import checked_whole
from symbalance.text.reals import Complex, Real
from symbalance.torque.body_groups import has_common_torque
from symbalance.torque.cylinder_gas import AMBIENT, TangentialPressure
from symbalance.torque.flywheel import (
    Fluctuation,
    checked_delta,
    flywheel_inertia,
    least_and_largest,
    speed_fluctuation,
)
from symbalance.torque.gas import GasGroup, gas_groups
from symbalance.torque.ideal_cycles import IdealCycle
from symbalance.torque.inertia_balance import MILLI, first_excess, inertia_torque
from symbalance.torque.pressure import PressureTrace
from symbalance.torque.roll import rod_torque
from symbalance.torque.star_diagrams import firing_pin_passings

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

PASCAL = 100_000
"""A bar, in Pa."""
HIGHEST = 12
"""The highest order that is printed, unless another is given."""
DELTA = 0.02
"""A usual speed fluctuation."""
RPM = 60 / (2 * pi)
"""Revolutions a minute in a radian a second."""


@dataclass(frozen=True)
class RunningCylinder:
    """One cylinder of a running engine, SI: `firing_angle` in rad, `excess` its rod's J_x."""

    tangential: TangentialPressure
    firing_angle: float
    radius: float
    mass: float
    excess: float = 0.0

    def gas(self, theta: float) -> float:
        """Return the gas torque over the piston's area, in N m/m^2."""
        return self.radius * PASCAL * self.tangential.at(theta - self.firing_angle)

    def inertia(self, theta: float) -> float:
        """Return the inertia torque over omega^2, the rod's part included."""
        piston, a = self.tangential.piston, theta - self.firing_angle
        torque = -self.mass * self.radius**2 * piston.velocity(a) * piston.acceleration(a)
        if self.excess:
            rate, change = piston.rod_rates(a)
            torque -= self.excess * rate * change
        return torque

    def kinetic(self, theta: float) -> float:
        """Return the kinetic energy over omega^2/2 that comes and goes."""
        piston, a = self.tangential.piston, theta - self.firing_angle
        moving = self.mass * (self.radius * piston.velocity(a)) ** 2
        return moving + (self.excess * piston.rod_rates(a)[0] ** 2 if self.excess else 0.0)

    def beside(self, theta: float) -> float:
        """Return over omega^2 what the frame gets besides the torque's opposite: offset, and the rod."""
        piston, a = self.tangential.piston, theta - self.firing_angle
        offset, moment = float(piston.mechanism.offset), 0.0
        if offset:
            moment = -offset * self.mass * self.radius**2 * piston.acceleration(a)
        return moment + (self.excess * piston.rod_rates(a)[1] if self.excess else 0.0)


@dataclass(frozen=True, repr=False)
class RunningTorque(Result):
    """A running engine's torque on its crank, SI: `area` of one piston in m^2, `omega` in rad/s.

    `pressure` is the trace or the cycle of every cylinder. `highest` is the highest order that is
    printed, `delta` the speed fluctuation that the flywheel is printed for.
    """

    engine: Engine
    cylinders: tuple[RunningCylinder, ...]
    area: float
    omega: float
    pressure: PressureTrace | IdealCycle
    highest: int = HIGHEST
    delta: float = DELTA

    kind: ClassVar[str] = "running-torque"

    def summary(self) -> str:
        """Return the mean torque, its extremes and the power, in one line."""
        swing = self.fluctuation
        return (
            f"Running torque of {self.engine.name} at {self.rpm:.6g} rpm: mean {self.mean:.6g} N m, "
            f"from {swing.least:.6g} to {swing.largest:.6g} N m; {self.power / 1000:.6g} kW"
        )

    def document(self) -> Document:
        """Return the mean, the swing, the flywheel and the orders, then what the engine runs with."""
        from symbalance.torque.running_document import running_document

        return running_document(self)

    def data(self) -> dict[str, Any]:
        """Return the same numbers: torque in N m, power in W, energy in J, flywheel in kg m^2."""
        swing = self.fluctuation
        return {
            "engine": self.engine.name,
            "strokes": self.engine.strokes,
            "rpm": round(self.rpm, 9),
            "bore_mm": self.bore * MILLI,
            "ambient_bar": self.cylinder.ambient,
            "pressure": self.pressure.summary(),
            "cylinders": [
                {
                    "number": cylinder.number,
                    "top_degrees": own.firing_angle * 180 / pi,
                    "stroke_mm": 2 * MILLI * own.radius,
                    "reciprocating_mass_kg": own.mass,
                    "rod_excess_kg_m2": own.excess,
                    "ratio": str(own.tangential.ratio),
                }
                for cylinder, own in zip(self.engine.cylinders, self.cylinders, strict=True)
            ],
            "mean": self.mean,
            "power": self.power,
            "highest": swing.largest,
            "lowest": swing.least,
            "energy": swing.energy,
            "delta": self.delta,
            "flywheel": self.flywheel(),
            "highest_order": self.highest,
            "orders": [
                {"order": str(n), "cos": float(cos), "sin": float(sin)} for n, cos, sin in self.terms()
            ],
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each order of the whole torque, in N m, without the mean.

        Keys: order, of, cos, sin, amplitude, unit.
        """
        return [
            {
                "order": float(n),
                "of": "whole torque on the crank",
                "cos": float(cos),
                "sin": float(sin),
                "amplitude": math.hypot(cos, sin),
                "unit": "N m",
            }
            for n, cos, sin in self.terms()
        ]

    @property
    def rpm(self) -> float:
        """The speed, in revolutions a minute."""
        return self.omega * RPM

    @property
    def bore(self) -> float:
        """The bore, in m."""
        return 2 * math.sqrt(self.area / pi)

    @cached_property
    def first(self) -> RunningCylinder:
        """Cylinder 1."""
        return self.cylinders[self.engine.cylinders.index(self.engine.first)]

    @property
    def cylinder(self) -> TangentialPressure:
        """The tangential pressure of the first cylinder."""
        return self.first.tangential

    @property
    def ratio(self) -> Fraction:
        """The first cylinder's rod ratio lambda = l/r."""
        return self.cylinder.ratio

    @property
    def radius(self) -> float:
        """The first cylinder's crank radius, in m."""
        return self.first.radius

    @property
    def mass(self) -> float:
        """The first cylinder's reciprocating mass, in kg."""
        return self.first.mass

    @property
    def firing_angles(self) -> tuple[float, ...]:
        """The cylinders' firing top dead centres, in radians."""
        return tuple(c.firing_angle for c in self.cylinders)

    @property
    def cycle(self) -> float:
        """The crank angle of a cycle, in radians."""
        return self.cylinder.trace.cycle * pi / 180

    def gas(self, theta: float) -> float:
        """Return the gas torque at a crank angle (radians), in N m."""
        return self.area * sum(c.gas(theta) for c in self.cylinders)

    def inertia(self, theta: float) -> float:
        """Return the inertia torque at a crank angle (radians), in N m, the rods' own included."""
        return self.omega**2 * sum(c.inertia(theta) for c in self.cylinders)

    def at(self, theta: float) -> float:
        """Return the whole torque at a crank angle (radians), in N m: + in the sense of rotation."""
        return self.gas(theta) + self.inertia(theta)

    def frame(self, theta: float) -> float:
        """Return the moment on the frame at a crank angle: the opposite, and what `roll` adds to it."""
        aside = sum(c.beside(theta) for c in self.cylinders) + self.mass * self.radius**2 * sum(
            c * math.cos(n * theta) + s * math.sin(n * theta) for n, c, s in self.shafts
        )
        return self.omega**2 * aside - self.at(theta)

    @cached_property
    def shafts(self) -> tuple[tuple[int, float, float], ...]:
        """The balance shafts' roll moment, (n, C, S) in m r^2 omega^2."""
        fastest = max((abs(shaft.speed) for shaft in self.engine.balancers.shafts), default=0)
        return tuple((n, float(c), float(s)) for n, c, s in shaft_terms(self.engine, fastest))

    @property
    def mean(self) -> float:
        """The mean torque: the gas's, indicated, in N m."""
        return self.work / self.cycle

    @property
    def work(self) -> float:
        """The work of all cylinders in one cycle, in J."""
        return self.area * PASCAL * sum(c.radius * c.tangential.cycle_work for c in self.cylinders)

    @property
    def power(self) -> float:
        """The indicated power, in W."""
        return self.mean * self.omega

    def energy(self, theta: float) -> float:
        """Return the integral of T - mean up to a crank angle (radians), in J, to a constant."""
        worked = sum(c.radius * c.tangential.work(theta - c.firing_angle) for c in self.cylinders)
        moving = sum(c.kinetic(theta) for c in self.cylinders)
        return self.area * PASCAL * worked - self.omega**2 * moving / 2 - self.mean * theta

    def curve(self, points: int = 720) -> list[tuple[float, float, float, float]]:
        """Return (degrees, gas, inertia, whole torque) at evenly spread angles of one cycle."""
        checked_whole(points, "points", 1, 100_000, "720 is usual")
        angles = [self.cycle * i / points for i in range(points)]
        parts = ((a, self.gas(a), self.inertia(a)) for a in angles)
        return [(a * 180 / pi, gas, inertia, gas + inertia) for a, gas, inertia in parts]

    @cached_property
    def fluctuation(self) -> Fluctuation:
        """The swing of the torque and of its energy, their extremes narrowed to 1e-9 of a grid's step."""
        least, largest = least_and_largest(self.at, self.cycle)
        low, high = least_and_largest(self.energy, self.cycle)
        return Fluctuation(self.mean, least, largest, high - low, self.work)

    def flywheel(self, delta: object = None) -> float:
        """Return the moment of inertia J in kg m^2 that keeps the speed's fluctuation at `delta`.

        Without one it is the result's own.
        """
        limit = self.delta if delta is None else delta
        return flywheel_inertia(self.fluctuation.energy, self.omega, limit)

    def speed_fluctuation(self, inertia: object) -> float:
        """Return delta = (omega_max - omega_min)/omega for a moment of inertia in kg m^2."""
        return speed_fluctuation(self.fluctuation.energy, self.omega, inertia)

    def at_speed(self, rpm: object) -> RunningTorque:
        """Return the same engine with the same trace at another speed."""
        return replace(self, omega=_omega(rpm))

    def terms(self, order: int | None = None) -> tuple[tuple[Fraction, Real, Real], ...]:
        """Return (order, C, S) of the whole torque in N m, halves included, without the mean.

        Without an order they go to `highest`, as do those of gas and inertia.
        """
        total: dict[Fraction, Complex] = {}
        for part in (self.gas_terms(order), self.inertia_terms(order)):
            for n, cos, sin in part:
                total[n] = total.get(n, Complex(0)) + Complex(cos, sin)
        return tuple((n, total[n].real, total[n].imag) for n in sorted(total))

    def gas_terms(self, order: int | None = None) -> tuple[tuple[Fraction, Real, Real], ...]:
        """Return (order, C, S) of the gas torque in N m, without the mean."""
        order = self.highest if order is None else order
        unit, groups = self.area * self.radius * PASCAL, self._groups
        sums: dict[Fraction, complex] = {}
        for group in groups:
            for n, number in group.numbers(self.engine.strokes, order).items():
                sums[n] = sums.get(n, 0j) + number * unit
        return tuple((n, Real(sums[n].real), Real(sums[n].imag)) for n in sorted(sums))

    @cached_property
    def _groups(self) -> tuple[GasGroup, ...]:
        """The cylinders by what their gas does, as `gas_torque` has them."""
        nominal, members = firing_pin_passings(self.engine), {}
        for cylinder, own in zip(self.engine.cylinders, self.cylinders, strict=True):
            key = (id(own.tangential), own.radius)
            members.setdefault(key, (own, {}))[1][cylinder.number] = nominal[cylinder.number]
        return tuple(
            GasGroup(own.tangential, firing_angles, own.radius / self.radius)
            for own, firing_angles in members.values()
        )

    def inertia_terms(self, order: int | None = None) -> tuple[tuple[Fraction, Real, Real], ...]:
        """Return (order, C, S) of the inertia torque in N m, the rods' own included."""
        order = self.highest if order is None else order
        unit, rods = self.mass * (self.radius * self.omega) ** 2, float(first_excess(self.engine))
        total: dict[Fraction, Complex] = {}
        parts = [(inertia_torque(self.engine, order), unit)]
        parts += [(rod_torque(self.engine, order), rods / MILLI**2 * self.omega**2)] if rods else []
        for balance, scale in parts:
            for n, cos, sin in balance.terms(digits=20):
                total[n] = total.get(n, Complex(0)) + Complex(cos, sin) * scale
        return tuple((n, total[n].real, total[n].imag) for n in sorted(total))


def running_torque(
    engine: Engine,
    trace: PressureTrace | IdealCycle,
    *,
    rpm: object,
    bore: object = None,
    stroke: object = None,
    reciprocating_mass: object = None,
    ratio: object = None,
    ambient: object = AMBIENT,
    order: int = HIGHEST,
    delta: object = DELTA,
) -> RunningTorque:
    """Return the torque of a running engine: bore and stroke in mm, mass in kg, rpm, ambient in bar.

    Bore, stroke, reciprocating mass (per cylinder) and rod ratio default to the engine's; where
    that gives them, they cannot be given anew for cylinders that are not alike. `order` is the highest
    order that is printed, `delta` the speed fluctuation that the flywheel is printed for.

    >>> from symbalance.engine.catalogue import load
    >>> from symbalance.torque.ideal_cycles import ideal_cycle
    >>> trace = ideal_cycle(10, heat=20).trace(4)
    >>> sizes = {"bore": 80, "stroke": 80, "reciprocating_mass": 0.5}
    >>> four = running_torque(load("inline-4"), trace, rpm=3000, **sizes)
    >>> round(four.mean, 1), round(four.work, 1), round(four.fluctuation.of_torque, 2)
    (141.6, 1780.0, 2.78)
    """
    order, fluctuation = checked_order(order), checked_delta(delta)
    if not has_common_torque(checked_engine(engine)):
        _check_own(engine, stroke=stroke, reciprocating_mass=reciprocating_mass, ratio=ratio)
    engine = engine if ratio is None else engine.with_ratio(ratio)
    groups = gas_groups(engine, trace, ambient=ambient)
    width = _bore(bore, engine) / MILLI
    tangential = {number: group.tangential for group in groups for number in group.firing_angles}
    firing_angles, cylinders = firing_pin_passings(engine), []
    for cylinder in engine.cylinders:
        own = tangential[cylinder.number]
        length = _argument_or_known(stroke, cylinder.stroke, "stroke", "mm")
        known = cylinder.reciprocating_mass
        mass = float(_argument_or_known(reciprocating_mass, known, "reciprocating_mass", "kg"))
        firing_angle = float(firing_angles[cylinder.number]) * pi / 180 + own.piston.top
        excess = float(cylinder.excess) / MILLI**2
        cylinders.append(RunningCylinder(own, firing_angle, float(length) / (2 * MILLI), mass, excess))
    area, omega = pi * width**2 / 4, _omega(rpm)
    return RunningTorque(engine, tuple(cylinders), area, omega, trace, order, fluctuation)


def _check_own(engine: Engine, **arguments: object) -> None:
    for name, value in arguments.items():
        if value is not None and any(getattr(c, name) is not None for c in engine.cylinders):
            rule = f"cannot be set for all cylinders of {engine.name}, which are not alike"
            raise SymbalanceError(f"{name} = {brief(value)}", rule, "give it in the engine file")


def _argument_or_known(value: object, known: Fraction | None, name: str, unit: str) -> Fraction:
    if value is None and known is None:
        rule, remedy = "is needed, and the engine does not give it", f"give {name}, in {unit}"
        raise SymbalanceError(name, rule, remedy)
    number = measurement(known if value is None else value, name)
    if number < 0 or (number == 0 and name == "stroke"):
        raise SymbalanceError(f"{name} = {brief(value)}", "must be positive", f"in {unit}")
    return number


def _bore(bore: object, engine: Engine) -> float:
    known = engine.bore if bore is None else bore
    if known is None:
        raise SymbalanceError("bore", "is needed, and the engine does not give it", "give bore, in mm")
    return positive_float(known, "bore")


def _omega(rpm: object) -> float:
    return positive_float(rpm, "rpm") * pi / 30
