"""Angles at which a generated source tests itself, and the true values there."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import prod

from symbalance.codegen.cosines import LIMIT
from symbalance.codegen.expression_ir import Kernel
from symbalance.codegen.plans import Plan
from symbalance.text.reals import Real, pi

DIGITS = 50
"""Of the true values; a thousandth of an ulp of theirs is far below what any check allows."""
ANGLES = (0.0, 0.1, -0.75, 1.5707963267948966, 2.5, -3.0, 12.566370614359172, 1e3, -98765.4321, 1e6)
FAR_ANGLES = (-4194304.5, 1e9)
GRIDS = (7, 11, 13, 17)
"""Points to a turn that a grid may be tested with: no order to 1000 is a multiple of all of them."""
KEYWORDS = {"mass": 2.0, "radius": 3.0, "omega": 5.0, "pitch": 7.0}
"""Primes: whatever keyword is left out, or taken for another, the product is another number."""
COUNTED = re.compile(r"rint\(theta\*(\w+)(?: - (\w+))?\)")
"""How every reduction of the angle begins: so many periods in a radian, less a phase."""
BESIDE = {1: 1 / 24, -1: 1 / 14}
"""Periods beside the middle between two crests, near +limit and near -limit. Nearer to it a count that is
off by one does no harm that shows, for the sine's polynomial is good beyond the quarter turn: it errs by
2 u at 1/64, 84 u at 1/24, 1700 u at 1/14. The farther serves where an output depends little on its cosine
there."""


@dataclass(frozen=True)
class Check:
    """An angle, the true values there, and what each may be off, both with every keyword 1."""

    theta: float
    values: tuple[float, ...]
    allowed: tuple[float, ...]


def checks(plan: Plan, angles: Sequence[float] | None = None) -> list[Check]:
    """Return the checks of a plan: near ones held to its bounds, far ones to the order times as much.

    The near ones are at `ANGLES` and at the plan's own `counted_angles`, unless others are given.
    """
    angles = (*ANGLES, *counted_angles(plan.reduced_range)) if angles is None else angles
    near = [_check(plan, theta, 1.0) for theta in angles]
    return near + [_check(plan, theta, 4.0 + plan.highest_step) for theta in FAR_ANGLES]


def counted_angles(kernel: Kernel, limit: float = LIMIT) -> list[float]:
    """Return angles near +-limit, each beside the middle between two periods that a kernel counts.

    There a count of periods that is off by a few hundredths, as by a small fault of the period, is
    rounded to a wrong number; elsewhere it may go unseen, though it spoils many other angles.
    """
    values = {constant.name: constant.value for constant in kernel.constants}
    matches = (COUNTED.search(line.formula) for line in kernel.lines)
    counts = {(values[f[1]], values[f[2]] if f[2] else 0.0) for f in matches if f}
    return sorted({angle for per, shift in counts for angle in _beside(per, shift, limit)})


def _beside(per_radian: float, shift: float, limit: float) -> Iterator[float]:
    for sign, beside in BESIDE.items():
        middle = sign * (int(limit * per_radian) - 2) + 0.5
        for place in (middle - beside, middle + beside):
            yield (place + shift) / per_radian


def unit_values(plan: Plan) -> list[float]:
    """Return what each output is to be multiplied by where the keywords are `KEYWORDS`."""
    return [prod(KEYWORDS[factor] for factor in o.harmonic_sum.unit.factors) for o in plan.outputs]


def default_values(plan: Plan) -> list[float]:
    """Return what each output is to be multiplied by where no keyword is given."""
    return [plan.defaults.unit(o.harmonic_sum.unit.factors) for o in plan.outputs]


def grid_points(plan: Plan) -> int:
    """Return how many points to a turn test a grid: the fewest that do not repeat within the turn."""
    return next(points for points in GRIDS if plan.step.numerator % points)


def grid_checks(plan: Plan) -> list[Check]:
    """Return the checks on a grid of two turns; its angles are rounded twice more than plain ones."""
    points = grid_points(plan)
    allowed = tuple(2.0**-52 * o.rounding * max(o.amplitude, 2.0**-900) for o in plan.outputs)
    angles = [2 * pi(DIGITS) * j / points for j in range(2 * points)]
    return [Check(float(t), tuple(float(o.value(t)) for o in plan.outputs), allowed) for t in angles]


def _check(plan: Plan, theta: float, slack: float) -> Check:
    outputs = plan.outputs
    allowed = tuple(2.0**-53 * o.rounding * max(o.amplitude, 2.0**-900) * slack for o in outputs)
    return Check(theta, tuple(float(o.value(Real(theta, DIGITS))) for o in outputs), allowed)
