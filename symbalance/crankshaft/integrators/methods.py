"""The fixed-step methods by name."""

from __future__ import annotations

from collections.abc import Callable

from symbalance.crankshaft.integrators.marching import LinearSteps
from symbalance.crankshaft.integrators.newmark import newmark_steps
from symbalance.crankshaft.integrators.radau import radau_steps
from symbalance.crankshaft.system import PeriodicSystem
from symbalance.errors import SymbalanceError, shown

FIXED: dict[str, Callable[[PeriodicSystem, int], LinearSteps]] = {
    "radau-iia": radau_steps,
    "radau-iia-9": lambda system, steps: radau_steps(system, steps, stages=5),
    "newmark": newmark_steps,
}
LEAST_STEPS = 4


def linear_steps(system: PeriodicSystem, method: str, steps: int) -> LinearSteps:
    """Return one cycle of a fixed-step method."""
    if method not in FIXED:
        raise SymbalanceError(f"method = {shown(method)!r}", "is not known", f"one of {', '.join(FIXED)}")
    if steps < LEAST_STEPS:
        raise SymbalanceError(
            f"steps = {shown(steps)}", f"must be at least {LEAST_STEPS}", "720 is usual"
        )
    if not system.omega > 0:
        raise SymbalanceError(f"speed = {shown(system.omega)} rad/s", "must be positive", "give rpm > 0")
    return FIXED[method](system, steps)
