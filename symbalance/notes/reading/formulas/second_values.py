"""The same quantity once more in brackets: 5.39 kW (7.3 PS), 88 in. (2.235 m) are two values, no product.

A number with its unit, and behind it brackets that hold a number with its unit and nothing else: the
second is what the first comes to in other units, about, and is judged as that. In the same unit it is
another quantity, of which the relation says nothing: F = 5969 N (1990 N) without its middle part.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from symbalance.notes.reading.formulas.lexer import Token


def with_second_values(
    sides: Sequence[list[Token]], signs: Sequence[Token]
) -> tuple[list[list[Token]], list[Token]]:
    """Return the sides of a chain and its signs, a value in brackets as a side behind ≈.

    A chain without a relation stays as it is: a value in its text claims nothing.
    """
    if not signs:
        return list(sides), list(signs)
    done: list[list[Token]] = []
    joined: list[Token] = []
    for place, side in enumerate(sides):
        if place:
            joined.append(signs[place - 1])
        opening = _opening_of_value(side) if place else None
        if opening is None:
            done.append(side)
            continue
        bracket = side[opening]
        if _unit(side[:opening]) == _unit(side[opening + 1 : -1]):
            done.append(side[:opening])
            continue
        done += [side[:opening], side[opening + 1 : -1]]
        joined.append(replace(bracket, kind="rel", value="≈"))
    return done, joined


def _opening_of_value(side: Sequence[Token]) -> int | None:
    """Return where the bracket opens that ends a side and holds a second value of it."""
    if len(side) < 4 or side[-1].kind != "close" or side[-1].value != ")":
        return None
    opening = next((n for n in range(len(side) - 2, 0, -1) if side[n].value == "("), None)
    if opening is None or not _is_measured(side[opening + 1 : -1]):
        return None
    return opening if _is_measured(side[:opening]) else None


def _is_measured(tokens: Sequence[Token]) -> bool:
    """Tell whether tokens are one number with a unit: its factor follows the number in braces."""
    if not tokens or tokens[0].kind != "number" or tokens[0].scale is None:
        return False
    inside = tokens[1:]
    is_factor = bool(inside) and inside[0].value == "{" and inside[-1].value == "}"
    return not inside or (is_factor and all(token.end <= inside[-1].end for token in inside))


def _unit(tokens: Sequence[Token]) -> tuple[object, ...]:
    """Return what tells the unit of a measured number."""
    return tokens[0].scale, *(token.value for token in tokens[1:])
