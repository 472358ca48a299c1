"""Free forces and couples: the sums over an engine's cylinders, order by order.

In: a `Layout`. Out: a `Balance`: for each order that survives, force and couple in four components,
exact.

    resultants                  the sums;  unlike_spectrum, rotating: unlike cylinders, what turns
    summation                   closed forms for a symbolic number of cylinders
    shafts                      the roll moment of balance shafts
    balance_text, _latex, _json the tables
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
