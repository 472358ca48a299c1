r"""Balance weights of bounded size with a given force and couple: exact if possible, else nearest.

First the fewest planes are looked for over which the weights of least squares are small enough: these are
exact. Else |force - sum of w_i|^2 + |couple - sum of z_i w_i|^2/length^2 with |w_i| <= most is convex; a
projected gradient with Nesterov's momentum (Soviet Math. Dokl. 27 (1983)) finds its least in doubles. The
result is written in fractions a billionth of `most` fine, within the bound. What these miss is put,
exactly, on planes whose weights are not at the bound, if it is little more than rounding; else it is
left, counted exactly.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import chain, combinations, islice

from symbalance.design.balancing.planes import PlacedVector, in_planes
from symbalance.exact.amplitude import Amplitude
from symbalance.exact.arithmetic import total
from symbalance.exact.phasor import Phasor

ITERATIONS = 4000
"""Of the descent; momentum makes its error fall with their square (Nesterov)."""
DENOMINATOR = 10**9
"""Of the fractions that weights are written in, over `most`."""
MOST_CHOICES = 20_000
"""So many choices of planes are looked at; beyond them the descent decides."""
REPAIRABLE = 1e-6
"""What a descent that could come to 0 may still miss, over `most`."""


def bounded_vectors(
    force: Amplitude, couple: Amplitude, arms: Sequence[Fraction], most: Fraction, length: Fraction
) -> list[PlacedVector]:
    """Return vectors no larger than `most` at `arms` (each once) that miss force and couple least.

    >>> from symbalance.exact.phasor import ONE, ZERO
    >>> bounded_vectors(ONE.scaled(3), ZERO, [Fraction(0)], Fraction(2), Fraction(1))[0][1].rational()
    Fraction(2, 1)
    >>> arms = [Fraction(z) for z in (1, 0, -1)]
    >>> three = bounded_vectors(ONE.scaled(3), ZERO, arms, Fraction(1), Fraction(1))
    >>> [w.rational() for _, w in three]
    [Fraction(1, 1), Fraction(1, 1), Fraction(1, 1)]
    """
    vectors = _in_fewest(force, couple, arms, most, length)
    if vectors is None:
        near = _nearest(force, couple, arms, most, length)
        vectors = _repair(force, couple, near, arms, most, length) or near
    return [(arm, w) for arm, w in vectors if not w.is_zero()]


def _in_fewest(
    force: Amplitude, couple: Amplitude, arms: Sequence[Fraction], most: Fraction, length: Fraction
) -> list[PlacedVector] | None:
    """Return vectors with force and couple in the fewest planes where least squares are small."""
    f, c, limit = complex(force.evaluated()), complex(couple.evaluated()), float(most) * (1 + 1e-9)
    choices = chain.from_iterable(combinations(arms, k) for k in range(2, len(arms) + 1))
    for places in islice(choices, MOST_CHOICES):
        if _largest(f, c, [float(z) for z in places]) <= limit:
            vectors = in_planes(force, couple, places, spread="even", length=length)
            if _within_bound(vectors, most):
                return vectors
    return None


def _largest(force: complex, couple: complex, places: Sequence[float]) -> float:
    """Return the largest of the vectors of least squares that have force and couple."""
    count, total, squares = len(places), sum(places), sum(z * z for z in places)
    over = count * squares - total * total
    level, slope = force * squares - couple * total, couple * count - force * total
    return max(abs(level + z * slope) for z in places) / over


def _within_bound(vectors: Sequence[PlacedVector], most: Fraction) -> bool:
    return all(w.size() <= most for _, w in vectors)


def _repair(
    force: Amplitude,
    couple: Amplitude,
    near: Sequence[PlacedVector],
    arms: Sequence[Fraction],
    most: Fraction,
    length: Fraction,
) -> list[PlacedVector] | None:
    """Return vectors with force and couple from some that nearly have them, None where that cannot be."""
    residual = force - total(w for _, w in near)
    lever = couple - total(w.scaled(z) for z, w in near)
    weights, little = dict(near), float(most) * REPAIRABLE
    free = [
        z for z in arms if z not in weights or weights[z].size() < float(most) * (1 - 100 * REPAIRABLE)
    ]
    if len(free) < 2 or max(residual.size(), lever.size() / length) > little:
        return None
    for arm, more in in_planes(residual, lever, free, spread="even", length=length):
        weights[arm] = weights[arm] + more if arm in weights else more
    vectors = sorted(weights.items(), reverse=True, key=lambda pair: pair[0])
    return vectors if _within_bound(vectors, most) else None


def _nearest(
    force: Amplitude, couple: Amplitude, arms: Sequence[Fraction], most: Fraction, length: Fraction
) -> list[PlacedVector]:
    """Return vectors no larger than `most`, in fractions, that miss force and couple least."""
    return joint_vectors([(force, couple)], arms, most, length, Fraction(0))[0]


def joint_vectors(
    targets: Sequence[tuple[Amplitude, Amplitude]],
    arms: Sequence[Fraction],
    most: Fraction,
    length: Fraction,
    tilt: Fraction,
) -> list[list[PlacedVector]]:
    """Return vectors no larger than `most`, in fractions, for one part of an order or for both together.

    With a and b what is left of both parts, |a|^2 + |b|^2 + 2 tilt Re(a b) of force and couple is least.

    >>> from symbalance.exact.phasor import ONE, ZERO
    >>> pair = [(-ONE.scaled(3), ZERO), (-ONE, ZERO)]  # lateral free: b makes up for what a cannot
    >>> most = length = tilt = Fraction(1)
    >>> [w[0][1].rational() for w in joint_vectors(pair, [Fraction(0)], 2 * most, length, tilt)]
    [Fraction(-2, 1), Fraction(-2, 1)]
    """
    scale, rows = float(most), [float(z / length) for z in arms]
    scaled_targets = [
        (complex(f.evaluated()) / scale, complex(c.evaluated()) / scale / float(length))
        for f, c in targets
    ]
    vectors = [
        [(arm, _fraction(w).scaled(most)) for arm, w in zip(arms, side, strict=True)]
        for side in _descend(scaled_targets, rows, float(tilt))
    ]
    return [[(arm, w) for arm, w in side if not w.is_zero()] for side in vectors]


def _descend(
    targets: Sequence[Residual], arms: Sequence[float], tilt: float = 0.0
) -> list[list[complex]]:
    """Return the weights, the largest allowed being 1, by the accelerated projected gradient.

    With two targets, of both parts of an order, what both miss counts with 2 tilt Re of their product.
    """
    steepest = (len(arms) + sum(z * z for z in arms)) * (1 + abs(tilt))  # no less than the curvature
    now = extrapolated = [[0j] * len(arms) for _ in targets]
    momentum = 1.0
    for _ in range(ITERATIONS):
        residual = [
            _residual(target, arms, side) for target, side in zip(targets, extrapolated, strict=True)
        ]
        if len(residual) == 2 and tilt:
            residual = [_weighted(one, other, tilt) for one, other in (residual, residual[::-1])]
        stepped = [
            [_clip(w + (force + z * couple) / steepest) for z, w in zip(arms, side, strict=True)]
            for (force, couple), side in zip(residual, extrapolated, strict=True)
        ]
        next_momentum = (1 + (1 + 4 * momentum * momentum) ** 0.5) / 2
        push = (momentum - 1) / next_momentum
        extrapolated = [
            [b + push * (b - a) for a, b in zip(old, new, strict=True)]
            for old, new in zip(now, stepped, strict=True)
        ]
        now, momentum = stepped, next_momentum
    return now


Residual = tuple[complex, complex]
"""A force and a couple, the couple over the length."""


def _residual(target: Residual, arms: Sequence[float], weights: Sequence[complex]) -> Residual:
    couple = sum(z * w for z, w in zip(arms, weights, strict=True))
    return target[0] - sum(weights), target[1] - couple


def _weighted(one: Residual, other: Residual, tilt: float) -> Residual:
    return one[0] + tilt * other[0].conjugate(), one[1] + tilt * other[1].conjugate()


def _clip(weight: complex) -> complex:
    return weight / abs(weight) if abs(weight) > 1 else weight


def _fraction(weight: complex) -> Phasor:
    """Return a weight of at most 1 in fractions, rounded towards 0 but for a whole one on an axis."""
    parts = [
        Fraction(int(x * DENOMINATOR + (1e-4 if x > 0 else -1e-4)), DENOMINATOR)
        for x in (weight.real, weight.imag)
    ]
    square = sum(p * p for p in parts)
    while square > 1:
        parts = [p * (1 - Fraction(1, DENOMINATOR)) for p in parts]
        square = sum(p * p for p in parts)
    return Phasor.of(4, {0: parts[0], 1: parts[1]})
