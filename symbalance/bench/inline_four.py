"""An in-line four on journal bearings as a periodic system: crank, loads, films, housings. SI units."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np

from symbalance.crankshaft.arrays import DOF, Array
from symbalance.crankshaft.assembly import assemble
from symbalance.crankshaft.bearings.film_tables import trigonometric_film
from symbalance.crankshaft.bearings.orbits import journal_orbit
from symbalance.crankshaft.bearings.short_film import Bearing
from symbalance.crankshaft.crank import Crank, Journal, Part, Pin, Web, WebCounterweight
from symbalance.crankshaft.frames import rotation
from symbalance.crankshaft.rotor.matrices import Rotor
from symbalance.crankshaft.rotor.parts import Disc
from symbalance.crankshaft.rotor.rigid_body_mode import deflated, spin_motion
from symbalance.crankshaft.system import Film, Housing, PeriodicSystem

CYCLE = 4 * np.pi
ANGLES = 720
BEARING = Bearing(diameter=0.065, length=0.03, clearance=35e-6, viscosity=0.012)
FIRING = (0.0, 3 * np.pi, np.pi, 2 * np.pi)
THROWS = (0.0, np.pi, np.pi, 0.0)
SMOOTHING = 3.0
"""Degrees over which the films' tables are averaged, by a bell curve, so that they stay positive: sharper
peaks only make every reference dearer."""
THRUST, COUPLING = (1e8, 1e3), (1e4, 50.0)
"""What holds the middle journal lengthwise (N/m, N s/m), the flywheel's turning (N m, N m s per rad)."""
GAS, PISTON, RATIO = 3e4, 1.0, 0.25
"""Peak gas force in N, reciprocating mass in kg, rod ratio r/l."""


@dataclass(frozen=True)
class Case:
    """What differs from one case to the next; `housing` in N/m, 0: films on the ground."""

    name: str
    rpm: float = 2200.0
    housing: float = 5e8
    film: float = 1.0
    damping: float = 2e-6


@cache
def crank() -> Crank:
    """Return the crank: throw 60 mm, journals 65 mm, pins 55 mm, pitch 110 mm, eight counterweights."""
    parts: list[Part] = [Journal(0.065, 0.03)]
    for number, angle in enumerate(THROWS, 1):
        web = Web(0.02, 0.09, 0.04, 0.045, WebCounterweight(0.9, 0.05, angle + np.pi))
        parts += [web, Pin(0.055, 0.034, 0.06, angle, (number,)), web, Journal(0.065, 0.036)]
    pulley, flywheel = Disc(3.0, 0.01, 0.006, 0.05), Disc(32.0, 0.65, 0.35, 0.03)
    return Crank(tuple(parts), pulley=pulley, flywheel=flywheel)


@cache
def full_system(case: Case) -> PeriodicSystem:
    """Return the whole crank on its bearings in a case."""
    rotor, omega = assemble(crank(), damping_time=case.damping), case.rpm * np.pi / 30
    stiffness, damping, points = _turning_matrices(rotor, omega)
    film = _film(case.rpm, case.film)
    housings = None
    if case.housing:
        spring = np.array([np.diag([case.housing, 0.7 * case.housing])] * len(points))
        housings = Housing(spring, np.array([np.diag([2e4, 2e4])] * len(points)))
    loads = Loads(rotor, omega)
    return PeriodicSystem(rotor.mass, damping, stiffness, points, film, housings, loads, omega, CYCLE)


def spin() -> Array:
    """Return the crank's turning as a whole, (n,): large, of no interest, taken out of errors."""
    return spin_motion(assemble(crank()).points)


