"""Dimensions of rates by their letters: ω̇ is in 1/s² and φ̇ in 1/s, whatever a page says of ω and φ.

Nobody declares the dot above an angle, and ω̇_max = 11079/2527 = 4.38 rad/s is an angular speed where an
angular acceleration stands.
"""

from __future__ import annotations

from symbalance.document.formula import Derivative, Formula, Name
from symbalance.document.letters import TIME_DOTS
from symbalance.document.wordlists import word_set
from symbalance.notes.checking.units.dimensions import Dimension, unit_of

_ANGLES = word_set("phi varphi theta vartheta psi")
_SPEEDS = word_set("omega Omega")
_RATES = ("1", "1/s", "1/s^2", "1/s^3", "1/s^4")


def rate_dimension(node: Formula) -> Dimension | None:
    """Return the dimension of the rate of an angle or of an angular speed, None for other formulas."""
    name, order = _base_and_order(node)
    times = order + 1 if name in _SPEEDS else order
    if not order or name not in _SPEEDS | _ANGLES or times >= len(_RATES):
        return None
    return unit_of(_RATES[times].replace("/", " / "))


def _base_and_order(node: Formula) -> tuple[str, int]:
    """Return the letter below the dots, without its subscript, and how many dots there are."""
    if isinstance(node, Derivative) and isinstance(node.expression, Name) and node.variable.name == "t":
        return node.expression.name.split("_")[0], node.order
    if isinstance(node, Name):
        dots, _, rest = node.name.partition("_")
        return rest.split("_")[0], TIME_DOTS.get(dots, 0)
    return "", 0
