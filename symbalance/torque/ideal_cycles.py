"""Ideal cycles of spark-ignition and Diesel engines: an ideal gas, heated at the top dead centre.

From the firing top dead centre on: heat at constant volume (Otto), then, where a peak pressure limits
it, at constant pressure (Seiliger's mixed cycle; Diesel's if the peak is the compression's end), then
p V^gamma = const to bottom dead centre. A four-stroke exhausts and takes in at constant pressures, a
two-stroke changes its gas at bottom dead centre at once. Then p V^gamma = const to the top.

With the swept volume V_h and the clearance V_c = V_h/(eps - 1), the heat Q is given as Q/V_h, in bar (1
bar = 100 J per litre): p_3 = p_2 + (gamma - 1) (eps - 1) Q/V_h, p_2 = p_intake eps^gamma.
Source: Heywood, Internal Combustion Engine Fundamentals, ch. 5 (constant-volume, constant-pressure and
limited-pressure cycles).

Of heat at constant volume alone, with E the compression ratio, K = E^gamma, and pressures p_1 to p_4
before and after compression and expansion, the closed work over the heat is the efficiency:

Formulas:
    p_3 - p_2 = (gamma - 1) (E - 1) Q
    W/Q = 1 - E/K
    with W = (p_3 - p_4 E - p_2 + p_1 E)/((gamma - 1) (E - 1)); p_4 = p_3/K;
    p_3 = p_2 + (gamma - 1) (E - 1) Q; p_2 = p_1 K; gamma, E, p_1, Q, K positive
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass
from fractions import Fraction
from math import pi
from typing import TYPE_CHECKING, Any, ClassVar

from symbalance.document.result import Result
from symbalance.engine.engine import checked_strokes
from symbalance.errors import SymbalanceError, shown
from symbalance.kinematics.mechanisms import LinkRod, SliderCrank
from symbalance.kinematics.piston_motion import Piston
from symbalance.kinematics.slider_crank import checked_ratio
from symbalance.text.measurements import measured
from symbalance.text.numbers import checked_whole
from symbalance.torque.pressure import MOST_BAR, PressureTrace

if TYPE_CHECKING:
    from symbalance.document.nodes import Document

POINTS = 2880
"""Every quarter of a degree of a four-stroke: straight lines between add 4e-6 of the work."""
MOST_POINTS = 100_000
HIGHEST_COMPRESSION = 100
MOST_HEAT = 1000
"""Bar: Q/V_h of some forty times a full load."""
NEAR = 1e-9
"""Degrees within which a point of the grid is a dead centre."""
HALVINGS = 60
"""Steps of a bisection: more than a double has bits."""


@dataclass(frozen=True, repr=False)
class IdealCycle(Result):
    """An ideal cycle: pressures in bar; `cutoff` is V/V_c at the end of constant pressure, at least 1."""

    compression_ratio: float
    gamma: float
    intake: float
    exhaust: float
    compressed: float
    peak: float
    cutoff: float
    heat: float
    strokes: int = 4

    kind: ClassVar[str] = "ideal-cycle"

    def summary(self) -> str:
        """Return compression, heat and peak, in one line."""
        return (
            f"Ideal cycle of compression ratio {self.compression_ratio:.6g}, "
            f"heat {self.heat:.6g} bar, peak {self.peak:.6g} bar"
        )

    def document(self) -> Document:
        """Return the pressures of the cycle and its work, then what they are computed from."""
        from symbalance.torque.pressure_document import cycle_document

        return cycle_document(self)

    def data(self) -> dict[str, Any]:
        """Return the pressures of the cycle, its work over the swept volume and its efficiency."""
        return {
            "strokes": self.strokes,
            "compression_ratio": self.compression_ratio,
            "gamma": self.gamma,
            "heat_bar": self.heat,
            "intake_bar": self.intake,
            "compressed_bar": self.compressed,
            "peak_bar": self.peak,
            "cutoff": self.cutoff,
            "expanded_bar": self.expanded,
            "exhaust_bar": self.exhaust,
            "mean_effective_pressure_bar": self.mean_effective_pressure,
            "efficiency": self.efficiency,
        }

    def records(self) -> list[dict[str, Any]]:
        """Return the cycle as one row, with the keys of `data`."""
        return [self.data()]

    @property
    def closed_work(self) -> float:
        """The work of compression and expansion over V_h, in bar."""
        volume, rest = self.compression_ratio, self.gamma - 1
        flat = self.peak * (self.cutoff - 1)
        down = (self.peak * self.cutoff - self.expanded * volume) / rest
        up = (self.compressed - self.intake * volume) / rest
        return (flat + down - up) / (volume - 1)

    @property
    def expanded(self) -> float:
        """The pressure at the end of expansion, in bar."""
        return self.peak * (self.cutoff / self.compression_ratio) ** self.gamma

    @property
    def mean_effective_pressure(self) -> float:
        """The work of the whole cycle over V_h, in bar: the gas exchange of a four-stroke included."""
        exchange = self.intake - self.exhaust if self.strokes == 4 else 0.0
        return self.closed_work + exchange

    @property
    def efficiency(self) -> float:
        """The closed work over the heat; 1 - eps^(1 - gamma) for Otto's cycle, without heat too."""
        if not self.heat:
            return 1 - self.compression_ratio ** (1 - self.gamma)
        return self.closed_work / self.heat

    def pressure(self, volume: float, down: bool) -> float:
        """Return the pressure of the closed part at V/V_c, on the way down or up."""
        if not down:
            return self.intake * (self.compression_ratio / volume) ** self.gamma
        return self.peak * min(1.0, (self.cutoff / volume)) ** self.gamma

    def trace(self, ratio: object, points: int = POINTS) -> PressureTrace:
        """Return the pressure against the crank angle for a rod ratio or a mechanism, at even steps.

        0 is the piston's own top dead centre. `points` is a multiple of 8; the dead centres, their jumps
        and the cutoff are added exactly. The straight lines between add about 30/points^2 of the work
        (compression ratio 10; 4e-6 for 2880).
        """
        checked_whole(points, "points", 8, MOST_POINTS, "2880 is every quarter of a degree")
        if points % 8:
            raise SymbalanceError(f"points = {points}", "must be a multiple of 8", "2880 is usual")
        known = isinstance(ratio, SliderCrank | LinkRod)
        piston = Piston(ratio if known else SliderCrank(checked_ratio(ratio)))
        down = 180.0 if piston.down == pi else piston.down * 180 / pi
        centres = [360.0 * turn + part for turn in range(self.strokes // 2) for part in (0.0, down)]
        grid = (180 * self.strokes * i / points for i in range(points))
        angles = sorted({*centres, *(a for a in grid if min(abs(a - c) for c in centres) > NEAR)})
        rows = [p for a in angles for p in self._points(a, bisect_right(centres, a) - 1, centres, piston)]
        if self.cutoff > 1:
            rows = sorted([*rows, (self._cutoff_angle(piston), 1, self.peak)])
        return PressureTrace(tuple(r[0] for r in rows), tuple(r[2] for r in rows), self.strokes)

    def _points(
        self, degrees: float, stroke: int, centres: list[float], piston: Piston
    ) -> list[tuple[float, int, float]]:
        """Return (angle, which of two, pressure) in one of the strokes: two where the pressure jumps."""
        firing, last = stroke == 0, stroke == self.strokes - 1
        here = self._closed_pressure(degrees, piston, firing) if firing or last else 0.0
        level = here if firing or last else (self.exhaust if stroke == 1 else self.intake)
        before = {0: self.compressed, 1: self.expanded, 2: self.exhaust, 3: self.intake}
        if degrees == centres[stroke] and before[stroke] != level:
            return [(degrees, 0, before[stroke]), (degrees, 1, level)]
        return [(degrees, 1, level)]

    def _closed_pressure(self, degrees: float, piston: Piston, down: bool) -> float:
        share = min(max(piston.displacement(degrees * pi / 180) / piston.stroke, 0.0), 1.0)
        return self.pressure(1 + (self.compression_ratio - 1) * share, down)

    def _cutoff_angle(self, piston: Piston) -> float:
        """Return the degrees after top dead centre at the cutoff, by bisection."""
        displacement = (self.cutoff - 1) / (self.compression_ratio - 1) * piston.stroke
        low, high = 0.0, piston.down
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            low, high = (middle, high) if piston.displacement(middle) < displacement else (low, middle)
        return high * 180 / pi


def ideal_cycle(
    compression_ratio: object,
    *,
    heat: object = None,
    peak_pressure: object = None,
    gamma: object = "1.35",
    intake: object = 1,
    exhaust: object = None,
    strokes: int = 4,
) -> IdealCycle:
    """Return the ideal cycle for a heat Q/V_h (bar), a peak pressure (bar), or both (then mixed).

    `intake` and `exhaust` are the pressures of the gas exchange, in bar absolute (equal by default).

    >>> otto = ideal_cycle(10, heat=20, gamma=1.4)
    >>> round(otto.efficiency, 6), round(1 - 10**-0.4, 6), round(otto.peak, 3)
    (0.601893, 0.601893, 97.119)
    >>> mixed = ideal_cycle(16, heat=20, gamma=1.4, peak_pressure=100)
    >>> round(mixed.cutoff, 4), round(mixed.efficiency, 4)
    (1.4893, 0.6532)
    """
    volume = _above(
        compression_ratio, "compression_ratio", 1, HIGHEST_COMPRESSION, "a volume ratio, 8 to 22"
    )
    index = _above(gamma, "gamma", 1, 2, "1.4 is cold air, 1.25 to 1.35 burnt gas")
    bottom = _above(intake, "intake", 0, MOST_BAR, "absolute, in bar")
    out = bottom if exhaust is None else _above(exhaust, "exhaust", 0, MOST_BAR, "absolute, in bar")
    if checked_strokes(strokes) == 2 and out != bottom:
        rule = "must be the intake's: the gas of a two-stroke changes at bottom dead centre"
        raise SymbalanceError(f"exhaust = {shown(exhaust)}", rule, "leave it out")
    pressed = bottom * volume**index
    peak, cutoff, added = _add_heat(heat, peak_pressure, volume, index, pressed)
    return IdealCycle(volume, index, bottom, out, pressed, peak, cutoff, added, strokes)


def _add_heat(
    heat: object, peak_pressure: object, volume: float, index: float, pressed: float
) -> tuple[float, float, float]:
    """Return the peak pressure, the cutoff and the heat."""
    if heat is None and peak_pressure is None:
        raise SymbalanceError("ideal_cycle(...)", "needs heat or peak_pressure", "heat=20 is full load")
    scale = (volume - 1) * (index - 1)
    added = None if heat is None else _heat(heat)
    if peak_pressure is None:
        assert added is not None
        return pressed + scale * added, 1.0, added
    peak = _above(peak_pressure, "peak_pressure", 0, MOST_BAR, "absolute, in bar")
    if peak < pressed * (1 - 1e-12):
        rule = f"is below the compression's end, {pressed:.6g} bar"
        raise SymbalanceError(
            f"peak_pressure = {shown(peak_pressure)}", rule, "raise it, or compress less"
        )
    if added is None:
        return peak, 1.0, (peak - pressed) / scale
    remaining = added - (peak - pressed) / scale
    cutoff = 1 + remaining * (volume - 1) * (index - 1) / (index * peak)
    if remaining < -1e-12 * added or cutoff > volume:
        rule = (
            "is not reached with this heat" if remaining < 0 else "leaves heat beyond bottom dead centre"
        )
        remedy = "leave peak_pressure out" if remaining < 0 else "raise it, or add less heat"
        raise SymbalanceError(f"peak_pressure = {shown(peak_pressure)}", rule, remedy)
    return peak, max(cutoff, 1.0), added


def _heat(heat: object) -> float:
    number = measured(heat, "heat")
    if not 0 <= number <= MOST_HEAT:
        rule, remedy = (
            f"must lie in [0, {MOST_HEAT}]",
            "Q/V_h in bar: 100 J per litre; 0 is a motored engine",
        )
        raise SymbalanceError(f"heat = {shown(heat)}", rule, remedy)
    return float(number)


def _above(value: object, name: str, low: int, high: int, remedy: str) -> float:
    number = measured(value, name)
    if not Fraction(low) < number <= high:
        raise SymbalanceError(f"{name} = {shown(value)}", f"must lie in ({low}, {high}]", remedy)
    return float(number)
