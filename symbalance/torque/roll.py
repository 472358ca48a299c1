"""Roll moment on the frame, and what the rods' own inertia adds to the torque on the crank.

Let H be the moment of momentum about the crank's axis of all that moves, T the torque the crank gets and
hands on at its end. The frame has the rest of what changes H:

    M = -T - dH/dt,    -dH/dt = sum of (-e_j F_j) + sum of J_x,j omega^2 phi_j''.

The crank and what turns with it have a steady H; a mass that goes along an axis beside the crank's has
one that changes (the inertia force F acts at the arm e), and a rod's two end masses belong to those two.
A mass on a link pin neither turns steadily nor goes along an axis: its force acts where the pin is.
What is left of the rod is its couple. T holds, by virtual work, the masses' kinetic energy, the rods'
(-J_x omega^2 phi' phi'') and the gas, which enters M by T alone: with centred cylinders and rods that are
two masses M = -T. Balance shafts off the crank's axis add their moment (`shafts`).

Formulas:
    -D dD/dtheta = u_2 sin 2 theta + u_4 sin 4 theta + ...        the rods, on the crank
    D = rho cos theta/cos phi
    with D = dphi/dtheta
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, ClassVar, Unpack

from symbalance.document.result import Result
from symbalance.engine.engine import Engine, checked_engine
from symbalance.errors import SymbalanceError, brief
from symbalance.exact.decimal_phasor import DecimalPhasor
from symbalance.exact.spectrum import Component
from symbalance.forces.operating_point import Sizes, sized
from symbalance.forces.shaft_moments import shaft_moment, shaft_terms
from symbalance.kinematics.bodies import EXCESS
from symbalance.kinematics.coefficients import OF_RODS, ROCKING, RODS, Kinematics
from symbalance.kinematics.slider_crank import checked_order
from symbalance.text.reals import DIGITS, Complex
from symbalance.torque.body_groups import has_common_torque, torque_groups, total_moment, total_torque
from symbalance.torque.inertia_balance import (
    TorqueBalance,
    first_excess,
    inertia_torque,
    sine_components,
)

if TYPE_CHECKING:
    from symbalance.document.nodes import Document
    from symbalance.torque.running import RunningTorque

ROD_TORQUE = "torque of the rods' own inertia on the crank"
ROD_COUPLE = "couple of the rods' own inertia on the frame"
BESIDE_MOMENT = "moment on the frame of inertia forces beside the crank's axis"
ROLL_MOMENT = "roll moment on the frame about the crank's axis, of all inertia"


def has_rod_couples(engine: Engine) -> bool:
    """Tell whether some rod's given inertia differs from that of two masses at its ends."""
    return any(excesses(engine))


def rod_torque(engine: Engine, order: int = 12, *, ratio: object = None) -> TorqueBalance:
    """Return what the rods' own inertia adds to the torque on the crank, in J_x omega^2.

    J_x is that of the first rod that has one; it comes from `rod_mass`, `rod_centre` and `rod_inertia`.
    """
    return _of_rods(engine, order, ratio, RODS)


def rod_couple(engine: Engine, order: int = 12, *, ratio: object = None) -> TorqueBalance:
    """Return the couple of the rods' own inertia on the frame, in J_x omega^2, as in `rod_torque`."""
    return _of_rods(engine, order, ratio, ROCKING)


def offset_moment(engine: Engine, order: int = 12, *, ratio: object = None) -> TorqueBalance:
    """Return the moment about the crank's axis of inertia forces whose line of action misses it.

    They are those of pistons whose axes are offset, and of masses on link pins. Units of m r^2 omega^2
    of cylinder 1; empty where there are none.
    """
    engine = _at_ratio(engine, order, ratio)
    groups = [] if has_common_torque(engine) else torque_groups(engine)
    moments = total_moment(groups, order)
    return TorqueBalance(
        engine, order, moments, kinematics=None, quantity=BESIDE_MOMENT, function=offset_moment
    )


