"""Where crank pins, rods and pistons of an engine stand at a crank angle: what drawings are drawn from.

In floats, since a drawing has pixels. Points are complex numbers, up + i right, seen from the front; the
crank turns clockwise, so that a pin of throw t stands at r e^(i (theta + t)). A rod of length l from a
pin w meets the cylinder's axis, of direction e^(i b), offset e to its right, at

    y = Re v + sqrt(l^2 - (Im v - e)^2), v = w e^(-i b).

Formulas:
    (y - u)^2 + (v - e)^2 = l^2
    with y = u + sqrt(l^2 - (v - e)^2); u, v, e, l numbers

Lengths are in mm where the engine has strokes, and in crank radii of cylinder 1 where it has none. What a
drawing needs and the engine does not say (a rod ratio, a bore, a pitch) is assumed, and named.
"""

from __future__ import annotations

from cmath import exp, phase
from dataclasses import dataclass
from functools import cached_property
from math import pi, sqrt

from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError

RATIO, BORE, PITCH = 3.5, 0.95, 1.1
"""Assumed in drawings alone: l/r; the bore over the stroke; the pitch over the bore."""


@dataclass(frozen=True)
class Posture:
    """One cylinder at one crank angle: its crank pin, the pin its rod turns on, its piston pin."""

    crank_pin: complex
    rod_pin: complex
    piston_pin: complex
    rod_angle: float
    """From the axis of the drawing's vertical to the rod, clockwise, in radians."""


@dataclass(frozen=True)
class Machine:
    """An engine with the sizes that its drawings take: `assumed` names those that it does not give."""

    engine: Engine

    def __post_init__(self) -> None:
        if self.engine.has_symbols:
            rule = "has symbols for angles"
            raise SymbalanceError(self.engine.name, rule, "draw it with angles in numbers")

    @cached_property
    def assumed(self) -> tuple[str, ...]:
        """What the engine does not say and its drawings assume, in words."""
        words = []
        if any(c.ratio is None for c in self.engine.cylinders if c.link is None):
            words.append(f"rod ratio {RATIO}")
        if self.engine.bore is None:
            words.append(f"bore {BORE} of the stroke")
        if self.engine.pitch is None:
            words.append(f"pitch {PITCH} of the bore")
        return tuple(words)

    @cached_property
    def unit(self) -> str:
        """The unit of lengths: mm, or r where no stroke is given."""
        return "mm" if self.engine.first.radius else "r"

    @cached_property
    def bore(self) -> float:
        """The bore, given or assumed."""
        if self.engine.bore is not None and self.unit == "mm":
            return float(self.engine.bore)
        return BORE * 2 * self.radius(self.engine.first)

    @cached_property
    def pitch(self) -> float:
        """The distance of neighbouring cylinders, given or assumed."""
        if self.engine.pitch is not None and self.unit == "mm":
            return float(self.engine.pitch)
        return PITCH * self.bore

    def radius(self, cylinder: Cylinder) -> float:
        """Return the crank radius that moves a cylinder."""
        if cylinder.radius is not None:
            return float(cylinder.radius)
        place = self.engine.cylinders.index(cylinder)
        return float(self.engine.radii[place])

    def length(self, cylinder: Cylinder) -> float:
        """Return the length of a cylinder's own rod, given or assumed."""
        mechanism = cylinder.mechanism
        ratio = RATIO if mechanism is None else float(mechanism.length)
        return ratio * self.radius(cylinder)

    def offset(self, cylinder: Cylinder) -> float:
        """Return how far a cylinder's axis passes the crank, to the right of its direction."""
        mechanism = cylinder.mechanism
        return 0.0 if mechanism is None else float(mechanism.offset) * self.radius(cylinder)

    def axis(self, cylinder: Cylinder) -> complex:
        """Return the direction of a cylinder's axis."""
        return _direction(float(cylinder.bank.turns))

    def pin(self, cylinder: Cylinder, theta: float) -> complex:
        """Return where a cylinder's crank pin stands at theta, in radians."""
        throw = cylinder.throw if cylinder.master is None else cylinder.master.throw
        return self.radius(cylinder) * _direction(float(throw.turns)) * exp(1j * theta)

    def posture(self, cylinder: Cylinder, theta: float) -> Posture:
        """Return where the pins of a cylinder stand at a crank angle in radians."""
        crank_pin = rod_pin = self.pin(cylinder, theta)
        if cylinder.master is not None and cylinder.link is not None:
            over = self.posture(cylinder.master, theta)
            along = over.piston_pin - over.crank_pin
            arm = along / abs(along) * _direction(float(cylinder.link.angle))
            radius = float(cylinder.link.radius)  # mm: a link rod has sizes
            rod_pin = crank_pin + radius * arm
        axis, length, offset = self.axis(cylinder), self.length(cylinder), self.offset(cylinder)
        own = rod_pin / axis
        height = own.real + sqrt(length**2 - (own.imag - offset) ** 2)
        piston_pin = complex(height, offset) * axis
        rod = piston_pin - rod_pin
        return Posture(crank_pin, rod_pin, piston_pin, phase(rod))

    def travel(self, cylinder: Cylinder) -> tuple[float, float]:
        """Return the least and the greatest height of a piston pin along its axis, over a turn."""
        return self._travels[cylinder.number]

    @cached_property
    def _travels(self) -> dict[int, tuple[float, float]]:
        return {c.number: self._travel(c) for c in self.engine.cylinders}

    def _travel(self, cylinder: Cylinder) -> tuple[float, float]:
        if cylinder.link is None:  # crank and rod in one line
            radius, length, offset = self.radius(cylinder), self.length(cylinder), self.offset(cylinder)
            return sqrt((length - radius) ** 2 - offset**2), sqrt((length + radius) ** 2 - offset**2)
        axis = self.axis(cylinder)

        def height(turn: float) -> float:
            return (self.posture(cylinder, 2 * pi * turn).piston_pin / axis).real

        heights = [height(k / STEPS) for k in range(STEPS)]
        low, high = heights.index(min(heights)), heights.index(max(heights))
        ends = (_vertex([height((k + d) / STEPS) for d in (-1, 0, 1)]) for k in (low, high))
        least, greatest = ends
        return least, greatest

    @cached_property
    def reach(self) -> float:
        """The greatest distance of a piston pin from the crank's axis."""
        return max(abs(complex(self.travel(c)[1], self.offset(c))) for c in self.engine.cylinders)

    @cached_property
    def front_to_rear(self) -> tuple[Cylinder, ...]:
        """The cylinders from the front to the rear, in order of number where they stand together."""
        return tuple(sorted(self.engine.cylinders, key=lambda c: (-c.station, c.number)))


STEPS = 72
"""Crank angles at which a path is taken; between them it is a parabola, to 1e-5 of the stroke."""


def _vertex(row: list[float]) -> float:
    """Return the extreme value of the parabola through three values at even steps."""
    before, middle, after = row
    slope, bend = (after - before) / 2, after - 2 * middle + before
    return middle - slope**2 / (2 * bend) if bend else middle


def _direction(turns: float) -> complex:
    return exp(2j * pi * turns)
