"""The moving bodies of a mechanism, each with the harmonics of its force, torque and moment.

A mechanism is a set of bodies whose paths or angles are series in the crank angle: the piston, which goes
along the cylinder's axis; the rod, whose own inertia turns with it; and a link rod's big end, which
swings with the master rod. Another linkage is another set. Each has, for every order, in units of its
own mass (m r omega^2, m r^2 omega^2) or moment of inertia (J_x omega^2):

    force    h_n of both signs, sum of h_n e^(inp), height + i lateral in the cylinder's frame
    torque   C + iS of what its kinetic energy gives back to the crank
    moment   C + iS of what the frame gets about the crank's axis besides the torque's opposite
    tail     a proved bound on the sum of |h_n| above an order, both signs

A real harmonic A cos n p + B sin n p is two of them, h_n = f/2 and h_-n = g/2:

Formulas:
    A cos n p + B sin n p = (1/2) (f e^(i n p) + g e^(-i n p))
    with f = A - i B; g = A + i B; p the crank angle; A, B numbers; n a whole number
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from symbalance.kinematics.mechanism_torque import (
    beside_harmonics,
    inertia_harmonics,
    link_pin_harmonics,
    link_pin_moments,
    rocking_harmonics,
    rod_harmonics,
)
from symbalance.kinematics.mechanisms import LinkRod, Mechanism, force_tail, has_link_pin
from symbalance.kinematics.mechanisms.moving_masses import link_pin_force, link_pin_tail, piston_force
from symbalance.text.reals import Complex, Real

RECIPROCATING, ROTATING, EXCESS = "reciprocating mass", "rotating mass", "J_x"
"""The measure of a body: kg at the piston, kg at the rod's lower end, the rod's own inertia."""


@dataclass(frozen=True)
class PistonMass:
    """The reciprocating mass: it goes along the axis."""

    measure: ClassVar[str] = RECIPROCATING
    mechanism: Mechanism

    def force(self, order: int) -> dict[int, Complex]:
        """Return n -> h_n: (A_n - i B_n)/2 for n > 0, and its conjugate for -n."""
        halves = {n: f / 2 for n, f in piston_force(self.mechanism, order).items()}
        return halves | {-n: h.conjugate() for n, h in halves.items()}

    def torque(self, order: int) -> Mapping[int, Complex]:
        """Return n -> C + iS of the inertia torque."""
        return inertia_harmonics(self.mechanism, order)

    def moment(self, order: int) -> Mapping[int, Complex]:
        """Return n -> C + iS of the force at the arm of an offset axis; empty without offset."""
        return beside_harmonics(self.mechanism, order)

    def tail(self, order: int) -> Real:
        """Return a bound on the force's harmonics above an order."""
        return force_tail(self.mechanism, order)


@dataclass(frozen=True)
class LinkPinMass:
    """A link rod's big end: what its link pin moves it by beside the crank pin, which turns steadily."""

    measure: ClassVar[str] = ROTATING
    mechanism: LinkRod

    def force(self, order: int) -> dict[int, Complex]:
        """Return n -> h_n, less that of a mass on the crank pin."""
        return link_pin_force(self.mechanism, order)

    def torque(self, order: int) -> Mapping[int, Complex]:
        """Return n -> C + iS of the inertia torque."""
        return link_pin_harmonics(self.mechanism, order)

    def moment(self, order: int) -> Mapping[int, Complex]:
        """Return n -> C + iS of the force at the arm of the link pin."""
        return link_pin_moments(self.mechanism, order)

    def tail(self, order: int) -> Real:
        """Return a bound on the force's harmonics above an order."""
        return link_pin_tail(self.mechanism, order)


@dataclass(frozen=True)
class RodInertia:
    """What a rod's inertia differs by from two masses at its ends: a couple that turns with it."""

    measure: ClassVar[str] = EXCESS
    mechanism: Mechanism

    def force(self, order: int) -> dict[int, Complex]:
        """Return nothing: a couple has no force."""
        return {}

    def torque(self, order: int) -> Mapping[int, Complex]:
        """Return n -> C + iS of the torque on the crank, over J_x omega^2."""
        return rod_harmonics(self.mechanism, order)

    def moment(self, order: int) -> Mapping[int, Complex]:
        """Return n -> C + iS of the couple on the frame, over J_x omega^2."""
        return rocking_harmonics(self.mechanism, order)

    def tail(self, order: int) -> Real:
        """Return 0."""
        return Real(0)


Body = PistonMass | LinkPinMass | RodInertia


def bodies(mechanism: Mechanism) -> tuple[Body, ...]:
    """Return what moves with a mechanism; what turns steadily with the crank is not among it.

    >>> from symbalance.kinematics.mechanisms import SliderCrank
    >>> [body.measure for body in bodies(LinkRod(SliderCrank(4), "1/9", "3/4", "13/4", "1/9"))]
    ['reciprocating mass', 'J_x', 'rotating mass']
    """
    piston_and_rod: tuple[Body, ...] = (PistonMass(mechanism), RodInertia(mechanism))
    if has_link_pin(mechanism):
        return (*piston_and_rod, LinkPinMass(mechanism))
    return piston_and_rod
