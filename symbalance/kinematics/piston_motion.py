"""One piston in floating point: displacement, velocity and acceleration from its own top dead centre.

Angles `a` are the crank's, in radians after the piston's own top dead centre, which an offset axis or a
link rod moves away from p = 0 of `mechanisms`. Displacement and stroke are over r, velocities over
r omega, towards the crank.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import ceil, cos, pi, sin, sqrt

from symbalance.kinematics.mechanisms import DeadCentres, LinkRod, Mechanism, SliderCrank, dead_centres
from symbalance.kinematics.mechanisms.fourier import series_of
from symbalance.kinematics.mechanisms.mechanism_types import simplified
from symbalance.kinematics.slider_crank import HIGHEST_ORDER, acceleration_floats

VISIBLE = 40
"""Nepers below which a harmonic of the speed does not show in a double."""


def velocity(angle: float, crank: float) -> float:
    """Return v/(r omega) of a centred piston at an angle after top dead centre, for lambda = `crank`.

    Formulas:
        v/(r omega) = sin theta (1 + cos theta/sqrt(lambda^2 - sin^2 theta))
    """
    sine, cosine = sin(angle), cos(angle)
    return sine * (1 + cosine / sqrt((crank - sine) * (crank + sine)))


def acceleration(angle: float, crank: float) -> float:
    """Return a/(r omega^2), the velocity's derivative, at an angle after top dead centre.

    Formulas:
        a/(r omega^2) = cos theta + (w^2 cos 2 theta + (sin theta cos theta)^2)/w^3
        with w = sqrt(lambda^2 - sin^2 theta)
    """
    sine, cosine = sin(angle), cos(angle)
    square = (crank - sine) * (crank + sine)
    return cosine + ((cosine - sine) * (cosine + sine) * square + (sine * cosine) ** 2) / square**1.5


@dataclass(frozen=True)
class Piston:
    """The piston of a mechanism, from its own top dead centre.

    >>> vr6 = Piston(SliderCrank("3.4", "0.3"))
    >>> round(vr6.stroke, 6), round(vr6.down * 180 / pi, 3), round(vr6.velocity(1.0), 6)
    (2.008585, 183.271, 0.959201)
    """

    mechanism: Mechanism

    @cached_property
    def _centred(self) -> float | None:
        """lambda of a centred slider-crank, whose closed forms are quicker."""
        mechanism = simplified(self.mechanism)
        if isinstance(mechanism, SliderCrank) and not mechanism.offset:
            return float(mechanism.ratio)
        return None

    @cached_property
    def _centres(self) -> DeadCentres:
        return dead_centres(self.mechanism, 30)

    @cached_property
    def top(self) -> float:
        """The crank angle p of the top dead centre, in radians."""
        return 0.0 if self._centred else float(self._centres.top)

    @cached_property
    def down(self) -> float:
        """The crank angle that the downward stroke takes, in radians."""
        return pi if self._centred else float(self._centres.down)

    @cached_property
    def stroke(self) -> float:
        """The distance between the dead centres, over r."""
        return 2.0 if self._centred else float(self._centres.stroke)

    def displacement(self, a: float) -> float:
        """Return the displacement from top dead centre, over r.

        Of a centred piston:

        Formulas:
            x/r = 2 sin^2(theta/2) + lambda - sqrt(lambda^2 - sin^2 theta)
        """
        if self._centred:
            return 2 * sin(a / 2) ** 2 + self._centred - sqrt(self._centred**2 - sin(a) ** 2)
        return float(self._centres.highest) - self._motion(a)[0]

    def velocity(self, a: float) -> float:
        """Return v/(r omega)."""
        return velocity(a, self._centred) if self._centred else -self._motion(a)[1]

    def acceleration(self, a: float) -> float:
        """Return the velocity's derivative by the crank angle."""
        return acceleration(a, self._centred) if self._centred else -self._motion(a)[2]

    def rod_rates(self, a: float) -> tuple[float, float]:
        """Return phi' and phi'', the rod's angular speed and acceleration over omega and omega^2."""
        return self._motion(a)[3:]

    def _motion(self, a: float) -> tuple[float, float, float, float, float]:
        """Return y, y', y'', phi', phi'' by the formulas of `mechanisms`."""
        p = a + self.top
        turn = complex(cos(p), sin(p))
        pin, first, second = turn, 1j * turn, -turn
        if isinstance(self.mechanism, LinkRod):
            pin, first, second = (x + y for x, y in zip((pin, first, second), self._arm(p), strict=True))
        return _rod_driven(pin, first, second, *self._sizes)

    @cached_property
    def _sizes(self) -> tuple[float, float]:
        return float(self.mechanism.length), float(self.mechanism.offset)

    def _arm(self, p: float) -> tuple[complex, complex, complex]:
        """Return the link pin's place from the crank pin, with both derivatives."""
        link = self.mechanism
        assert isinstance(link, LinkRod)
        lean = p + 2 * pi * float(link.bank_difference)
        turn = complex(cos(lean), sin(lean))
        length, offset = float(link.master.ratio), float(link.master.offset)
        *_, rate, change = _rod_driven(turn, 1j * turn, -turn, length, offset)
        sine = (turn.imag - offset) / length
        chi = 2 * pi * float(link.pin_direction)
        direction = complex(cos(chi), sin(chi)) * complex(sqrt((1 - sine) * (1 + sine)), -sine)
        arm = float(link.link_radius) * direction
        return arm, -1j * rate * arm, -arm * (1j * change + rate**2)

    @cached_property
    def speeds(self) -> dict[int, complex]:
        """The v_m, m > 0, of the speed as sum of v_m e^(ima), v_-m = conj(v_m), that show in a double."""
        most = min(HIGHEST_ORDER, 2 * (2 + ceil(VISIBLE / (2 * max(self.mechanism.strip, 1e-9)))))
        if self._centred:
            ratio = simplified(self.mechanism).length
            return {m: a / (2j * m) for m, a in acceleration_floats(most, ratio).items()}
        heights = series_of(self.mechanism, most, 20, "height")
        rotated = {
            m: complex(c) * complex(cos(m * self.top), sin(m * self.top)) for m, c in heights.items()
        }
        return {m: -1j * m * c for m, c in rotated.items() if m}


def _rod_driven(
    pin: complex, first: complex, second: complex, length: float, offset: float
) -> tuple[float, float, float, float, float]:
    """Return y, y', y'', phi', phi'' of a piston whose rod turns on a moving pin."""
    sine = (pin.imag - offset) / length
    cosine = sqrt((1 - sine) * (1 + sine))
    rate = first.imag / (length * cosine)
    change = (second.imag / length + sine * rate**2) / cosine
    speed = first.real - length * sine * rate
    return (
        pin.real + length * cosine,
        speed,
        second.real - length * (sine * change + cosine * rate**2),
        rate,
        change,
    )
