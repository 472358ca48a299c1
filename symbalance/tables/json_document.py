"""Results as JSON, for other programs: every number exact, as a string that SymPy reads."""

from __future__ import annotations

import json

from symbalance.design.balancing import Design
from symbalance.design.balancing.design_json import design_json
from symbalance.forces.balance_json import document
from symbalance.forces.resultants import Balance


def to_json(balance: Balance | Design) -> str:
    """Return a balance or a design as a JSON document, made of strings, lists and dicts."""
    if isinstance(balance, Design):
        return design_json(balance)
    return json.dumps(document(balance), indent=1, ensure_ascii=False)
