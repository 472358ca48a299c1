"""Drawings of an engine and its forces: `section(engine, 30)`, `star(engine, 2)`, `path(balance)`.

A drawing shows itself in a notebook; `to_svg` returns it as SVG, `to_tikz` for LaTeX, and `to_picture`
as the bytes of a PNG or PDF. What is drawn of results also takes the engine itself.

>>> from symbalance.engine.catalogue import load
>>> section(load("v8-90"), 30)
Drawing: Cross-section of v8-90 at θ = 30°
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from symbalance.document.picture_files import drawing_picture as to_picture
from symbalance.document.shapes import Drawing
from symbalance.document.svg_writer import drawing_svg as to_svg
from symbalance.document.tikz_writer import drawing_tikz as to_tikz
from symbalance.drawing.crank_star import draw_star_alone as star
from symbalance.drawing.firing_diagram import draw_firing as firing
from symbalance.drawing.oblique import draw_oblique as oblique
from symbalance.drawing.plan import draw_plan as plan
from symbalance.drawing.section import draw_section as section

if TYPE_CHECKING:
    from symbalance.engine.engine import Engine
    from symbalance.forces.free_forces import Balance
    from symbalance.torque.inertia_balance import TorqueBalance

OVERVIEW_HIGH, OVERVIEW_FIELD = 250.0, 240.0
"""Pixels of an overview's height, and of a diagram's field in it."""
MOST_AXES, MOST_BARS = 4, 8

__all__ = [
    "firing",
    "forces",
    "oblique",
    "orders",
    "overview",
    "path",
    "plan",
    "section",
    "star",
    "to_picture",
    "to_svg",
    "to_tikz",
    "torque",
]


def forces(result: Balance | Engine) -> Drawing:
    """Return the free force and couple over a turn, vertical and lateral."""
    from symbalance.forces.pictures import draw_forces

    return draw_forces(_balance(result))


def path(result: Balance | Engine, of: str = "force") -> Drawing:
    """Return the way the end of the force's vector goes over a turn, or the couple's."""
    from symbalance.forces.pictures import draw_force_path

    return draw_force_path(_balance(result), of)


def orders(result: Balance | Engine) -> Drawing:
    """Return every order of force and couple as a bar, on a logarithmic scale."""
    from symbalance.forces.pictures import draw_orders

    return draw_orders(_balance(result))


def overview(result: Balance | Engine) -> Drawing:
    """Return the section, the star of the first free order, the firing diagram and the orders in a row.

    What an engine has not is left out: a star of more than four axes, a diagram without a firing order.
    """
    from symbalance.drawing.charts import beside
    from symbalance.forces.pictures import draw_orders

    shown = _balance(result)
    engine = shown.engine
    drawings = [section(engine)]
    if len(engine.grouped(lambda c: c.bank)) <= MOST_AXES:
        drawings.append(star(engine, min([*shown.force.orders(), *shown.couple.orders()], default=1)))
    if all(c.fires is not None for c in engine.cylinders):
        drawings.append(firing(engine, OVERVIEW_FIELD))
    drawings.append(draw_orders(shown, OVERVIEW_FIELD - 80, MOST_BARS))
    return beside(drawings, OVERVIEW_HIGH, f"{engine.name} at a glance")


def torque(result: TorqueBalance | Engine) -> Drawing:
    """Return the inertia torque on the crank over a turn."""
    from symbalance.torque.inertia_balance import TorqueBalance, inertia_torque
    from symbalance.torque.pictures import draw_torque

    return draw_torque(result if isinstance(result, TorqueBalance) else inertia_torque(result))


def _balance(result: Balance | Engine) -> Balance:
    from symbalance.forces.free_forces import Balance, balance

    return result if isinstance(result, Balance) else balance(result)