def roll_moment(engine: Engine, order: int = 12, *, ratio: object = None) -> TorqueBalance:
    """Return the whole inertia moment on the frame about the crank, in m r^2 omega^2 of cylinder 1.

    It is that of pistons, rods and balance shafts together.

    It needs numbers: rod ratio, and with rods the reciprocating mass and the stroke in kg and mm.

    >>> from symbalance.engine.catalogue import load
    >>> roll_moment(load("inline-4"), 2, ratio=4)[2].torque.sin.round(6)
    2.000521
    """
    engine = _at_ratio(engine, order, ratio)
    excess = first_excess(engine) / _checked_scale(engine) if has_rod_couples(engine) else Fraction(0)
    parts = [(inertia_torque(engine, order), Fraction(-1)), (offset_moment(engine, order), Fraction(1))]
    if excess:
        parts += [(rod_torque(engine, order), -excess), (rod_couple(engine, order), excess)]
    terms = [(n, c, s, weight) for part, weight in parts for n, c, s in part.terms(digits=DIGITS)]
    of_shafts = list(shaft_terms(engine, order))
    terms += [(n, c, s, Fraction(1)) for n, c, s in of_shafts]
    total: dict[int, DecimalPhasor] = {}
    for n, cos, sin, weight in terms:
        number = DecimalPhasor(Complex(cos, sin) * weight)
        total[int(n)] = total[int(n)] + number if int(n) in total else number
    components = {n: Component(total[n]) for n in sorted(total) if not total[n].is_zero()}
    quantity = ROLL_MOMENT + (" and balance shafts" if of_shafts else "")
    return TorqueBalance(
        engine, order, components, kinematics=None, quantity=quantity, function=roll_moment
    )


@dataclass(frozen=True, repr=False)
class TorqueReport(Result):
    """An engine's inertia torque on the crank, its moments on the frame, and its running torque if given.

    `rod` and `rocking` are the rods' parts on crank and frame; `beside` is the frame's from offset axes;
    `shafts` is the moment of balance shafts in F_n r, and
    `frame` the whole moment on it in numbers, None where it is the crank's torque reversed, or where
    sizes are missing that it needs. `running` is the same engine's torque with gas, where that was given.
    """

    inertia: TorqueBalance
    rod: TorqueBalance
    rocking: TorqueBalance
    beside: TorqueBalance
    shafts: dict[int, Component]
    excess: Fraction
    frame: TorqueBalance | None
    running: RunningTorque | None = None

    kind: ClassVar[str] = "torque"
    record_keys: ClassVar[tuple[str, ...]] = (
        *("order", "of", "cos", "sin", "amplitude", "exact_cos", "exact_sin", "coefficient", "unit"),
    )

    def summary(self) -> str:
        """Return which orders the crank gets and what the frame gets, in one line."""
        frame = "the frame gets the opposite" if self.is_opposite else "the frame gets more than that"
        run = self.running
        mean = "" if run is None else f"; mean {run.mean:.6g} N m at {run.rpm:.6g} rpm"
        return f"{self.inertia.summary()}; {frame}{mean}"

    def document(self) -> Document:
        """Return the torque's orders on crank and frame, the running engine's, and what letters mean."""
        from symbalance.torque.torque_document import torque_document

        return torque_document(self)

    def data(self) -> dict[str, Any]:
        """Return the engine and every order, exact numbers as strings that SymPy reads."""
        from symbalance.torque.torque_data import torque_data

        return torque_data(self)

    def records(self) -> list[dict[str, Any]]:
        """Return a row for each order of each part, and of the running engine's torque in N m."""
        from symbalance.torque.torque_data import torque_records

        return torque_records(self)

    def at(self, *, rpm: object, **sizes: Unpack[Sizes]) -> TorqueReport:
        """Return the same report with its values in N m at a speed; sizes as of `TorqueBalance.at`."""
        if sizes:
            engine = sized(self.engine, sizes)
            if self.running is not None and engine != self.engine:
                rule = "would be another engine than the running one"
                raise SymbalanceError("sizes", rule, "give them to the engine: engine.with_sizes(...)")
            return torque_report(engine, self.inertia.highest, running=self.running).at(rpm=rpm)
        return replace(
            self,
            inertia=self.inertia.at(rpm=rpm),
            rod=self.rod.at(rpm=rpm),
            rocking=self.rocking.at(rpm=rpm),
            beside=self.beside.at(rpm=rpm),
            frame=None if self.frame is None else self.frame.at(rpm=rpm),
        )

    def parts(self) -> tuple[TorqueBalance, ...]:
        """Return the torques and moments that the report is of: on the crank, then on the frame."""
        rods = (self.rod, self.rocking) if self.excess else ()
        beside = (self.beside,) if self.beside.components else ()
        whole = () if self.frame is None else (self.frame,)
        return (self.inertia, *rods, *beside, *whole)

    @property
    def engine(self) -> Engine:
        """The engine, at the rod ratio asked for."""
        return self.inertia.engine

    @property
    def is_opposite(self) -> bool:
        """Whether the frame gets the crank's torque reversed, and nothing else."""
        return not (self.excess or self.beside.components or self.shafts)


