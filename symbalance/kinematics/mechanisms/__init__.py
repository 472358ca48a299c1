"""Piston motions beyond the centred slider-crank: offset cylinders, link rods, the rod's own inertia.

Everything is seen in the cylinder's own frame: its axis runs up from the crank, + lateral is the side
the pin moves to after p = 0, and p is the cylinder's own crank angle, the pin's angle from the axis'
direction in the sense of rotation. Lengths are over the crank radius r.

    pin                    w = e^(ip)                                      (height + i lateral)
    link pin               w = e^(ip) + L e^(i (chi - phi_master(p + D))),  chi = link angle - D
    rod angle              sin phi = (Im w - eps)/lam,    the rod points from its pin along -phi
    height of the piston   y = Re w + lam cos phi
    inertia force          F/(m r omega^2) = -y''(p), positive away from the crank

lam = l/r is the rod's own ratio, eps = e/r the offset of the cylinder's axis towards + lateral, L the
link radius over r and D the bank difference, the link cylinder's axis minus the master's. Without offset:

Formulas:
    -d^2y/dtheta^2 = cos theta + A_2 cos 2 theta + A_4 cos 4 theta + ...
    with y = cos theta + lambda cos phi

With y = sum of c_n e^(inp) the force has A_n cos np + B_n sin np, A_n - i B_n = 2 n^2 c_n. What two
symmetries make zero is left out, or is an exact 0:

- y - cos p and phi depend on sin p alone, for a slider-crank of any offset and for a link rod with
  2D whole: then even orders are cosines and odd orders sines (but for A_1 = 1);
- half a turn later y - cos p repeats and phi is reversed, without offset, for a slider-crank and for a
  link rod with 2 chi whole: then y has order 1 and even ones, phi has odd ones.

    mechanism_types     SliderCrank and LinkRod: sizes, and whether the rod reaches
    motion              height and rod angle with their derivatives;  dead_centre_angles: its stroke
    fourier             harmonics to any number of digits;  force_bounds: of those above an order
    offset_powers       the force of an offset slider-crank in powers of rho and delta
    rod_masses          the rod as two masses and a couple;  moving_masses: the force of every mass
"""

from symbalance.kinematics.mechanisms.dead_centre_angles import (
    DeadCentres,
    dead_centres,
    exact_dead_centres,
)
from symbalance.kinematics.mechanisms.force_bounds import force_tail
from symbalance.kinematics.mechanisms.fourier import force_harmonics, harmonics_of, rod_angle_harmonics
from symbalance.kinematics.mechanisms.mechanism_types import LinkRod, Mechanism, SliderCrank, has_link_pin
from symbalance.kinematics.mechanisms.motion import Motion, height, height_motion, rod_angle, rod_motion
from symbalance.kinematics.mechanisms.offset_powers import (
    OffsetPowers,
    OffsetSeries,
    delta_symbol,
    offset_left_out,
    offset_series,
)
from symbalance.kinematics.mechanisms.rod_masses import RodSplit, rocking_series, side_thrust

__all__ = [
    "DeadCentres",
    "LinkRod",
    "Mechanism",
    "Motion",
    "OffsetPowers",
    "OffsetSeries",
    "RodSplit",
    "SliderCrank",
    "dead_centres",
    "delta_symbol",
    "exact_dead_centres",
    "force_harmonics",
    "force_tail",
    "harmonics_of",
    "has_link_pin",
    "height",
    "height_motion",
    "offset_left_out",
    "offset_series",
    "rocking_series",
    "rod_angle",
    "rod_angle_harmonics",
    "rod_motion",
    "side_thrust",
]
