"""Pressure of a cylinder over one cycle, against the crank angle after its firing top dead centre.

Between its points the pressure is a straight line, periodic over the cycle; two points at one angle are
a jump. What follows from a trace (torque, work, harmonics) follows from these lines without a further
error: all error lies in the points. Degrees, and bar absolute.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from math import isfinite, pi
from typing import TYPE_CHECKING, Any, ClassVar

from symbalance.document.result import Result
from symbalance.engine.engine import checked_strokes
from symbalance.errors import SymbalanceError, brief
from symbalance.text.measurements import as_float
from symbalance.text.numbers import as_list

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

MOST_BAR = 2000
"""Of no engine: a larger number is in another unit."""
WIDEST = 10
"""Degrees that two neighbouring points of a measured trace may lie apart."""
CLOSING = 0.02
"""How far the last point, a cycle after the first, may differ from it: of the trace's whole range."""
NEAR_TOP = 90
"""Degrees about the firing top dead centre in which the highest pressure of a cycle stands."""
SAME = 1e-9
"""Degrees that are the rounding of sums of doubles."""


@dataclass(frozen=True, repr=False)
class PressureTrace(Result):
    """Cylinder pressures in bar at `degrees` in [0, cycle), in order; a repeated angle is a jump.

    >>> trace = PressureTrace((0.0, 180.0, 360.0, 540.0), (3.0, 1.0, 1.0, 1.0))
    >>> trace.at(90), trace.at(630), trace.at(-90)
    (2.0, 2.0, 2.0)
    """

    degrees: tuple[float, ...]
    bar: tuple[float, ...]
    strokes: int = 4

    kind: ClassVar[str] = "pressure-trace"

    def summary(self) -> str:
        """Return its points and its extremes, in one line."""
        count = len(self.degrees)
        return (
            f"Pressure trace over {self.cycle}° of {count} point{'s' if count > 1 else ''}, "
            f"from {min(self.bar):.6g} to {self.peak:.6g} bar"
        )

    def document(self) -> Document:
        """Return the peak and where it stands, then the pressure at even steps of the cycle."""
        from symbalance.torque.pressure_document import trace_document

        return trace_document(self)

    def data(self) -> dict[str, Any]:
        """Return the points: degrees after the firing top dead centre, bar absolute."""
        return {
            "strokes": self.strokes,
            "cycle_degrees": self.cycle,
            "peak_bar": self.peak,
            "peak_degrees": self.peak_degrees,
            "degrees": list(self.degrees),
            "bar": list(self.bar),
        }

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each point; keys: degrees, bar."""
        return [{"degrees": d, "bar": p} for d, p in zip(self.degrees, self.bar, strict=True)]

    @property
    def peak(self) -> float:
        """The highest pressure, in bar."""
        return max(self.bar)

    @property
    def peak_degrees(self) -> float:
        """Where the highest pressure stands, in degrees after the firing top dead centre."""
        return self.degrees[self.bar.index(self.peak)]

    def __post_init__(self) -> None:
        checked_strokes(self.strokes)
        if not 1 <= len(self.degrees) == len(self.bar):
            what = f"{len(self.degrees)} angles and {len(self.bar)} pressures"
            raise SymbalanceError(what, "must be as many, and at least one", "give one pressure an angle")
        if not all(map(isfinite, (*self.degrees, *self.bar))):
            raise SymbalanceError("a trace", "must hold finite numbers only", "leave the others out")
        steady = all(a <= b for a, b in pairwise(self.degrees))
        if not steady or self.degrees[0] < 0 or self.degrees[-1] >= self.cycle:
            rule = f"must rise from 0 to below {self.cycle} degrees"
            raise SymbalanceError("the angles of a trace", rule, "pressure_trace(...) sorts them in")

    @property
    def cycle(self) -> int:
        """The degrees of one cycle: 720 in a four-stroke, 360 in a two-stroke."""
        return 180 * self.strokes

    @cached_property
    def radians(self) -> tuple[float, ...]:
        """The points' angles in radians, the first one a cycle later added."""
        return tuple(d * pi / 180 for d in (*self.degrees, self.degrees[0] + self.cycle))

    @cached_property
    def closed(self) -> tuple[float, ...]:
        """The points' pressures, the first one added."""
        return (*self.bar, self.bar[0])

    def at(self, degrees: float) -> float:
        """Return the pressure in bar at an angle after the firing top dead centre."""
        first = self.degrees[0]
        angle = first + (degrees - first) % self.cycle
        i = min(bisect_right(self.degrees, angle), len(self.degrees)) - 1
        before, after = self.radians[i], self.radians[i + 1]
        share = (angle * pi / 180 - before) / (after - before) if after > before else 0.0
        return self.closed[i] + share * (self.closed[i + 1] - self.closed[i])


Point = tuple[str, float, float]
"""Where a point was read, its angle and its pressure."""


