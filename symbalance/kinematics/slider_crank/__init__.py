r"""Harmonics of the centred slider-crank: piston motion, inertia force and rod angle, to any order.

The crank pin turns at radius r, the rod of length l joins it to a piston on an axis through the crank,
rho = r/l = 1/lambda < 1, and theta = 0 at top dead centre.

Formulas:
    x = r (1 - cos theta) + l (1 - cos phi)                      from top dead centre
    sin phi = rho sin theta
    x/r = B_0 - cos theta - B_2 cos 2 theta - B_4 cos 4 theta - ...
    v/(r omega) = sin theta + 2 B_2 sin 2 theta + 4 B_4 sin 4 theta + ...
    a/(r omega^2) = cos theta + A_2 cos 2 theta + A_4 cos 4 theta + ...
    F = m a                                                      positive away from the crank
    phi = R_1 sin theta + R_3 sin 3 theta + R_5 sin 5 theta + ...
    A_4 = 16 B_4                                                 A_n = n^2 B_n

From sqrt(1 - X) = 1 - 2 sum of Catalan(m-1) (X/4)^m with X = rho^2 sin^2 theta, and
sin^2m theta = (C(2m, m) + 2 sum of (-1)^k C(2m, m-k) cos 2k theta)/4^m,

    A_2k = (-1)^(k+1) sum over m >= k of 16 k^2 Catalan(m-1) C(2m, m-k) rho^(2m-1) / 16^m,

dyadic rationals whose numerators follow one exact integer recurrence in m. All terms of one A_2k have
the same sign, and the A_2k alternate: that makes the bounds of `left_out` sharp, not merely safe.
Likewise R_n = (-1)^i sum over j >= i of C(2j, j) C(2j+1, j-i) rho^(2j+1) / (16^j (2j+1)), n = 2i+1.

Formulas:
    sqrt(1 - X) = 1 - X/2 - X^2/8 - X^3/16 - ...
    asin X = X + X^3/6 + 3 X^5/40 + ...
    sin^2 theta = (1 - cos 2 theta)/2
    sin^3 theta = (3 sin theta - sin 3 theta)/4
    sin^4 theta = (3 - 4 cos 2 theta + cos 4 theta)/8
    sin^6 theta = (10 - 15 cos 2 theta + 6 cos 4 theta - cos 6 theta)/32
    with X a number

Exact in rho, with k' = sqrt(1 - rho^2) and q = (rho/(1 + k'))^2,

    A_2k = (4 k^2/rho) (1 + k') C(1/2, k) q^k 2F1(-1/2, k - 1/2; k + 1; q^2),

which converges like q^2: well before rho nears 1 and far beyond where powers of rho do.
Source: expanded afresh; the classical expansion is in Biezeno and Grammel, Technische Dynamik, ch. XI.
"""

from symbalance.kinematics.slider_crank.arguments import (
    HIGHEST_ORDER,
    HIGHEST_POWER,
    QUANTITIES,
    checked_order,
    checked_power,
    checked_quantity,
    checked_ratio,
    surviving,
)
from symbalance.kinematics.slider_crank.closed_forms import (
    acceleration_value,
    acceleration_values,
    exact_coefficient,
    rho_root_q,
    rod_angle_value,
    root_mean,
)
from symbalance.kinematics.slider_crank.floats import acceleration_floats
from symbalance.kinematics.slider_crank.power_series import (
    Harmonics,
    acceleration_integers,
    acceleration_series,
    harmonics,
    integrated,
    rod_angle_series,
)
from symbalance.kinematics.slider_crank.series import Series

__all__ = [
    "HIGHEST_ORDER",
    "HIGHEST_POWER",
    "QUANTITIES",
    "Harmonics",
    "Series",
    "acceleration_floats",
    "acceleration_integers",
    "acceleration_series",
    "acceleration_value",
    "acceleration_values",
    "checked_order",
    "checked_power",
    "checked_quantity",
    "checked_ratio",
    "exact_coefficient",
    "harmonics",
    "integrated",
    "rho_root_q",
    "rod_angle_series",
    "rod_angle_value",
    "root_mean",
    "surviving",
]
