"""Intervals of weight and angle within which one cylinder in tolerance contributes to an order.

Each factor of the weight m r f_n(l/r, e/r) s runs through an interval of its own. For a slider-crank
r |A_n| and r |B_n|, n >= 2, grow with r and |e| and fall with l, for all terms of their series have one
sign, so the corners of the box bound them, and are attained. Order 1 of an offset cylinder has two
parts, cosine and sine, which are bounded each for itself.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product
from math import ceil, cos, floor, pi

from symbalance.design.variations.annular_sectors import AnnularSector
from symbalance.design.variations.contributions import checked_numeric_engine, mechanism_to
from symbalance.design.variations.tolerances import RelativeTolerances
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError
from symbalance.kinematics.mechanisms import LinkRod, Mechanism, SliderCrank
from symbalance.kinematics.mechanisms.mechanism_types import simplified
from symbalance.kinematics.mechanisms.moving_masses import piston_force

FLAT = 1e-14
"""Cosines, and imaginary parts over the modulus, below this are rounding of exact zeros."""
Interval = tuple[float, float]
Harmonics = dict[int, complex]
"""n -> r f_n over the nominal radius, at one corner of the lengths' box."""


def interval_product(one: Interval, other: Interval) -> Interval:
    """Return the interval of products.

    >>> interval_product((-1, 2), (3, 4))
    (-4, 8)
    """
    ends = [a * b for a in one for b in other]
    return min(ends), max(ends)


def cosine_interval(low: float, high: float) -> Interval:
    """Return the least and the largest cosine of an interval of angles.

    >>> cosine_interval(-0.1, 0.2)[1]
    1.0
    """
    ends = (cos(low), cos(high))
    least = -1.0 if floor((high - pi) / (2 * pi)) >= ceil((low - pi) / (2 * pi)) else min(ends)
    most = 1.0 if floor(high / (2 * pi)) >= ceil(low / (2 * pi)) else max(ends)
    return least, most


@dataclass(frozen=True)
class ToleranceBox:
    """One cylinder in one order; angles in radians, weights in m r omega^2 of cylinder 1.

    `corners` are attainable values of m r f_n, `nominal` the one without errors; `arm` is the station's
    interval and `level` the station itself; `throw` and `bank` are the angles' tolerances.
    """

    number: int
    order: int
    axis: float
    lead: float
    corners: tuple[complex, ...]
    nominal: complex
    arm: Interval
    level: float
    throw: float
    bank: float

    @cached_property
    def parts(self) -> tuple[tuple[Interval, float], ...]:
        """The weight as intervals, each with its phase: f is real, imaginary, or of a fixed phase."""
        if not any(c.imag for c in self.corners):
            return ((_hull(c.real for c in self.corners), 0.0),)
        if not any(c.real for c in self.corners):
            return ((_hull(c.imag for c in self.corners), pi / 2),)
        phase = cmath.phase(self.nominal)
        aligned = [c * cmath.rect(1, -phase) for c in self.corners]
        if all(abs(z.imag) <= FLAT * abs(z) for z in aligned):  # a link rod, whose lengths are fixed
            return ((_hull(z.real for z in aligned), phase),)
        return ((_hull(c.real for c in self.corners), 0.0), (_hull(c.imag for c in self.corners), pi / 2))

    def weights(self, quantity: str) -> Iterator[tuple[Interval, float]]:
        """Yield the intervals of the weight, times the arm for a couple, with their phases."""
        for interval, phase in self.parts:
            yield (interval_product(interval, self.arm) if quantity == "couple" else interval), phase

    def component_sectors(self, quantity: str, direction: float) -> list[AnnularSector]:
        """Return sectors of what it may add to the component along a direction, as C + iS would turn."""
        slant = direction - self.axis
        if self.bank:
            window = cosine_interval(slant - self.bank, slant + self.bank)
        else:
            flat = cos(slant)
            # Across its axis a cylinder has nothing: banks are fractions, so this is rounding.
            window = (flat, flat) if abs(flat) > FLAT else (0.0, 0.0)
        half = self.order * (self.throw + self.bank)
        return [
            AnnularSector(*interval_product(interval, window), self.lead + phase, min(half, pi))
            for interval, phase in self.weights(quantity)
        ]

    def rotating_sectors(self, quantity: str, sign: int) -> list[AnnularSector]:
        """Return sectors of what it may add to c_n (sign 1) or c_-n (sign -1)."""
        half = min(self.order * self.throw + abs(1 - sign * self.order) * self.bank, pi)
        return [
            AnnularSector(low / 2, high / 2, self.axis + sign * (self.lead + phase), half)
            for (low, high), phase in self.weights(quantity)
        ]

    def pair(
        self, quantity: str, weight: complex, arm: float, turn: float, tilt: float
    ) -> tuple[complex, complex]:
        """Return c_n and c_-n with errors: `turn` of the throw and `tilt` of the bank."""
        scale = arm / 2 if quantity == "couple" else 0.5
        lead = self.lead + self.order * (turn - tilt)
        forward = weight * scale * cmath.rect(1, self.axis + tilt + lead)
        return forward, weight.conjugate() * scale * cmath.rect(1, self.axis + tilt - lead)


