"""Relations as a page shows them: `left = right` of the first in a chain, `= right` of those after it."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import islice
from operator import is_

from symbalance.document.formula import (
    Constant,
    Equation,
    Formula,
    Number,
    Product,
    Quotient,
    Span,
    Upright,
    children,
    walk,
    with_children,
)
from symbalance.document.text_writer import formula_text
from symbalance.notes.checking.verdicts import Verdict
from symbalance.notes.reading.equations import Chain, ReadNotes

LARGEST_FORMULA = 300
"""Parts of a formula that is written out."""
Sides = Mapping[Span, tuple[Chain, int]]


def sides_by_span(derivation: ReadNotes) -> Sides:
    """Return the chain of each side, by where the side stands, and which side of it it is."""
    return {side.span: (chain, k) for chain in derivation.chains for k, side in enumerate(chain.sides)}


def typeset(verdict: Verdict, sides: Sides) -> Formula | Equation | None:
    """Return a verdict's relation; None where it was not read, or is too large to be written out."""
    if verdict.node is None or not is_readable(verdict.node):
        return None
    chain, k = sides.get(verdict.span, (None, 0))
    right = in_degrees(verdict.node)
    if chain is None or not k:
        return right
    left = chain.sides[k - 1].node
    first = in_degrees(left) if k == 1 and is_readable(left) else Upright("")
    return Equation(first, ((chain.relations[k - 1].sign, right),))


def is_readable(node: Formula) -> bool:
    """Tell whether a formula is small enough to be written out; the JSON has any."""
    return next(islice(walk(node), LARGEST_FORMULA, None), None) is None


def whole_chain(chain: Chain) -> Formula | Equation:
    """Return a chain as one equation."""
    rest = tuple(
        (relation.sign, in_degrees(side.node))
        for relation, side in zip(chain.relations, chain.sides[1:], strict=True)
    )
    first = in_degrees(chain.sides[0].node)
    return Equation(first, rest) if rest else first


def in_degrees(node: Formula) -> Formula:
    """Return a formula with angles in degrees as they were written: the reader makes 90° 90 π/180.

    >>> from symbalance.notes.reading import read_equation
    >>> formula_text(in_degrees(read_equation("cos(x + 90°)", {"x"}).sides[0].node))
    'cos(x + 90°)'
    """
    if isinstance(node, Product) and _is_degree(node.factors[-1]):
        (*rest, _) = node.factors
        if len(rest) == 1 and isinstance(rest[0], Number):
            return Upright(f"{formula_text(rest[0])}°")
    parts = children(node)
    changed = tuple(map(in_degrees, parts))
    return node if all(map(is_, parts, changed)) else with_children(node, changed)


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
