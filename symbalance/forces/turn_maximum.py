"""Largest value over a turn of a sum of harmonics: where it is, what it is, and a proved bound on it.

Of z(theta) = sum of c_n e^(i n theta), complex for a vector in the plane, |z| is searched. About a point
z_0, with slope z_1 there and M = sum of n^2 |c_n|, which no |z''| exceeds, within h of it

    |z| <= max(|z_0 - h z_1|, |z_0 + h z_1|) + M h^2/2,

the first because a convex function has its largest value at an end. Intervals are halved, the one of the
largest bound first, until no bound exceeds the largest value met by more than a share `NEAR` of it.
"""

from __future__ import annotations

from cmath import exp
from collections.abc import Mapping
from heapq import heapify, heappop, heappush
from math import degrees, pi
from typing import NamedTuple

NEAR = 5e-7
"""How far, over the value, the bound may lie above it."""
ROUNDING = 1e-12
"""Over the sum of all |c_n|: covers the rounding of sums of some thousand doubles."""
PARTS = 4
"""Intervals that a turn begins with, for each order."""
MOST = 2_000_000
"""Intervals; a vector of almost constant size and a thousand orders takes a tenth of them."""


class TurnMaximum(NamedTuple):
    """The largest `value` met, at `angle` degrees, and a `bound` that no angle exceeds."""

    value: float
    bound: float
    angle: float


def turn_maximum(harmonics: Mapping[int, complex], left_out: float = 0.0) -> TurnMaximum:
    """Return the largest |sum of c_n e^(i n theta)| over a turn; `left_out` bounds what is not in the sum.

    A real component C cos n theta + S sin n theta has c_n = (C - i S)/2 and its conjugate for -n.

    >>> top = turn_maximum({1: 0.5, -1: 0.5, 2: 0.1j, -2: -0.1j})
    >>> 1.0 < top.value <= top.bound < top.value * (1 + 1e-6), round(top.angle)
    (True, 160)
    """
    terms = [(n, complex(c)) for n, c in harmonics.items() if c]
    size = sum(abs(c) for _, c in terms)
    slack = left_out + ROUNDING * size
    if not terms:
        return TurnMaximum(0.0, left_out, 0.0)
    curvature = sum(n * n * abs(c) for n, c in terms)

    def at(theta: float) -> tuple[complex, complex]:
        value, slope = 0j, 0j
        for n, c in terms:
            part = c * exp(1j * n * theta)
            value += part
            slope += 1j * n * part
        return value, slope

    best, place = 0.0, 0.0

    def bounded(theta: float, half: float) -> tuple[float, float, float]:
        nonlocal best, place
        value, slope = at(theta)
        if abs(value) > best:
            best, place = abs(value), theta
        reach = max(abs(value - half * slope), abs(value + half * slope)) + curvature * half**2 / 2
        return -reach, theta, half

    count = PARTS * max(abs(n) for n, _ in terms)
    heap = [bounded(2 * pi * k / count, pi / count) for k in range(count)]
    heapify(heap)
    for _ in range(MOST):
        bound, theta, half = heap[0]
        if -bound <= best * (1 + NEAR):
            break
        heappop(heap)
        for side in (-half / 2, half / 2):
            heappush(heap, bounded(theta + side, half / 2))
    return TurnMaximum(best, max(-heap[0][0], best) + slack, degrees(place) % 360)
