"""What both renderers share: the binding strength of each kind of node, and exact decimals."""

from __future__ import annotations

from fractions import Fraction

from symbalance.reading.syntax import (
    Call,
    Constant,
    Derivative,
    Dots,
    Name,
    Negative,
    Node,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Summation,
)

SUM, SIGN, PRODUCT, QUOTIENT, POWER, ATOM = range(6)
"""How tightly a node binds; a node within one that binds tighter needs brackets."""

_STRENGTH: dict[type[Node], int] = {
    Sum: SUM, Dots: SUM, Negative: SIGN, Summation: SIGN, Product: PRODUCT, Quotient: QUOTIENT,
    Derivative: QUOTIENT, Power: POWER, Call: ATOM, Name: ATOM, Constant: ATOM,
}  # fmt: skip


def strength(node: Node) -> int:
    """Return how tightly a node binds."""
    if isinstance(node, Number):
        if node.value < 0:
            return SIGN
        return ATOM if numeral(node) else QUOTIENT
    if isinstance(node, Product):
        return strength(node.factors[0]) if len(node.factors) == 1 else PRODUCT if node.factors else ATOM
    if isinstance(node, Sum):
        return strength(node.terms[0]) if len(node.terms) == 1 else SUM if node.terms else ATOM
    return _STRENGTH[type(node)]


def numeral(number: Number) -> str:
    """Return the absolute value's digits as printed, or "" where it is no decimal number.

    >>> numeral(Number(Fraction(201, 50), Fraction(1, 100))), numeral(Number(Fraction(1, 3)))
    ('4.02', '')
    """
    value, place = abs(number.value), number.last_place
    if place is None:
        return str(value) if value.denominator == 1 else ""
    steps = value / place
    decimals = _power_of_ten(place)
    if decimals is None or steps.denominator != 1:
        return ""
    if decimals > 0:
        digits = str(steps.numerator).rjust(decimals + 1, "0")
        return f"{digits[:-decimals]}.{digits[-decimals:]}"
    digits = str(steps.numerator).rjust(2, "0")
    return f"{digits[:-1]}.{digits[-1]}e{1 - decimals}"


def _power_of_ten(place: Fraction) -> int | None:
    """Return n of place = 10^-n, or None."""
    top, bottom = place.numerator, place.denominator
    zeros = len(str(max(top, bottom))) - 1
    if top == 1 and bottom == 10**zeros:
        return zeros
    return -zeros if bottom == 1 and top == 10**zeros else None


def merged(number: Number) -> tuple[int, int]:
    """Return numerator and denominator of a number's absolute value."""
    value = abs(number.value)
    return value.numerator, value.denominator


def is_whole(node: Node) -> bool:
    """Tell whether a node is a natural number printed without a point."""
    return (
        isinstance(node, Number)
        and node.value >= 0
        and node.value.denominator == 1
        and node.last_place is None
    )


def begins_with_digit(text: str) -> bool:
    """Tell whether a text begins with a digit or point."""
    return text[:1].isdecimal() or text.startswith(".")
