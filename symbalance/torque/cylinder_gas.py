"""Gas torque of one cylinder: tangential pressure, work and harmonics.

The gas turns the crank with T = (p - p_ambient) A r v/(r omega), A the piston's area: torque over A r is
the tangential pressure, in bar. That is virtual work, and true of any mechanism, a link rod's included.
With the two-sided series of the pressure, p_s, s = n/2 in a four-stroke, and of the speed, v_m (of a
centred piston A_m/(2i m)), its two-sided series is

    sum over m of v_m p_{s-m},

p_s from the straight lines between the trace's points exactly: no quadrature. Only the v_m that are below
a double's last digit are left out.

Formulas:
    v/(r omega) = sin theta + A_2/2 sin 2 theta + A_4/4 sin 4 theta + ...
    A_2/(4 i) e^(2 i theta) - A_2/(4 i) e^(-2 i theta) = A_2/2 sin 2 theta
"""

from __future__ import annotations

from bisect import bisect_right
from cmath import exp
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from math import floor, pi, sqrt

from symbalance.kinematics.mechanisms import Mechanism, SliderCrank
from symbalance.kinematics.piston_motion import Piston
from symbalance.torque.pressure import PressureTrace

AMBIENT = Fraction(101325, 100_000)
"""The pressure below the piston: the standard atmosphere, in bar."""
_ROOT = sqrt(Fraction(3, 5))
_GAUSS = ((-_ROOT, 5 / 9), (0.0, 8 / 9), (_ROOT, 5 / 9))


@dataclass(frozen=True)
class TangentialPressure:
    """One cylinder's tangential pressure, in bar, against radians after its own firing top dead centre.

    >>> trace = PressureTrace((0.0,), (3.0,))
    >>> tangential = TangentialPressure(trace, Fraction(4), 1.0)
    >>> tangential.at(pi / 2), round(tangential.work(pi), 12), abs(tangential.mean) < 1e-15
    (2.0, 4.0, True)
    """

    trace: PressureTrace
    ratio: Fraction
    ambient: float = float(AMBIENT)
    mechanism: Mechanism | None = None

    @cached_property
    def piston(self) -> Piston:
        """The piston that the gas moves: of `mechanism`, else of a centred slider-crank of `ratio`."""
        return Piston(SliderCrank(self.ratio) if self.mechanism is None else self.mechanism)

    def at(self, angle: float) -> float:
        """Return (p - p_ambient) v/(r omega)."""
        return (self.trace.at(angle * 180 / pi) - self.ambient) * self.piston.velocity(angle)

    @property
    def cycle_work(self) -> float:
        """The integral over a cycle: twice the mean effective pressure."""
        return self._work_at_points[-1]

    @property
    def mean(self) -> float:
        """The mean over a cycle."""
        return self.cycle_work / (self.trace.cycle * pi / 180)

    @property
    def mean_effective_pressure(self) -> float:
        """The work of a cycle over the swept volume, in bar; the ambient pressure has no part."""
        return self.cycle_work / self.piston.stroke

    def work(self, angle: float) -> float:
        """Return the integral from the trace's first point on, in bar: the work over A r."""
        radians = self.trace.radians
        cycles = floor((angle - radians[0]) / (radians[-1] - radians[0]))
        rest = min(angle - cycles * (radians[-1] - radians[0]), radians[-1])
        i = max(min(bisect_right(radians, rest), len(radians) - 1) - 1, 0)
        return cycles * self.cycle_work + self._work_at_points[i] + self._piece(i, rest)

    @cached_property
    def _work_at_points(self) -> list[float]:
        """The work up to each point."""
        total, sums = 0.0, [0.0]
        for i, end in enumerate(self.trace.radians[1:]):
            total += self._piece(i, end)
            sums.append(total)
        return sums

    def _piece(self, i: int, end: float) -> float:
        """Return the integral from point i to an angle before the next, Gauss's rule in small steps."""
        start, bar, slope = self._lines[i]
        if end <= start:
            return 0.0
        steps = 1 + floor((end - start) * 60)
        half = (end - start) / (2 * steps)
        total, velocity = 0.0, self.piston.velocity
        for k in range(steps):
            for place, weight in _GAUSS:
                along = half * (2 * k + 1 + place)
                total += weight * (bar + slope * along) * velocity(start + along)
        return total * half

    @cached_property
    def _lines(self) -> list[tuple[float, float, float]]:
        """The straight lines: where each starts, its first value above ambient, its slope per radian."""
        points = pairwise(zip(self.trace.radians, self.trace.closed, strict=True))
        return [(a, p - self.ambient, (r - p) / (b - a) if b > a else 0.0) for (a, p), (b, r) in points]

    def harmonics(self, order: int) -> dict[Fraction, complex]:
        """Return C + iS of each order to `order`, in bar: the sum of C cos s theta + S sin s theta.

        >>> constant = TangentialPressure(PressureTrace((0.0,), (3.0,)), Fraction(4), 1.0)
        >>> {str(s): round(c.imag, 6) for s, c in constant.harmonics(2).items() if abs(c) > 1e-15}
        {'1': 2.0, '2': 0.254025}
        """
        speeds = self.piston.speeds
        step = self.trace.strokes // 2  # orders come in steps of 1/step
        pressures = self._two_sided(step * (order + max(speeds)), step)
        sums = {}
        for k in range(1, step * order + 1):
            total = sum(
                v * _place(pressures, k - step * m) + v.conjugate() * pressures[k + step * m]
                for m, v in speeds.items()
            )
            sums[Fraction(k, step)] = 2 * total.conjugate()
        return sums

    def _two_sided(self, most: int, step: int) -> list[complex]:
        """Return p_0, p_1/step, ... p_most/step of the pressure above ambient, exact for straight lines.

        Twice integrated by parts: jumps over is, and changes of slope over s^2.
        """
        lines, period = self._lines, self.trace.cycle * pi / 180
        cyclic = pairwise([*lines, (lines[0][0] + period, *lines[0][1:])])
        corners, mean = [], 0.0
        for (start, bar, slope), (end, after, _) in cyclic:
            width = end - start
            mean += (bar + slope * width / 2) * width / period
            corners.append((end, slope, after - bar if not width else 0.0))
        sums: list[complex] = [complex(mean)]
        for k in range(1, most + 1):
            s = k / step
            total, here = 0j, exp(-1j * s * lines[0][0])
            for end, slope, jump in corners:
                before, here = here, exp(-1j * s * end)
                total += slope * (here - before) / (s * s)
                if jump:
                    total += jump * here / (1j * s)
            sums.append(total / period)
        return sums


def _place(series: list[complex], k: int) -> complex:
    return series[k] if k >= 0 else series[-k].conjugate()
