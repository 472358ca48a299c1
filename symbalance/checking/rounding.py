"""Rounded numbers: does a printed decimal agree with the other side to the digits it shows?"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from symbalance.algebra import values
from symbalance.algebra.evaluation import Meaning
from symbalance.algebra.trees import TreeValues
from symbalance.checking.changing import replaced
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
    """Tell whether a rounded side agrees with the other to the last digits printed.

    Half a unit of the last place is allowed (a whole one if `generous`: the digits may be cut off, not
    rounded), and as much again, at most twice, as the other side's own decimals may bring in.
    """
    for k, (result, other) in enumerate(((right, left), (left, right))):
        for _, pair in points:
            room = _room(result, abs(pair[1 - k])) * (2 if generous else 1)
            if not room:
                break
            room += min(_room(other, abs(pair[k])), MOST_EXTRA * room)
            if abs(pair[0] - pair[1]) > room * (1 + 1e-9) + abs(pair[0]) * float(TINY):
                break
        else:
            return True
    return False


def _room(node: Node, value: Any) -> Any:
    """Return how much a side may be off, half a unit in the last place of each of its decimals."""
    found = decimals(node)
    if len(found) < 2 or syntax.names(node):
        return sum(float(relative_room(d)) for d in found) * value
    here = TreeValues(Meaning(), {})
    total = 0
    for number in found:
        assert number.last_place is not None
        shifted = replaced(node, number, Number(number.value + number.last_place / 2))
        total += abs(here.value(shifted) - here.value(node))
    return total


def relative_room(number: Number) -> Fraction:
    """Return half a unit of a decimal's last place, relative to it.

    >>> relative_room(Number(Fraction(1, 4), Fraction(1, 100)))
    Fraction(1, 50)
    """
    assert number.last_place is not None
    return number.last_place / 2 / abs(number.value)
