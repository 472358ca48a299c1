"""Results as functions in memory: the very source that `symbalance emit` writes, compiled when used."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from importlib.util import find_spec
from math import isfinite
from typing import Any

from symbalance.codegen.harmonic_sum import HarmonicSum
from symbalance.codegen.keyword_defaults import defaults_of
from symbalance.codegen.plans import Plan, choose_plan
from symbalance.codegen.requests import OUTPUTS, checked_outputs, rod_ratio, sums_to_order, sums_within
from symbalance.codegen.source_cache import source_file
from symbalance.codegen.targets import FILES, IN_MEMORY, files
from symbalance.codegen.torque_requests import TORQUES, torque_sum
from symbalance.errors import MissingPartError, SymbalanceError, brief
from symbalance.forces.free_forces import Balance, balance, checked_balance
from symbalance.kinematics.slider_crank import checked_order
from symbalance.torque import RunningTorque, TorqueBalance

ALL_OUTPUTS = (*OUTPUTS, *TORQUES)
RUNNING_ORDER = 12
"""The highest order of a running engine's torque, unless another is given."""
Source = Balance | TorqueBalance | RunningTorque
Result = Any


@dataclass(frozen=True)
class Evaluator:
    """A function of the crank angle (rad) that computes outputs of a result in SI units.

    Called as f(theta, *, mass, radius, omega, pitch, out=None).
    theta may have any shape; the values come back in it, as an array for one output and a dict of arrays
    for several. mass (kg, reciprocating, one cylinder), radius (m, half the stroke), omega (rad/s) and
    pitch (m) are one number each. Unless given they are 1, and the result is in units of m r omega^2
    (couples: times a; torque: times r); of a result at an operating point, `balance(…).at(rpm=6000)`,
    they are that point's, and the result is in N and N m. + is up and right; couples are + with the front
    pushed up or right, torque as it turns. `out` takes the values, an array for each output, and may
    overlap theta. What is no angle is refused with TypeError: None, text, and a masked array, whose mask
    would be lost.

    `rounding` holds, by output, what a value may be off by rounding, in u = 2^-53 of the output's
    `amplitude` (for |theta| <= 2^20); `left_out` what the orders left out may sum to, in units of
    m r omega^2 (couples: times a), None where the orders were given. `source` is the module's text.
    """

    target: str
    source: str
    ratio: Fraction
    outputs: tuple[str, ...]
    orders: dict[str, tuple[str, ...]]
    forms: dict[str, str]
    rounding: dict[str, float]
    amplitude: dict[str, float]
    left_out: dict[str, float | None]

    @cached_property
    def _module(self) -> dict[str, Any]:
        name = f"symbalance_{self.target}"
        file = source_file(self.source) if self.target == "numba" else None
        namespace: dict[str, Any] = {"__name__": name}
        place = f"<{name}>" if file is None else str(file)
        exec(compile(self.source, place, "exec"), namespace)  # text of our own
        return namespace

    def __repr__(self) -> str:
        return f"Evaluator({', '.join(self.outputs)}; target {self.target}, rod ratio {self.ratio})"

    def __call__(self, theta: Any, **keywords: Any) -> Result:
        """Return the outputs at the crank angles `theta` (radians)."""
        return self._module["evaluate"](theta, **keywords)

    def on_grid(self, points: int, turns: int = 1, **keywords: Any) -> Result:
        """Return the outputs at theta = 2 pi j/points over whole turns, computing one period only."""
        return self._module["on_grid"](points, turns, **keywords)

    def self_test(self) -> None:
        """Compare with the true values at the angles the source holds; AssertionError past a bound."""
        self._module["self_test"]()

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in self.__dict__.items() if name != "_module"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)

    def __hash__(self) -> int:
        return hash(self.source)


