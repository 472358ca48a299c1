"""The fixed-step integrators by name: Radau IIA of order 5 and 9, and Newmark's."""

from __future__ import annotations

from collections.abc import Callable

from symbalance.crankshaft.integrators.newmark import newmark_steps
from symbalance.crankshaft.integrators.radau import radau_steps
from symbalance.crankshaft.integrators.time_stepping import LinearSteps
from symbalance.crankshaft.system import PeriodicSystem, check_consistency, check_steps
from symbalance.errors import SymbalanceError, shown

FIXED: dict[str, Callable[[PeriodicSystem, int], LinearSteps]] = {
    "radau-iia": radau_steps,
    "radau-iia-9": lambda system, steps: radau_steps(system, steps, stages=5),
    "newmark": newmark_steps,
}


def linear_steps(system: PeriodicSystem, method: str, steps: int) -> LinearSteps:
    """Return one cycle of a fixed-step method."""
    if method not in FIXED:
        raise SymbalanceError(f"method = {shown(method)!r}", "is not known", f"one of {', '.join(FIXED)}")
    check_steps(steps)
    check_consistency(system)
    return FIXED[method](system, steps)
