r"""Torque on the crank and on the frame: inertia exact in lambda, gas from a pressure trace or cycle.

In: an `Engine`, and for gas a pressure trace or an ideal cycle. Out: torques by order, exact where the
geometry is, and the torque of the running engine in N m. Torque is positive on the crank in the sense of
rotation; the frame gets the opposite. theta is the crank angle, theta + throw - bank a cylinder's own.

    inertia_balance  the cylinders' inertia torques, order by order;  body_groups: like bodies
    roll             what the rods add, and the whole moment that rolls the frame
    star_diagrams    star diagrams of all orders, halves in a four-stroke, closed or open: exact
    pressure         pressure traces;  pressure_files: from CSV files;  ideal_cycles: computed
    cylinder_gas     gas torque of one cylinder, its work and harmonics;  gas: of the engine
    running          torque, mean, fluctuation and energy at a speed;  flywheel: what evens the speed
    torque_document, running_document, gas_document, pressure_document, torque_data   results written
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
