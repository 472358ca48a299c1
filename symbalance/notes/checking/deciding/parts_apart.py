"""Two sides of one build that differ in one part: √(5.1·5000/8000) and √3.19 differ under the root."""

from __future__ import annotations

from symbalance.document.formula import Call, Formula, Power, Product, Quotient, children, names

_BUILDS = (Call, Power, Product, Quotient)
"""What changes by about as much as its part does: a sum may lose all its digits."""


def parts_apart(left: Formula, right: Formula) -> tuple[Formula, Formula] | None:
    """Return the only two parts in which numbers differ, None where they differ as wholes.

    >>> from symbalance.notes.reading import read_equation
    >>> sides = read_equation("√(2·1.6) = √3.2", set()).sides
    >>> [part.span for part in parts_apart(*(side.node for side in sides))]
    [(1, 8), (12, 15)]
    """
    if names(left) or names(right):
        return None
    first, second = left, right
    while _is_one_build(first, second):
        differing = [
            pair for pair in zip(children(first), children(second), strict=True) if pair[0] != pair[1]
        ]
        if len(differing) != 1:
            break
        first, second = differing[0]
    return None if first is left else (first, second)


def _is_one_build(first: Formula, second: Formula) -> bool:
    """Tell whether two formulas are the same function, power, product or quotient of as many parts."""
    if type(first) is not type(second) or not isinstance(first, _BUILDS):
        return False
    if isinstance(first, Call) and isinstance(second, Call) and first.function != second.function:
        return False
    return len(children(first)) == len(children(second))
