"""Engines with unequal cylinders: symbolic formulas, sensitivities, tolerances, assignment of parts.

symbolic_orders       one order with symbols for masses, stations and lengths
derivatives           how each order changes with each size of each cylinder (`sensitivity`), also of
                      master and link rods (`articulated`);  length_derivatives: by lengths
worst_case_search     the worst within tolerances, attained and bounded (`objectives`, `annular_sectors`,
                      `tolerance_intervals`)
assignment            which weighed part (`part_sets`) goes to which cylinder, with the least residual
                      (`assignment_objective`, `arrangement_search`, `assignment_bounds`, `shaking`)
size_sweep            forces, couples and torque on a grid of an engine's sizes
contributions         what one cylinder adds to an order;  as_built: what turns adds
*_document, legend    how these are written
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