def torque_report(
    engine: Engine, order: int = 12, *, ratio: object = None, running: RunningTorque | None = None
) -> TorqueReport:
    """Return an engine's inertia torque on crank and frame, and the running engine's torque if given.

    `running` is `running_torque` of the same engine, at the same rod ratio.

    >>> from symbalance.engine.catalogue import load
    >>> torque_report(load("inline-6"), 6)
    Inertia torque on the crank, inline-6 to order 6: order 3, 6; the frame gets the opposite
    """
    inertia = inertia_torque(engine, order, ratio=ratio)
    engine = inertia.engine
    if running is not None and running.engine != engine:
        what = f"running = {brief(running.engine.name)}"
        rule = f"is another engine than {engine.name}, or has another rod ratio"
        raise SymbalanceError(what, rule, "give the same engine and ratio to running_torque")
    rod, rocking = rod_torque(engine, order), rod_couple(engine, order)
    beside, excess = offset_moment(engine, order), first_excess(engine)
    known = all(c.mechanism for c in engine.cylinders) and not engine.has_symbols
    needs = known and (mass_scale(engine) is not None or not excess)
    shafts = {n: c for n, c in shaft_moment(engine).items() if n <= order}
    opposite = not (excess or beside.components or shafts)
    frame = roll_moment(engine, order) if needs and not opposite else None
    return TorqueReport(inertia, rod, rocking, beside, shafts, excess, frame, running)


def mass_scale(engine: Engine) -> Fraction | None:
    """Return m r^2 of cylinder 1 in kg mm^2, None where its mass or its stroke is not known."""
    first = engine.first
    mass, radius = first.reciprocating_mass, first.radius
    return mass * radius * radius if mass and radius else None


def _checked_scale(engine: Engine) -> Fraction:
    scale = mass_scale(engine)
    if scale is None:
        rule = "has rods with inertia, but no reciprocating mass or no stroke to compare it with"
        raise SymbalanceError(f"engine {engine.name!r}", rule, "give reciprocating_mass and stroke")
    return scale


def _of_rods(engine: Engine, order: int, ratio: object, kinematics: Kinematics) -> TorqueBalance:
    engine = _at_ratio(engine, order, ratio)
    unit, couple = first_excess(engine), kinematics is ROCKING
    components: dict[int, Component] = {}
    own: Kinematics | None = kinematics
    if unit and has_common_torque(engine) and {*excesses(engine)} == {unit}:
        components = {n: c for n, c in sine_components(engine, order).items() if n % 2 == couple}
    elif unit:
        own, total_of = None, total_moment if couple else total_torque
        total = total_of(torque_groups(engine, [EXCESS]), order)
        components = {n: Component(c.number.scaled(1 / unit)) for n, c in total.items()}
    quantity = ROD_COUPLE if couple else ROD_TORQUE
    function = rod_couple if couple else rod_torque
    return TorqueBalance(
        engine, order, components, kinematics=own, unit=OF_RODS, quantity=quantity, function=function
    )


def _at_ratio(engine: Engine, order: int, ratio: object) -> Engine:
    checked_order(order)
    return checked_engine(engine) if ratio is None else checked_engine(engine).with_ratio(ratio)


def excesses(engine: Engine) -> list[Fraction]:
    """Return every rod's J_x in kg mm^2, 0 where its inertia is not given."""
    return [c.excess for c in engine.cylinders]
