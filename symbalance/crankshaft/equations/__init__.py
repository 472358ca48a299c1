"""Symbolic derivation of the equations of motion of a running crankshaft.

quantities   the symbols, and the polynomial ring that keeps every coefficient in normal form
rotations    small rotations to the second order: a rotation vector, six Cardan orders
node         the linear equations of a general node, from its kinetic energy
published    the paper's equation (1), compared entry by entry
bearings     a bearing's stiffness and damping in turning coordinates
node_document   its document
"""

from symbalance.crankshaft.equations.bearings import TurnedBearing, turned_bearing
from symbalance.crankshaft.equations.node import NodeEquations, node_equations
from symbalance.crankshaft.equations.published import compare_with_published

__all__ = [
    "NodeEquations",
    "TurnedBearing",
    "compare_with_published",
    "node_equations",
    "turned_bearing",
]
