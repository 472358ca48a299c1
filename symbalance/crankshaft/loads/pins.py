"""Forces and moments of the rods at the middles of the crank pins, in turning coordinates."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.crank import Pin
from symbalance.crankshaft.files import RunningEngine
from symbalance.crankshaft.loads.cylinders import RodForces
from symbalance.crankshaft.loads.motion import Complex

MILLI = 1e-3


@dataclass(frozen=True)
class PinLoads:
    """F_C of an engine at a speed: the forces and moments on every pin's middle.

    A rod beside the middle of its pin brings the moment of its force about it; `shifts` are those
    distances along W in m, by cylinder.
    """

    rods: RodForces
    shifts: dict[int, float]

    @property
    def cycle(self) -> float:
        """The crank angle after which the loads repeat, in radians: 2 pi or 4 pi."""
        return self.rods.engine.layout.strokes * np.pi

    def at(self, theta: Array) -> Array:
        """Return (s, pins, 6): F_u, F_v, F_w, N_u, N_v, N_w at angles (s,), N and N m."""
        pins = self.rods.engine.crank.pins
        loads = np.zeros((len(theta), len(pins), DOF))
        for place, pin in enumerate(pins):
            for number in pin.cylinders:
                force = self.rods.at(number, theta)
                loads[:, place, 0] += force.real
                loads[:, place, 1] += force.imag
                loads[:, place, 3] -= self.shifts[number] * force.imag
                loads[:, place, 4] += self.shifts[number] * force.real
        return loads

    def harmonics(self, order: int, points: int = 4096) -> Complex:
        """Return (k + 1, pins, 6), the two-sided coefficients c of sum c e^(i s theta) of each load.

        Order s = k/2 in a four-stroke (k in a two-stroke), to `order`; the loads at `points` angles of a
        cycle, transformed, so that orders near points/4 carry what lies above.
        """
        theta = self.cycle * np.arange(points) / points
        spectrum = np.fft.rfft(self.at(theta), axis=0) / points
        return spectrum[: order * self.rods.engine.layout.strokes // 2 + 1]

    @property
    def mean_torque(self) -> float:
        """The mean torque of all rods about W, N m: the gas's, for the load to take."""
        theta = self.cycle * np.arange(2880) / 2880
        return float(self.rods.torque(theta).mean())


def pin_loads(engine: RunningEngine, omega: float, *parts: str) -> PinLoads:
    """Return the loads at a speed in rad/s: of gas and inertia, or of the `parts` named."""
    rods = RodForces(engine, omega, parts) if parts else RodForces(engine, omega)
    return PinLoads(rods, _shifts(engine))


def big_end_masses(engine: RunningEngine) -> list[float]:
    """Return the rods' rotating mass on every pin, kg: for the rotor's nodes, and not for `pin_loads`."""
    return [engine.operation.big_end_mass * len(pin.cylinders) for pin in engine.crank.pins]


def _shifts(engine: RunningEngine) -> dict[int, float]:
    """Return how far behind its pin's middle each cylinder stands, in m."""
    pitch = float(engine.layout.pitch or 0) * MILLI
    stations = {c.number: float(c.station) for c in engine.layout.cylinders}

    def of(pin: Pin) -> dict[int, float]:
        mean = sum(stations[n] for n in pin.cylinders) / len(pin.cylinders)
        return {n: (mean - stations[n]) * pitch for n in pin.cylinders}

    return {n: shift for pin in engine.crank.pins for n, shift in of(pin).items()}
