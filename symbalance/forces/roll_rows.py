"""The roll moment of balance shafts beside or above the crank, as a block of the printed tables."""

from __future__ import annotations

from symbalance.forces.free_forces import Balance
from symbalance.forces.rows import Row
from symbalance.forces.shafts import has_shafts_aside, shaft_moment


def roll_rows(balance: Balance) -> list[Row]:
    """Return the roll moment of an engine's shafts by order; empty where all run on the crank's axis.

    Units F_n r, or m r^2 omega^2 where components hold the kinematics; a stroke has to be known.
    """
    layout = balance.layout
    if not has_shafts_aside(layout) or layout.first.stroke is None:
        return []
    found = shaft_moment(layout).items()
    return [Row(n, "roll", part) for n, part in found if n <= balance.highest]
