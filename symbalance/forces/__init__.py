"""Free forces and couples: the sums over an engine's cylinders, order by order.

In: an `Engine`. Out: a `Balance`: force and couple of each order that survives, in four exact components.

    planar_vectors              the sums;  resultants: the result
    summation                   closed forms for a symbolic number of cylinders
    shafts                      the roll moment of balance shafts
    rows, roll_rows             components as rows of a table
    balance_document, balance_data              what is written of a balance, and its data for programs
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
