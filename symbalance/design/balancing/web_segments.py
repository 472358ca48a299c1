r"""A balance weight as a segment that can be cut: a sector of a ring about its shaft's axis.

A sector of density d, thickness t, inner and outer radius r and R, and half angle h has the mass and the
mass times radius

    m = d t h (R^2 - r^2),     U = d t int_-h^h int_r^R cos(phi) s^2 ds dphi = 2/3 d t (R^3 - r^3) sin h.

So the least sector for an unbalance U has sin h = 3 U/(2 d t (R^3 - r^3)), at most half a ring. A weight
that takes more has none: `thickness_for` is the thickness that would do.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from symbalance.errors import SymbalanceError
from symbalance.text.numbers import exact
from symbalance.text.reals import Real, asin, pi

STEEL = 7850
"""kg/m^3, of a crankshaft's steel."""
CUBIC_MM = Fraction(1, 10**9)
"""Cubic metres in a cubic millimetre."""


@dataclass(frozen=True)
class Segment:
    """A sector about the axis, middle where the weight points: its whole angle in degrees, its kg."""

    angle: Real
    mass: Real


@dataclass(frozen=True)
class SegmentRing:
    """What segments are cut from: `inner` and `outer` radius and `thickness` in mm, kg/m^3."""

    outer: Fraction
    thickness: Fraction
    inner: Fraction = Fraction(0)
    density: Fraction = Fraction(STEEL)

    @property
    def largest(self) -> Fraction:
        """The mass times radius of half the ring, kg mm."""
        per_area = self.density * CUBIC_MM * self.thickness
        return Fraction(2, 3) * per_area * (self.outer**3 - self.inner**3)

    def thickness_for(self, unbalance: Real) -> Real:
        """Return the thickness in mm of which half a ring has so many kg mm."""
        return abs(unbalance) / self.largest * self.thickness

    def segment(self, unbalance: Real) -> Segment | None:
        """Return the least sector with a mass times radius in kg mm; None if half a ring has less.

        >>> half = SegmentRing(Fraction(60), Fraction(20))
        >>> segment = half.segment(Real(half.largest) / 2)
        >>> round(float(segment.angle), 9), round(float(segment.mass), 6)
        (60.0, 0.295938)
        >>> double = Real(half.largest) * 2
        >>> half.segment(double), float(half.thickness_for(double))
        (None, 40.0)
        """
        share = abs(unbalance) / self.largest
        if share > 1:
            return None
        half_angle = asin(share)
        area = self.outer**2 - self.inner**2
        mass = half_angle * (self.density * CUBIC_MM * self.thickness * area)
        return Segment(2 * half_angle * 180 / pi(), mass)


def checked_ring(
    outer: object, thickness: object, inner: object = 0, density: object = STEEL
) -> SegmentRing:
    """Return a ring, or refuse sizes that are none."""
    sizes = {"outer": outer, "thickness": thickness, "inner": inner, "density": density}
    values = {name: exact(value, name) for name, value in sizes.items()}
    for name, value in values.items():
        if value < 0 or (value == 0 and name != "inner"):
            rule = "must not be negative" if name == "inner" else "must be positive"
            raise SymbalanceError(f"{name} = {value}", rule, "mm, and kg/m^3")
    if values["inner"] >= values["outer"]:
        what = f"inner = {values['inner']}, outer = {values['outer']}"
        raise SymbalanceError(what, "leave no ring", "the outer radius is the larger one, mm")
    return SegmentRing(**values)
