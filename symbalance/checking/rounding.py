"""Rounded numbers: does a printed decimal agree with the other side to the digits it shows?"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from symbalance.algebra import values
from symbalance.reading import syntax
from symbalance.reading.syntax import Node, Number

TINY = Fraction(1, 10**25)
MOST_EXTRA = 2


def decimals(node: Node) -> list[Number]:
    """Return the numbers of a formula that are printed with a decimal point."""
    return [
        part
        for part in syntax.walk(node)
        if isinstance(part, Number) and part.last_place is not None and part.value
    ]


def agrees_as_printed(
    left: Node, right: Node, points: list[tuple[values.Point, list[Any]]], *, generous: bool = False
) -> bool:
    """Tell whether a side with one decimal number agrees with the other to its last digit.

    Half a unit of the last place is allowed (a whole one if `generous`: the digits may be cut off, not
    rounded), and as much again, at most twice, as the other side's own decimals may bring in.
    """
    for result, other in ((right, left), (left, right)):
        found = decimals(result)
        if len(found) == 1:
            room = relative_room(found[0]) * (2 if generous else 1)
            room += min(sum(map(relative_room, decimals(other)), Fraction(0)), MOST_EXTRA * room) + TINY
            allowed = values.context().mpf(room.numerator) / room.denominator
            if all(abs(a - b) <= allowed * max(abs(a), abs(b)) for _, (a, b) in points):
                return True
    return False


def relative_room(number: Number) -> Fraction:
    """Return half a unit of a decimal's last place, relative to it.

    >>> relative_room(Number(Fraction(1, 4), Fraction(1, 100)))
    Fraction(1, 50)
    """
    assert number.last_place is not None
    return number.last_place / 2 / abs(number.value)