def pressure_trace(
    degrees: Sequence[object], bar: Sequence[object], *, strokes: int = 4
) -> PressureTrace:
    """Return a pressure trace from points of one measured cycle, strictly checked.

    Angles rise from point to point, at most 10 degrees each, within [-720, 720] ([-360, 360] for two
    strokes), and span the cycle; 0 is the firing top dead centre. Pressures are absolute, in bar. A last
    point one cycle after the first repeats it.

    >>> trace = pressure_trace(range(-360, 361, 10), [1] * 73)
    >>> len(trace.degrees), trace.degrees[0], trace.at(5)
    (72, 0.0, 1.0)
    """
    angles, values = as_list(degrees, "degrees"), as_list(bar, "bar", "[1.0, 1.1, 1.3]")
    if len(angles) != len(values):
        what = f"{len(angles)} angles and {len(values)} pressures"
        raise SymbalanceError(what, "must be as many", "give one pressure an angle")
    points = zip(angles, values, strict=True)
    rows = [
        (f"point {i}", as_float(a, "angle"), as_float(p, "bar")) for i, (a, p) in enumerate(points, 1)
    ]
    return from_rows(rows, 180 * checked_strokes(strokes))


def from_rows(rows: list[Point], cycle: int, name: str = "the trace") -> PressureTrace:
    """Return the trace of checked points; a refusal says at which one it stands."""
    if len(rows) < 2:
        rule = "needs at least two points"
        raise SymbalanceError(f"{name} of {len(rows)} points", rule, "give the angles of a whole cycle")
    for place, angle, bar in rows:
        _check_point(place, angle, bar, cycle)
    for (_, before, _), (place, after, _) in pairwise(rows):
        _check_step(place, before, after)
    rows = _closed(rows, cycle)
    _check_top(rows, cycle)
    wrapped = ((angle % cycle, bar) for _, angle, bar in rows)
    points = sorted((angle if angle < cycle else 0.0, bar) for angle, bar in wrapped)
    return PressureTrace(tuple(a for a, _ in points), tuple(bar for _, bar in points), cycle // 180)


def _check_point(place: str, angle: float, bar: float, cycle: int) -> None:
    if not -cycle <= angle <= cycle:
        what, rule = f"angle = {brief(angle)}", f"must lie in [{-cycle}, {cycle}] degrees"
        raise SymbalanceError(what, rule, "count from the firing top dead centre", place)
    if not 0 <= bar <= MOST_BAR:
        what, rule = f"pressure = {brief(bar)}", f"must lie in [0, {MOST_BAR}] bar"
        raise SymbalanceError(what, rule, "give absolute pressures, in bar", place)


def _check_step(place: str, before: float, after: float) -> None:
    if after <= before:
        what, rule = f"angle = {brief(after)}", f"must be above the one before, {before}"
        raise SymbalanceError(what, rule, "sort the points, each angle once", place)
    if after - before > WIDEST:
        what = f"angle = {brief(after)}"
        rule = f"is more than {WIDEST} degrees past the one before, {before}"
        raise SymbalanceError(what, rule, "give the points between", place)


def _closed(rows: list[Point], cycle: int) -> list[Point]:
    """Return the rows of one cycle, without a last one that repeats the first."""
    (_, start, first), (place, end, last) = rows[0], rows[-1]
    if end - start > cycle + SAME:
        what, rule = f"angle = {end}", f"is more than a cycle, {cycle} degrees, past the first"
        raise SymbalanceError(what, rule, "give one cycle, or the mean of several", place)
    widest = 2 * max(b - a for (_, a, _), (_, b, _) in pairwise(rows))
    if start + cycle - end > min(widest, WIDEST):
        what, rule = f"angles from {start} to {end}", f"leave some of {cycle} degrees open"
        raise SymbalanceError(what, rule, "give a whole cycle (or strokes=2, if it has 360)", place)
    if end - start < cycle - SAME:
        return rows
    bars = [bar for *_, bar in rows]
    if abs(last - first) > CLOSING * (max(bars) - min(bars)):
        what = f"pressure = {last}"
        rule = f"must be the first one, {first}, a cycle later"
        raise SymbalanceError(what, rule, "give a periodic trace, as the mean of many cycles is", place)
    return rows[:-1]


def _check_top(rows: list[Point], cycle: int) -> None:
    """Refuse a four-stroke's trace that counts from the gas exchange."""

    def off(angle: float) -> float:
        return min(angle % cycle, -angle % cycle)

    near = max((bar for _, angle, bar in rows if off(angle) <= NEAR_TOP), default=0.0)
    place, angle, bar = max(rows, key=lambda row: row[2])
    if bar > near:
        what, rule = f"angle = {angle}", f"has the highest pressure, {bar} bar"
        remedy = "0 must be the firing top dead centre: subtract what it is off"
        raise SymbalanceError(what, rule, remedy, place)
