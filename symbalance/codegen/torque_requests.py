"""The requested torques as harmonic sums: inertia, rods, gas, or a running engine's whole torque.

Gas has the traces' harmonics compiled in, the piston's area too: its unit is the crank radius alone. The
whole torque is that of the running engine's own sizes and speed, and takes no keyword: inertia and gas do
not grow alike with them.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import ceil

from symbalance.codegen.harmonic_sum import (
    RODS,
    TORQUE,
    TORQUE_ITSELF,
    TORQUE_PER_RADIUS,
    HarmonicSum,
    HarmonicTerm,
)
from symbalance.codegen.requests import FIRST_ORDER, double_above, fewest_within, visible_terms
from symbalance.errors import SymbalanceError
from symbalance.forces.free_forces import Balance
from symbalance.kinematics.piston_torque import torque_left_out
from symbalance.kinematics.slider_crank import HIGHEST_ORDER
from symbalance.text.reals import DIGITS, Real
from symbalance.torque import RunningTorque, TorqueBalance, inertia_torque, rod_torque, roll_moment
from symbalance.torque.body_groups import has_common_torque
from symbalance.torque.inertia_balance import MILLI, first_excess

MANY_ORDERS = 96
"""Orders taken where all are requested and no bound is proved; what does not show is dropped."""
NEPERS = 50
"""e^-50 = 2e-22: far below a double's last digit."""

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
Result = Balance | TorqueBalance | RunningTorque


def torque_sum(
    result: Result, name: str, ratio: Fraction, order: int, tolerance: float | None
) -> HarmonicSum:
    """Return a torque's harmonics to an order; with a tolerance the fewest within it, 0 asking for all.

    The tolerance's unit is that of the torque with every keyword 1.
    """
    if name in (GAS, TOTAL):
        return _running(_checked_running(result, name), name, order, tolerance)
    if tolerance is None:
        return _to_order(result, name, ratio, order, order)
    if name == INERTIA and has_common_torque(result.engine):
        return _within(result, ratio, tolerance)
    if tolerance:
        rule = f"has no proven bound for {name} here"
        raise SymbalanceError(f"tolerance = {tolerance:g}", rule, "give the highest order instead")
    return _to_order(result, name, ratio, _most_orders(result), order)


def _most_orders(result: Result) -> int:
    """Return from which order on nothing shows: orders n fall as e^(-a n), a the mechanisms' strip."""
    known = [c.mechanism for c in result.engine.cylinders if c.mechanism is not None]
    if has_common_torque(result.engine) or not known:
        return MANY_ORDERS
    return min(MANY_ORDERS, 4 + ceil(NEPERS / max(min(m.strip for m in known), NEPERS / MANY_ORDERS)))


def _to_order(result: Result, name: str, ratio: Fraction, order: int, requested: int) -> HarmonicSum:
    terms = _terms(result, name, ratio, order)
    through = order if order == requested else max((int(t.order) for t in terms), default=0)
    return _sum(name, terms=visible_terms(terms), through=through)


def _sum(name: str, **fields: object) -> HarmonicSum:
    return HarmonicSum(name, UNITS[name], MEANINGS[name], **fields)  # type: ignore[arg-type]


def _terms(result: Result, name: str, ratio: Fraction, order: int) -> tuple[HarmonicTerm, ...]:
    torques: dict[str, Callable[..., TorqueBalance]]
    torques = {INERTIA: inertia_torque, ROD: rod_torque, FRAME: roll_moment}
    engine, scale = result.engine, Fraction(1)
    if has_common_torque(engine):
        engine = engine.with_ratio(ratio)
    if name == ROD:
        scale = first_excess(engine) / MILLI**2
    terms = torques[name](engine, order).terms(digits=DIGITS)
    return tuple(HarmonicTerm(n, cos * scale, sin * scale) for n, cos, sin in terms)


def _within(result: Result, ratio: Fraction, tolerance: float) -> HarmonicSum:
    """Return like cylinders' inertia torque with the fewest orders whose proven bound is within reach."""
    count = len(result.engine.cylinders)
    terms, bound, _ = fewest_within(
        lambda order: _terms(result, INERTIA, ratio, order),
        lambda order: count * torque_left_out(order, ratio),
        tolerance,
        FIRST_ORDER,
        default_size=Real(1),
    )
    if terms is None:
        rule = f"needs orders above {HIGHEST_ORDER} of {INERTIA} at lambda = {float(ratio):g}"
        remedy = f"{HIGHEST_ORDER} orders leave out up to {float(bound):.2g}: ask for that"
        raise SymbalanceError(f"tolerance = {tolerance:g}", rule, remedy)
    through = int(terms[-1].order) if terms else 0
    return _sum(INERTIA, terms=terms, through=through, left_out=double_above(bound))


def _checked_running(result: Result, name: str) -> RunningTorque:
    if not isinstance(result, RunningTorque):
        rule = "is that of a running engine, with pressures in its cylinders"
        remedy = "running_torque(engine, trace, ...); on the command line --pressure or --compression"
        raise SymbalanceError(f"output '{name}'", rule, remedy)
    return result


def _running(torque: RunningTorque, name: str, order: int, tolerance: float | None) -> HarmonicSum:
    if tolerance is not None:
        rule = "has corners, and orders that fall too slowly to take all that show"
        raise SymbalanceError(f"output '{name}'", rule, "give the highest order, as --order 24")
    terms, mean, scale = torque.terms(order), torque.mean, 1.0
    if name == GAS:
        terms, scale = torque.gas_terms(order), torque.radius
    scaled = tuple(HarmonicTerm(n, Real(cos) / scale, Real(sin) / scale) for n, cos, sin in terms)
    return _sum(name, terms=visible_terms(scaled), through=order, mean=Real(mean) / scale)
