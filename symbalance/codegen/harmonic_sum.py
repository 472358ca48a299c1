"""An output of a result as a sum of harmonics of the crank angle or a closed form, to 40 digits.

The digits are those the coefficients carry before they are rounded, once, to a double.

A `HarmonicSum` is all the evaluators know of a result. Whatever has a spectrum can be evaluated by making
sums of it: forces and couples, torque (half orders included) alike.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from symbalance.text.reals import Exact, Real, cos, fsum, hypot, pi, sin, sqrt

ZERO = Real(0)


@dataclass(frozen=True)
class HarmonicTerm:
    """One harmonic, cos * cos(order theta) + sin * sin(order theta); `order` is n or n/2."""

    order: Fraction
    cos: Real
    sin: Real

    def __post_init__(self) -> None:
        object.__setattr__(self, "cos", Real(self.cos))
        object.__setattr__(self, "sin", Real(self.sin))

    @property
    def size(self) -> Real:
        """The harmonic's amplitude."""
        return hypot(self.cos, self.sin)

    def at(self, theta: Real) -> Real:
        """Return the harmonic at a crank angle, to its digits."""
        angle = theta * self.order
        return self.cos * cos(angle) + self.sin * sin(angle)


@dataclass(frozen=True)
class OutputUnit:
    """What a value is measured in: a product of the keyword arguments, and its SI unit in words."""

    factors: tuple[str, ...]
    name: str

    @property
    def formula(self) -> str:
        """The product, as every target language writes it."""
        return "*".join(self.factors) or "1.0"


FORCE = OutputUnit(("mass", "radius", "omega", "omega"), "N")
COUPLE = OutputUnit(("mass", "radius", "omega", "omega", "pitch"), "N m")
LENGTH = OutputUnit(("radius",), "m")
SPEED = OutputUnit(("radius", "omega"), "m/s")
TORQUE = OutputUnit(("mass", "radius", "radius", "omega", "omega"), "N m")
RODS = OutputUnit(("omega", "omega"), "N m")
TORQUE_PER_RADIUS = OutputUnit(("radius",), "N m")
TORQUE_ITSELF = OutputUnit((), "N m")
ACCELERATION = OutputUnit(("radius", "omega", "omega"), "m/s^2")


@dataclass(frozen=True)
class ClosedForm:
    """A closed form, all orders at once, in a rod ratio lambda > 1.

    `kind` "secondary": `first` plus the sum of weight * E(theta + 2 pi turns) over `places`, E being
    every order of one piston's acceleration above the first. `kind` "displacement" and "velocity": one
    piston's own, at theta + 2 pi turns of the one place.
    """

    kind: str
    ratio: Fraction
    places: tuple[tuple[Real, Fraction], ...]
    first: tuple[HarmonicTerm, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "places", tuple((Real(weight), turns) for weight, turns in self.places))

    def value(self, theta: Exact | Real) -> Real:
        """Return the function at a crank angle (radians), to its digits, 40 where it carries none."""
        theta = Real(theta)
        rho, turn = Real(1 / self.ratio, theta.digits), 2 * pi(theta.digits)
        part = {"secondary": _secondary, "displacement": _displacement, "velocity": _velocity}[self.kind]
        shifted = (weight * part(theta + turn * turns, rho) for weight, turns in self.places)
        return fsum(shifted) + fsum(term.at(theta) for term in self.first)

    def peaks(self) -> list[float]:
        """Return turns of the crank where the largest value may be: a grid, and pistons in mid-stroke.

        Near rho = 1 a piston's acceleration is a narrow peak a quarter turn from its dead centre.
        """
        grid = [j / 360 for j in range(360)]
        return grid + [float(side / 4 - turns) for _, turns in self.places for side in (1, 3)]


def _secondary(theta: Real, rho: Real) -> Real:
    c, s, rest = cos(theta), sin(theta), (1 - rho) * (1 + rho)
    return rho * (c**4 - rest * s**4) / (rest + (rho * c) ** 2) ** 1.5


def _displacement(theta: Real, rho: Real) -> Real:
    root = sqrt(1 - (rho * sin(theta)) ** 2)
    return 2 * sin(theta / 2) ** 2 + rho * sin(theta) ** 2 / (1 + root)


def _velocity(theta: Real, rho: Real) -> Real:
    root = sqrt((1 - rho) * (1 + rho) + (rho * cos(theta)) ** 2)
    return sin(theta) * (1 + rho * cos(theta) / root)


@dataclass(frozen=True)
class HarmonicSum:
    """One output: its mean and harmonics or its closed form, and how it is measured.

    `left_out` bounds what the harmonics, which reach order `through`, leave out of the exact function, in
    the sum's unit with every keyword 1; it is None where nothing was promised beyond `through`.
    """

    name: str
    unit: OutputUnit
    meaning: str
    terms: tuple[HarmonicTerm, ...] = ()
    through: int = 0
    left_out: float | None = None
    closed_form: ClosedForm | None = None
    mean: Real = ZERO

    def __post_init__(self) -> None:
        object.__setattr__(self, "mean", Real(self.mean))

    def value(self, theta: Exact | Real) -> Real:
        """Return the harmonics' sum at a crank angle (radians), or a closed form that stands alone.

        The value has the digits of the angle, 40 where it carries none.
        """
        theta = Real(theta)
        if self.closed_form is not None and not self.terms:
            return self.closed_form.value(theta)
        return self.mean + fsum(term.at(theta) for term in self.terms)

    def amplitude(self) -> float:
        """Return the largest size over all angles: sampled, so a lower bound, within 1 in 1000."""
        import numpy as np

        if self.closed_form is not None and not self.terms:
            if self.closed_form.kind == "displacement":
                return 2.0
            turn = 2 * pi(20)
            return float(max(abs(self.value(turn * x)) for x in self.closed_form.peaks()))
        turns = 2 * max((t.order.denominator for t in self.terms), default=1)
        theta = np.linspace(0.0, turns * np.pi, 1 + 96 * max(16, self.through))
        total = np.full_like(theta, float(self.mean))
        for term in self.terms:
            angle = float(term.order) * theta
            total += float(term.cos) * np.cos(angle) + float(term.sin) * np.sin(angle)
        return float(np.abs(total).max())
