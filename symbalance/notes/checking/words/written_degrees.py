"""Angles in degrees as they were written: the reader makes 90° 90 π/180."""

from __future__ import annotations

from symbalance.document.formula import (
    Constant,
    Formula,
    Number,
    Product,
    Quotient,
    Upright,
    with_parts_changed,
)
from symbalance.document.text_writer import formula_text


def in_degrees(node: Formula) -> Formula:
    """Return a formula with its degrees as they were written.

    >>> from symbalance.notes.reading import read_equation
    >>> formula_text(in_degrees(read_equation("cos(x + 90°)", {"x"}).sides[0].node))
    'cos(x + 90°)'
    """
    degrees = degrees_of(node)
    if degrees is not None:
        return degrees
    return with_parts_changed(node, in_degrees)


def degrees_of(node: Formula) -> Formula | None:
    """Return 90 π/180 as 90°, None for any other formula."""
    if isinstance(node, Product) and _is_degree(node.factors[-1]):
        (*rest, _) = node.factors
        if len(rest) == 1 and isinstance(rest[0], Number):
            return Upright(f"{formula_text(rest[0])}°")
    return None


def _is_degree(node: Formula) -> bool:
    """Tell whether a factor π/180 is one sign of the source, not a quotient that the author wrote."""
    return (
        isinstance(node, Quotient)
        and isinstance(node.numerator, Constant)
        and node.numerator.name == "pi"
        and isinstance(node.denominator, Number)
        and node.denominator.value == 180
        and node.numerator.span == node.denominator.span
    )
