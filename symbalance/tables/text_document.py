"""Results as text for a terminal of 80 columns."""

from __future__ import annotations

from symbalance.design.balancing import Design
from symbalance.design.balancing.design_text import design_text
from symbalance.forces.balance_text import balance_text
from symbalance.forces.resultants import Balance


def to_text(balance: Balance | Design) -> str:
    """Return a balance as text: the engine, its free force, its free couple, the coefficients A_n.

    A design of `design_balance` is told with its certificate.
    """
    return design_text(balance) if isinstance(balance, Design) else balance_text(balance)
