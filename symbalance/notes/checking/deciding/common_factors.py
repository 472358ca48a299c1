"""Factors that both sides of a relation have as typed: 4 λ K cos 2θ = 4(0.3125)(4549) cos 2θ less cos 2θ.

What is left of one side may be numbers put in, which are judged as such; a product's equality follows.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from symbalance.document.formula import Formula, Negative, Number, Product, names
from symbalance.notes.reading.equations import Side


def without_common_factor(left: Side, right: Side) -> tuple[Side, Side] | None:
    """Return two sides without the factors with letters that both have as typed; None if none."""
    first, second = _factors(left.node), _factors(right.node)
    shared: list[Formula] = []
    for factor in second:
        if names(factor) and first.count(factor) > shared.count(factor):
            shared.append(factor)
    if not shared:
        return None
    return _less(left, first, shared), _less(right, second, shared)


def _factors(node: Formula) -> list[Formula]:
    if isinstance(node, Negative):
        return [Number(Fraction(-1)), *_factors(node.operand)]
    if isinstance(node, Product):
        return [each for factor in node.factors for each in _factors(factor)]
    return [node]


def _less(side: Side, factors: list[Formula], shared: list[Formula]) -> Side:
    rest = list(factors)
    for factor in shared:
        rest.remove(factor)
    node = rest[0] if len(rest) == 1 else Product(tuple(rest)) if rest else Number(Fraction(1))
    return replace(side, readings=(node,))
