"""The roll moment of balance shafts beside or above the crank, as a block of the printed tables."""

from __future__ import annotations

from symbalance.resultants import Balance
from symbalance.tables.facts import Row


def roll_rows(balance: Balance) -> list[Row]:
    """Return the roll moment of an engine's shafts by order; empty where all run on the crank's axis.

    Units F_n r, or m r^2 omega^2 where components hold the kinematics; a stroke has to be known.
    """
    layout = balance.layout
    aside = any(s.x or s.y for s in layout.balancers.shafts)
    if not aside or layout.train_of(layout.cylinders[0]).stroke is None:
        return []
    from symbalance.balancing import shaft_moment  # an engine without shafts does without this room

    found = shaft_moment(layout).items()
    return [Row(n, "roll", part) for n, part in found if n <= balance.highest]
