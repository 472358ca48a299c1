r"""Weights that may not be larger than so much: the least left of force and couple, by a descent.

|force - sum of w_i|^2 + |couple - sum of z_i w_i|^2/length^2 with |w_i| <= most is convex; a projected
gradient with Nesterov's momentum (Nesterov 1983, from memory) finds its least in doubles. The result is
then written in fractions a billionth of `most` fine, within the bound: what is left is that of these
fractions, counted exactly.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from symbalance.balancing.planes import Placed
from symbalance.phasor import Phasor
from symbalance.spectrum import Number
from symbalance.unlike import decimal

ROUNDS = 4000
FINE = 10**9


def bounded(
    force: Number, couple: Number, arms: Sequence[Fraction], most: Fraction, length: Fraction
) -> list[Placed]:
    """Return vectors no larger than `most` at `arms` that miss force and couple least.

    >>> from symbalance.phasor import ONE, ZERO
    >>> bounded(ONE.scaled(3), ZERO, [Fraction(0)], Fraction(2), Fraction(1))[0][1].rational()
    Fraction(2, 1)
    """
    scale = float(most)
    targets = complex(decimal(force)) / scale, complex(decimal(couple)) / scale / float(length)
    rows = [float(z / length) for z in arms]
    found = _descended(targets, rows)
    placed = [(arm, _fraction(w).scaled(most)) for arm, w in zip(arms, found, strict=True)]
    return [(arm, w) for arm, w in placed if not w.is_zero()]


def _descended(targets: tuple[complex, complex], arms: Sequence[float]) -> list[complex]:
    """Return the weights, the largest allowed being 1, by the accelerated projected gradient."""
    steepest = len(arms) + sum(z * z for z in arms)  # no smaller than the largest curvature
    now = ahead = [0j] * len(arms)
    momentum = 1.0
    for _ in range(ROUNDS):
        force = targets[0] - sum(ahead)
        couple = targets[1] - sum(z * w for z, w in zip(arms, ahead, strict=True))
        moved = [_within(w + (force + z * couple) / steepest) for z, w in zip(arms, ahead, strict=True)]
        following = (1 + (1 + 4 * momentum * momentum) ** 0.5) / 2
        push = (momentum - 1) / following
        ahead = [b + push * (b - a) for a, b in zip(now, moved, strict=True)]
        now, momentum = moved, following
    return now


def _within(weight: complex) -> complex:
    return weight / abs(weight) if abs(weight) > 1 else weight


def _fraction(weight: complex) -> Phasor:
    """Return a weight of at most 1 in fractions, rounded towards 0 but for a whole one on an axis."""
    parts = [
        Fraction(int(x * FINE + (1e-4 if x > 0 else -1e-4)), FINE) for x in (weight.real, weight.imag)
    ]
    square = sum(p * p for p in parts)
    while square > 1:
        parts = [p * (1 - Fraction(1, FINE)) for p in parts]
        square = sum(p * p for p in parts)
    return Phasor.of(4, {0: parts[0], 1: parts[1]})
