"""What a designer changes: counterweights, balance shafts, tolerances, weighed parts.

In: a `Engine` and what is wanted of it. Out: designs with certificates, worst cases that are reached and
proved, derivatives, assignments.

    balancing     the least weights and shafts that end given orders
    variations    formulas in parts' sizes, sensitivities, tolerances, weighed parts
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
