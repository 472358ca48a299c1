"""Angles at which a generated source tests itself, and what mpmath says there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from mpmath import mp

from symbalance.codegen.plans import Plan

ANGLES = (0.0, 0.1, -0.75, 1.5707963267948966, 2.5, -3.0, 12.566370614359172, 1e3, -98765.4321, 1e6)
FAR_ANGLES = (-4194304.5, 1e9)
GRIDS = (7, 11, 13, 17)
"""Points to a turn that a grid may be tested with: no order to 1000 is a multiple of all of them."""


@dataclass(frozen=True)
class Check:
    """An angle, the true values there, and what each may be off, both with every keyword 1."""

    theta: float
    values: tuple[float, ...]
    allowed: tuple[float, ...]


def checks(planned: Plan, angles: Sequence[float] = ANGLES) -> list[Check]:
    """Return the checks of a plan: near ones held to its bounds, far ones to the order times as much."""
    with mp.workdps(50):
        near = [_check(planned, theta, 1.0) for theta in angles]
        return near + [_check(planned, theta, 4.0 + planned.highest_step) for theta in FAR_ANGLES]


def grid_points(planned: Plan) -> int:
    """Return how many points to a turn test a grid: the fewest that do not repeat within the turn."""
    return next(points for points in GRIDS if planned.step.numerator % points)


def grid_checks(planned: Plan) -> list[Check]:
    """Return the checks on a grid of two turns; its angles are rounded twice more than plain ones."""
    points = grid_points(planned)
    allowed = tuple(2.0**-52 * o.rounding * max(o.amplitude, 2.0**-900) for o in planned.outputs)
    with mp.workdps(50):
        angles = [2 * mp.pi * j / points for j in range(2 * points)]
        return [
            Check(float(t), tuple(float(o.value(t)) for o in planned.outputs), allowed) for t in angles
        ]


def _check(planned: Plan, theta: float, slack: float) -> Check:
    outputs = planned.outputs
    allowed = tuple(2.0**-53 * o.rounding * max(o.amplitude, 2.0**-900) * slack for o in outputs)
    return Check(theta, tuple(float(o.value(theta)) for o in outputs), allowed)
