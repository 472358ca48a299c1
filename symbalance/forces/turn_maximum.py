"""Largest value over a turn of a sum of harmonics: where it is, what it is, and a proved bound on it.

Of z(theta) = sum of c_n e^(i n theta), complex for a vector in the plane, g = |z|^2 is searched, itself a
sum of harmonics g_k = sum of c_n conj(c_(n-k)). Within h of a point,

    g <= g_0 + |g'_0| h + G h^2/2, with G = sum of k^2 |g_k|, which no |g''| exceeds.

Intervals whose bound exceeds the largest value met by more than a share `NEAR` are halved, until none is
left. Of a vector that turns without changing its size g is constant and G zero: no interval is halved.
"""

from __future__ import annotations

from cmath import rect
from collections.abc import Mapping
from math import degrees, pi, sqrt
from typing import NamedTuple

from symbalance.errors import SymbalanceError

NEAR = 5e-7
"""How far, over the value, the bound may lie above it."""
ROUNDING = 1e-12
"""Over the sum of all |c_n|: covers the rounding of sums of some thousand doubles."""
PARTS = 4
"""Intervals that a turn begins with, for each order."""
MOST = 60
"""Halvings: doubles know no narrower interval of a turn."""


class TurnMaximum(NamedTuple):
    """The largest `value` met, at `angle` degrees, and a `bound` that no angle exceeds."""

    value: float
    bound: float
    angle: float


def turn_maximum(harmonics: Mapping[int, complex], left_out: float = 0.0) -> TurnMaximum:
    """Return the largest |sum of c_n e^(i n theta)| over a turn; `left_out` bounds what it leaves out.

    A real component C cos n theta + S sin n theta has c_n = (C - i S)/2 and its conjugate for -n.

    >>> top = turn_maximum({1: 0.5, -1: 0.5, 2: 0.1, -2: 0.1})
    >>> round(top.value, 6), top.value <= top.bound < top.value * (1 + 1e-6), round(top.angle)
    (1.2, True, 0)
    """
    terms = {n: complex(c) for n, c in harmonics.items() if c}
    if not terms:
        return TurnMaximum(0.0, left_out, 0.0)
    slack = left_out + ROUNDING * sum(map(abs, terms.values()))
    scale = max(map(abs, terms.values()))  # squares of the least and the largest forces are doubles too
    low, high = min(terms), max(terms)
    values = [terms.get(n, 0j) / scale for n in range(low, high + 1)]
    slopes = [1j * n * c for n, c in enumerate(values, low)]
    curvature = _curvature(values)
    count = PARTS * max(abs(low), abs(high))
    angles, half = [2 * pi * k / count for k in range(count)], pi / count
    best, place = 0.0, 0.0
    for _ in range(MOST):
        reaches = []
        for theta in angles:
            z, slope = _sum(values, theta), _sum(slopes, theta)
            square = abs(z) ** 2
            if square > best:
                best, place = square, theta
            # The e^(i low theta) that both sums lack is of size 1, and goes out of the product.
            reaches.append(square + abs(2 * (z.conjugate() * slope).real) * half)
        rest, near = curvature * half**2 / 2, best * (1 + NEAR) ** 2
        beyond = [theta for theta, reach in zip(angles, reaches, strict=True) if reach + rest > near]
        if not beyond:
            break
        half /= 2
        angles = [theta + side for theta in beyond for side in (-half, half)]
    else:
        raise SymbalanceError("the largest value over a turn", "could not be enclosed", "report this")
    value = sqrt(best) * scale
    return TurnMaximum(value, value * (1 + NEAR) + slack, degrees(place) % 360)


def _sum(values: list[complex], theta: float) -> complex:
    """Return the sum of values[k] e^(i k theta)."""
    step, total = rect(1.0, theta), 0j
    for value in reversed(values):
        total = total * step + value
    return total


def _curvature(values: list[complex]) -> float:
    """Return the sum of k^2 |g_k|, g_k the harmonics of the square."""
    total = 0.0
    for k in range(1, len(values)):
        product = sum(a * b.conjugate() for a, b in zip(values[k:], values, strict=False) if a and b)
        total += 2 * k * k * abs(product)
    return total
