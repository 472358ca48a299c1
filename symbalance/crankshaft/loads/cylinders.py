"""The force of every rod on its crank pin, in its cylinder's frame and in turning coordinates."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import pi

import numpy as np

from symbalance.crankshaft.arrays import Array
from symbalance.crankshaft.files import RunningEngine
from symbalance.crankshaft.loads.motion import Complex, PistonMotion, link_arm, piston_motion
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.kinematics.mechanisms import LinkRod, Mechanism
from symbalance.kinematics.piston_motion import Piston
from symbalance.torque import PressureTrace, firing_pin_passings
from symbalance.torque.running import PASCAL

MILLI = 1e-3


@dataclass(frozen=True)
class RodForces:
    """The rods' forces of an engine at a speed `omega` (rad/s), as functions of the crank angle.

    Arrays of crank angles theta (s,) in radians give complex arrays (s,): N, in turning coordinates
    along U + i V. `parts` switches gas and inertia on: both by default.
    """

    engine: RunningEngine
    omega: float
    parts: tuple[str, ...] = ("gas", "inertia")

    def at(self, number: int, theta: Array) -> Complex:
        """Return the force of a cylinder's rod on the crank pin, a link rod's through its master."""
        return self.own(number, theta) * np.exp(1j * (self._bank(number) - theta))

    def own(self, number: int, theta: Array) -> Complex:
        """Return that force in the cylinder's own frame: height + i lateral, N.

        A master's holds the lateral force that balances its link rods' moments about the crank pin; the
        link rods have forces of their own.
        """
        cylinder, motion_ = self._cylinders[number], self._motion(number, theta)
        axial = self.axial(number, theta)
        excess = self.engine.operation.excess * self.omega**2 * motion_.angle_acceleration
        moment = excess + sum(self._link_moment(link, theta) for link in self._links(cylinder))
        across = moment / (self._length(number) * np.cos(motion_.angle))
        return axial - 1j * (axial * np.tan(motion_.angle) + across)

    def axial(self, number: int, theta: Array) -> Array:
        """Return F, the piston's load along its axis, away from the crank: gas and inertia, N."""
        total = np.zeros_like(np.asarray(theta, dtype=float))
        if "gas" in self.parts:
            after, run = theta - self._firing_angles[number], self.engine.operation
            bar = pressures(self._traces[number], after) - run.ambient
            total = total - bar * PASCAL * run.area
        if "inertia" in self.parts:
            unit = self._mass(number) * self._radius(number) * self.omega**2
            total = total - unit * self._motion(number, theta).acceleration
        return total

    def side_thrust(self, number: int, theta: Array) -> Array:
        """Return the force on the cylinder's wall, + lateral, N: minus the lateral part of `own`."""
        return -self.own(number, theta).imag

    def torque(self, theta: Array) -> Array:
        """Return the torque of all rods on the crank, + in the sense of rotation, N m."""
        arms = {pin: p for p in self.engine.crank.pins for pin in p.cylinders}
        return sum(
            (
                arms[n].radius * (np.exp(-1j * arms[n].angle) * self.at(n, theta)).imag
                for n in self._cylinders
            ),
            np.zeros_like(theta),
        )

    @cached_property
    def _cylinders(self) -> dict[int, Cylinder]:
        return {c.number: c for c in self.engine.layout.cylinders}

    @cached_property
    def _mechanisms(self) -> dict[int, Mechanism]:
        return {n: c.known_mechanism for n, c in self._cylinders.items()}

    @cached_property
    def _firing_angles(self) -> dict[int, float]:
        return firing_crank_angles(self.engine.layout)

    @cached_property
    def _traces(self) -> dict[int, PressureTrace]:
        run = self.engine.operation
        if run.ideal is None:
            return dict.fromkeys(self._mechanisms, run.trace)
        traces = {self._mechanisms[self.engine.layout.first.number]: run.trace}
        traces |= {m: run.ideal.trace(m) for m in set(self._mechanisms.values()) - traces.keys()}
        return {n: traces[m] for n, m in self._mechanisms.items()}

    def _motion(self, number: int, theta: Array) -> PistonMotion:
        delay = 2 * pi * float(self._cylinders[number].delay.turns)
        return piston_motion(self._mechanisms[number], theta + delay)

    def _bank(self, number: int) -> float:
        return 2 * pi * float(self._cylinders[number].bank.turns)

    def _mass(self, number: int) -> float:
        return float(self._cylinders[number].reciprocating_mass or 0)

    def _radius(self, number: int) -> float:
        """Return the crank radius in m; a link rod's is its master's."""
        return float(self._cylinders[number].radius or 0) * MILLI

    def _length(self, number: int) -> float:
        """Return a rod's length in m."""
        return float(self._mechanisms[number].length) * self._radius(number)

    def _links(self, master: Cylinder) -> list[Cylinder]:
        cylinders = self._cylinders.values()
        return [c for c in cylinders if c.link is not None and c.link.master == master.number]

    def _link_moment(self, cylinder: Cylinder, theta: Array) -> Array:
        """Return a link rod's moment about the crank pin, + in the sense of rotation, N m."""
        link = self._mechanisms[cylinder.number]
        assert isinstance(link, LinkRod)
        master = cylinder.link.master if cylinder.link else 0
        angle = self._motion(master, theta).angle
        arm = link_arm(link) * np.exp(-1j * angle) * self._radius(cylinder.number)
        return (np.conj(arm) * self.own(cylinder.number, theta)).imag


def firing_crank_angles(layout: Engine) -> dict[int, float]:
    """Return theta at every piston's own firing top dead centre, in radians, 0 to under a cycle.

    >>> from symbalance.engine.catalogue import load
    >>> [round(float(np.degrees(top)), 3) for top in firing_crank_angles(load("vw-vr6")).values()]
    [0.071, 240.071, 120.071, 479.929, 599.929, 359.929]
    """
    passes, cycle = firing_pin_passings(layout), layout.strokes * pi
    pistons = {c.number: Piston(c.known_mechanism) for c in layout.cylinders}
    return {n: (float(passes[n]) * pi / 180 + p.top) % cycle for n, p in pistons.items()}


def rod_forces(engine: RunningEngine, omega: float) -> RodForces:
    """Return the rods' forces of an engine at a speed in rad/s."""
    return RodForces(engine, omega)


def pressures(trace: PressureTrace, angles: Array) -> Array:
    """Return the pressures in bar at angles (radians) after the firing top dead centre.

    Straight lines between the points; at a jump the value behind it, as `PressureTrace.at`.

    >>> trace = PressureTrace((0.0, 180.0, 360.0, 540.0), (3.0, 1.0, 1.0, 1.0))
    >>> pressures(trace, np.radians([90.0, 630.0, -90.0])).tolist()
    [2.0, 2.0, 2.0]
    """
    points, values = np.array(trace.radians), np.array(trace.closed)
    cycle = points[-1] - points[0]
    places = points[0] + np.mod(angles - points[0], cycle)
    i = np.clip(np.searchsorted(points, places, side="right") - 1, 0, len(points) - 2)
    width = points[i + 1] - points[i]
    share = np.where(width > 0, (places - points[i]) / np.where(width > 0, width, 1.0), 0.0)
    return values[i] + share * (values[i + 1] - values[i])