def to_function(
    result: Source,
    ratio: object = None,
    outputs: Sequence[str] | str | None = None,
    target: str = "numpy",
    *,
    tolerance: float | None = None,
    order: int | None = None,
) -> Evaluator:
    """Return a picklable function of the crank angle that computes `outputs` of a result and no more.

    Outputs: force or couple, a dot, and vertical, lateral, forward or backward; and piston.displacement,
    piston.velocity and piston.acceleration of cylinder 1, exact. `ratio` is the rod ratio lambda = l/r;
    every A_n is taken exact in it, rounded once. Targets: numpy, numba, array-api. The default is
    force.vertical, of an inertia torque torque.inertia, of a running engine torque.total.

    Torque: torque.inertia and torque.frame, in units of m r^2 omega^2; torque.rod, which takes omega
    alone; of a running engine (`running_torque`) torque.gas, which takes the radius alone, and
    torque.total, which takes no keyword: it is that of the engine's own sizes and speed, in N m.

    The orders are those of the result (of a running engine `order`, 12 unless given); with a `tolerance`,
    in units of m r omega^2 (couples: times a), the fewest whose proven bound is within it; with tolerance
    0 all that can show in a double. A tolerance leaves the choice between harmonics and the closed form
    to the cheaper (`codegen.plans`).

    The keywords' defaults are 1; of a result at an operating point they are that point's, so that the
    values are in N and N m with no keyword given.

    >>> from symbalance.forces.free_forces import balance
    >>> from symbalance.engine.catalogue import load
    >>> force = to_function(balance(load("inline-4"), order=4))
    >>> float(force(0.0).round(6)), force.orders
    (0.999708, {'force.vertical': ('2', '4')})
    >>> at_speed = balance(load("inline-4"), 2).at(rpm=6000, stroke=80, mass="0.5", rod=160)
    >>> float(to_function(at_speed)(0.0).round(3))  # newtons
    8022.805
    """
    if target not in IN_MEMORY:
        known = ", ".join(IN_MEMORY)
        raise SymbalanceError(
            f"target = {brief(target)!r}", f"must be one of {known}", f"emit writes {', '.join(FILES)}"
        )
    plan = plan_for(result, ratio, outputs, target, tolerance, order)
    if target == "numba" and find_spec("numba") is None:
        raise MissingPartError("target = 'numba'", "Numba is not installed", "pip install numba")
    (source,) = files(plan, target, result.engine.name, result.engine.name).values()
    by_name = {o.harmonic_sum.name: o for o in plan.outputs}
    return Evaluator(
        target,
        source,
        plan.ratio,
        tuple(by_name),
        {n: tuple(str(t.order) for t in o.harmonic_sum.terms) for n, o in by_name.items()},
        {n: o.form for n, o in by_name.items()},
        {n: o.rounding for n, o in by_name.items()},
        {n: o.amplitude for n, o in by_name.items()},
        {n: o.harmonic_sum.left_out for n, o in by_name.items()},
    )


def plan_for(
    result: Source,
    ratio: object,
    outputs: Sequence[str] | str | None,
    target: str,
    tolerance: float | None,
    order: int | None = None,
) -> Plan:
    """Return the plan, in formulas, of code that computes a result's outputs on a target."""
    if not isinstance(result, TorqueBalance | RunningTorque):
        checked_balance(result)
    names = checked_outputs(_default(result) if outputs is None else outputs, ALL_OUTPUTS)
    if isinstance(result, RunningTorque) and ratio is not None:
        rule = "is the running engine's own already"
        raise SymbalanceError(f"ratio = {brief(ratio)}", rule, "give it to running_torque")
    number = rod_ratio(result, ratio)
    tolerance = None if tolerance is None else checked_tolerance(tolerance)
    highest = checked_order(_highest(result) if order is None else order)
    sums = {n: torque_sum(result, n, number, highest, tolerance) for n in names if n in TORQUES}
    forces = [name for name in names if name not in sums]
    if forces:
        known = result if isinstance(result, Balance) and order is None else None
        known = balance(result.engine, highest) if known is None else known
        sums |= {each.name: each for each in _force_sums(known, forces, number, tolerance)}
    plan = choose_plan([sums[name] for name in names], number, target)
    point = None if isinstance(result, RunningTorque) else result.operating_point
    return replace(plan, defaults=defaults_of(point))


def _force_sums(
    result: Balance, names: Sequence[str], ratio: Fraction, tolerance: float | None
) -> tuple[HarmonicSum, ...]:
    if tolerance is None:
        return sums_to_order(result, names, ratio)
    return sums_within(result, names, ratio, tolerance)


def _default(result: Source) -> str:
    if isinstance(result, RunningTorque):
        return "torque.total"
    return "torque.inertia" if isinstance(result, TorqueBalance) else "force.vertical"


def _highest(result: Source) -> int:
    return RUNNING_ORDER if isinstance(result, RunningTorque) else result.highest


def checked_tolerance(tolerance: object) -> float:
    """Return a tolerance as a number, 0 or more, or refuse."""
    if isinstance(tolerance, (int, float, Fraction)) and not isinstance(tolerance, bool):
        value = float(tolerance)
        if isfinite(value) and value >= 0:
            return value
    raise SymbalanceError(
        f"tolerance = {brief(tolerance)}",
        "must be 0 or a positive number",
        "its unit is m r omega^2; 0 asks for every order that shows in a double",
    )
