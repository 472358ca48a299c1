r"""What rolls the frame, and what the rods' own inertia adds to the crank's torque.

Let H be the moment of momentum about the crank's axis of all that moves, T the torque the crank gets and
hands on at its end. The frame has the rest of what changes H:

    M = -T - dH/dt,    -dH/dt = sum of (-e_j F_j) + sum of J_x,j omega^2 phi_j''.

The crank and what turns with it have a steady H; a mass that goes along an axis beside the crank's has
one that changes (the inertia force F acts at the arm e), and a rod's two end masses belong to those two.
A mass on a link pin neither turns steadily nor goes along an axis: its force acts where the pin is.
What is left of the rod is its couple. T holds, by virtual work, the masses' kinetic energy, the rods'
(-J_x omega^2 phi' phi'') and the gas, which enters M by T alone: with centred cylinders and rods that are
two masses M = -T. Balance shafts off the crank's axis add their moment (`shafts`).
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from symbalance.engine.engine import Engine
from symbalance.errors import SymbalanceError
from symbalance.exact.decimal_phasor import DecimalPhasor
from symbalance.exact.spectrum import Component
from symbalance.forces.shafts import shaft_moment, shaft_terms
from symbalance.kinematics.bodies import EXCESS
from symbalance.kinematics.coefficients import OF_RODS, ROCKING, RODS, Kinematics
from symbalance.kinematics.slider_crank import checked_order
from symbalance.text.reals import DIGITS, Complex
from symbalance.torque.groups import has_common_torque, summed_moment, summed_torque, torque_groups
from symbalance.torque.inertia_balance import (
    TorqueBalance,
    checked_layout,
    inertia_torque,
    sine_components,
)

MILLI = 1000
"""Millimetres in a metre."""


def has_rods(layout: Engine) -> bool:
    """Tell whether some rod's inertia is given and is not that of two masses."""
    return any(excesses(layout))


def first_excess(layout: Engine) -> Fraction:
    """Return J_x in kg mm^2 of the first rod that has one: the unit of the rods' parts."""
    rods = sorted(layout.cylinders, key=lambda c: c.number)
    return next((c.excess for c in rods if c.excess), Fraction(0))


def rod_torque(layout: Engine, order: int = 12, *, ratio: object = None) -> TorqueBalance:
    """Return what the rods' own inertia adds to the torque on the crank, in J_x omega^2.

    J_x is that of the first rod that has one; it comes from `rod_mass`, `rod_centre` and `rod_inertia`.
    """
    return _of_rods(layout, order, ratio, RODS)


def rod_couple(layout: Engine, order: int = 12, *, ratio: object = None) -> TorqueBalance:
    """Return the couple of the rods' own inertia on the frame, in J_x omega^2, as in `rod_torque`."""
    return _of_rods(layout, order, ratio, ROCKING)


def beside_moment(layout: Engine, order: int = 12, *, ratio: object = None) -> TorqueBalance:
    """Return the moment about the crank's axis of inertia forces that act beside it.

    They are those of pistons whose axes are offset, and of masses on link pins. Units of m r^2 omega^2
    of cylinder 1; empty where there are none.
    """
    layout = _at_ratio(layout, order, ratio)
    groups = [] if has_common_torque(layout) else torque_groups(layout)
    return TorqueBalance(layout, order, summed_moment(groups, order), kinematics=None)


def roll_moment(layout: Engine, order: int = 12, *, ratio: object = None) -> TorqueBalance:
    """Return the whole inertia moment on the frame about the crank, in m r^2 omega^2 of cylinder 1.

    It is that of pistons, rods and balance shafts together.

    It needs numbers: rod ratio, and with rods the reciprocating mass and the stroke in kg and mm.

    >>> from symbalance.engine.catalogue import load
    >>> roll_moment(load("inline-4"), 2, ratio=4)[2].torque.sin.round(6)
    2.000521
    """
    layout = _at_ratio(layout, order, ratio)
    excess = first_excess(layout) / _checked_scale(layout) if has_rods(layout) else Fraction(0)
    parts = [(inertia_torque(layout, order), Fraction(-1)), (beside_moment(layout, order), Fraction(1))]
    if excess:
        parts += [(rod_torque(layout, order), -excess), (rod_couple(layout, order), excess)]
    terms = [(n, c, s, weight) for part, weight in parts for n, c, s in part.terms(digits=DIGITS)]
    terms += [(n, c, s, Fraction(1)) for n, c, s in shaft_terms(layout, order)]
    total: dict[int, DecimalPhasor] = {}
    for n, cos, sin, weight in terms:
        number = DecimalPhasor(Complex(cos, sin) * weight)
        total[int(n)] = total[int(n)] + number if int(n) in total else number
    components = {n: Component(total[n]) for n in sorted(total) if not total[n].is_zero()}
    return TorqueBalance(layout, order, components, kinematics=None)


