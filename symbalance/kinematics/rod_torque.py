r"""What the couple of a centred rod's own inertia does to the crank and to the frame, in closed form.

A rod is two masses at its ends and a moment of inertia J_x that turns with it (`mechanisms.rod`). The
crank gets what its kinetic energy J_x omega^2 phi'^2/2 loses, the frame its couple J_x omega^2 phi'':

    -phi' phi'' = sum of u_n sin n theta,    phi'^2 = 1 - k'^2/(1 - rho^2 sin^2 theta),
    u_2k = -2 k k' (-q)^k,    odd u_n = 0:    u_n = rho^2 t_n but for u_2 = rho^2 (1 + t_2),
    phi'' = sum of k_n sin n theta,    k_n = -n^2 R_n, even k_n = 0.

k' = sqrt(1 - rho^2), q = (rho/(1 + k'))^2, t_n of `inertia`, R_n of
`symbalance.kinematics.slider_crank`. Units J_x omega^2; J_x is negative for most rods.
Source: expanded afresh; phi'^2 is the Poisson kernel again.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.kinematics.mechanisms import rocking_series
from symbalance.kinematics.piston_torque import torque_series, torque_values
from symbalance.kinematics.slider_crank import Series, checked_order, rod_angle_value
from symbalance.text.reals import Real


def rod_torque_series(order: int, through: int) -> Series:
    """Return u_order, the crank's, kept through (1/lambda)^through.

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
    """Return k_order, the frame's, kept through (1/lambda)^through.

    >>> rocking_couple_series(3, 5).in_powers_of_rho()
    27*rho**5/128 + 3*rho**3/8
    """
    return rocking_series(order, through).scaled(-1)


def rocking_couple_values(order: int, ratio: Fraction, digits: int = 20) -> dict[int, Real]:
    """Return every k_n to `order`, n odd, exact in lambda, to `digits` significant digits."""
    checked_order(order)
    return {n: -n * n * rod_angle_value(n, ratio, digits) for n in range(1, order + 1, 2)}
