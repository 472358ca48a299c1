"""From a torque to waves: inertia and rods by their orders, gas and the whole of a running engine.

Gas has the traces' harmonics compiled in, the piston's area too: its unit is the crank radius alone. The
whole torque is that of the running engine's own sizes and speed, and takes no keyword: inertia and gas do
not grow alike with them.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from symbalance.codegen.asked import shown_terms, upward
from symbalance.codegen.waves import RODS, TORQUE, TORQUE_ITSELF, TORQUE_PER_RADIUS, Term, Wave
from symbalance.errors import SymbalanceError
from symbalance.forces.free_forces import Balance
from symbalance.kinematics.piston_torque import torque_left_out
from symbalance.kinematics.slider_crank import HIGHEST_ORDER
from symbalance.text.reals import DIGITS, Real, fsum, ldexp
from symbalance.torque import CrankTorque, TorqueBalance, inertia_torque, rod_torque, roll_moment
from symbalance.torque.body_groups import has_common_torque
from symbalance.torque.roll import MILLI, first_excess

MANY_ORDERS = 96
"""Orders taken where all are asked for and no bound is proved; what does not show is dropped."""

INERTIA, ROD, FRAME = "torque.inertia", "torque.rod", "torque.frame"
GAS, TOTAL = "torque.gas", "torque.total"
TORQUES = (INERTIA, ROD, FRAME, GAS, TOTAL)
MEANINGS = {
    INERTIA: "inertia torque on the crank",
    ROD: "torque on the crank of the rods' own inertia, J_x of the engine's file",
    FRAME: "inertia moment on the frame about the crank's axis; rods' part as at the file's masses",
    GAS: "gas torque on the crank at the pressures and the bore given",
    TOTAL: "torque on the crank, gas and inertia, at the bore, stroke, mass and speed given",
}
UNITS = {
    INERTIA: TORQUE,
    ROD: RODS,
    FRAME: TORQUE,
    GAS: TORQUE_PER_RADIUS,
    TOTAL: TORQUE_ITSELF,
}
FIRST_TRY = 48
Result = Balance | TorqueBalance | CrankTorque


def torque_wave(result: Result, name: str, ratio: Fraction, order: int, tolerance: float | None) -> Wave:
    """Return a torque's harmonics to an order; with a tolerance the fewest within it, 0 asking for all.

    The tolerance's unit is that of the torque with every keyword 1.
    """
    if name in (GAS, TOTAL):
        return _running(_checked_running(result, name), name, order, tolerance)
    if tolerance is None:
        return _to(result, name, ratio, order, order)
    if name == INERTIA and has_common_torque(result.layout):
        return _within(result, ratio, tolerance)
    if tolerance:
        rule = f"has no proven bound for {name} here"
        raise SymbalanceError(f"tolerance = {tolerance:g}", rule, "give the highest order instead")
    return _to(result, name, ratio, MANY_ORDERS, order)


def _to(result: Result, name: str, ratio: Fraction, order: int, asked: int) -> Wave:
    terms = _terms(result, name, ratio, order)
    through = order if order == asked else max((int(t.order) for t in terms), default=0)
    return _wave(name, terms=shown_terms(terms), through=through)


def _wave(name: str, **fields: object) -> Wave:
    return Wave(name, UNITS[name], MEANINGS[name], **fields)  # type: ignore[arg-type]


def _terms(result: Result, name: str, ratio: Fraction, order: int) -> tuple[Term, ...]:
    makers: dict[str, Callable[..., TorqueBalance]]
    makers = {INERTIA: inertia_torque, ROD: rod_torque, FRAME: roll_moment}
    layout, scale = result.layout, Fraction(1)
    if has_common_torque(layout):
        layout = layout.with_ratio(ratio)
    if name == ROD:
        scale = first_excess(layout) / MILLI**2
    found = makers[name](layout, order).terms(digits=DIGITS)
    return tuple(Term(n, cos * scale, sin * scale) for n, cos, sin in found)


def _within(result: Result, ratio: Fraction, tolerance: float) -> Wave:
    """Return like cylinders' inertia torque with the fewest orders whose proven bound is within reach."""
    count, order = len(result.layout.cylinders), FIRST_TRY
    while True:
        terms = _terms(result, INERTIA, ratio, order)
        beyond = count * torque_left_out(order, ratio)
        sizes = [t.size for t in terms]
        wanted, bound = tolerance or ldexp(max(sizes, default=Real(1)), -57), fsum(sizes) + beyond
        for kept in range(len(sizes) + 1):
            bound = fsum(sizes[kept:]) + beyond
            if bound <= wanted:
                through = int(terms[kept - 1].order) if kept else 0
                return _wave(INERTIA, terms=terms[:kept], through=through, left_out=upward(bound))
        if order == HIGHEST_ORDER:
            rule = f"needs orders above {HIGHEST_ORDER} of {INERTIA} at lambda = {float(ratio):g}"
            remedy = f"{HIGHEST_ORDER} orders leave out up to {float(bound):.2g}: ask for that"
            raise SymbalanceError(f"tolerance = {tolerance:g}", rule, remedy)
        order = min(4 * order, HIGHEST_ORDER)


def _checked_running(result: Result, name: str) -> CrankTorque:
    if not isinstance(result, CrankTorque):
        rule = "is that of a running engine, with pressures in its cylinders"
        remedy = "crank_torque(layout, trace, ...); on the command line --pressure or --compression"
        raise SymbalanceError(f"output '{name}'", rule, remedy)
    return result


def _running(made: CrankTorque, name: str, order: int, tolerance: float | None) -> Wave:
    if tolerance is not None:
        rule = "has corners, and orders that fall too slowly to take all that show"
        raise SymbalanceError(f"output '{name}'", rule, "give the highest order, as --order 24")
    found, mean, scale = made.terms(order), made.mean, 1.0
    if name == GAS:
        found, scale = made.gas_terms(order), made.radius
    terms = tuple(Term(n, Real(cos) / scale, Real(sin) / scale) for n, cos, sin in found)
    return _wave(name, terms=shown_terms(terms), through=order, mean=Real(mean) / scale)
