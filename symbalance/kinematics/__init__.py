"""One cylinder: how its piston moves, and the harmonics of the forces and torques that makes.

In: a rod ratio, an offset, a link rod. Out: integer coefficients in powers of 1/lambda, values exact in
lambda, proved bounds on what a truncation leaves out, and the derivation step by step.

    slider_crank            harmonics of the centred slider-crank
    mechanisms              offset axes, link rods, the rod's own inertia;  pistons: in floating point
    truncation              bounds on the orders left out;  truncation_table: as a table
    inertia, rod, kinetic   the torque's harmonics, closed and for any mechanism
    bodies                  what moves with a mechanism: piston, rod, link rod's big end
    coefficients            A_n, t_n, u_n, k_n, which like cylinders have in common
    series_printing         a series as a formula;  conventions: in which letter
    harmonics_document, derivation   the series of a quantity, as a table and step by step
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
