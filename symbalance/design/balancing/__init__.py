"""Balancing of an engine: rotating masses, overbalance, counterweights and shafts, with certificates.

In: an `Engine` and the orders to balance. Out: exact weights at stations, and a proof of what they leave.

    planes, bounded_weights    weights in given planes for a force and couple, within a largest size
    rotating_balance           counterweights against rotating masses
    ellipses, overbalance      what one order draws, and the first order as a function of overbalance
    order_selection, devices   which orders get a shaft, and what stands on it
    designs                    a design with its certificate;  design_limits: what it may use
    *_document, *_data, design_facts, weight_cells, design_picture   how these are written and drawn
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
