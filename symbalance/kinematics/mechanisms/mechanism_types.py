"""The mechanisms between crank and piston: slider-crank and link rod, with checks of their lengths.

A rod reaches where |sin phi| < 1. For complex crank angles |Im p| <= a, with C = cosh a,

    |sin phi| <= (C + |eps|)/lam                                             of a slider-crank,
    |sin phi| <= (C + L (|sin chi| sqrt(1 + x^2) + |cos chi| x) + |eps|)/l    of a link rod,

x = (C + |eps|)/lam of its master: |sin p| <= C, |cos phi| <= sqrt(1 + |sin phi|^2). With C = 1 that is
the condition asked for here (exact for a slider-crank; for a link rod safe, and a little more than
needed); the largest a at which the bound is 1 gives the strip that `fourier` relies on.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import cos, log1p, pi, sin, sqrt
from typing import TypeGuard

from symbalance.errors import SymbalanceError, brief
from symbalance.exact.angles import Angle
from symbalance.kinematics.slider_crank import checked_ratio
from symbalance.text.numbers import LARGEST_QUOTIENT, exact

SAFE = 1 - 1e-9
"""Covers the rounding of floats in what must be a lower bound."""
HALVINGS = 60
"""Steps of a bisection: more than a double has bits."""


@dataclass(frozen=True)
class SliderCrank:
    """A slider-crank, centred or with an offset between the cylinder's axis and the crank's.

    `ratio` is lambda = l/r, `offset` is eps = e/r, positive towards the side the pin moves to after
    p = 0; both are held exactly. Refused unless ratio > 1 + |offset|: the crank could not turn.

    Formulas:
        y = cos p + sqrt(lambda^2 - (sin p - e)^2)
        dy/dp = -sin p - cos p tan f
        with y = cos p + lambda cos f; f = asin((sin p - e)/lambda); p an angle; e a number

    >>> SliderCrank("7/2", 0.25)
    SliderCrank(ratio=Fraction(7, 2), offset=Fraction(1, 4))
    >>> SliderCrank(2, 1)
    Traceback (most recent call last):
    symbalance.errors.SymbalanceError: offset = 1: must lie within -1 and 1 (lambda - 1); e/r, not mm
    """

    ratio: Fraction
    offset: Fraction = Fraction(0)

    def __post_init__(self) -> None:
        ratio, offset = checked_ratio(self.ratio), exact(self.offset, "offset", LARGEST_QUOTIENT)
        object.__setattr__(self, "ratio", ratio)
        object.__setattr__(self, "offset", offset)
        if abs(offset) >= ratio - 1:
            most = ratio - 1
            rule = f"must lie within {brief(-most)} and {brief(most)} (lambda - 1)"
            raise SymbalanceError(f"offset = {brief(offset)}", rule, "e/r, not mm")

    @property
    def length(self) -> Fraction:
        """The rod's length over r."""
        return self.ratio

    @property
    def is_centred(self) -> bool:
        """Whether the axis passes through the crank's: then A_n has a closed form, and B_n is 0."""
        return not self.offset

    @cached_property
    def strip(self) -> float:
        """A half-width a of a strip |Im p| <= a in which |sin phi| <= 1; the widest there is."""
        return _area_cosine(float(self.ratio - abs(self.offset) - 1))


