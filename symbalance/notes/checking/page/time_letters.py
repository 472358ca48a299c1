"""The letter of time that a page brings in itself: θ = ω t, the crank angle and its speed being declared.

Nobody declares t. Undeclared it is a letter like any other: cos(ω t) + λ cos(2ω t) = 0 would be no
equation for an angle, and t stands on one side only of whatever is said of θ next.
"""

from __future__ import annotations

from dataclasses import replace

from symbalance.document.formula import Name, Product, names
from symbalance.notes.checking.declared.sidecar import Declarations
from symbalance.notes.checking.declared.symbol_roles import letters_by_role
from symbalance.notes.checking.meant.motion_in_time import has_another_value
from symbalance.notes.reading.equations import ReadNotes


def with_time(page: ReadNotes, declarations: Declarations) -> Declarations:
    """Return the declarations with the letter that that turns an angle at its speed, where none is."""
    roles = letters_by_role(declarations.symbols)
    if "time" in roles:
        return declarations
    for chain in page.chains:
        for before, after in zip(chain.sides, chain.sides[1:], strict=False):
            head, value = before.node, after.node
            if not isinstance(head, Name) or head.name not in roles.get("crank angle", ()):
                continue
            if not isinstance(value, Product) or not all(isinstance(f, Name) for f in value.factors):
                continue
            others = names(value) - set(roles.get("angular speed", ()))
            if len(value.factors) != 2 or len(others) != 1:
                continue
            (name,) = others
            if name not in declarations.symbols and not has_another_value(name, page):
                return replace(declarations, symbols={**declarations.symbols, name: "time"})
    return declarations
