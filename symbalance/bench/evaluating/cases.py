"""What is evaluated: one output of a preset engine at a rod ratio, to an order."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import atan2, hypot

from symbalance.codegen import Evaluator, plan_for, to_function
from symbalance.codegen.harmonic_sum import HarmonicSum
from symbalance.codegen.plans import Plan
from symbalance.engine.catalogue import load
from symbalance.engine.engine import Engine
from symbalance.forces.free_forces import Balance, balance

ALL = "all"


@dataclass(frozen=True)
class Harmonic:
    """amplitude * cos(order * theta - phase), in doubles: what the alternatives are given."""

    order: float
    amplitude: float
    phase: float


@dataclass(frozen=True)
class Case:
    """An output of an engine; `order` None: all that shows in a double; `ratio` None: its own."""

    engine: str
    output: str
    order: int | None = 12
    ratio: Fraction | None = None

    @cached_property
    def layout(self) -> Engine:
        """The preset."""
        return load(self.engine)

    @cached_property
    def balance(self) -> Balance:
        """The engine's balance to the order asked for."""
        return balance(self.layout, self.order or 12, ratio=self.ratio)

    @property
    def known_ratio(self) -> Fraction:
        """lambda = l/r, the engine's own unless given."""
        ratio = self.balance.ratio
        if ratio is None:
            raise ValueError(f"{self.engine} has no rod ratio")
        return ratio

    @property
    def tolerance(self) -> float | None:
        """What is asked for where no order is."""
        return 0.0 if self.order is None else None

    @property
    def reach(self) -> str:
        """The order, or "all"."""
        return ALL if self.order is None else str(self.order)

    def evaluator(self, target: str) -> Evaluator:
        """Return our function of the crank angle, as a user gets it."""
        return to_function(self.balance, None, self.output, target, tolerance=self.tolerance)

    def planned(self, target: str) -> Plan:
        """Return what a target is written from."""
        return plan_for(self.balance, None, self.output, target, self.tolerance)

    @cached_property
    def wave(self) -> HarmonicSum:
        """The output's surviving harmonics, exact in lambda."""
        return self.planned("numpy").outputs[0].harmonic_sum

    @cached_property
    def harmonics(self) -> tuple[Harmonic, ...]:
        """The cancelled sum, each harmonic one cosine."""
        return tuple(
            _harmonic(float(term.order), float(term.cos), float(term.sin)) for term in self.wave.terms
        )


def _harmonic(order: float, cos: float, sin: float) -> Harmonic:
    """Return one harmonic; what is rounding of a phase 0 or 180 degrees is taken for it.

    >>> _harmonic(2.0, -3.0, 1e-30), _harmonic(1.0, 0.0, 2.0).amplitude
    (Harmonic(order=2.0, amplitude=-3.0, phase=0.0), 2.0)
    """
    if abs(sin) < 1e-20 * abs(cos):
        return Harmonic(order, cos, 0.0)
    return Harmonic(order, hypot(cos, sin), atan2(sin, cos))
