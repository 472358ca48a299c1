"""Torque of a centred rod's own inertia on the crank, and its couple on the frame, in closed form.

A rod is two masses at its ends and a moment of inertia J_x that turns with it (`mechanisms.rod_masses`).
The crank gets what its kinetic energy J_x omega^2 phi'^2/2 loses, -phi' phi'' = sum of u_n sin n theta;
the frame gets its couple J_x omega^2 phi'', phi'' = sum of k_n sin n theta.

Formulas:
    D^2 = 1 - k'^2/(1 - rho^2 sin^2 theta)
    -D dD/dtheta = u_2 sin 2 theta + u_4 sin 4 theta + ...
    u_2 = 2 k' q
    u_4 = -4 k' q^2
    u_6 = 6 k' q^3
    u_2 = rho^2 (1 + t_2)
    u_4 = rho^2 t_4
    k_1 = -R_1
    k_3 = -9 R_3
    with D = dphi/dtheta; q = (rho/(1 + k'))^2; k' = sqrt(1 - rho^2)

In general u_2k = -2 k k' (-q)^k, odd u_n = 0, and k_n = -n^2 R_n, even k_n = 0, with t_n of
`piston_torque` and R_n of `slider_crank`. Units J_x omega^2; J_x is negative for most rods.
Source: expanded afresh; phi'^2 is the Poisson kernel again.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.kinematics.mechanisms import rocking_series
from symbalance.kinematics.piston_torque import torque_series, torque_values
from symbalance.kinematics.slider_crank import Series, checked_order, rod_angle_value
from symbalance.text.reals import Real


def rod_torque_series(order: int, through: int) -> Series:
    """Return u_order, the torque on the crank over J_x omega^2, kept through (1/lambda)^through.

    Formulas:
        u_2 = rho^2/2 - rho^6/32 - ...
        u_4 = -rho^4/4 - rho^6/8 - ...

    >>> [rod_torque_series(n, 6).in_powers_of_rho() for n in (2, 3, 4)]
    [-rho**6/32 + rho**2/2, 0, -rho**6/8 - rho**4/4]
    """
    checked_order(order)
    if order % 2:
        return Series({}, through, complete=True)
    terms = dict(torque_series(order, max(through - 2, 0)).terms)
    if order == 2:
        terms[0] = terms.get(0, Fraction(0)) + 1
    return Series({p + 2: c for p, c in sorted(terms.items()) if c and p + 2 <= through}, through)


def rod_torque_values(order: int, ratio: Fraction, digits: int = 20) -> dict[int, Real]:
    """Return every u_n to `order`, n even, exact in lambda, to `digits` significant digits.

    >>> from symbalance.text.reals import nstr
    >>> {n: nstr(u, 8) for n, u in rod_torque_values(4, Fraction(4)).items()}
    {2: '0.031241866', 4: '-0.0010080644'}
    """
    values, square = torque_values(order, ratio, digits + 20), 1 / ratio**2
    return {n: square * (t + (n == 2)) for n, t in values.items() if n % 2 == 0}


def rocking_couple_series(order: int, through: int) -> Series:
    """Return k_order, the couple on the frame over J_x omega^2, kept through (1/lambda)^through.

    Formulas:
        k_1 = -rho - rho^3/8 - ...
        k_3 = 3 rho^3/8 + 27 rho^5/128 + ...

    >>> rocking_couple_series(3, 5).in_powers_of_rho()
    27*rho**5/128 + 3*rho**3/8
    """
    return rocking_series(order, through).scaled(-1)


def rocking_couple_values(order: int, ratio: Fraction, digits: int = 20) -> dict[int, Real]:
    """Return every k_n to `order`, n odd, exact in lambda, to `digits` significant digits."""
    checked_order(order)
    return {n: -n * n * rod_angle_value(n, ratio, digits) for n in range(1, order + 1, 2)}
