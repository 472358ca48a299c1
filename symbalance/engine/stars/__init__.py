"""Firing orders a crank allows, cranks an in-line engine may have, bank angles that fire evenly."""

from symbalance.engine.stars.banks import (
    even_interval,
    fewest_cylinders,
    natural_bank_angles,
    pin_offsets,
)
from symbalance.engine.stars.cranks import StarClass, crank_stars
from symbalance.engine.stars.firings import (
    Firing,
    evenest,
    firing_orders,
    intervals,
    is_even,
    known_firing,
)

__all__ = [
    "Firing",
    "StarClass",
    "crank_stars",
    "even_interval",
    "evenest",
    "fewest_cylinders",
    "firing_orders",
    "intervals",
    "is_even",
    "known_firing",
    "natural_bank_angles",
    "pin_offsets",
]
