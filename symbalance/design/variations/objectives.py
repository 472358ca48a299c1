"""The worst errors of one cylinder, the others held fixed: a step of the search for worst cases."""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from itertools import product
from math import degrees
from typing import NamedTuple

from symbalance.design.variations.tolerance_intervals import ToleranceBox

MODES = ("largest", "vertical", "lateral", "forward", "backward")


def component_amplitude(forward: complex, backward: complex, mode: str) -> float:
    """Return the amplitude of a component of c_n and c_-n, or the largest modulus over a turn."""
    match mode:
        case "vertical":
            return abs(forward.conjugate() + backward)
        case "lateral":
            return abs(forward.conjugate() - backward)
        case "forward":
            return abs(forward)
        case "backward":
            return abs(backward)
    return abs(forward) + abs(backward)


Objective = tuple[complex, complex]
"""What c_n and c_-n are multiplied by: the real part of the sum is to be made large."""


def objective_of(forward: complex, backward: complex, mode: str) -> Objective:
    """Return the objective that these numbers themselves make largest."""
    match mode:
        case "vertical" | "lateral":
            sign = 1 if mode == "vertical" else -1
            phase = unit_phase((forward.conjugate() + sign * backward).conjugate())
            return phase.conjugate(), sign * phase
        case "forward":
            return unit_phase(forward.conjugate()), 0j
        case "backward":
            return 0j, unit_phase(backward.conjugate())
    return unit_phase(forward.conjugate()), unit_phase(backward.conjugate())


def unit_phase(number: complex) -> complex:
    """Return a number over its modulus, 0 for 0."""
    return number / abs(number) if number else 0j


class Errors(NamedTuple):
    """One cylinder's errors: its weight without arm, its arm, errors of throw and bank (radians)."""

    weight: complex
    arm: float
    turn: float
    tilt: float


def error_tuple(box: ToleranceBox, one: Errors) -> tuple[float, float, float, float]:
    """Return errors in the form of `WorstCase.errors`."""
    return (
        abs(one.weight) / abs(box.nominal) if box.nominal else 0.0,
        one.arm - box.level,
        degrees(one.turn),
        degrees(one.tilt),
    )


def engine_sums(
    rows: Sequence[ToleranceBox], quantity: str, errors: Sequence[Errors]
) -> tuple[complex, complex]:
    """Return c_n and c_-n of the engine with these errors."""
    pairs = [box.pair(quantity, *one) for box, one in zip(rows, errors, strict=True)]
    return sum(a for a, _ in pairs), sum(b for _, b in pairs)


def best_response(box: ToleranceBox, quantity: str, objective: Objective) -> Errors:
    """Return the errors of one cylinder that make an objective largest, of those looked at."""
    arms = box.arm if quantity == "couple" else (box.level,)
    candidates = []
    for weight, arm, tilt in product(box.corners, arms, {0.0, box.bank, -box.bank}):
        for turn in _turns(box, quantity, weight, arm, tilt, objective):
            forward, backward = box.pair(quantity, weight, arm, turn, tilt)
            candidates.append(
                ((objective[0] * forward + objective[1] * backward).real, Errors(weight, arm, turn, tilt))
            )
    return max(candidates, key=lambda pair: pair[0])[1]


def _turns(
    box: ToleranceBox, quantity: str, weight: complex, arm: float, tilt: float, objective: Objective
) -> set[float]:
    """Return errors of the throw to look at: both ends, none, and where the phase is best."""
    if not box.throw:
        return {0.0}
    forward, backward = box.pair(quantity, weight, arm, 0.0, tilt)
    value = objective[0] * forward + (objective[1] * backward).conjugate()
    best = -cmath.phase(value) / box.order if value else 0.0
    return {0.0, box.throw, -box.throw, max(-box.throw, min(box.throw, best))}
