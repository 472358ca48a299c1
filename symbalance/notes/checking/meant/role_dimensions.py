"""Whether two formulas of the same letters have different dimensions, by the roles of their letters."""

from __future__ import annotations

from collections.abc import Mapping

from symbalance.document.formula import Formula
from symbalance.notes.checking.meant.catalogue.role_units import UNIT_OF_ROLE
from symbalance.notes.checking.units.dimensions import Dimensions

_STIFFNESSES = frozenset({"stiffness", "first_rate", "second_rate", "third_rate"})
_OF_STIFFNESS = ("N/m", "N m")
"""The units of a stiffness, of a spring and of a shaft."""


def are_of_other_dimension(one: Formula, other: Formula, letters: Mapping[str, str]) -> bool:
    """Tell whether two formulas differ in their dimension; `letters` are those of the roles.

    >>> from symbalance.document.formula import Name
    >>> J, c = Name("J"), Name("c")
    >>> are_of_other_dimension(c / J, J / c, {"inertia": "J", "stiffness": "c"})
    True
    >>> are_of_other_dimension(c / J, 2 * c / J, {"inertia": "J", "stiffness": "c"})
    False
    """
    for stiffness in _OF_STIFFNESS:
        units = {
            n: UNIT_OF_ROLE.get(r, stiffness if r in _STIFFNESSES else "") for r, n in letters.items()
        }
        if not all(units.values()):
            return False
        dimensions = Dimensions({n: f"size, {unit}" for n, unit in units.items()}, {})
        first, second = dimensions.side(one, ""), dimensions.side(other, "")
        if first is None or second is None or first == second:
            return False
    return True
