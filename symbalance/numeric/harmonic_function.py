"""A balance as a NumPy function: only the outputs asked for, only the orders that survive."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import gcd
from typing import Any

import numpy as np
from mpmath import mp

from symbalance.errors import SymbalanceError, shown
from symbalance.rational import listed
from symbalance.resultants import Balance, Order, checked_balance
from symbalance.slider_crank import acceleration_values, checked_ratio
from symbalance.spectrum import COMPONENTS, SymbolicPhasor

Result = Any
OUTPUTS = tuple(f"{kind}.{name}" for kind in ("force", "couple") for name in COMPONENTS)


@dataclass(frozen=True)
class Output:
    """One output: the sum of Re(conj(weight) e^(i n theta)) over its orders n = step, 2 step, ....

    `weights` holds A_n (C + iS) from the highest multiple of `step` down to 1; absent orders are 0.
    """

    name: str
    step: int
    weights: tuple[complex, ...]


@dataclass(frozen=True)
class HarmonicFunction:
    """f(theta, *, mass, radius, omega, pitch): free forces in N and couples in N m, for theta in radians.

    theta may have any shape and comes back in it, as an array for one output and a dict of arrays for
    several. mass (kg, reciprocating, one cylinder), radius (m, half the stroke), omega (rad/s) and
    pitch (m) are 1 unless given: the result then is in units of m r omega^2 (couples: times a). Units
    are those of the conventions: + up and right, couples + with the front pushed up or right. Orders
    above `highest` are left out; `symbalance.left_out` bounds them for one cylinder.
    """

    outputs: tuple[Output, ...]
    ratio: Fraction
    highest: int

    def __call__(
        self,
        theta: Any,
        *,
        mass: float = 1.0,
        radius: float = 1.0,
        omega: float = 1.0,
        pitch: float = 1.0,
    ) -> Result:
        """Return the outputs at the crank angles `theta` (radians)."""
        angles = np.asarray(theta, dtype=float)
        force = mass * radius * omega**2
        with np.errstate(invalid="ignore"):  # a non-finite angle gives NaN there, and no warning
            turning = np.cos(angles) + 1j * np.sin(angles)
        values = {
            output.name: _evaluated(output, turning)
            * (force if output.name.startswith("force") else force * pitch)
            for output in self.outputs
        }
        return values if len(values) > 1 else values[self.outputs[0].name]


def _evaluated(output: Output, turning: Any) -> Any:
    """Return the sum by Horner's rule in e^(i step theta), which has modulus 1: no order is amplified."""
    if not output.weights:
        return np.zeros_like(turning, dtype=float)
    base = turning**output.step
    total = np.full_like(base, np.conj(output.weights[0]))
    for weight in output.weights[1:]:
        total = total * base + np.conj(weight)
    return (total * base).real


def to_function(
    result: Balance,
    ratio: object = None,
    outputs: Sequence[str] | str = ("force.vertical",),
    target: str = "numpy",
) -> HarmonicFunction:
    """Return a picklable function of the crank angle that holds `outputs` of a balance.

    Outputs: force or couple, a dot, and vertical, lateral, forward or backward. `ratio` is the rod
    ratio lambda = l/r; every A_n is taken exact in it, rounded once. Truncated at the balance's order.

    >>> from symbalance.resultants import balance
    >>> from symbalance.catalogue import load
    >>> force = to_function(balance(load("inline-4"), order=4))
    >>> float(force(0.0).round(6))
    0.999708
    """
    checked_balance(result)
    names = [outputs] if isinstance(outputs, str) else listed(outputs, "outputs", '("force.vertical",)')
    if target != "numpy":
        raise SymbalanceError(
            f"target = {shown(target)!r}", "must be numpy", "it is the one target so far"
        )
    for name in names:
        if name not in OUTPUTS:
            raise SymbalanceError(f"output {shown(name)!r}", "is unknown", f"known: {', '.join(OUTPUTS)}")
    if not names:
        raise SymbalanceError("outputs = ()", "names no output", f"known: {', '.join(OUTPUTS)}")
    number = result.ratio if ratio is None else checked_ratio(ratio)
    if number is None:
        raise SymbalanceError(
            f"engine {result.layout.name!r}",
            "has no rod ratio",
            "pass ratio=..., lambda = l/r, often 3 to 4.5",
        )
    with mp.workdps(30):  # whatever precision the caller has set
        made = tuple(_output(result, name, number) for name in dict.fromkeys(names))
    return HarmonicFunction(made, number, result.highest)


def _output(result: Balance, name: str, ratio: Fraction) -> Output:
    weights = {o.order: w for o in result.orders if (w := _weight(o, name))}
    if not weights:
        return Output(name, 1, ())
    step, highest = gcd(*weights), max(weights)
    values = acceleration_values(highest, ratio)
    scaled = {n: complex(values[n] * w) for n, w in weights.items()}
    return Output(name, step, tuple(scaled.get(n, 0j) for n in range(highest, 0, -step)))


def _weight(order: Order, name: str) -> Any:
    kind, _, part = name.partition(".")
    component = (order.force if kind == "force" else order.couple).component(part)
    if isinstance(component.number, SymbolicPhasor):
        raise SymbalanceError(
            "a layout with symbols", "has no numeric function", "build the layout with numbers"
        )
    cos, sin = component.decimal(25)
    return mp.mpc(cos, sin)
