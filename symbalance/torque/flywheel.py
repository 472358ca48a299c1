"""Fluctuation of a torque over its cycle, and the flywheel that evens out the speed.

What a torque T(theta) does beyond its mean is stored in all that turns, of moment of inertia J. Under a
constant load its energy E, the integral of T - mean, swings by dE = max E - min E, and the speed between
omega_max and omega_min, p and n here, delta = (p - n)/omega of its mean omega = (p + n)/2:

Formulas:
    J (p^2 - n^2)/2 = J delta omega^2
    with delta = (p - n)/omega; omega = (p + n)/2; J, p, n positive

so that J = dE/(delta omega^2).
Source: Shigley, Mechanical Engineering Design, flywheels (delta is its C_s).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import sqrt

from symbalance.errors import SymbalanceError, brief
from symbalance.text.measurements import as_float, measurement, positive_float

POINTS = 1440
"""Of the grid on which extremes are sought: two a degree of a four-stroke's cycle."""
_FINE = 48
"""Steps of the golden section: each narrows the bracket to 0.618 of it."""
_GOLDEN = (sqrt(5) - 1) / 2


@dataclass(frozen=True)
class Fluctuation:
    """Fluctuation of a torque over its cycle: mean, least and largest in N m; energy and work in J.

    `energy` is the largest swing of the integral of T - mean, `work` the work of a cycle.
    """

    mean: float
    least: float
    largest: float
    energy: float
    work: float

    @property
    def of_torque(self) -> float:
        """The coefficient of fluctuation of torque: (largest - least)/mean."""
        return (self.largest - self.least) / self._checked(self.mean)

    @property
    def of_energy(self) -> float:
        """The coefficient of fluctuation of energy: the swing over the work of a cycle."""
        return self.energy / self._checked(self.work)

    def _checked(self, value: float) -> float:
        if self.mean <= 1e-12 * max(abs(self.least), abs(self.largest)):
            what, rule = f"mean torque = {self.mean:.6g} N m", "must be positive for a coefficient"
            raise SymbalanceError(what, rule, "use least, largest and energy themselves")
        return value


def least_and_largest(function: Callable[[float], float], cycle: float) -> tuple[float, float]:
    """Return the least and the largest value over a cycle: the best of a grid, then a golden section.

    >>> from math import sin
    >>> [round(v, 12) for v in least_and_largest(lambda a: sin(a + 0.123), 6.283185307179586)]
    [-1.0, 1.0]
    """
    step = cycle / POINTS
    values = [function(i * step) for i in range(POINTS)]
    least = min(range(POINTS), key=values.__getitem__)
    largest = max(range(POINTS), key=values.__getitem__)
    low = -_golden_section(lambda a: -function(a), least * step, step)
    high = _golden_section(function, largest * step, step)
    return min(low, values[least]), max(high, values[largest])


def _golden_section(function: Callable[[float], float], place: float, step: float) -> float:
    """Return the largest value within a step of a place."""
    low, high = place - step, place + step
    for _ in range(_FINE):
        lower, upper = high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)
        if function(lower) < function(upper):
            low = lower
        else:
            high = upper
    return function((low + high) / 2)


def flywheel_inertia(energy: float, omega: float, delta: object) -> float:
    """Return the flywheel's inertia J = dE/(delta omega^2) in kg m^2; `energy` in J, `omega` in rad/s.

    Formulas:
        J ((omega (1 + delta/2))^2 - (omega (1 - delta/2))^2)/2 = K
        with J = K/(delta omega^2); K, delta positive

    >>> flywheel_inertia(500.0, 100.0, "1/50")
    2.5
    """
    work, speed = as_float(energy, "energy"), positive_float(omega, "omega")
    return work / (positive_float(delta, "delta") * speed**2)


def checked_delta(delta: object, name: str = "delta") -> float:
    """Return a speed fluctuation (omega_max - omega_min)/omega, or refuse what does not lie in (0, 1)."""
    number = measurement(delta, name)
    if not 0 < number < 1:
        what, rule = f"{name} = {brief(delta)}", "must lie between 0 and 1"
        raise SymbalanceError(what, rule, "(highest - lowest)/mean speed, often 0.02")
    return float(number)


def speed_fluctuation(energy: float, omega: float, inertia: object) -> float:
    """Return delta = (omega_max - omega_min)/omega = dE/(J omega^2), the speed fluctuation; J in kg m^2.

    Formulas:
        (omega (1 + delta/2) - omega (1 - delta/2))/omega = delta
        J delta omega^2 = K
        with delta = K/(J omega^2); K, J positive

    >>> speed_fluctuation(500.0, 100.0, 2.5)
    0.02
    """
    return energy / (positive_float(inertia, "inertia") * omega**2)
