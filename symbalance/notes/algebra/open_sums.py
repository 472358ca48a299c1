"""Dots in a sum: it has more terms than are printed, and between others no value without them."""

from __future__ import annotations

from symbalance.document.formula import Dots, Formula, Sum, names, walk

NOT_CONTINUED = "dots between terms that are not seen to go on in one way"
NUMBERS_WITHOUT_END = "a sum of numbers without end, of which only the first are printed"
FEWEST_PRINTED = 2
"""Numbers before the dots: of 3.14… alone the digits go on."""


def goes_on_within(node: Sum) -> bool:
    """Tell whether dots stand between the terms of a sum, not only behind them."""
    is_dots = [isinstance(term, Dots) for term in node.terms]
    return any(is_dots) and not all(is_dots[is_dots.index(True) :])


def has_open_numbers(node: Formula) -> bool:
    """Tell whether a formula holds a sum of numbers alone that ends in dots, 1 - 1/3 + 1/5 - …"""
    return any(_is_open(part) for part in walk(node) if isinstance(part, Sum))


def _is_open(node: Sum) -> bool:
    printed = [term for term in node.terms if not isinstance(term, Dots)]
    ends = isinstance(node.terms[-1], Dots) and node.terms[-1].order is None
    return ends and len(printed) >= FEWEST_PRINTED and not names(node)