@dataclass(frozen=True)
class LinkRod:
    """A link rod on another cylinder's master rod; `link_radius` 0 is a fork-and-blade rod.

    `link_angle`, in turns, is the link pin's direction seen from the crank pin, counted from the
    master rod (crank pin towards master piston) in the sense of rotation; `link_radius` is its distance
    and `length` the link rod's own length, over r; `bank_difference`, in turns, is this cylinder's axis
    minus the master's; `offset` is this cylinder's own, over r. All are held exactly. The link pin
    stands at height h and u to the side, b being the master rod's angle, c `pin_direction` and L
    `link_radius`:

    Formulas:
        h + i u = e^(i p) + L e^(i (c - b))
        h^2 + u^2 = 1 + L^2 + 2 L cos(p - c + b)
        with h = cos p + L cos(c - b); u = sin p + L sin(c - b); p, b, c angles; L positive

    >>> LinkRod(SliderCrank(4), "1/9", "3/4", "13/4", "1/9").pin_direction
    Fraction(0, 1)
    """

    master: SliderCrank
    link_angle: Fraction
    link_radius: Fraction
    length: Fraction
    bank_difference: Fraction
    offset: Fraction = Fraction(0)

    def __post_init__(self) -> None:
        if not isinstance(self.master, SliderCrank):
            what, rule = f"master = {brief(self.master)}", "must be a SliderCrank"
            raise SymbalanceError(what, rule, "a link rod hangs on a master rod, not on another link")
        for name in ("link_angle", "link_radius", "length", "bank_difference", "offset"):
            object.__setattr__(self, name, exact(getattr(self, name), name, LARGEST_QUOTIENT))
        for name in ("link_angle", "bank_difference"):  # like rods compare equal in every row of a radial
            object.__setattr__(self, name, Angle(getattr(self, name)).normalized().turns)
        if self.link_radius < 0:
            what = f"link_radius = {brief(self.link_radius)}"
            raise SymbalanceError(what, "must not be negative", "turn link_angle by half a turn instead")
        if not self._reaches():
            bound = _link_reach(self, 1.0)
            rule = f"must exceed {bound:.9g} for the rod to reach at every crank angle"
            raise SymbalanceError(f"length = {brief(self.length)}", rule, "l/r of the link rod, not mm")

    def _reaches(self) -> bool:
        if self.link_radius == 0:
            return self.length > 1 + abs(self.offset)
        return _link_reach(self, 1.0) < SAFE * float(self.length)

    @property
    def is_centred(self) -> bool:
        """Never: a fork-and-blade rod is one of its own too, and `simplified` says what it is."""
        return False

    @property
    def pin_direction(self) -> Fraction:
        """The angle chi = link angle - bank difference in turns, from 0 up to 1."""
        return (self.link_angle - self.bank_difference) % 1

    @cached_property
    def strip(self) -> float:
        """A half-width a of a strip |Im p| <= a in which |sin phi| <= 1, of this rod and the master's."""
        low, high = 0.0, float(self.master.ratio - abs(self.master.offset) - 1)
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            inside = _link_reach(self, 1 + middle) < SAFE * float(self.length)
            low, high = (middle, high) if inside else (low, middle)
        return _area_cosine(low)


Mechanism = SliderCrank | LinkRod
"""What joins a piston to the crank."""


def has_link_pin(mechanism: Mechanism | None) -> TypeGuard[LinkRod]:
    """Tell whether the rod hangs on a pin beside the crank pin, which moves with the master rod.

    A forked rod does not: its link pin is on the crank pin's axis.
    """
    return isinstance(mechanism, LinkRod) and mechanism.link_radius != 0


def checked_mechanism(value: object) -> Mechanism:
    """Return a mechanism, or refuse what is none.

    >>> checked_mechanism(4)  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    symbalance.errors.SymbalanceError: mechanism = 4: must be a SliderCrank or a LinkRod; ...
    """
    if not isinstance(value, SliderCrank | LinkRod):
        rule = "must be a SliderCrank or a LinkRod"
        raise SymbalanceError(f"mechanism = {brief(value)}", rule, "as SliderCrank(4)")
    return value


def simplified(mechanism: Mechanism) -> Mechanism:
    """Return the slider-crank that a fork-and-blade rod is, and anything else as it stands.

    >>> simplified(LinkRod(SliderCrank(4), 0, 0, 3, "1/6"))
    SliderCrank(ratio=Fraction(3, 1), offset=Fraction(0, 1))
    """
    if isinstance(mechanism, LinkRod) and not has_link_pin(mechanism):
        return SliderCrank(mechanism.length, mechanism.offset)
    return mechanism


def depends_on_sine(mechanism: Mechanism) -> bool:
    """Tell whether y - cos p and phi depend on sin p alone: a proof, whatever the other sizes are."""
    return isinstance(mechanism, SliderCrank) or mechanism.bank_difference % Fraction(1, 2) == 0


def alternates(mechanism: Mechanism) -> bool:
    """Tell whether half a turn leaves y - cos p as it is and reverses phi: a proof."""
    if isinstance(mechanism, SliderCrank):
        return mechanism.offset == 0
    centred = mechanism.offset == 0 and mechanism.master.offset == 0
    return centred and mechanism.pin_direction % Fraction(1, 2) == 0


def _area_cosine(above: float) -> float:
    """Return a little less than acosh(1 + above)."""
    return SAFE * log1p(above + sqrt(above * (above + 2)))


def _link_reach(rod: LinkRod, c: float) -> float:
    """Return a bound on l |sin phi| for |Im p| <= acosh c."""
    slant = (c + float(abs(rod.master.offset))) / float(rod.master.ratio)
    chi = 2 * pi * float(rod.pin_direction)
    reach = abs(sin(chi)) * sqrt(1 + slant * slant) + abs(cos(chi)) * slant
    return c + float(rod.link_radius) * reach + float(abs(rod.offset))
