"""Errors of single cylinders that serve an aim: how a worst engine is reached, one cylinder at a time."""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from itertools import product
from math import degrees
from typing import NamedTuple

from symbalance.design.variations.boxes import Box

MODES = ("largest", "vertical", "lateral", "forward", "backward")


def seen(ahead: complex, against: complex, mode: str) -> float:
    """Return what one looks at of c_n and c_-n: a component's amplitude, or the largest modulus."""
    match mode:
        case "vertical":
            return abs(ahead.conjugate() + against)
        case "lateral":
            return abs(ahead.conjugate() - against)
        case "forward":
            return abs(ahead)
        case "backward":
            return abs(against)
    return abs(ahead) + abs(against)


Aim = tuple[complex, complex]
"""What c_n and c_-n are multiplied by in the real number that is to be made large."""


def aim_at(ahead: complex, against: complex, mode: str) -> Aim:
    """Return the aim that these numbers themselves reach best."""
    match mode:
        case "vertical" | "lateral":
            sign = 1 if mode == "vertical" else -1
            seen = unit((ahead.conjugate() + sign * against).conjugate())
            return seen.conjugate(), sign * seen
        case "forward":
            return unit(ahead.conjugate()), 0j
        case "backward":
            return 0j, unit(against.conjugate())
    return unit(ahead.conjugate()), unit(against.conjugate())


def unit(number: complex) -> complex:
    """Return a number over its modulus, 0 for 0."""
    return number / abs(number) if number else 0j


class Errors(NamedTuple):
    """One cylinder's errors: its weight without arm, its arm, errors of throw and bank (radians)."""

    weight: complex
    arm: float
    turn: float
    tilt: float


def told(box: Box, one: Errors) -> tuple[float, float, float, float]:
    """Return errors as `WorstCase` tells them."""
    return (
        abs(one.weight) / abs(box.nominal) if box.nominal else 0.0,
        one.arm - box.level,
        degrees(one.turn),
        degrees(one.tilt),
    )


def sums_of(rows: Sequence[Box], quantity: str, chosen: Sequence[Errors]) -> tuple[complex, complex]:
    """Return c_n and c_-n of the engine with these errors."""
    pairs = [box.pair(quantity, *one) for box, one in zip(rows, chosen, strict=True)]
    return sum(a for a, _ in pairs), sum(b for _, b in pairs)


def answer(box: Box, quantity: str, aim: Aim) -> Errors:
    """Return the errors of one cylinder that serve an aim best, of those looked at."""
    arms = box.arm if quantity == "couple" else (box.level,)
    found = []
    for weight, arm, tilt in product(box.corners, arms, {0.0, box.bank, -box.bank}):
        for turn in _turns(box, quantity, weight, arm, tilt, aim):
            ahead, against = box.pair(quantity, weight, arm, turn, tilt)
            found.append(((aim[0] * ahead + aim[1] * against).real, Errors(weight, arm, turn, tilt)))
    return max(found, key=lambda pair: pair[0])[1]


def _turns(box: Box, quantity: str, weight: complex, arm: float, tilt: float, aim: Aim) -> set[float]:
    """Return errors of the throw to look at: both ends, none, and where the phase is best."""
    if not box.throw:
        return {0.0}
    ahead, against = box.pair(quantity, weight, arm, 0.0, tilt)
    reached = aim[0] * ahead + (aim[1] * against).conjugate()
    best = -cmath.phase(reached) / box.order if reached else 0.0
    return {0.0, box.throw, -box.throw, max(-box.throw, min(box.throw, best))}