@dataclass(frozen=True)
class TorqueReport:
    """All that is known of a layout's inertia torque: on the crank, and on the frame.

    `rod` and `rocking` are the rods' parts on crank and frame; `beside` is the frame's from offset axes;
    `shafts` is the moment of balance shafts in F_n r, and
    `frame` the whole moment on it in numbers, None where it is the crank's torque reversed, or where
    sizes are missing that it needs.
    """

    inertia: TorqueBalance
    rod: TorqueBalance
    rocking: TorqueBalance
    beside: TorqueBalance
    shafts: dict[int, Component]
    excess: Fraction
    frame: TorqueBalance | None

    def as_latex(self, *, standalone: bool = False) -> str:
        """Return it as LaTeX, a fragment or a whole document."""
        from symbalance.torque.torque_latex import torque_latex

        return torque_latex(self, standalone=standalone)

    @property
    def layout(self) -> Engine:
        """The layout, at the rod ratio asked for."""
        return self.inertia.layout

    @property
    def is_opposite(self) -> bool:
        """Whether the frame gets the crank's torque reversed, and nothing else."""
        return not (self.excess or self.beside.components or self.shafts)


def torque_report(layout: Engine, order: int = 12, *, ratio: object = None) -> TorqueReport:
    """Return a layout's inertia torque with all that goes to the frame."""
    inertia = inertia_torque(layout, order, ratio=ratio)
    layout = inertia.layout
    rod, rocking = rod_torque(layout, order), rod_couple(layout, order)
    beside, excess = beside_moment(layout, order), first_excess(layout)
    known = all(c.mechanism for c in layout.cylinders) and not layout.has_symbols
    needs = known and (mass_scale(layout) is not None or not excess)
    shafts = {n: c for n, c in shaft_moment(layout).items() if n <= order}
    opposite = not (excess or beside.components or shafts)
    frame = roll_moment(layout, order) if needs and not opposite else None
    return TorqueReport(inertia, rod, rocking, beside, shafts, excess, frame)


def mass_scale(layout: Engine) -> Fraction | None:
    """Return m r^2 of cylinder 1 in kg mm^2, None where its mass or its stroke is not known."""
    first = layout.first
    mass, radius = first.reciprocating_mass, first.radius
    return mass * radius * radius if mass and radius else None


def _checked_scale(layout: Engine) -> Fraction:
    scale = mass_scale(layout)
    if scale is None:
        rule = "has rods with inertia, but no reciprocating mass or no stroke to compare it with"
        raise SymbalanceError(f"engine {layout.name!r}", rule, "give reciprocating_mass and stroke")
    return scale


def _of_rods(layout: Engine, order: int, ratio: object, kinematics: Kinematics) -> TorqueBalance:
    layout = _at_ratio(layout, order, ratio)
    unit = first_excess(layout)
    if not unit:
        return TorqueBalance(layout, order, {}, kinematics=kinematics, unit=OF_RODS)
    if has_common_torque(layout) and {*excesses(layout)} == {unit}:
        odd = kinematics is ROCKING
        found = {n: c for n, c in sine_components(layout, order).items() if n % 2 == odd}
        return TorqueBalance(layout, order, found, kinematics=kinematics, unit=OF_RODS)
    summed = summed_moment if kinematics is ROCKING else summed_torque
    components = summed(torque_groups(layout, [EXCESS]), order)
    per_unit = {n: Component(c.number.scaled(1 / unit)) for n, c in components.items()}
    return TorqueBalance(layout, order, per_unit, kinematics=None, unit=OF_RODS)


def _at_ratio(layout: Engine, order: int, ratio: object) -> Engine:
    checked_order(order)
    return checked_layout(layout) if ratio is None else checked_layout(layout).with_ratio(ratio)


def excesses(layout: Engine) -> list[Fraction]:
    """Return every rod's J_x in kg mm^2, 0 where its inertia is not given."""
    return [c.excess for c in layout.cylinders]
