"""Errors of a piston's displacement, in ulp of itself, and velocity, in u of its amplitude."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import partial

import numpy as np

from symbalance.bench.bounded_cases import (
    OF_AMPLITUDE,
    ULP,
    BoundedCase,
    Part,
    attempt,
    worst,
    worst_point,
)
from symbalance.bench.hard_angles import closest, hard, near_turns, random_angles, small
from symbalance.bench.output_requests import Array, OutputRequest, on_target, targets
from symbalance.bench.timing import progress
from symbalance.bench.true_values import Points, U
from symbalance.engine.builders import inline
from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine

RATIOS = (Fraction(10_000_001, 10_000_000), Fraction(101, 100), Fraction(7, 2), Fraction(10**6))
DISPLACEMENT, VELOCITY = 4.0, 4.0
"""Stated bounds: ulp of the value itself, and u of the amplitude."""
REAL = Fraction(7, 2)
Measure = Callable[[Engine, Points, Fraction], dict[str, Callable[[], BoundedCase]]]
INTRODUCTION = """\
The displacement is held to ulp of its own value, however small that is; naive: 1 - cos + λ(1 - √(1 -
sin²/λ²)). The velocity to u = 2^-53 of its amplitude; naive: sin (1 + cos/√(λ² - sin²))."""


def piston_part(quick: bool) -> Part:
    """Return the cases of one piston, on every target."""
    count = 50 if quick else 1200
    single, rotated_throw = inline(throws=[0]), Engine([Cylinder(1, throw="360/7")])
    regions = (
        ("displacement near TDC, 5e-324 to 0.1 rad", single, small(count)),
        ("displacement at 2πn, n to 166000, and around", single, near_turns(count)),
        ("displacement anywhere to 1e6 rad", single, anywhere(count)),
        ("displacement, TDC at -360°/7, and around", rotated_throw, near_turns(count, 7, 1 / 7)),
    )
    cases = [
        c
        for name, engine, theta in regions
        for c in everywhere(displacement_cases, name, engine, theta, quick)
    ]
    velocities = everywhere(
        velocity_cases, "velocity anywhere to 1e6 rad", single, hard(4 * count), quick
    )
    return Part("One piston, λ = 1.0000001, 1.01, 3.5 and 1e6", INTRODUCTION, [*cases, *velocities])


def anywhere(count: int) -> Array:
    """Return angles all over, with bottom dead centres and the closest doubles to quarter turns."""
    bottom = near_turns(count // 4, 8, 0.5)
    wide = np.random.default_rng(9).uniform(-7, 7, 4 * count)
    return np.concatenate([random_angles(4 * count), wide, bottom[np.abs(bottom) <= 1e6], closest()])


def everywhere(
    measure: Measure, name: str, engine: Engine, theta: Array, quick: bool
) -> list[BoundedCase]:
    """Return a case on every target, the worst over the rod ratios; quickly, others than NumPy at 3.5."""
    progress(name)
    points, cases = Points(theta), {target: [] for target in targets()}
    for ratio in RATIOS:
        for target, make in measure(engine, points, ratio).items():
            if target == "numpy" or not quick or ratio == REAL:
                cases[target].append(attempt(f"{name}, {target}", DISPLACEMENT, ULP, make))
    return [worst(rows, f"{name}, {target}") for target, rows in cases.items()]


def displacement_cases(
    engine: Engine, points: Points, ratio: Fraction
) -> dict[str, Callable[[], BoundedCase]]:
    """Return, by target, the measuring of the displacement at one rod ratio, in ulp of itself."""
    request = OutputRequest(engine, "piston.displacement", ratio, 1)
    truth, lam = request.true_values(points), float(ratio)
    ulp = np.spacing(truth.high)
    angle = points.theta + 2 * np.pi * float(engine.first.delay.turns)
    naive = 1 - np.cos(angle) + lam * (1 - np.sqrt(1 - (np.sin(angle) / lam) ** 2))
    others = {"1 - cos ...": truth.off(naive) / ulp}

    def make(target: str) -> BoundedCase:
        errors = truth.off(on_target(request, target)(points.theta)) / ulp
        return worst_point("", points.theta, errors, DISPLACEMENT, ULP, others, f"λ={lam:.8g}: ")

    return {target: partial(make, target) for target in targets()}


def velocity_cases(
    engine: Engine, points: Points, ratio: Fraction
) -> dict[str, Callable[[], BoundedCase]]:
    """Return, by target, the measuring of the velocity at one rod ratio, in u of its amplitude."""
    request = OutputRequest(engine, "piston.velocity", ratio, 1)
    truth, lam = request.true_values(points), float(ratio)
    sin, cos = np.sin(points.theta), np.cos(points.theta)
    naive = truth.off(sin * (1 + cos / np.sqrt(lam * lam - sin * sin)))

    def make(target: str) -> BoundedCase:
        size = U * request.amplitude
        errors = truth.off(on_target(request, target)(points.theta)) / size
        others = {"sin (1 + ...)": naive / size}
        return worst_point("", points.theta, errors, VELOCITY, OF_AMPLITUDE, others, f"λ={lam:.8g}: ")

    return {target: partial(make, target) for target in targets()}