def _hull(values: Iterator[float] | Sequence[float]) -> Interval:
    numbers = list(values)
    return min(numbers), max(numbers)


def tolerance_boxes(
    layout: Engine, relative: RelativeTolerances, order: int, reference: object = None
) -> dict[int, list[ToleranceBox]]:
    """Return n -> every cylinder's box, for each order to `order` that some engine in tolerance has."""
    checked_numeric_engine(layout)
    cylinders = zip(layout.cylinders, layout.sizes, layout.arms(layout.plane(reference)), strict=True)
    parts = []
    by_kind: dict[tuple[Mechanism, Fraction], list[Harmonics]] = {}
    for cylinder, size, arm in cylinders:
        key = (simplified(mechanism_to(layout, cylinder, order)), _radius(layout, cylinder))
        if key not in by_kind:
            by_kind[key] = list(_corners(key[0], key[1], relative, order))
        parts.append((cylinder, (size, arm), by_kind[key], _mass_interval(layout, cylinder, relative)))
    present = sorted({n for corners in by_kind.values() for f in corners for n, c in f.items() if c})
    return {
        n: [
            _box(cylinder, weight, corners, mass, relative, n)
            for cylinder, weight, corners, mass in parts
        ]
        for n in present
        if n <= order
    }


def _radius(layout: Engine, cylinder: Cylinder) -> Fraction:
    """Return r_j/r_1, 1 where strokes are not given."""
    radius, first = cylinder.radius, layout.first.radius
    return radius / first if radius and first else Fraction(1)


def _mass_interval(
    layout: Engine, cylinder: Cylinder, relative: RelativeTolerances
) -> tuple[float, float]:
    """Return the least and the largest mass over its own."""
    mass, first = cylinder.reciprocating_mass, layout.first.reciprocating_mass
    part = relative.mass * first / mass if mass and first else relative.mass
    if part > 1:
        what = f"mass = ±{float(part):.3g} of m"
        raise SymbalanceError(what, "lets a mass be negative", "give kg, or percent: 0.5%")
    return 1 - float(part), 1 + float(part)


def _corners(
    mechanism: Mechanism, radius: Fraction, relative: RelativeTolerances, order: int
) -> Iterator[Harmonics]:
    """Yield the nominal harmonics r f_n/r, and then those at the corners of the lengths' box."""
    yield {n: complex(f) for n, f in piston_force(mechanism, order).items()}
    lengths = (relative.stroke / radius, relative.rod / radius, relative.offset / radius)
    if isinstance(mechanism, LinkRod) and (relative.bank or any(lengths)):
        rule = "are not bounded where cylinders hang on link rods"
        remedy = "leave them out, or take the derivatives of sensitivities"
        names = [name for name in ("bank", "stroke", "rod", "offset") if relative.steps[name]]
        raise SymbalanceError(f"tolerances of {', '.join(names)}", rule, remedy)
    if not any(lengths):
        return
    assert isinstance(mechanism, SliderCrank)
    middles = (Fraction(1), mechanism.ratio, mechanism.offset)
    ends = [{m - x, m + x} for m, x in zip(middles, lengths, strict=True)]
    if abs(mechanism.offset) < lengths[2]:
        ends[2].add(Fraction(0))  # where the even orders are least
    for r, length, e in product(*map(sorted, ends)):
        at = SliderCrank(length / r, e / r)
        yield {n: complex(f) * float(r) for n, f in piston_force(at, order).items()}


def _box(
    cylinder: Cylinder,
    weight: tuple[Fraction, Fraction],
    lengths: Sequence[Harmonics],
    mass: Interval,
    relative: RelativeTolerances,
    n: int,
) -> ToleranceBox:
    size, arm = weight
    values = [f.get(n, 0j) * float(size) for f in lengths]
    level, half = float(arm), float(relative.station)
    corners = tuple(v * m for v in values for m in sorted(set(mass)))
    return ToleranceBox(
        number=cylinder.number,
        order=n,
        axis=2 * pi * float(cylinder.bank.turns),
        lead=2 * pi * float(n * cylinder.delay.turns % 1),
        corners=corners,
        nominal=values[0],
        arm=(level - half, level + half),
        level=level,
        throw=relative.throw,
        bank=relative.bank,
    )
