"""The direction and size of one cylinder's contribution to an order of the free force and couple.

With w = m r/(m_1 r_1) of cylinder 1 and f_n = A_n - i B_n the cylinder's part of the planar vector is

    c_n  = 1/2 w f_n  e^(2 pi i (axis + lead)),     c_-n = 1/2 w f_n* e^(2 pi i (axis - lead)),

axis = bank and lead = n (throw - bank), in turns: the force of a piston stays on its axis. The couple is
that times `arm`, the station from the reference plane. Unit m r omega^2 of cylinder 1 (times a).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from symbalance.engine.cylinders import Cylinder
from symbalance.engine.engine import Engine, checked_engine
from symbalance.errors import SymbalanceError
from symbalance.kinematics.mechanisms import Mechanism, SliderCrank
from symbalance.kinematics.mechanisms.moving_masses import piston_force
from symbalance.kinematics.slider_crank import checked_order
from symbalance.text.reals import Complex, expjpi


@dataclass(frozen=True)
class Contribution:
    """One cylinder's part in one order, by its number."""

    number: int
    order: int
    axis: Fraction
    lead: Fraction
    arm: Fraction
    size: Fraction
    value: Complex
    """f_n to 40 digits."""


def checked_numeric_engine(value: object) -> Engine:
    """Return an engine whose angles and rod ratios are numbers, or refuse."""
    engine = checked_engine(value)
    if engine.has_symbols:
        rule, remedy = "has symbols for angles", "give numbers, or use symbolic_order"
        raise SymbalanceError(f"engine {engine.name!r}", rule, remedy)
    return engine


def rotating_pair(cylinder: Cylinder, pins: Mapping[int, Complex], n: int) -> tuple[Complex, Complex]:
    """Return c_n and c_-n of 1 kg of a rod's rotating mass, over its r omega^2, in the engine's plane.

    On the crank pin it turns: e^(i throw) forward in order 1. `pins` (`link_pin_force`) is what a link
    pin adds to that in the cylinder's frame; it is empty for rods on the crank pin.
    """
    pair = []
    for signed in (n, -n):
        rotation = expjpi(2 * (cylinder.bank.turns + signed * cylinder.delay.turns))
        circle = expjpi(2 * cylinder.throw.turns) if signed == 1 else Complex(0)
        pair.append(circle + pins.get(signed, Complex(0)) * rotation)
    return pair[0], pair[1]


def contributions(engine: Engine, order: int, reference: object = None) -> dict[int, list[Contribution]]:
    """Return n -> every cylinder's contribution, for all orders to `order` that some cylinder has.

    >>> from symbalance.engine.catalogue import load
    >>> {n: [str(s.lead) for s in of] for n, of in contributions(load("inline-4"), 2).items()}
    {1: ['0', '1/2', '1/2', '0'], 2: ['0', '1', '1', '0']}
    """
    checked_order(order)
    checked_numeric_engine(engine)
    forces = [piston_force(mechanism_to(engine, c, order), order) for c in engine.cylinders]
    arms = engine.lever_arms(engine.plane(reference))
    rows = list(zip(engine.cylinders, arms, engine.sizes, forces, strict=True))
    return {
        n: [
            Contribution(c.number, n, c.bank.turns, n * c.delay.turns, arm, size, f.get(n, Complex(0)))
            for c, arm, size, f in rows
        ]
        for n in sorted({n for f in forces for n in f})
    }


def mechanism_to(engine: Engine, cylinder: Cylinder, order: int) -> Mechanism:
    """Return a cylinder's mechanism; of an unknown rod ratio, which order 1 needs not, one of ratio 4."""
    if cylinder.mechanism is None and order == 1:
        return SliderCrank(Fraction(4))
    if cylinder.mechanism is None and engine.has_common_harmonics:
        remedy = "give stroke and rod in mm, or --ratio"
        raise SymbalanceError(f"engine {engine.name!r}", "has no rod ratio", remedy)
    return cylinder.known_mechanism
