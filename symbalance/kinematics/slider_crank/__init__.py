r"""One slider-crank: exact harmonics of the piston and of the rod, to any order.

The crank pin turns at radius r, the rod of length l joins it to a piston on an axis through the crank,
rho = r/l = 1/lambda < 1. With theta = 0 at top dead centre:

    displacement  x/r           = B_0 - cos theta - sum of B_n cos n theta     from top dead centre
    velocity      v/(r omega)   =       sin theta + sum of n B_n sin n theta
    acceleration  a/(r omega^2) =       cos theta + sum of A_n cos n theta,    A_n = n^2 B_n
    force         F/(m r omega^2) = the same: the inertia force, positive away from the crank
    rod-angle     phi           = asin(rho sin theta) = sum of R_n sin n theta (n odd)

over n = 2, 4, 6, .... From sqrt(1 - X) = 1 - 2 sum of Catalan(m-1) (X/4)^m with X = rho^2 sin^2 theta,
and sin^2m theta = (C(2m, m) + 2 sum of (-1)^k C(2m, m-k) cos 2k theta)/4^m,

    A_2k = (-1)^(k+1) sum over m >= k of 16 k^2 Catalan(m-1) C(2m, m-k) rho^(2m-1) / 16^m,

dyadic rationals whose numerators follow one exact integer recurrence in m. All terms of one A_2k have
the same sign, and the A_2k alternate: that makes the bounds of `left_out` sharp, not merely safe.
Likewise R_n = (-1)^i sum over j >= i of C(2j, j) C(2j+1, j-i) rho^(2j+1) / (16^j (2j+1)), n = 2i+1.

Exact in rho, with k' = sqrt(1 - rho^2) and q = (rho/(1 + k'))^2,

    A_2k = (4 k^2/rho) (1 + k') C(1/2, k) q^k 2F1(-1/2, k - 1/2; k + 1; q^2),

which converges like q^2: well before rho nears 1 and far beyond where powers of rho do.
Source: expanded afresh; the classical expansion is in Biezeno and Grammel, Technische Dynamik, ch. XI.
"""

from symbalance.kinematics.slider_crank.exact import (
    acceleration_value,
    acceleration_values,
    exact_coefficient,
    rho_root_q,
    rod_angle_value,
    root_mean,
)
from symbalance.kinematics.slider_crank.floats import acceleration_floats
from symbalance.kinematics.slider_crank.limits import (
    HIGHEST_ORDER,
    HIGHEST_POWER,
    QUANTITIES,
    checked_order,
    checked_power,
    checked_quantity,
    checked_ratio,
    surviving,
)
from symbalance.kinematics.slider_crank.powers import (
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
