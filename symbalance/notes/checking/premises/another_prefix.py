"""A number given again with another prefix of its unit: E = 4524 J above, E = 4524 kJ here.

The same digits a thousand times larger are no other case of an example but a slip of the unit.
"""

from __future__ import annotations

from fractions import Fraction

from symbalance.document.formula import Formula, Number, Product

PREFIXES = frozenset(Fraction(1000) ** power for power in (-3, -2, -1, 1, 2, 3))
ANOTHER_PREFIX = "with another prefix: the unit is wrong"
"""How the reason of such a refutation ends."""
FEWEST_DIGITS = 3
"""Of which a number is recognised: 1 kN and 1 MN may be two loads."""


def size_of(node: Formula) -> Fraction | None:
    """Return the size of a number, perhaps with its unit, that is typed with digits enough; else None."""
    factors = node.factors if isinstance(node, Product) else (node,)
    size = Fraction(1)
    for factor in factors:
        if not isinstance(factor, Number):
            return None
        size *= factor.value
    digits = str(size.numerator * 10**12 // size.denominator).strip("0")
    return size if len(digits) >= FEWEST_DIGITS else None


def is_in_another_prefix(first: Formula, second: Formula) -> bool:
    """Tell whether two numbers have the same digits in units that are a thousand times apart."""
    sizes = size_of(first), size_of(second)
    return None not in sizes and bool(sizes[0] and sizes[1] and abs(sizes[1] / sizes[0]) in PREFIXES)
