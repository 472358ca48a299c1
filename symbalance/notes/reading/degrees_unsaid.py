"""Angles in degrees without their sign, cos(120) = −1/2: a second way to read whole numbers there.

Only on a page that speaks of degrees, and where every angle in numbers on a side is one of those that are
written so: 0, 30, 45, 90, 120, …
"""

from __future__ import annotations

import re
from fractions import Fraction

from symbalance.document.formula import (
    Call,
    Constant,
    Formula,
    Number,
    Product,
    Quotient,
    children,
    walk,
    with_children,
)

_FUNCTIONS = ("sin", "cos", "tan")
_STEP, _LEAST = 15, 30
_SPEAKS = re.compile(r"°|\^\{?\\circ|\\ang(?![a-z])|\b(?:degrees?|deg|Grad|degrés)\b|度")


def speaks_of_degrees(text: str) -> bool:
    """Tell whether a page has angles in degrees."""
    return _SPEAKS.search(text) is not None


def with_degrees(readings: tuple[Formula, ...]) -> tuple[Formula, ...]:
    """Return the readings of a side and the first of them with its angles in degrees, where it has any.

    >>> from symbalance.document.text_writer import formula_text
    >>> from symbalance.notes.reading import read_expression
    >>> [formula_text(node) for node in with_degrees(read_expression("cos(120)", set()))]
    ['cos(120)', 'cos 120π/180']
    """
    angles = [
        part.argument
        for part in walk(readings[0])
        if isinstance(part, Call) and part.function in _FUNCTIONS and isinstance(part.argument, Number)
    ]
    sizes = [abs(angle.value) for angle in angles]
    are_degrees = all(size % _STEP == 0 for size in sizes) and any(size >= _LEAST for size in sizes)
    return (*readings, _in_degrees(readings[0])) if are_degrees else readings


def _in_degrees(node: Formula) -> Formula:
    if isinstance(node, Call) and node.function in _FUNCTIONS and isinstance(node.argument, Number):
        span = node.argument.span
        degree = Quotient(Constant("pi", span=span), Number(Fraction(180), span=span), span=span)
        return with_children(node, (Product((node.argument, degree), span=span),))
    parts = children(node)
    return with_children(node, tuple(map(_in_degrees, parts))) if parts else node
