"""Picture of a torque: what the pistons' inertia puts on the crank over a turn."""

from __future__ import annotations

from math import cos, pi, sin
from typing import TYPE_CHECKING

from symbalance.document.shapes import Drawing
from symbalance.drawing.charts import Curve, draw_curves, figure

if TYPE_CHECKING:
    from symbalance.torque.inertia_balance import TorqueBalance

POINTS = 180


def torque_over_a_turn(torque: TorqueBalance) -> tuple[tuple[float, ...], str]:
    """Return the inertia torque at even steps of a turn, and its unit."""
    if torque.operating_point is not None:
        terms = [(o.order, *map(float, torque.in_newton_metres(o.order))) for o in torque.orders]
        unit = "N m"
    else:
        terms = [(float(n), float(c), float(s)) for n, c, s in torque.terms()]
        unit = "m r² ω²"
    angles = [2 * pi * k / POINTS for k in range(POINTS + 1)]
    return tuple(sum(c * cos(n * t) + s * sin(n * t) for n, c, s in terms) for t in angles), unit


def draw_torque(torque: TorqueBalance) -> Drawing:
    """Return the inertia torque over a turn, in m r^2 omega^2, or in N m at an operating point."""
    values, unit = torque_over_a_turn(torque)
    largest = figure(max(map(abs, values)))
    words = f"Within ±{largest} {unit} over a turn, to order {torque.highest}; + with the rotation."
    curve = Curve("inertia torque on the crank", values, "force")
    return draw_curves([curve], 360, unit, f"Inertia torque of {torque.engine.name}", words)
