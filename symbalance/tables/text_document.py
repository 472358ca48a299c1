"""Results as text for a terminal of 80 columns."""

from __future__ import annotations

from symbalance.balancing import Design
from symbalance.resultants import Balance
from symbalance.tables.design_text import design_text
from symbalance.tables.text_table import balance_text


def to_text(balance: Balance | Design) -> str:
    """Return a balance as text: the engine, its free force, its free couple, the coefficients A_n.

    A design of `design_balance` is told with its certificate.
    """
    return design_text(balance) if isinstance(balance, Design) else balance_text(balance)
