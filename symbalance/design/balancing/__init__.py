"""Balancing: rotating parts, overbalance, balance shafts, and designs with their certificates."""

from symbalance.design.balancing.certifying import Claim
from symbalance.design.balancing.designing import Design, design_balance
from symbalance.design.balancing.devices import Device
from symbalance.design.balancing.ellipses import Ellipse, ellipse
from symbalance.design.balancing.overbalancing import best_forward, best_overbalance, overbalanced
from symbalance.design.balancing.planes import in_planes
from symbalance.design.balancing.rotating import (
    RotatingBalance,
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
    "RotatingBalance",
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
