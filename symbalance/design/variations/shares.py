"""What one cylinder contributes to one order: an exact direction, and a size.

With w = m r/(m_1 r_1) of cylinder 1 and f_n = A_n - i B_n the cylinder's part of the planar vector is

    c_n  = 1/2 w f_n  e^(2 pi i (axis + lead)),     c_-n = 1/2 w f_n* e^(2 pi i (axis - lead)),

axis = bank and lead = n (throw - bank), in turns: the force of a piston stays on its axis. The couple is
that times `arm`, the station from the reference plane. Unit m r omega^2 of cylinder 1 (times a).
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from mpmath import mp

from symbalance.engine.cylinders import Cylinder, known_mechanism
from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError, shown
from symbalance.kinematics.mechanisms import Mechanism, SliderCrank
from symbalance.kinematics.mechanisms.moving_masses import piston_force
from symbalance.kinematics.slider_crank import checked_order
from symbalance.text.numbers import Real, exact


@dataclass(frozen=True)
class Share:
    """One cylinder's part in one order, by its number."""

    number: int
    order: int
    axis: Fraction
    lead: Fraction
    arm: Fraction
    size: Fraction
    value: Real
    """f_n to 40 digits."""


def checked_layout(layout: object) -> Engine:
    """Return a layout whose angles and rod ratios are numbers, or refuse."""
    if not isinstance(layout, Engine):
        raise SymbalanceError(f"layout = {shown(layout)}", "must be a Engine", 'load one: load("v12-60")')
    if layout.has_symbols:
        rule, remedy = "has symbols for angles", "give numbers, or use symbolic_order"
        raise SymbalanceError(f"engine {layout.name!r}", rule, remedy)
    return layout


def check_crank_pins(layout: Engine, what: str) -> None:
    """Refuse what takes all rotating masses to sit on crank pins where link pins bear some."""
    if layout.link_pins:
        rule = f"is of masses on the crank pin, and the rod of cylinder {layout.link_pins[0]} hangs on a"
        rule += " link pin"
        raise SymbalanceError(what, rule, "leave it out: what a link pin's mass adds is not computed")


def arms(layout: Engine, reference: object = None) -> list[Fraction]:
    """Return the stations from the reference plane, in pitches."""
    return layout.arms(None if reference is None else exact(reference, "reference"))


def shares(layout: Engine, order: int, reference: object = None) -> dict[int, list[Share]]:
    """Return n -> every cylinder's share, for all orders to `order` that some cylinder has.

    >>> from symbalance.engine.catalogue import load
    >>> {n: [str(s.lead) for s in of] for n, of in shares(load("inline-4"), 2).items()}
    {1: ['0', '1/2', '1/2', '0'], 2: ['0', '1', '1', '0']}
    """
    checked_order(order)
    checked_layout(layout)
    own = [piston_force(mechanism_to(layout, c, order), order) for c in layout.cylinders]
    rows = list(zip(layout.cylinders, arms(layout, reference), layout.sizes, own, strict=True))
    return {
        n: [
            Share(c.number, n, c.bank.turns, n * c.delay.turns, arm, size, f.get(n, mp.mpc(0)))
            for c, arm, size, f in rows
        ]
        for n in sorted({n for f in own for n in f})
    }


def mechanism_to(layout: Engine, cylinder: Cylinder, order: int) -> Mechanism:
    """Return a cylinder's mechanism; of an unknown rod ratio, which order 1 needs not, one of ratio 4."""
    if cylinder.mechanism is None and order == 1:
        return SliderCrank(Fraction(4))
    if cylinder.mechanism is None and layout.has_common_harmonics:
        remedy = "give stroke and rod in mm, or --ratio"
        raise SymbalanceError(f"engine {layout.name!r}", "has no rod ratio", remedy)
    return known_mechanism(cylinder)
