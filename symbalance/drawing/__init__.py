"""The engine as drawings: section, plan, oblique view, crank star, firing and stroke diagram; charts.

In: an `Engine` and a crank angle. Out: a `Drawing`, which `to_svg` and `to_tikz` write. What is drawn of
results (orders, forces, torque) stands with them.

    positions         where pins and pistons stand at a crank angle
    section, plan, oblique          the engine seen from the front, from above, from in front
    crank_star, firing_diagram      an order's arrows and what they leave; strokes and intervals
    charts            curves, a path, bars
"""

from symbalance.loading import attach

__getattr__, __dir__, __all__ = attach(__name__, __file__)
