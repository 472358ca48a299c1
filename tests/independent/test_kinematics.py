"""Each formula of a slider-crank's motions is what the path of a piston gives, differentiated."""

from __future__ import annotations

from fractions import Fraction
from functools import partial

import pytest
from mpmath import mp, mpf

from symbalance.notes.checking.meant.catalogue.kinematics import (
    ACCELERATION,
    BOTTOM,
    FASTEST,
    HALF,
    HUMP,
    JERK,
    LARGEST,
    LEAST,
    MOTIONS,
    OFFSET,
    PATH,
    RIGHT,
    ROD_ACCELERATION,
    ROD_ANGLE,
    ROD_SPEED,
    SHORTENING,
    SPEED,
    STROKE,
    TOP,
)
from symbalance.notes.checking.meant.harmonic_coefficients import coefficients
from symbalance.notes.checking.meant.pistons.motion_slips import value_at

F = Fraction
R, W, THETA, E = F(3, 100), F(150), F(7, 10), F(1, 200)
LONG, SHORT = F(1, 5), F(1, 3)
PLACES = {"": THETA, TOP: 0, BOTTOM: mp.pi, RIGHT: mp.pi / 2}


def height(angle, ratio, offset=0):
    """Return how far the piston pin is from the crank, along the line of stroke."""
    rod = mpf(float(R)) / float(ratio)
    across = float(R) * mp.sin(angle) - float(offset)
    return float(R) * mp.cos(angle) + mp.sqrt(rod**2 - across**2)


def lean(angle, ratio, offset=0):
    """Return the angle whose tangent is how far the big end is off, over how far the piston is ahead."""
    across = float(R) * mp.sin(angle) - float(offset)
    return mp.atan2(across, height(angle, ratio, offset) - float(R) * mp.cos(angle))


def rate(function, order, angle):
    """Return a derivative by the time of what turns with the crank."""
    return mp.diff(function, angle, order) * mpf(float(W)) ** order


def largest(function):
    """Return the largest size over a turn, and its angle."""
    angles = [mp.pi * k / 3000 for k in range(6001)]
    return max((abs(function(angle)), angle) for angle in angles)


def expected(kind, place, ratio):
    """Return the values that a motion may have at a place, by its path."""
    path, swing = partial(height, ratio=ratio), partial(lean, ratio=ratio)
    rod = mpf(float(R)) / float(ratio)
    orders = {PATH: (path, 0), SPEED: (path, 1), ACCELERATION: (path, 2), JERK: (path, 3),
              ROD_ANGLE: (swing, 0), ROD_SPEED: (swing, 1), ROD_ACCELERATION: (swing, 2)}  # fmt: skip
    if kind == STROKE:
        return [path(0) - path(mp.pi)]
    if kind == SHORTENING:
        angle = PLACES[place]
        return [rod + float(R) * mp.cos(angle) - path(angle)]
    if kind == FASTEST:
        angle = largest(partial(rate, path, 1))[1]
        return [min(angle, 2 * mp.pi - angle)]
    if kind == HALF:
        middle = (path(0) + path(mp.pi)) / 2
        return [mp.findroot(lambda angle: path(angle) - middle, 1.4)]
    function, order = orders[kind]
    motion = partial(rate, function, order)
    if place == LARGEST:
        values = [largest(motion)[0]]
        return [*values, path(0) - path(mp.pi)] if kind == PATH else values
    if place == LEAST:
        return [0, path(mp.pi)] if kind == PATH else [abs(motion(mp.pi))]
    value = motion(PLACES[place])
    if kind != PATH:
        return [value]
    travel = path(0) - value
    return [value, travel, value - rod, 2 * float(R) - travel, rod - value]


def point(ratio):
    return {"r": R, "lam": ratio, "w": W, "theta": THETA, "e": E}


@pytest.mark.parametrize(("kind", "place"), [key for key in MOTIONS if key[0] != HUMP], ids=str)
def test_each_formula_is_what_the_path_gives(kind, place):
    values = expected(kind, place, LONG)
    scale = max(1e-3, *map(abs, values))
    for node in MOTIONS[kind, place].exact:
        claim = value_at(node, point(LONG))
        assert min(abs(abs(claim) - abs(value)) for value in values) < 1e-6 * scale
    for node in MOTIONS[kind, place].rough if (kind, place) != (ACCELERATION, LEAST) else ():
        claim = value_at(node, point(LONG))
        assert min(abs(abs(claim) - abs(value)) for value in values) < 0.06 * scale


def test_a_short_rod_has_a_third_extreme_of_the_acceleration():
    def two_terms(angle):
        return mp.cos(angle) + float(SHORT) * mp.cos(2 * angle)

    angles = [mp.pi * k / 20000 for k in range(20001)]
    least, where = min((two_terms(angle), angle) for angle in angles)
    (hump,), (_, peak) = MOTIONS[HUMP, ""].rough, (None, MOTIONS[ACCELERATION, LEAST].rough[0])
    assert abs(value_at(hump, point(SHORT)) - where) < 1e-3
    assert abs(value_at(peak, point(SHORT)) / float(R * W**2) + least) < 1e-6


def test_the_formulas_of_an_offset_crank_are_what_its_path_gives():
    path = partial(height, ratio=LONG, offset=E)
    angles = [mp.pi * k / 20000 for k in range(40001)]
    heights = [(path(angle), angle) for angle in angles]
    (top, at_top), (bottom, at_bottom) = max(heights), min(heights)
    rest = {
        (STROKE, ""): [top - bottom], (PATH, TOP): [top], (PATH, BOTTOM): [bottom],
        (FASTEST, TOP): [at_top], (FASTEST, BOTTOM): [at_bottom - mp.pi],
        (PATH, ""): [path(THETA), height(THETA, LONG, -E)],
        (ROD_ANGLE, ""): [lean(THETA, LONG, E), lean(THETA, LONG, -E)],
        (ROD_ANGLE, LARGEST): [largest(partial(lean, ratio=LONG, offset=E))[0]],
    }  # fmt: skip
    assert rest.keys() == OFFSET.keys()
    for key, motion in OFFSET.items():
        for node in motion.exact:
            gaps = [abs(value_at(node, point(LONG)) - value) for value in rest[key]]
            assert min(gaps) < (2e-4 if key[0] == FASTEST else 1e-6)


@pytest.mark.parametrize("order", [0, 2, 4, 6])
def test_the_series_of_the_position_is_its_fourier_integral(order):
    ratio = F(1, 20)
    mean = mp.quad(lambda a: height(a, ratio) * mp.cos(order * a), [0, mp.pi / 2, mp.pi]) / mp.pi
    amplitude = mean / float(R) * (2 if order else 1)
    series = coefficients(order, 9)
    value = sum(float(c) * mpf(float(ratio)) ** power for power, c in series.items())
    assert abs(amplitude / (value / max(order, 1) ** 2) - 1) < 1e-6