def _turning_matrices(rotor: Rotor, omega: float) -> tuple[Array, Array, Array]:
    """Return stiffness and damping of the turning crank, thrust and coupling in, its bearings' rows."""
    turning = deflated(rotor.centrifugal, rotor.mass, spin_motion(rotor.points))
    stiffness = rotor.stiffness + omega**2 * turning
    damping = rotor.damping + omega * rotor.gyroscopic
    thrust, turn = DOF * rotor.journals[2] + 2, DOF * (rotor.flywheel or 0) + 5
    for unknown, (spring, damper) in ((thrust, THRUST), (turn, COUPLING)):
        stiffness[unknown, unknown] += spring
        damping[unknown, unknown] += damper
    points = np.zeros((len(rotor.journals), 2, rotor.size))
    for j, node in enumerate(rotor.journals):
        points[j, :, DOF * node : DOF * node + 2] = np.eye(2)
    return stiffness, damping, points


@dataclass(frozen=True)
class Loads:
    """Gas, piston and centrifugal forces in turning axes; called with angles (s,), gives (s, n)."""

    rotor: Rotor
    omega: float

    def __call__(self, theta: Array) -> Array:
        """Return the forces at angles (s,)."""
        force = np.tile(self.omega**2 * self.rotor.centrifugal_force, (len(theta), 1))
        for node, fires, throw in zip(self.rotor.pins, FIRING, THROWS, strict=True):
            x = theta - fires
            gas = GAS * np.exp(10 * (np.cos(x / 2 - 0.1) - 1))
            inertia = PISTON * 0.06 * self.omega**2 * (np.cos(x) + RATIO * np.cos(2 * x))
            axial, lean = inertia - gas, RATIO * np.sin(x)
            radial = axial * (np.cos(x) - lean * np.sin(x))
            tangential = -axial * (np.sin(x) + lean * np.cos(x))
            force[:, DOF * node] += radial * np.cos(throw) - tangential * np.sin(throw)
            force[:, DOF * node + 1] += radial * np.sin(throw) + tangential * np.cos(throw)
        return force


def film_tables(rpm: float, angles: int = ANGLES) -> tuple[Array, Array]:
    """Return stiffness and damping (s, b, 2, 2) of the films along the orbits, as they are."""
    rotor, omega = assemble(crank()), rpm * np.pi / 30
    theta = CYCLE / angles * np.arange(angles)
    stiffness, _, points = _turning_matrices(rotor, omega)
    loads = bearing_loads(stiffness, points, Loads(rotor, omega)(theta), theta, 5e8)
    orbit = journal_orbit([BEARING] * len(points), loads, omega, CYCLE)
    return orbit.stiffness, orbit.damping


def bearing_loads(stiffness: Array, points: Array, force: Array, theta: Array, support: float) -> Array:
    """Return the shaft's forces on its bearings (s, b, 2) in N, stationary axes, without inertia.

    The crank's `stiffness` (n, n), centrifugal part included, rests on equal springs `support` (N/m) at
    `points` (b, 2, n) under `force` (s, n) at angles (s,), all in turning axes: statically indeterminate,
    so that stiffer supports give the bearings next to a throw more of its load.
    """
    rows = points.reshape(-1, points.shape[-1])
    supported = stiffness + support * rows.T @ rows
    place = np.linalg.solve(supported, np.ascontiguousarray(force.T))
    turning = (support * rows @ place).T.reshape(len(theta), -1, 2)
    return (rotation(theta)[:, None] @ turning[..., None])[..., 0]


@cache
def _film(rpm: float, factor: float) -> Film:
    stiffness, damping = film_tables(rpm)
    return trigonometric_film(factor * smooth(stiffness), factor * smooth(damping), CYCLE)


def smooth(table: Array, degrees: float = SMOOTHING, keep: int = 160) -> Array:
    """Return a periodic table (s, ...) averaged by a bell curve of that standard deviation."""
    parts = np.fft.rfft(table, axis=0)
    orders = np.arange(len(parts))
    bell = np.exp(-((orders * np.radians(degrees) * 2 * np.pi / CYCLE) ** 2) / 2) * (orders <= keep)
    return np.fft.irfft(parts * bell.reshape(-1, *[1] * (table.ndim - 1)), len(table), axis=0)
