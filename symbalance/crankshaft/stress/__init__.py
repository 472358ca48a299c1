"""Stresses of a crankshaft as linear functions of its displacements, and its durability under them.

concentration   stress concentration factors of the fillets by published formulas, with their range
channels        the named stresses and twists of a crank: pins, fillets; section loads
fatigue         mean and amplitude, Goodman's line, rainflow damage
"""

from symbalance.crankshaft.stress.channels import Channel, channels, stress_matrix
from symbalance.crankshaft.stress.concentration import FilletFactors, fillet_factors
from symbalance.crankshaft.stress.fatigue import Durability, durability

__all__ = [
    "Channel",
    "Durability",
    "FilletFactors",
    "channels",
    "durability",
    "fillet_factors",
    "stress_matrix",
]
