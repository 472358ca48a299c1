"""Free forces and couples of an engine, order by order.

In: an `Engine`. Out: a `Balance`: force and couple of each order that survives, in four exact components.

    force_sums        the sums over cylinders;  free_forces: the result
    inline_sums       closed forms for a symbolic number of cylinders
    row_formulas      those closed forms as a result, N a symbol
    shaft_moments     the roll moment of balance shafts
    rows              components as rows of a table
    operating_point   speed and sizes, which make forces newtons;  speed_table: several speeds
    all_orders        the largest force and couple over a turn;  turn_maximum: its value and bound
    balance_document, balance_data   a balance as it is written, and as data for programs
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
