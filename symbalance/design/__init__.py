"""Design for low vibration: comparisons, counterweights and shafts, tolerances, assignment of parts.

In: an `Engine` and the orders, tolerances or parts in question. Out: designs with certificates, worst
cases that are attained and proved, derivatives, assignments.

    balancing     the least counterweights and shafts that balance given orders
    comparison    several engines side by side, a line each
    variations    formulas in parts' sizes, sensitivities, tolerances, weighed parts
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
