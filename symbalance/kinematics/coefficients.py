"""Coefficients of one cylinder's harmonics: A_n of its force; t_n, u_n and k_n of its torques.

Of centred cylinders that are alike, an order of the engine is one such coefficient, which is the
kinematics of one cylinder, times a sum over angles, which is geometry: the two are shown apart.

Formulas:
    A_1 = 1
    A_2 = rho + rho^3/4 + ...
    t_1 = rho/4 + rho^3/16 + ...
    u_2 = rho^2/2 - rho^6/32 - ...
    k_1 = -rho - rho^3/8 - ...
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import dataclass
from fractions import Fraction

from symbalance.kinematics.piston_torque import default_power as torque_power
from symbalance.kinematics.piston_torque import torque_series, torque_values
from symbalance.kinematics.rod_torque import (
    rocking_couple_series,
    rocking_couple_values,
    rod_torque_series,
    rod_torque_values,
)
from symbalance.kinematics.slider_crank import Series, acceleration_series, acceleration_values
from symbalance.text.reals import Real


@dataclass(frozen=True)
class Kinematics:
    """Coefficients of one cylinder's harmonics: letter, unit, series, values, usual highest power.

    `series(n, power)` is the coefficient of order n through (1/lambda)^power, `values(order, ratio,
    digits)` maps every n to its value exact in lambda, `power(n)` is the power that keeps two terms.
    """

    letter: str
    unit: str
    series: Callable[[int, int], Series]
    values: Callable[[int, Fraction, int], dict[int, Real]]
    power: Callable[[int], int]

    def coefficient(self, order: int, power: int | None = None) -> Series:
        """Return the coefficient of an order as a series in 1/lambda: through `power`, or two terms."""
        return self.series(order, self.power(order) if power is None else power)

    def values_of(self, orders: Collection[int], ratio: Fraction, digits: int) -> dict[int, Real]:
        """Return the coefficients of some orders, exact in lambda = `ratio`, to so many digits."""
        values = self.values(max(orders), ratio, digits) if orders else {}
        return {n: values[n] for n in orders}


def force_power(order: int) -> int:
    """Return the power of 1/lambda that keeps two terms of A_order (A_1 = 1 has but one)."""
    return order + 1 if order > 1 else 0


def rod_power(order: int) -> int:
    """Return the power of 1/lambda that keeps two terms of u_order."""
    return 6 if order == 2 else order + 2


def rocking_power(order: int) -> int:
    """Return the power of 1/lambda that keeps two terms of k_order."""
    return order + 2


OF_RODS = "J_x omega^2"
"""The unit of the rods' own inertia, J_x being that of `mechanisms.RodSplit`."""
FORCE = Kinematics("A", "m r omega^2", acceleration_series, acceleration_values, force_power)
INERTIA = Kinematics("t", "m r^2 omega^2", torque_series, torque_values, torque_power)
RODS = Kinematics("u", OF_RODS, rod_torque_series, rod_torque_values, rod_power)
ROCKING = Kinematics("k", OF_RODS, rocking_couple_series, rocking_couple_values, rocking_power)
