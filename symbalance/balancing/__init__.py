"""Balancing: rotating parts, overbalance, balance shafts, and designs with their certificates."""

from symbalance.balancing.certifying import Claim
from symbalance.balancing.designing import Design, design_balance
from symbalance.balancing.devices import Device
from symbalance.balancing.ellipses import Ellipse, ellipse
from symbalance.balancing.overbalancing import best_forward, best_overbalance, overbalanced
from symbalance.balancing.planes import in_planes
from symbalance.balancing.rotating import (
    balanced_weights,
    rotating_unbalance,
    rotating_weights,
    throw_unbalance,
)

__all__ = [
    "Claim",
    "Design",
    "Device",
    "Ellipse",
    "balanced_weights",
    "best_forward",
    "best_overbalance",
    "design_balance",
    "ellipse",
    "in_planes",
    "overbalanced",
    "rotating_unbalance",
    "rotating_weights",
    "throw_unbalance",
]
