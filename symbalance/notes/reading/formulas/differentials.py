"""Differentials outside integrals, T dθ = p A dx: one is a letter, the others are derivatives by it.

Of the letters that change together one is chosen, an angle or time if there is any: both sides are
divided by its dθ, T = p A dx/dθ. In a sum dθ is a letter of its own and dx is (dx/dθ) dθ.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from fractions import Fraction

from symbalance.document.letters import is_greek
from symbalance.notes.reading.formulas.lexer import Token


def with_differentials(sides: Sequence[list[Token]], names: Collection[str]) -> list[list[Token]]:
    """Return the sides of a chain, its differentials in one of them, where every side holds some."""
    places = [_differentials(side) for side in sides]
    has_integral = any(token.is_cmd("int", "oint") for side in sides for token in side)
    if "d" in names or has_integral or len(sides) < 2 or not all(places):
        return list(sides)
    letters = {side[n + 1].value for side, found in zip(sides, places, strict=True) for n in found}
    known = sorted(letters & set(names), key=lambda name: (name != "t", not is_greek(name), name))
    base = known[0] if known else ""
    divides = base != "" and all(
        len(found) == 1 and not any(token.is_op("+-±∓") for token in _outside(side)[1:])
        for side, found in zip(sides, places, strict=True)
    )
    return [
        _rewritten(side, found, base, names, divides) for side, found in zip(sides, places, strict=True)
    ]


def _outside(side: Sequence[Token]) -> list[Token]:
    """Return the tokens outside brackets."""
    result, depth = [], 0
    for token in side:
        depth += {"open": 1, "close": -1}.get(token.kind, 0)
        if depth == 0:
            result.append(token)
    return result


def _differentials(side: Sequence[Token]) -> list[int]:
    """Return where a d and its letter stand outside brackets, and in no quotient such as dx/dθ."""
    result, depth = [], 0
    for place, token in enumerate(side):
        depth += {"open": 1, "close": -1}.get(token.kind, 0)
        after = side[place + 1] if place + 1 < len(side) else None
        if depth or token.kind != "name" or token.value != "d" or after is None or after.kind != "name":
            continue
        beyond = side[place + 2] if place + 2 < len(side) else None
        before = side[place - 1] if place else None
        in_quotient = (beyond is not None and beyond.is_op("/")) or (
            before is not None and before.is_op("/")
        )
        if not in_quotient and after.value != "d":
            result.append(place)
    return result


def _rewritten(
    side: Sequence[Token], places: Sequence[int], base: str, names: Collection[str], divides: bool
) -> list[Token]:
    done = list(side)
    alone = len(side) == 2 or (len(side) == 3 and side[0].is_op("+-"))
    for place in reversed(places):
        d, letter = side[place : place + 2]
        span = d.start, letter.end
        if divides and letter.value == base:
            done[place : place + 2] = [Token("number", "1", *span, Fraction(1))] if alone else []
            continue
        if letter.value == base or letter.value not in names:
            done[place : place + 2] = [Token("name", f"d_{letter.value}", *span)]
            if divides:
                below = Token("name", f"d_{base}", *span)
                done[place + 1 : place + 1] = [Token("op", "/", *span), below]
            continue
        opener, closer = Token("open", "{", *span), Token("close", "}", *span)
        below = replace(letter, value=base)
        rate = [Token("cmd", "frac", *span), opener, d, letter, closer, opener, d, below, closer]
        done[place : place + 2] = rate if divides else [*rate, Token("name", f"d_{base}", *span)]
    return done
