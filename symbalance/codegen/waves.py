"""What a scene asks for, as numbers: each output a sum of harmonics or a closed form, to 40 digits.

A `Wave` is all the evaluators know of a result. Whatever has a spectrum can be evaluated by making
waves of it: forces and couples, torque (half orders included) alike.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from mpmath import mp

from symbalance.text.numbers import Real, real

DIGITS = 40
"""Digits the coefficients carry before they are rounded, once, to a double."""


@dataclass(frozen=True)
class Term:
    """One harmonic, cos * cos(order theta) + sin * sin(order theta); `order` is n or n/2."""

    order: Fraction
    cos: Real
    sin: Real

    @property
    def size(self) -> Real:
        """The harmonic's amplitude."""
        with mp.workdps(DIGITS):
            return mp.hypot(self.cos, self.sin)

    def at(self, theta: Any) -> Real:
        """Return the harmonic at a crank angle, to mpmath's working precision."""
        angle = theta * self.order.numerator / self.order.denominator
        return self.cos * mp.cos(angle) + self.sin * mp.sin(angle)


@dataclass(frozen=True)
class Unit:
    """What a value is measured in: a product of the keyword arguments, and its SI unit in words."""

    factors: tuple[str, ...]
    name: str

    @property
    def formula(self) -> str:
        """The product, as every target language writes it."""
        return "*".join(self.factors) or "1.0"


FORCE = Unit(("mass", "radius", "omega", "omega"), "N")
COUPLE = Unit(("mass", "radius", "omega", "omega", "pitch"), "N m")
LENGTH = Unit(("radius",), "m")
SPEED = Unit(("radius", "omega"), "m/s")
TORQUE = Unit(("mass", "radius", "radius", "omega", "omega"), "N m")
RODS = Unit(("omega", "omega"), "N m")
TORQUE_PER_RADIUS = Unit(("radius",), "N m")
TORQUE_ITSELF = Unit((), "N m")
ACCELERATION = Unit(("radius", "omega", "omega"), "m/s^2")


@dataclass(frozen=True)
class Closed:
    """A closed form, all orders at once, in a rod ratio lambda > 1.

    `kind` "secondary": `first` plus the sum of weight * E(theta + 2 pi turns) over `places`, E being
    every order of one piston's acceleration above the first. `kind` "displacement" and "velocity": one
    piston's own, at theta + 2 pi turns of the one place.
    """

    kind: str
    ratio: Fraction
    places: tuple[tuple[Real, Fraction], ...]
    first: tuple[Term, ...] = ()

    def value(self, theta: Any) -> Real:
        """Return the function at a crank angle, to mpmath's working precision."""
        rho = real(1 / self.ratio)
        part = {"secondary": _secondary, "displacement": _displacement, "velocity": _velocity}[self.kind]
        moved = (weight * part(theta + 2 * mp.pi * real(turns), rho) for weight, turns in self.places)
        return mp.fsum(moved) + mp.fsum(term.at(theta) for term in self.first)

    def peaks(self) -> list[float]:
        """Return turns of the crank where the largest value may be: a grid, and pistons in mid-stroke.

        Near rho = 1 a piston's acceleration is a narrow peak a quarter turn from its dead centre.
        """
        grid = [j / 360 for j in range(360)]
        return grid + [float(side / 4 - turns) for _, turns in self.places for side in (1, 3)]


def _secondary(theta: Real, rho: Real) -> Real:
    cos, sin, rest = mp.cos(theta), mp.sin(theta), (1 - rho) * (1 + rho)
    return rho * (cos**4 - rest * sin**4) / (rest + (rho * cos) ** 2) ** mp.mpf(1.5)


def _displacement(theta: Real, rho: Real) -> Real:
    root = mp.sqrt(1 - (rho * mp.sin(theta)) ** 2)
    return 2 * mp.sin(theta / 2) ** 2 + rho * mp.sin(theta) ** 2 / (1 + root)


def _velocity(theta: Real, rho: Real) -> Real:
    root = mp.sqrt((1 - rho) * (1 + rho) + (rho * mp.cos(theta)) ** 2)
    return mp.sin(theta) * (1 + rho * mp.cos(theta) / root)


@dataclass(frozen=True)
class Wave:
    """One output: its mean and harmonics or its closed form, and how it is measured.

    `left_out` bounds what the harmonics, which reach order `through`, leave out of the exact function, in
    the wave's unit with every keyword 1; it is None where nothing was promised beyond `through`.
    """

    name: str
    unit: Unit
    meaning: str
    terms: tuple[Term, ...] = ()
    through: int = 0
    left_out: float | None = None
    closed: Closed | None = None
    mean: Real = 0

    def value(self, theta: Any) -> Real:
        """Return the harmonics' sum at a crank angle (radians), or a closed form that stands alone."""
        theta = mp.mpf(theta)
        if self.closed is not None and not self.terms:
            return self.closed.value(theta)
        return self.mean + mp.fsum(term.at(theta) for term in self.terms)

    def amplitude(self) -> float:
        """Return the largest size over all angles: sampled, so a lower bound, within 1 in 1000."""
        import numpy as np

        if self.closed is not None and not self.terms:
            if self.closed.kind == "displacement":
                return 2.0
            with mp.workdps(20):
                return float(max(abs(self.value(2 * mp.pi * mp.mpf(x))) for x in self.closed.peaks()))
        turns = 2 * max((t.order.denominator for t in self.terms), default=1)
        theta = np.linspace(0.0, turns * np.pi, 1 + 96 * max(16, self.through))
        total = np.full_like(theta, float(self.mean))
        for term in self.terms:
            angle = float(term.order) * theta
            total += float(term.cos) * np.cos(angle) + float(term.sin) * np.sin(angle)
        return float(np.abs(total).max())
