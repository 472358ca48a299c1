"""Crank angles that are hard to reduce: doubles next to multiples of parts of a turn, and the largest."""

from __future__ import annotations

from collections.abc import Iterator
from math import inf, nextafter
from typing import Any

import numpy as np

from symbalance.bench.true_values import mp

Array = Any
REACH = 1e6
"""The largest |theta| that the bounds are stated for."""
TURNS = 166_000
"""Whole turns: to 1.04e6 rad, still below the 2^20 rad that are reduced exactly."""
DIGITS = 60


def random_angles(count: int, seed: int = 1) -> Array:
    """Return angles of both signs, half spread evenly to REACH, half over all sizes."""
    draw = np.random.default_rng(seed)
    even = draw.uniform(-REACH, REACH, count // 2)
    sizes = 10.0 ** draw.uniform(-3, 6, count - count // 2) * draw.choice([-1.0, 1.0], count - count // 2)
    return np.concatenate([even, sizes])


def near_multiples(parts: int, count: int, seed: int = 2, shift: float = 0.0) -> Array:
    """Return doubles nearest to multiples of 2 pi/parts, less `shift` turns, and their neighbours."""
    draw = np.random.default_rng(seed)
    most = int(REACH * parts / 6.2832)
    multiples = [*draw.integers(-most, most, count), *range(-12, 13)]
    return np.array([a for k in multiples for a in _around(_multiple(int(k), parts, shift))])


def near_turns(count: int, seed: int = 3, shift: float = 0.0) -> Array:
    """Return doubles at and around 2 pi n, |n| to TURNS, a few ulp to 10^-2 off; `shift` turns less."""
    draw = np.random.default_rng(seed)
    angles = []
    for n in [*draw.integers(-TURNS, TURNS, count), -TURNS, TURNS, -1, 0, 1]:
        centre = _multiple(int(n), 1, shift)
        angles += _around(centre)
        angles += [centre + sign * 10.0 ** draw.uniform(-9, -2) for sign in (-1, 1)]
    return np.array(angles)


def small(count: int) -> Array:
    """Return angles of both signs from 10^-300 to 0.1, evenly over their exponents, and the ends."""
    sizes = 10.0 ** np.linspace(-300, -1, count)
    near = 10.0 ** np.linspace(-10, -1, count)
    ends = np.array([5e-324, 2.3e-308, 1e-162, 1e-154, 1e-8, 0.01])
    positive = np.concatenate([sizes, near, ends])
    return np.concatenate([-positive, positive])


def closest() -> Array:
    """Return the doubles below REACH that come closest to multiples of pi/2, binade by binade.

    theta = m 2^e is close to k pi/2 where k/m is a convergent of 2^e/(pi/2): Kahan's search.
    """
    with mp.workdps(DIGITS):
        angles = [
            float(mp.ldexp(m, e)) for e in range(-52, -32) for m in _convergents(mp.ldexp(2 / mp.pi, e))
        ]
    return np.array([sign * angle for angle in angles if 1 <= angle <= REACH for sign in (-1, 1)])


def _convergents(value: Any) -> Iterator[int]:
    """Yield the denominators below 2^53 of a number's continued fraction."""
    before, here, rest = 0, 1, value - mp.floor(value)
    while here < 2**53 and rest:
        yield here
        rest = 1 / rest
        digit = int(mp.floor(rest))
        before, here, rest = here, digit * here + before, rest - digit


def _multiple(k: int, parts: int, shift: float) -> float:
    with mp.workdps(DIGITS):
        return float(2 * mp.pi * (mp.mpf(k) / parts - mp.mpf(shift)))


def _around(angle: float) -> list[float]:
    return [nextafter(angle, -inf), angle, nextafter(angle, inf)]


def ends(count: int) -> Array:
    """Return the last doubles before +-REACH."""
    angles = [REACH]
    for _ in range(count):
        angles.append(nextafter(angles[-1], 0.0))
    return np.array([*angles, *(-angle for angle in angles)])


def hard(count: int) -> Array:
    """Return all of them: `count` random ones, and as many again next to multiples and ends."""
    few = max(count // 12, 4)
    return np.concatenate(
        [
            random_angles(count),
            near_multiples(24, few, 4),
            near_multiples(4, few, 5),
            near_turns(few // 2),
            closest(),
            ends(few // 2),
        ]
    )


def quarters(width: float, count: int, turns: float = 0.0, seed: int = 6) -> Array:
    """Return angles within some widths of the peaks a quarter turn off, of a cylinder `turns` ahead."""
    draw = np.random.default_rng(seed)
    far = [_multiple(int(2 * k + 1), 4, turns) for k in draw.integers(-300_000, 300_000, count)]
    near = [_multiple(int(2 * k + 1), 4, turns) for k in draw.integers(-3, 3, count)]
    return np.array([*far, *near]) + draw.normal(0.0, width, 2 * count)
