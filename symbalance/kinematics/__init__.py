"""Kinematics of one cylinder: how its piston moves, and the harmonics of its inertia force and torque.

In: a rod ratio, an offset, a link rod. Out: integer coefficients in powers of 1/lambda, values exact in
lambda, proved bounds on what a truncation leaves out, and the derivation step by step.

    slider_crank            harmonics of the centred slider-crank
    mechanisms              offset axes, link rods, the rod's two masses and its couple
    piston_motion           any mechanism's piston in floating point
    truncation              bounds on the orders left out;  truncation_table: as a table
    piston_torque, rod_torque, mechanism_torque   the torque's harmonics: closed, and of any mechanism
    bodies                  what moves with a mechanism: piston, rod, link rod's big end
    coefficients            A_n, t_n, u_n, k_n, which like cylinders have in common
    series_printing         a series as a formula;  conventions: in which letter
    harmonics_document, derivation   the series of a quantity, as a table and step by step
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
